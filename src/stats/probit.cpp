#include "stats/probit.hpp"

#include <algorithm>
#include <cmath>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_multimin.h>
#include <gsl/gsl_multiroots.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_sf_erf.h>

#include "stats/detail/gsl_quiet.hpp"

namespace overturn {
namespace {

// Beyond this GSL's distribution function runs out of range and its asymptotic relatives take over.
constexpr double far_tail = 30;

// phi(z) / Phi(-z): the normal hazard.
double hazard(double z) { return z < far_tail ? gsl_ran_ugaussian_pdf(z) / gsl_cdf_ugaussian_Q(z) : gsl_sf_hazard(z); }

double log_upper_tail(double z) {
    return z < far_tail ? std::log(gsl_cdf_ugaussian_Q(z)) : gsl_sf_log_erfc(z / M_SQRT2) - M_LN2;
}

// d score / d z, never above 0: the likelihood is concave (Pratt 1981).
double curvature(FragilityPoint const& point, double z) {
    double value = 0;
    if (point.overturned > 0) {
        double const h = hazard(-z);
        value -= point.overturned * h * (h + z);
    }
    if (point.overturned < point.trials) {
        double const h = hazard(z);
        value -= (point.trials - point.overturned) * h * (h - z);
    }
    return value;
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

void evaluate(gsl_vector const* line, Scaled const& data, gsl_vector* f, gsl_matrix* jacobian) {
    double const a = gsl_vector_get(line, 0);
    double const b = gsl_vector_get(line, 1);
    double f0 = 0, f1 = 0, j00 = 0, j01 = 0, j11 = 0;
    for (auto const& point : data.points) {
        double const u = data.u(point);
        double const z = a + b * u;
        if (f != nullptr) {
            double const s = score(point, z) / data.trials;
            f0 += s;
            f1 += s * u;
        }
        if (jacobian != nullptr) {
            double const c = curvature(point, z) / data.trials;
            j00 += c;
            j01 += c * u;
            j11 += c * u * u;
        }
    }
    if (f != nullptr) {
        gsl_vector_set(f, 0, f0);
        gsl_vector_set(f, 1, f1);
    }
    if (jacobian != nullptr) {
        gsl_matrix_set(jacobian, 0, 0, j00);
        gsl_matrix_set(jacobian, 0, 1, j01);
        gsl_matrix_set(jacobian, 1, 0, j01);
        gsl_matrix_set(jacobian, 1, 1, j11);
    }
}

int scores(gsl_vector const* line, void* data, gsl_vector* f) {
    evaluate(line, *static_cast<Scaled const*>(data), f, nullptr);
    return GSL_SUCCESS;
}
int curvatures(gsl_vector const* line, void* data, gsl_matrix* jacobian) {
    evaluate(line, *static_cast<Scaled const*>(data), nullptr, jacobian);
    return GSL_SUCCESS;
}
int both(gsl_vector const* line, void* data, gsl_vector* f, gsl_matrix* jacobian) {
    evaluate(line, *static_cast<Scaled const*>(data), f, jacobian);
    return GSL_SUCCESS;
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
        return point.trials * hazard(z(point)) * hazard(-z(point));
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

double score(FragilityPoint const& point, double z) {
    double value = 0;
    if (point.overturned > 0) {
        value += point.overturned * hazard(-z);
    }
    if (point.overturned < point.trials) {
        value -= (point.trials - point.overturned) * hazard(z);
    }
    return value;
}

double log_likelihood(std::span<FragilityPoint const> points, ProbitLine const& line) {
    double sum = 0;
    for (auto const& point : points) {
        sum += log_likelihood(point, line.at(point.log_intensity));
    }
    return sum;
}

struct ProbitSolver::Workspace {
    Workspace()
        : solver(gsl_multiroot_fdfsolver_alloc(gsl_multiroot_fdfsolver_hybridsj, 2)), start(gsl_vector_alloc(2)) {}
    ~Workspace() {
        gsl_vector_free(start);
        gsl_multiroot_fdfsolver_free(solver);
    }
    Workspace(Workspace const&) = delete;
    Workspace& operator=(Workspace const&) = delete;
    Workspace(Workspace&&) = delete;
    Workspace& operator=(Workspace&&) = delete;

    gsl_multiroot_fdfsolver* solver;
    gsl_vector* start;
};

ProbitSolver::ProbitSolver() : workspace_(std::make_unique<Workspace>()) {}
ProbitSolver::~ProbitSolver() = default;

std::optional<ProbitLine> ProbitSolver::fit(std::span<FragilityPoint const> points) {
    auto data = scaled(points);
    auto const sum = sum_of(points);
    auto& w = *workspace_;
    gsl_vector_set(w.start, 0, gsl_cdf_ugaussian_Pinv(sum.overturned / sum.trials));
    gsl_vector_set(w.start, 1, 1);
    gsl_multiroot_function_fdf equations{&scores, &curvatures, &both, 2, &data};
    constexpr double residual = 1e-12;  // of the score per trial
    constexpr double enough = 1e-8;     // where rounding allows no more
    constexpr int most_steps = 200;
    int status = gsl_multiroot_fdfsolver_set(w.solver, &equations, w.start);
    for (int step = 0; step < most_steps && status == GSL_SUCCESS; ++step) {
        if (gsl_multiroot_test_residual(w.solver->f, residual) == GSL_SUCCESS) {
            break;
        }
        status = gsl_multiroot_fdfsolver_iterate(w.solver);
    }
    if (gsl_multiroot_test_residual(w.solver->f, enough) != GSL_SUCCESS) {
        return std::nullopt;
    }
    return data.unscaled(gsl_vector_get(w.solver->x, 0), gsl_vector_get(w.solver->x, 1));
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
