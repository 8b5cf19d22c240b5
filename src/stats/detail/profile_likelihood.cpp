#include "stats/detail/profile_likelihood.hpp"

#include <cmath>
#include <memory>
#include <numeric>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_roots.h>

#include "core/error.hpp"
#include "stats/detail/extended_real.hpp"
#include "stats/detail/gsl_quiet.hpp"

namespace overturn {
namespace {

struct SolverDeleter {
    void operator()(gsl_root_fsolver* solver) const { gsl_root_fsolver_free(solver); }
};

// The root of a continuous function between two values at which its signs differ.
template <class Function> double root_between(Function const& function, double low, double high) {
    GslQuiet const quiet;
    std::unique_ptr<gsl_root_fsolver, SolverDeleter> const solver(gsl_root_fsolver_alloc(gsl_root_fsolver_brent));
    gsl_function wrapped{[](double x, void* data) { return (*static_cast<Function const*>(data))(x); },
                         const_cast<Function*>(&function)};
    if (gsl_root_fsolver_set(solver.get(), &wrapped, std::min(low, high), std::max(low, high)) != GSL_SUCCESS) {
        return unknown;
    }
    constexpr double precise = 1e-11;
    constexpr int most_steps = 200;
    for (int step = 0; step < most_steps; ++step) {
        if (gsl_root_fsolver_iterate(solver.get()) != GSL_SUCCESS
            || gsl_root_test_interval(gsl_root_fsolver_x_lower(solver.get()), gsl_root_fsolver_x_upper(solver.get()),
                                      precise, precise)
                   == GSL_SUCCESS) {
            break;
        }
    }
    return gsl_root_fsolver_root(solver.get());
}

}  // namespace

ProfileLikelihood::ProfileLikelihood(std::span<FragilityPoint const> points, ProbitLine const& best, double confidence)
    : points_(points),
      best_(best),
      best_likelihood_(log_likelihood(points, best)),
      allowed_(gsl_cdf_chisq_Pinv(confidence, 1)) {
    OVERTURN_EXPECT(best.slope > 0);
    auto const sum = sum_of(points);
    mean_ = sum.overturned / sum.trials;
    rises_ = flat_deviance(mean_) > allowed_;
}

double ProfileLikelihood::flat_deviance(double probability) const {
    return deviance(log_likelihood(points_, {gsl_cdf_ugaussian_Pinv(probability), 0}));
}

// The likelihood is concave along the family, so that its slope falls through one zero: Newton's steps towards it, kept
// between the values that are known to lie on either side.
double ProfileLikelihood::best_of(Family const& family, Sign sign, double guess) const {
    auto const slope = [&](double s) {
        ScoreSlope sum;
        for (auto const& point : points_) {
            double const direction = family.direction.at(point.log_intensity);
            auto const of = score_slope(point, family.offset.at(point.log_intensity) + s * direction);
            sum.score += direction * of.score;
            sum.fall += direction * direction * of.fall;
        }
        return sum;
    };
    auto const value = [&](double s) {
        return log_likelihood(points_, {family.offset.intercept + s * family.direction.intercept,
                                        family.offset.slope + s * family.direction.slope});
    };
    if (sign == Sign::not_negative && slope(0).score <= 0) {
        return value(0);
    }
    double low = sign == Sign::not_negative ? 0 : -infinite;
    double high = infinite;
    double at = guess;
    double reach = std::max(std::abs(guess), 1e-3);
    constexpr int most_steps = 200;
    constexpr double precise = 1e-11;
    for (int step = 0; step < most_steps; ++step) {
        auto const [score, fall] = slope(at);
        if (score == 0) {
            break;
        }
        (score > 0 ? low : high) = at;
        double next = at + score / fall;
        if (!(next > low && next < high) || std::abs(next - at) > reach) {
            bool const bracketed = std::isfinite(low) && std::isfinite(high);
            next = bracketed ? std::midpoint(low, high) : at + (score > 0 ? reach : -reach);
            reach *= 2;
        }
        bool const arrived = std::abs(next - at) <= precise * (1 + std::abs(at));
        at = next;
        if (arrived) {
            break;
        }
    }
    return value(at);
}

// From the maximum outwards: the first value whose deviance is more than allowed, refined.
template <class Profile> double ProfileLikelihood::end(Profile const& profile, double from, double step) const {
    auto const excess = [&](double value) { return deviance(profile(value)) - allowed_; };
    double inside = from;
    constexpr int most_doublings = 60;
    for (int i = 0; i < most_doublings; ++i, step *= 2) {
        if (excess(inside + step) > 0) {
            return root_between(excess, inside, inside + step);
        }
        inside += step;
    }
    return step > 0 ? infinite : -infinite;
}

Interval ProfileLikelihood::beta() const {
    double const middle = sum_of(points_).log_intensity;
    // About the middle of the data level and slope hardly depend on each other.
    auto const profile = [&](double log_slope) {
        double const slope = std::exp(log_slope);
        return best_of({{-slope * middle, slope}, {1, 0}}, Sign::any, best_.at(middle));
    };
    double const from = std::log(best_.slope);
    constexpr double step = 0.05;
    return {std::exp(-end(profile, from, step)), rises_ ? std::exp(-end(profile, from, -step)) : infinite};
}

Interval ProfileLikelihood::intensity(double probability) const {
    double const q = gsl_cdf_ugaussian_Pinv(probability);
    auto const profile = [&](double log_intensity) {
        return best_of({{q, 0}, {-log_intensity, 1}}, Sign::not_negative, best_.slope);
    };
    double const from = (q - best_.intercept) / best_.slope;
    double const step = 0.05 * best_.beta();
    // Far away only a curve without slope remains, and P = probability bounds it on one side.
    bool const above = flat_deviance(std::min(mean_, probability)) > allowed_;
    bool const below = flat_deviance(std::max(mean_, probability)) > allowed_;
    return {below ? std::exp(end(profile, from, -step)) : 0, above ? std::exp(end(profile, from, step)) : infinite};
}

Interval ProfileLikelihood::probability(double intensity) const {
    double const at = std::log(intensity);
    auto const profile = [&](double z) { return best_of({{z, 0}, {-at, 1}}, Sign::not_negative, best_.slope); };
    double const from = best_.at(at);
    constexpr double step = 0.1;
    return {gsl_cdf_ugaussian_P(end(profile, from, -step)), gsl_cdf_ugaussian_P(end(profile, from, step))};
}

}  // namespace overturn
