#include "rare/pulse_mixture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "core/error.hpp"
#include "rare/detail/pulse_descent.hpp"
#include "rare/detail/scout.hpp"

namespace overturn::rare {
namespace {

constexpr double least_hits_fitted = 0.15;
constexpr double least_hits_of_pilots = 0.1;
constexpr double largest_share = 0.15;
constexpr double largest_scatter = 2;
constexpr double largest_deviation = 4;   // of the mean weight, in standard errors
constexpr double largest_difference = 3;  // from plain trials, likewise
constexpr double most_undecided = 0.01;

/// Sums over one replicate's final runs at one factor.
struct Sums {
    double failed = 0, squares = 0, largest = 0;  ///< of the weights of what failed
    double undecided = 0;                         ///< sum of weights
    std::int64_t hits = 0;
};

Sums sums_of(std::span<WeightedRow const> rows, std::size_t factor) {
    Sums sums;
    for (auto const& row : rows) {
        if ((row.failed >> factor & 1U) != 0) {
            sums.failed += row.weight;
            sums.squares += row.weight * row.weight;
            sums.largest = std::max(sums.largest, row.weight);
            ++sums.hits;
        }
        sums.undecided += (row.undecided >> factor & 1U) != 0 ? row.weight : 0;
    }
    return sums;
}

Count plain_of(std::vector<std::vector<MixtureStage>> const& stages, std::size_t factor) {
    Count count;
    for (auto const& replicate : stages) {
        for (auto const& row : replicate.back().rows) {
            if (row.plain != 0) {
                ++count.trials;
                count.failed += static_cast<std::int64_t>(row.failed >> factor & 1U);
                count.undecided += static_cast<std::int64_t>(row.undecided >> factor & 1U);
            }
        }
    }
    return count;
}

/// Mean weight of all final runs, off 1 by so many standard errors.
double weight_deviation(std::vector<std::vector<MixtureStage>> const& stages) {
    double sum = 0;
    double squares = 0;
    double n = 0;
    for (auto const& replicate : stages) {
        for (auto const& row : replicate.back().rows) {
            sum += row.weight - 1;
            squares += (row.weight - 1) * (row.weight - 1);
            ++n;
        }
    }
    double const mean = sum / n;
    double const error = std::sqrt((squares / n - mean * mean) / n);
    // Equal weights other than 1 are no scatter: nothing was drawn from the mixture that they are of.
    return mean == 0 ? 0 : error > 0 ? std::abs(mean) / error : std::numeric_limits<double>::infinity();
}

class Judge {
  public:
    Judge(PulseDescent const& descent, std::size_t fitted) : descent_(descent), fitted_(fitted) {}

    [[nodiscard]] Estimate estimate(double factor, std::size_t f, Count const* crude) const {
        auto const& stages = descent_.stages();
        auto const n = static_cast<double>(stages.front().back().rows.size());
        auto const replicates = static_cast<double>(stages.size());
        Estimate made;
        made.factor = factor;
        made.method = Method::pulse_mixture;
        double within = 0;
        double share = 0;
        double undecided = 0;
        std::int64_t hits = 0;
        for (auto const& replicate : stages) {
            auto const sums = sums_of(replicate.back().rows, f);
            double const p = sums.failed / n;
            made.replicates.push_back(p);
            within += (sums.squares / n - p * p) / n / (replicates * replicates);
            share += sums.failed > 0 ? sums.largest / sums.failed / replicates : 1 / replicates;
            undecided += sums.undecided;
            hits += sums.hits;
        }
        auto const mean = mean_of_replicates(made.replicates);
        made.interval_95 = mean.interval_95;
        made.cov = mean.mean > 0 ? mean.standard_error / mean.mean : 0;
        auto const at_most = [&](std::string name, double value, double limit) {
            made.health.push_back({std::move(name), value, limit, value <= limit});
        };
        auto const at_least = [&](std::string name, double value, double limit) {
            made.health.push_back({std::move(name), value, limit, value >= limit});
        };
        at_least("hits in the pilot runs", descent_.poorest_hits(), least_hits_of_pilots);
        at_least("hits at the fitted factor", hits_at(fitted_), least_hits_fitted);
        at_most("largest weight's share", share, largest_share);
        at_most("scatter of replicates over their own", within > 0 ? mean.standard_error / std::sqrt(within) : 0,
                largest_scatter);
        at_most("mean weight off 1, standard errors", weight_deviation(stages), largest_deviation);
        at_most("estimate", mean.mean, 1);
        at_most("undecided share", mean.mean > 0 ? undecided / n / replicates / mean.mean : 1, most_undecided);
        if (crude != nullptr && crude->failed >= fewest_failures) {
            auto const trials = static_cast<double>(crude->trials);
            double const p = static_cast<double>(crude->failed) / trials;
            double const error = std::hypot(mean.standard_error, std::sqrt(p * (1 - p) / trials));
            at_most("off plain trials, standard errors", std::abs(p - mean.mean) / error, largest_difference);
        }
        auto plain = plain_of(stages, f);
        if (crude != nullptr) {
            plain.add(*crude);
        }
        return conclude(made, mean.mean, plain, hits);
    }

  private:
    [[nodiscard]] double hits_at(std::size_t f) const {
        double hits = 0;
        double n = 0;
        for (auto const& replicate : descent_.stages()) {
            hits += static_cast<double>(sums_of(replicate.back().rows, f).hits);
            n += static_cast<double>(replicate.back().rows.size());
        }
        return hits / n;
    }

    [[nodiscard]] Estimate conclude(Estimate made, double mean, Count const& plain, std::int64_t hits) const {
        made.runs = descent_.runs();
        if (hits < fewest_failures) {
            distrust(made, State::not_resolved, fmt::format("{} draws failed", hits), plain);
        } else if (auto const words = words_of(made.health); !words.empty()) {
            distrust(made, State::not_trusted, words, plain);
        } else {
            made.state = State::trusted;
            made.probability = mean;
            made.crude_runs = crude_runs_for(mean, made.cov);
        }
        return made;
    }

    PulseDescent const& descent_;
    std::size_t fitted_;  ///< place of the fitted factor
};

std::vector<Estimate> none(std::span<double const> factors, std::span<Count const> crude, Scouted const& scouted,
                           PulseDescent const& descent, Request const& request) {
    std::vector<Estimate> estimates;
    for (std::size_t f = 0; f < factors.size(); ++f) {
        Estimate made;
        made.factor = factors[f];
        made.method = Method::pulse_mixture;
        made.runs = scouted.runs + descent.runs();
        bool const broken = scouted.found && descent.broken();
        distrust(made, broken ? State::not_trusted : State::not_resolved,
                 broken          ? "draws of the mixture hardly ever fail (waves are not linear in their normals, or "
                                   "failures have nothing in common)"
                 : scouted.found ? fmt::format("not reached in {} waves (max_runs)", request.max_runs)
                                 : scouted.reason,
                 crude.empty() ? Count{} : crude[f]);
        estimates.push_back(std::move(made));
    }
    return estimates;
}

// How many times as many final runs the worst estimate that could be trusted calls for.
double growth_wanted(std::span<Estimate const> estimates, double target_cov) {
    double growth = 1;
    for (auto const& estimate : estimates) {
        if (estimate.state == State::trusted) {
            growth = std::max(growth, estimate.cov * estimate.cov / (target_cov * target_cov));
        }
    }
    return growth;
}

}  // namespace

PulseResult estimate_pulse_mixture(Problem const& problem, std::span<double const> factors, double fitted_factor,
                                   Request const& request, Workforce& workers, std::span<Count const> crude,
                                   PulseOptions const& options) {
    OVERTURN_EXPECT(problem.frame().has_value() && factors.size() < most_factors && request.replicates >= 2);
    OVERTURN_EXPECT(crude.empty() || crude.size() == factors.size());
    PulseDescent descent(problem, request, workers, options);
    auto const scouted = options.fit.pulses == 0 ? Scouted{.factor = fitted_factor, .found = true}
                                                 : scout(problem, fitted_factor, request, workers);
    if (scouted.found) {
        descent.descend(scouted.factor, fitted_factor);
    }
    auto const final_runs = std::min(options.final_runs, (request.max_runs - descent.runs()) / request.replicates);
    if (!scouted.found || descent.broken() || descent.spent()
        || final_runs < std::min(options.final_runs, options.pilot_runs)) {
        auto estimates = none(factors, crude, scouted, descent, request);
        return {std::move(estimates), std::move(descent.stages())};
    }
    // The fitted factor is looked at too, whether it is asked for or not.
    std::vector<double> looked_at(factors.begin(), factors.end());
    looked_at.push_back(fitted_factor);
    descent.finish(looked_at, final_runs);
    Judge const judge(descent, factors.size());
    PulseResult result;
    for (std::int64_t round = 0;; ++round) {
        result.estimates.clear();
        for (std::size_t f = 0; f < factors.size(); ++f) {
            result.estimates.push_back(judge.estimate(factors[f], f, crude.empty() ? nullptr : &crude[f]));
            result.estimates.back().runs += scouted.runs;
        }
        std::int64_t const done = descent.stages().front().back().rows.size();
        auto const more = std::min(
            {static_cast<std::int64_t>(static_cast<double>(done)
                                       * (std::min(growth_wanted(result.estimates, request.target_cov), 2.0) - 1)),
             (request.max_runs - descent.runs()) / request.replicates});
        if (round + 1 >= options.most_rounds || more <= 0) {
            break;
        }
        descent.finish(looked_at, more);
    }
    result.stages = std::move(descent.stages());
    return result;
}

}  // namespace overturn::rare
