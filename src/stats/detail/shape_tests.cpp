#include "stats/detail/shape_tests.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include "stats/detail/simulated_chance.hpp"
#include "stats/detail/tail_bounds.hpp"
#include "stats/detail/wave_shape_tests.hpp"

namespace overturn {
namespace {

constexpr std::size_t most_refitted = 64;  // further points are put together for refits
constexpr std::size_t many_points = 2000;
constexpr double enough_chance = 0.1;  // no alarm, whatever else may be

int enough_of(std::size_t points) { return points > many_points ? 20 : 100; }

// Independent trials anew, a group as one.
class NullDraws {
  public:
    NullDraws(std::span<FragilityPoint const> points, std::vector<double> probabilities)
        : drawn_(points.begin(), points.end()), p_(std::move(probabilities)) {}
    [[nodiscard]] std::vector<FragilityPoint> const& draw(RandomStream& stream) {
        for (std::size_t i = 0; i < drawn_.size(); ++i) {
            auto& point = drawn_[i];
            double const groups = std::floor(point.groups());
            double const rest = point.trials - groups * point.group_size;
            point.overturned =
                point.group_size * fallen(stream, p_[i], groups) + rest * fallen(stream, p_[i], rest > 0 ? 1 : 0);
        }
        return drawn_;
    }

  private:
    static double fallen(RandomStream& stream, double p, double trials) {
        if (trials <= 1) {
            return trials > 0 && gsl_rng_uniform(stream.gsl()) < p ? 1 : 0;
        }
        return gsl_ran_binomial(stream.gsl(), p, static_cast<unsigned>(trials));
    }

    std::vector<FragilityPoint> drawn_;
    std::vector<double> p_;
};

std::vector<double> on_line(std::span<FragilityPoint const> points, ProbitLine const& line) {
    std::vector<double> p;
    for (auto const& point : points) {
        p.push_back(gsl_cdf_ugaussian_P(line.at(point.log_intensity)));
    }
    return p;
}

std::vector<double> rising(std::span<FragilityPoint const> points) {
    std::vector<double> p;
    for (auto const& pool : isotonic_estimate(points)) {
        p.insert(p.end(), pool.points, pool.probability());
    }
    return p;
}

std::optional<ProbitLine> refit(std::span<FragilityPoint const> points, ProbitLine const& begin) {
    bool const many = points.size() > most_refitted;
    auto const few = many ? grouped(points, most_refitted) : std::vector<FragilityPoint>();
    std::span<FragilityPoint const> const fitted = many ? std::span<FragilityPoint const>(few) : points;
    if (state_of(fitted) != FragilityState::fitted) {
        return std::nullopt;
    }
    auto const line = fit_probit(fitted, begin);
    return line && line->slope > 0 ? line : std::nullopt;
}

std::vector<FragilityPoint> seen_of(std::span<FragilityPoint const> points, FragilityData::Kind kind) {
    constexpr std::size_t tenths = 10;
    return kind == FragilityData::Kind::singles ? grouped(points, tenths)
                                                : std::vector<FragilityPoint>(points.begin(), points.end());
}

// The larger chance of the line, which may be wrong, and of the rising estimate, which follows single trials too
// closely. Without a line, of one P throughout: nothing that rises falls as often by chance.
double monotone_chance(FragilityData const& data, std::optional<ProbitLine> const& line, double found,
                       BootstrapKey const& key) {
    auto const under = [&](std::vector<double> p) {
        NullDraws draws(data.points, std::move(p));
        return simulated_chance(found, key, enough_of(data.points.size()), [&](RandomStream& stream) {
            return std::optional(test_monotone(seen_of(draws.draw(stream), data.kind)).deviance);
        });
    };
    if (!line) {
        auto const sum = sum_of(data.points);
        return under(std::vector<double>(data.points.size(), sum.overturned / sum.trials));
    }
    double const by_line = under(on_line(data.points, *line));
    return by_line < enough_chance ? std::max(by_line, under(rising(data.points))) : by_line;
}

double deviance_chance(FragilityData const& data, ProbitLine const& line, BootstrapKey const& key) {
    auto const own = refit(data.points, line);
    double const found = deviance_from(data.points, own.value_or(line)).deviance;
    NullDraws draws(data.points, on_line(data.points, line));
    return simulated_chance(
        found, key, enough_of(data.points.size()), [&](RandomStream& stream) -> std::optional<double> {
            auto const& drawn = draws.draw(stream);
            auto const refitted = refit(drawn, line);
            return refitted ? std::optional(deviance_from(drawn, *refitted).deviance) : std::nullopt;
        });
}

}  // namespace

ShapeTests test_shape(FragilityData const& data, std::optional<ProbitLine> const& line, BootstrapKey const& key) {
    ShapeTests tests;
    tests.monotone = test_monotone(proportions_of(data));
    if (line) {
        tests.goodness = goodness_of_fit(data.points, *line);
    }
    if (data.waves_shared && !data.trials.empty()) {
        WaveShapeTests const waves(data.trials, line, key);
        tests.monotone.p_value = tests.monotone.degrees_of_freedom > 0 ? waves.monotone_chance() : 1;
        if (line && tests.goodness->degrees_of_freedom > 0) {
            tests.goodness->p_value = waves.misfit_chance();
        }
        if (line && data.points.size() > stripes_at_most) {
            tests.goodness->stripe_p_value = 1;  // a group holds several trials of a wave: no binomial tail
        }
        return tests;
    }
    if (tests.monotone.degrees_of_freedom > 0) {
        tests.monotone.p_value = monotone_chance(data, line, tests.monotone.deviance, key);
    }
    if (line && tests.goodness->degrees_of_freedom > 0 && !tests.goodness->chi_squared) {
        tests.goodness->p_value = deviance_chance(data, *line, key);
    }
    return tests;
}

}  // namespace overturn
