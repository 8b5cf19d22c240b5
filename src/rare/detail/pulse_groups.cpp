#include "rare/detail/pulse_groups.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace overturn::rare {
namespace {

double distance(Lines const& a, Lines const& b) {
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        sum += std::norm(a[k] - b[k]);
    }
    return sum;
}

double product(Lines const& a, Lines const& b) {
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        sum += a[k].real() * b[k].real() + a[k].imag() * b[k].imag();
    }
    return sum;
}

Lines mean_of(std::vector<Lines> const& waves, std::span<double const> weights, std::span<std::size_t const> members) {
    Lines sum(waves.front().size());
    double total = 0;
    for (auto const i : members) {
        total += weights[i];
        for (std::size_t k = 0; k < sum.size(); ++k) {
            sum[k] += weights[i] * waves[i][k];
        }
    }
    for (auto& line : sum) {
        line /= total;
    }
    return sum;
}

// The direction in which members differ most: power iteration on their covariance, from the one farthest off.
Lines widest(std::vector<Lines> const& waves, std::span<double const> weights, std::span<std::size_t const> members,
             Lines const& mean) {
    auto const pull = [&](std::size_t i) { return weights[i] * distance(waves[i], mean); };
    auto const farthest =
        *std::max_element(members.begin(), members.end(), [&](auto i, auto j) { return pull(i) < pull(j); });
    auto const off = [&](std::size_t i) {
        auto apart = waves[i];
        for (std::size_t k = 0; k < apart.size(); ++k) {
            apart[k] -= mean[k];
        }
        return apart;
    };
    auto direction = off(farthest);
    constexpr int iterations = 20;
    for (int iteration = 0; iteration < iterations; ++iteration) {
        Lines next(direction.size());
        for (auto const i : members) {
            auto const apart = off(i);
            double const part = weights[i] * product(apart, direction);
            for (std::size_t k = 0; k < next.size(); ++k) {
                next[k] += part * apart[k];
            }
        }
        double const length = std::sqrt(product(next, next));
        if (!(length > 0)) {
            return direction;
        }
        for (auto& line : next) {
            line /= length;
        }
        direction = std::move(next);
    }
    return direction;
}

// All in one group, then again and again the heaviest group parted where it is widest. Outliers, whose weight is small,
// found no group of their own.
std::vector<Lines> parted(std::vector<Lines> const& waves, std::span<double const> weights, std::size_t count) {
    std::vector<std::vector<std::size_t>> groups(1);
    groups.front().reserve(waves.size());
    for (std::size_t i = 0; i < waves.size(); ++i) {
        groups.front().push_back(i);
    }
    auto const weight_of = [&](std::vector<std::size_t> const& group) {
        double sum = 0;
        for (auto const i : group) {
            sum += weights[i];
        }
        return sum;
    };
    while (groups.size() < count) {
        auto const heaviest = std::max_element(
            groups.begin(), groups.end(), [&](auto const& a, auto const& b) { return weight_of(a) < weight_of(b); });
        auto const mean = mean_of(waves, weights, *heaviest);
        auto const direction = widest(waves, weights, *heaviest, mean);
        double const middle = product(mean, direction);
        auto const second = std::stable_partition(heaviest->begin(), heaviest->end(),
                                                  [&](std::size_t i) { return product(waves[i], direction) < middle; });
        std::vector<std::size_t> other(second, heaviest->end());
        heaviest->erase(second, heaviest->end());
        if (other.empty() || heaviest->empty()) {
            other = other.empty() ? *heaviest : other;  // all equal: the same pulse twice
            *heaviest = other;
        }
        groups.push_back(std::move(other));
    }
    std::vector<Lines> means;
    means.reserve(groups.size());
    for (auto const& group : groups) {
        means.push_back(mean_of(waves, weights, group));
    }
    return means;
}

bool assign(std::vector<Lines> const& waves, Groups& groups) {
    bool moved = false;
    for (std::size_t i = 0; i < waves.size(); ++i) {
        std::size_t best = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t c = 0; c < groups.means.size(); ++c) {
            if (double const d = distance(waves[i], groups.means[c]); d < least) {
                least = d;
                best = c;
            }
        }
        moved = moved || groups.of[i] != best;
        groups.of[i] = best;
    }
    return moved;
}

// A group without waves stays where it is.
void average(std::vector<Lines> const& waves, std::span<double const> weights, Groups& groups) {
    for (std::size_t c = 0; c < groups.means.size(); ++c) {
        std::vector<std::size_t> members;
        for (std::size_t i = 0; i < waves.size(); ++i) {
            if (groups.of[i] == c) {
                members.push_back(i);
            }
        }
        if (!members.empty()) {
            groups.means[c] = mean_of(waves, weights, members);
        }
    }
}

// Squared length of what chance adds to a weighted mean.
double noise_of(std::vector<Lines> const& waves, std::span<double const> weights, Lines const& mean,
                std::span<std::size_t const> members) {
    double sum = 0;
    double total = 0;
    for (auto const i : members) {
        sum += weights[i] * weights[i] * distance(waves[i], mean);
        total += weights[i];
    }
    return total > 0 ? sum / (total * total) : 0;
}

// Brings each mean nearer to that of all, by the part of its distance that chance explains (James and Stein 1961): a
// few waves' own noise would otherwise be taken for a pulse of its own.
void shrink(std::vector<Lines> const& waves, std::span<double const> weights, Groups& groups) {
    std::vector<std::size_t> all(waves.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i] = i;
    }
    auto const centre = mean_of(waves, weights, all);
    for (std::size_t c = 0; c < groups.means.size(); ++c) {
        std::vector<std::size_t> members;
        std::copy_if(all.begin(), all.end(), std::back_inserter(members),
                     [&](std::size_t i) { return groups.of[i] == c; });
        auto& mean = groups.means[c];
        double const apart = distance(mean, centre);
        double const kept = apart > 0 ? std::max(0.0, 1 - noise_of(waves, weights, mean, members) / apart) : 0;
        for (std::size_t k = 0; k < mean.size(); ++k) {
            mean[k] = centre[k] + kept * (mean[k] - centre[k]);
        }
    }
}

}  // namespace

Groups grouped(std::vector<Lines> const& waves, std::span<double const> weights, std::size_t count) {
    Groups groups{std::vector<std::size_t>(waves.size(), count), parted(waves, weights, count)};
    constexpr int sweeps = 25;
    for (int sweep = 0; sweep < sweeps && assign(waves, groups); ++sweep) {
        average(waves, weights, groups);
    }
    shrink(waves, weights, groups);
    return groups;
}

}  // namespace overturn::rare
