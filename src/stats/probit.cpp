#include "stats/probit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_multimin.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_sf_erf.h>

#include "stats/detail/gsl_quiet.hpp"

namespace overturn {
namespace {

// Beyond this GSL's distribution function runs out of range and its asymptotic relatives take over.
constexpr double far_tail = 30;

// phi(z) / Phi(-z): the normal hazard.
double hazard(double z) { return z < far_tail ? gsl_ran_ugaussian_pdf(z) / gsl_cdf_ugaussian_Q(z) : gsl_sf_hazard(z); }

// The hazards at z and -z of one density and one tail.
struct Hazards {
    double at, opposite;
};

Hazards hazards(double z) {
    double const far = std::abs(z);
    if (far >= far_tail) {
        return {hazard(z), hazard(-z)};
    }
    double const density = gsl_ran_ugaussian_pdf(far);
    double const tail = gsl_cdf_ugaussian_Q(far);
    double const rare = density / tail;
    double const common = density / (1 - tail);
    return z > 0 ? Hazards{rare, common} : Hazards{common, rare};
}

double log_upper_tail(double z) {
    return z < far_tail ? std::log(gsl_cdf_ugaussian_Q(z)) : gsl_sf_log_erfc(z / M_SQRT2) - M_LN2;
}

// The points in u = (ln x - centre) / spread, in which both parameters are of order one.
struct Scaled {
    std::span<FragilityPoint const> points;
    double centre = 0, spread = 1, trials = 0;

    [[nodiscard]] double u(FragilityPoint const& point) const { return (point.log_intensity - centre) / spread; }
    [[nodiscard]] ProbitLine unscaled(double intercept, double slope) const {
        return {intercept - slope * centre / spread, slope / spread};
    }
};

Scaled scaled(std::span<FragilityPoint const> points) {
    auto const sum = sum_of(points);
    double variance = 0;
    for (auto const& point : points) {
        variance += point.trials * std::pow(point.log_intensity - sum.log_intensity, 2) / sum.trials;
    }
    return {points, sum.log_intensity, std::sqrt(variance), sum.trials};
}

// First derivatives of the log-likelihood by intercept and slope, and its negative second ones, per trial.
struct Derivatives {
    double by_intercept = 0, by_slope = 0;
    double intercepts = 0, mixed = 0, slopes = 0;

    // The larger of the scores.
    [[nodiscard]] double rest() const { return std::max(std::abs(by_intercept), std::abs(by_slope)); }
};

struct Place {
    double intercept, slope;
};

Derivatives derivatives(Scaled const& data, Place const& line) {
    Derivatives sum;
    for (auto const& point : data.points) {
        if (point.trials == 0) {
            continue;
        }
        double const u = data.u(point);
        auto const of = score_slope(point, line.intercept + line.slope * u);
        double const first = of.score / data.trials;
        double const second = of.fall / data.trials;
        sum.by_intercept += first;
        sum.by_slope += first * u;
        sum.intercepts += second;
        sum.mixed += second * u;
        sum.slopes += second * u * u;
    }
    return sum;
}

// Newton's steps, each halved until the slope along it has not turned to more than it was before.
std::optional<Place> top_of(Scaled const& data, Place line) {
    constexpr double residual = 1e-12;  // of the score per trial
    constexpr double enough = 1e-8;     // where rounding allows no more
    constexpr int most_steps = 100;
    constexpr int most_halvings = 50;
    auto at = derivatives(data, line);
    for (int step = 0; step < most_steps && at.rest() > residual; ++step) {
        double const determinant = at.intercepts * at.slopes - at.mixed * at.mixed;
        double const to_intercept = (at.slopes * at.by_intercept - at.mixed * at.by_slope) / determinant;
        double const to_slope = (at.intercepts * at.by_slope - at.mixed * at.by_intercept) / determinant;
        double const rise = at.by_intercept * to_intercept + at.by_slope * to_slope;
        if (!(rise > 0) || !std::isfinite(rise)) {
            break;
        }
        double share = 1;
        for (int halving = 0; halving < most_halvings; ++halving, share /= 2) {
            Place const next{line.intercept + share * to_intercept, line.slope + share * to_slope};
            auto const there = derivatives(data, next);
            double const left = there.by_intercept * to_intercept + there.by_slope * to_slope;
            if (std::abs(left) < rise) {
                line = next;
                at = there;
                break;
            }
        }
        if (share < std::ldexp(1.0, 1 - most_halvings)) {
            break;
        }
    }
    return at.rest() <= enough ? std::optional(line) : std::nullopt;
}

// -(l + ln det I / 2), with the expected information of a probit, n phi^2 / (Phi (1 - Phi)) at each point. Its
// determinant is taken about the weighted mean, where no two large numbers leave a small one: a point far from all
// others has next to no weight.
double penalised(gsl_vector const* line, void* data) {
    auto const& of = *static_cast<Scaled const*>(data);
    auto const z = [&](FragilityPoint const& point) {
        return gsl_vector_get(line, 0) + gsl_vector_get(line, 1) * of.u(point);
    };
    auto const weight = [&](FragilityPoint const& point) {
        auto const both = hazards(z(point));
        return point.trials * both.at * both.opposite;
    };
    double likelihood = 0, weights = 0, moment = 0;
    for (auto const& point : of.points) {
        likelihood += log_likelihood(point, z(point));
        weights += weight(point);
        moment += weight(point) * of.u(point);
    }
    double spread = 0;
    for (auto const& point : of.points) {
        double const apart = of.u(point) - moment / weights;
        spread += weight(point) * apart * apart;
    }
    double const determinant = weights * spread;
    return determinant > 0 ? -(likelihood + std::log(determinant) / 2) : GSL_POSINF;
}

struct VectorDeleter {
    void operator()(gsl_vector* vector) const { gsl_vector_free(vector); }
};
using Vector = std::unique_ptr<gsl_vector, VectorDeleter>;

struct SimplexDeleter {
    void operator()(gsl_multimin_fminimizer* simplex) const { gsl_multimin_fminimizer_free(simplex); }
};

}  // namespace

double log_likelihood(FragilityPoint const& point, double z) {
    double value = 0;
    if (point.overturned > 0) {
        value += point.overturned * log_upper_tail(-z);
    }
    if (point.overturned < point.trials) {
        value += (point.trials - point.overturned) * log_upper_tail(z);
    }
    return value;
}

double score(FragilityPoint const& point, double z) { return score_slope(point, z).score; }

ScoreSlope score_slope(FragilityPoint const& point, double z) {
    auto const [stands, falls] = hazards(z);
    double const stood = point.trials - point.overturned;
    return {point.overturned * falls - stood * stands,
            point.overturned * falls * (falls + z) + stood * stands * (stands - z)};
}

double log_likelihood(std::span<FragilityPoint const> points, ProbitLine const& line) {
    double sum = 0;
    for (auto const& point : points) {
        sum += log_likelihood(point, line.at(point.log_intensity));
    }
    return sum;
}

std::optional<ProbitLine> fit_probit(std::span<FragilityPoint const> points) {
    auto const data = scaled(points);
    auto const sum = sum_of(points);
    auto const top = top_of(data, {gsl_cdf_ugaussian_Pinv(sum.overturned / sum.trials), 1});
    return top ? std::optional(data.unscaled(top->intercept, top->slope)) : std::nullopt;
}

std::optional<ProbitLine> fit_probit(std::span<FragilityPoint const> points, ProbitLine const& begin) {
    auto const data = scaled(points);
    auto const top = top_of(data, {begin.at(data.centre), begin.slope * data.spread});
    return top ? std::optional(data.unscaled(top->intercept, top->slope)) : fit_probit(points);
}

std::optional<ProbitLine> fit_penalised(std::span<FragilityPoint const> points) {
    GslQuiet const quiet;  // where the penalty is infinite a simplex says so and is made smaller
    auto data = scaled(points);
    Vector const start(gsl_vector_alloc(2));
    Vector const reach(gsl_vector_alloc(2));
    gsl_vector_set(start.get(), 0, 0);
    gsl_vector_set(start.get(), 1, 1);
    gsl_vector_set_all(reach.get(), 1);
    std::unique_ptr<gsl_multimin_fminimizer, SimplexDeleter> const simplex(
        gsl_multimin_fminimizer_alloc(gsl_multimin_fminimizer_nmsimplex2, 2));
    gsl_multimin_function function{&penalised, 2, &data};
    // A simplex may shrink to nothing before it has arrived, so it starts again where it stopped until that moves it no
    // more.
    constexpr double size = 1e-8;
    constexpr int most_steps = 2000;
    constexpr int most_starts = 20;
    double before = std::numeric_limits<double>::infinity();
    for (int begin = 0; begin < most_starts; ++begin) {
        int status = gsl_multimin_fminimizer_set(simplex.get(), &function, start.get(), reach.get());
        constexpr int most_halvings = 60;
        for (int halving = 0; halving < most_halvings && status != GSL_SUCCESS; ++halving) {
            gsl_vector_set(start.get(), 1, gsl_vector_get(start.get(), 1) / 2);
            gsl_vector_scale(reach.get(), 0.5);
            status = gsl_multimin_fminimizer_set(simplex.get(), &function, start.get(), reach.get());
        }
        for (int step = 0;
             step < most_steps && status == GSL_SUCCESS && gsl_multimin_fminimizer_size(simplex.get()) > size; ++step) {
            status = gsl_multimin_fminimizer_iterate(simplex.get());
        }
        double const now = gsl_multimin_fminimizer_minimum(simplex.get());
        constexpr double rounding = 1e-13;
        if (std::isfinite(now) && before - now <= rounding * std::abs(now)) {
            return data.unscaled(gsl_vector_get(simplex->x, 0), gsl_vector_get(simplex->x, 1));
        }
        before = now;
        gsl_vector_memcpy(start.get(), simplex->x);
        gsl_vector_set_all(reach.get(), 0.1);
    }
    return std::nullopt;
}

}  // namespace overturn
