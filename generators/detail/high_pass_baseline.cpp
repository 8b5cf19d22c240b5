#include "generators/detail/high_pass_baseline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <utility>

#include "core/units.hpp"
#include "generators/detail/baseline.hpp"
#include "motion/ground_motion.hpp"

namespace overturn {
namespace {

constexpr double nodes_per_longest = 16;  // a chord of the slowest motion that stays is 2 % off its arc
constexpr double corner_over_longest = 2;
constexpr int order = 4;
constexpr double last_corner = 2.4;  // corners: of faster cosines less than 1e-3 would be taken off, so nothing is

// An even number of 2, 3 and 5: the nodes there and back.
std::size_t fft_length(std::size_t samples, double time_step_s, double longest_s) {
    double const duration_s = static_cast<double>(samples) * time_step_s;
    auto const spans = static_cast<std::size_t>(nodes_per_longest * duration_s / longest_s) + 1;
    return RealFft::good_length(2 * std::min(spans, std::max<std::size_t>(samples, 2) - 1));
}

// Changes the coefficients of every second cosine, from `first` on, until sum c_m = 0 and sum m^2 c_m = 0: the least
// change, weighed by the low-pass, so that what it does not hold is not brought in. (The mean counts twice in a mean
// square.)
void clamp_ends(std::span<double> c, std::span<double const> low_pass, std::size_t first) {
    double sum = 0, sum_2 = 0;                // what is to vanish
    double unit = 0, unit_2 = 0, unit_4 = 0;  // by how much multipliers of 1 and m^2 change it
    auto const weight = [&](std::size_t m) { return m == 0 ? 0.5 * low_pass[m] : low_pass[m]; };
    for (std::size_t m = first; m < c.size(); m += 2) {
        auto const square = static_cast<double>(m * m);
        sum += c[m];
        sum_2 += square * c[m];
        unit += weight(m);
        unit_2 += square * weight(m);
        unit_4 += square * square * weight(m);
    }
    double const determinant = unit * unit_4 - unit_2 * unit_2;
    double const plain = (sum * unit_4 - sum_2 * unit_2) / determinant;
    double const by_square = (sum_2 * unit - sum * unit_2) / determinant;
    for (std::size_t m = first; m < c.size(); m += 2) {
        c[m] -= weight(m) * (plain + by_square * static_cast<double>(m * m));
    }
}

}  // namespace

HighPassBaseline::HighPassBaseline(std::size_t samples, double time_step_s, double longest_s)
    : fft_(fft_length(samples, time_step_s, longest_s)),
      per_span_(2 * static_cast<double>(samples - 1) / static_cast<double>(fft_.length())) {
    constexpr std::size_t least = 3;  // the conditions at the ends take two cosines that are even, and two odd ones
    auto const nodes = fft_.length() / 2;
    double const duration_s = static_cast<double>(samples - 1) * time_step_s;
    constexpr double rounding = 1e-9;
    if (nodes <= least || per_span_ < 1 || duration_s < longest_s * (1 - rounding)) {
        return;
    }
    double const corner = 2 * duration_s / (corner_over_longest * longest_s);
    auto const last = std::min(nodes - 1, std::max(least, static_cast<std::size_t>(last_corner * corner)));
    for (std::size_t m = 0; m <= last; ++m) {
        low_pass_.push_back(1 / (1 + std::pow(static_cast<double>(m) / corner, 2 * order)));
    }
    auto const sums_of = [&](BaselinePolynomial const& polynomial) {
        std::vector<double> values(samples);
        for (std::size_t i = 0; i < samples; ++i) {
            values[i] = polynomial(static_cast<double>(i) / static_cast<double>(samples - 1));
        }
        auto sums = on_nodes(values);
        sums.resize(nodes + 1);
        return sums;
    };
    bump_ = sums_of({1, 0});
    wave_ = sums_of({0, 1});
}

// The first sample at or behind a node.
std::size_t HighPassBaseline::first_of(std::size_t node) const {
    return static_cast<std::size_t>(std::ceil(static_cast<double>(node) * per_span_));
}

// Sums of the samples, each shared by the two nodes beside it: integrals with any function that is straight between
// nodes. Node 0 to length / 2, and room for as many again that mirror them, for a transform that knows cosines alone.
// Four sums side by side, as one would wait for itself.
std::vector<double> HighPassBaseline::on_nodes(std::span<double const> a) const {
    constexpr std::size_t width = 4;
    auto const spans = fft_.length() / 2;
    std::vector<double> nodes(fft_.length(), 0.0);
    double const share = 1 / per_span_;
    for (std::size_t node = 0; node < spans; ++node) {
        auto const begin = first_of(node);
        auto const end = std::min(first_of(node + 1), a.size() - 1);
        std::array<double, width> all{}, late{};
        auto const samples = a.subspan(begin, end - begin);
        std::size_t i = 0;
        for (; i + width <= samples.size(); i += width) {
            for (std::size_t j = 0; j < width; ++j) {
                all[j] += samples[i + j];
                late[j] += static_cast<double>(static_cast<int>(i + j)) * samples[i + j];
            }
        }
        for (; i < samples.size(); ++i) {
            all[0] += samples[i];
            late[0] += static_cast<double>(i) * samples[i];
        }
        double const sum = (all[0] + all[1]) + (all[2] + all[3]);
        double const behind = static_cast<double>(begin) - static_cast<double>(node) * per_span_;
        double const moment = share * ((late[0] + late[1]) + (late[2] + late[3]) + behind * sum);
        nodes[node] += sum - moment;
        nodes[node + 1] += moment;
    }
    nodes[spans] += a.back();
    return nodes;
}

// The acceleration to be taken off, at the nodes.
std::vector<double> HighPassBaseline::slow(std::vector<double> series) const {
    auto const count = fft_.length() / 2;
    double mean = 0;  // of the displacement: the mean of a (T - t)^2 / 2
    for (std::size_t j = 0; j <= count; ++j) {
        double const left = 1 - static_cast<double>(j) / static_cast<double>(count);
        mean += series[j] * left * left;
    }
    series[0] *= 2;
    series[count] *= 2;
    for (std::size_t j = 1; j < count; ++j) {
        series[fft_.length() - j] = series[j];
    }
    std::vector<std::complex<double>> lines(low_pass_.size());
    fft_.analyse(series, lines);
    // Displacements over (duration / pi)^2: a = sum a_m cos(m tau), and their even continuation -a_m / m^2.
    double const per_sample = 1 / per_span_;
    std::vector<double> displacement(low_pass_.size());
    displacement[0] = 0.5 * pi * pi * per_sample * mean / static_cast<double>(count);
    for (std::size_t m = 1; m < displacement.size(); ++m) {
        displacement[m] = -low_pass_[m] * per_sample * lines[m].real() / static_cast<double>(m * m);
    }
    clamp_ends(displacement, low_pass_, 0);
    clamp_ends(displacement, low_pass_, 1);
    for (std::size_t m = 0; m < lines.size(); ++m) {
        lines[m] = -static_cast<double>(m * m) * displacement[m];
    }
    fft_.synthesise(lines, series);
    return series;
}

// A polynomial first, or the even continuation would have corners; on the nodes alone, as what it leaves is brought to
// rest sample by sample in the end.
void HighPassBaseline::correct(std::span<double> a) const {
    if (!low_pass_.empty()) {
        auto nodes = on_nodes(a);
        auto const last = static_cast<double>(a.size() - 1);
        GroundEnd end{-0.5 * (a.front() + a.back()), a.back() / 6 - (0.5 * last + 1.0 / 6) * a.front()};
        for (std::size_t j = 0; j < bump_.size(); ++j) {
            end.velocity += nodes[j];
            end.displacement += (last - static_cast<double>(j) * per_span_) * nodes[j];
        }
        auto const polynomial = polynomial_ending(end, a.size());
        for (std::size_t j = 0; j < bump_.size(); ++j) {
            nodes[j] -= polynomial.bump * bump_[j] + polynomial.wave * wave_[j];
        }
        auto taken = slow(std::move(nodes));
        auto const spans = bump_.size() - 1;
        for (std::size_t j = 0; j <= spans; ++j) {
            taken[j] += polynomial(static_cast<double>(j) / static_cast<double>(spans));
        }
        for (std::size_t node = 0; node < spans; ++node) {
            auto const begin = first_of(node);
            int const count = static_cast<int>(std::min(first_of(node + 1), a.size() - 1) - begin);
            double const step = (taken[node + 1] - taken[node]) / per_span_;
            double const first =
                taken[node] + (static_cast<double>(begin) - static_cast<double>(node) * per_span_) * step;
            for (int i = 0; i < count; ++i) {
                a[begin + i] -= first + i * step;
            }
        }
        a.back() -= taken[spans];
    }
    correct_baseline(a);
}

double slow_share(std::span<double const> acceleration_mps2, double time_step_s, double period_s) {
    auto displacement = displacement_of(acceleration_mps2, time_step_s);
    RealFft const fft(RealFft::good_length(2 * displacement.size()));
    displacement.resize(fft.length(), 0.0);
    std::vector<std::complex<double>> lines(fft.length() / 2);
    fft.analyse(displacement, lines);
    double const length_s = time_step_s * static_cast<double>(fft.length());
    double slow = 0;
    double all = 0;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        double const power = std::norm(lines[k]);
        all += power;
        slow += static_cast<double>(k) * period_s < length_s ? power : 0;
    }
    return all > 0 ? slow / all : 0;
}

}  // namespace overturn
