// Requirement: 95 % intervals of HCLPF hold the truth in about 95 % of repeated campaigns whose bodies
// were drawn: the split into beta_R and beta_U is resampled with everything else.
#include <array>
#include <cmath>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>
#include <gtest/gtest.h>

#include "core/keyed_permutation.hpp"
#include "core/random_stream.hpp"
#include "stats/detail/probit_regression.hpp"
#include "stats/fragility.hpp"

namespace overturn {
namespace {

constexpr double log_median = 2.3;
constexpr double beta_r = 0.18;
constexpr std::array shifts{0.11, -0.05, 0.03};
constexpr std::array levels{6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 13.0, 15.0};
constexpr int replicates = 400;

enum class Draws { independent, sliced };

struct Campaign {
    std::vector<SingleTrial> trials;
    std::vector<DrawnTrial> drawn;
};

// Waves with a capacity of their own at all levels, bodies drawn by wave: the model itself, so that the truth is known
// in closed form.
Campaign campaign(int waves, Draws draws, std::uint64_t repetition) {
    Campaign made;
    for (int wave = 0; wave < waves; ++wave) {
        auto const id = static_cast<std::uint64_t>(wave);
        RandomStream stream(43, id, Purpose::body_scatter, repetition);
        double capacity = log_median + gsl_ran_gaussian(stream.gsl(), beta_r);
        std::vector<double> scores;
        for (std::size_t k = 0; k < shifts.size(); ++k) {
            double u = gsl_rng_uniform_pos(stream.gsl());
            if (draws == Draws::sliced) {
                auto const count = static_cast<std::uint64_t>(waves);
                KeyedPermutation const slice(43, repetition, Purpose::body_scatter, k, count);
                u = (static_cast<double>(slice(id)) + u) / waves;
            }
            scores.push_back(gsl_cdf_ugaussian_Pinv(u));
            capacity += shifts.at(k) * scores.back();
        }
        for (double const level : levels) {
            bool const fell = std::log(level) > capacity;
            made.trials.push_back({level, wave, fell, wave});
            made.drawn.push_back({std::log(level), scores, fell, wave});
        }
    }
    return made;
}

struct Truth {
    double beta_u = std::sqrt(0.11 * 0.11 + 0.05 * 0.05 + 0.03 * 0.03);
    double hclpf = std::exp(log_median - 1.645 * (beta_r + beta_u));
    double five_percent_point = std::exp(log_median - 1.645 * std::hypot(beta_r, beta_u));
};

bool holds(Interval const& interval, double value) { return interval.lower <= value && value <= interval.upper; }

struct Shares {
    double median = 0, beta = 0, five = 0, hclpf = 0, fixed_hclpf = 0;
};

Shares coverage(int waves, Draws draws, int repetitions) {
    Truth const truth;
    Shares hits;
    for (std::uint64_t r = 0; r < static_cast<std::uint64_t>(repetitions); ++r) {
        auto const made = campaign(waves, draws, r);
        FragilityRequest request;
        request.bootstrap = {19, r, replicates};
        request.drawn = true;
        request.draws_balanced = draws == Draws::sliced;
        request.split = split_beta(made.drawn, request.bootstrap);
        FragilityData data;
        data.points = points_of(made.trials, 64);
        data.trials = made.trials;
        data.waves_shared = true;
        auto const fit = fit_fragility(data, request);
        auto const& ends = fit.intervals();
        hits.median += holds(ends.median, std::exp(log_median)) ? 1 : 0;
        hits.beta += holds(ends.beta, std::hypot(beta_r, truth.beta_u)) ? 1 : 0;
        hits.five += holds(ends.five_percent_point, truth.five_percent_point) ? 1 : 0;
        hits.hclpf += holds(*ends.hclpf, truth.hclpf) ? 1 : 0;
        double const margin = std::exp(-1.645 * (fit.beta_r() + fit.beta_u - fit.line->beta()));
        Interval const fixed{margin * ends.five_percent_point.lower, margin * ends.five_percent_point.upper};
        hits.fixed_hclpf += holds(fixed, truth.hclpf) ? 1 : 0;
    }
    for (double* share : {&hits.median, &hits.beta, &hits.five, &hits.hclpf, &hits.fixed_hclpf}) {
        *share /= repetitions;
    }
    return hits;
}

/// 400 campaigns: two standard errors of a share of 95 % are 2.2 %. The control: with the split held fixed, as if it
/// were known, HCLPF is held less often.
TEST(HclpfCoverage, IsNominalWhereTheSplitIsResampled) {
    auto const hits = coverage(200, Draws::independent, 400);
    RecordProperty("hclpf", std::to_string(hits.hclpf));

    EXPECT_NEAR(hits.median, 0.95, 0.025);
    EXPECT_NEAR(hits.beta, 0.95, 0.025);
    EXPECT_NEAR(hits.five, 0.95, 0.025);
    EXPECT_NEAR(hits.hclpf, 0.95, 0.025);
    EXPECT_LT(hits.fixed_hclpf, hits.hclpf);
}

/// A Latin hypercube leaves the draws' means to no chance; an interval that puts that chance back is too wide.
TEST(HclpfCoverage, IsNominalForSlicedDraws) {
    auto const hits = coverage(200, Draws::sliced, 400);

    EXPECT_NEAR(hits.median, 0.95, 0.025);
    EXPECT_GE(hits.beta, 0.925);
    EXPECT_NEAR(hits.hclpf, 0.95, 0.03);
}

double coverage_of_few(int waves, bool of_median, int repetitions) {
    constexpr double beta = 0.3;
    double const truth = of_median ? std::exp(log_median) : std::exp(log_median - 1.645 * beta);
    int hits = 0;
    int curves = 0;
    for (std::uint64_t r = 0; r < static_cast<std::uint64_t>(repetitions); ++r) {
        std::vector<SingleTrial> trials;
        for (int wave = 0; wave < waves; ++wave) {
            RandomStream stream(47, static_cast<std::uint64_t>(wave), Purpose::body_scatter, r);
            double const capacity = log_median + gsl_ran_gaussian(stream.gsl(), beta);
            for (int k = 0; k < 16; ++k) {
                double const level = log_median + (k - 7.5) * 0.1;
                trials.push_back({std::exp(level), wave, level > capacity, wave});
            }
        }
        FragilityRequest request;
        request.bootstrap = {19, r, 1000};
        FragilityData data;
        data.points = points_of(trials, 64);
        data.trials = trials;
        data.waves_shared = true;
        auto const fit = fit_fragility(data, request);
        if (fit.identifiable()) {
            ++curves;
            hits += holds(of_median ? fit.intervals().median : fit.intervals().five_percent_point, truth) ? 1 : 0;
        }
    }
    return static_cast<double>(hits) / curves;
}

/// Requirement R-703: intervals of few waves hold the truth as often as they say, and no less.
TEST(FewWaves, IntervalsHoldTheTruthAsOftenAsTheySay) {
    for (int const waves : {5, 10, 20}) {
        for (bool const of_median : {true, false}) {
            auto const share = coverage_of_few(waves, of_median, 200);
            RecordProperty(std::to_string(waves) + (of_median ? "median" : "five"), std::to_string(share));
            EXPECT_GE(share, 0.925) << waves << (of_median ? " waves, median" : " waves, 5 % point");
        }
    }
}

/// One Newton step lands where refitting the resampled trials does, far within their scatter.
TEST(HclpfCoverage, OneStepIsNearTheFullRefit) {
    auto const made = campaign(200, Draws::independent, 1);
    ProbitDesign design;
    design.columns.resize(static_cast<Eigen::Index>(made.drawn.size()), 3);
    for (Eigen::Index i = 0; i < design.columns.rows(); ++i) {
        auto const& trial = made.drawn[static_cast<std::size_t>(i)];
        design.columns.row(i) << 1, trial.log_intensity - log_median, trial.scores[0];
        design.overturned.push_back(trial.overturned);
        design.waves.push_back(trial.wave);
    }
    auto const fit = regress(design);
    ASSERT_TRUE(fit);
    BootstrapKey const key{3, 0, 50};
    double worst = 0;
    for (int r = 0; r < key.replicates; ++r) {
        auto const times = times_drawn(key, r, 200);
        ProbitDesign drawn;
        std::vector<Eigen::Index> rows;
        for (Eigen::Index i = 0; i < design.columns.rows(); ++i) {
            auto const at = static_cast<std::size_t>(i);
            for (int n = 0; n < times[static_cast<std::size_t>(design.waves[at])]; ++n) {
                rows.push_back(i);
                drawn.overturned.push_back(design.overturned[at]);
                drawn.waves.push_back(design.waves[at]);
            }
        }
        drawn.columns = design.columns(rows, Eigen::all);
        auto const full = regress(drawn);
        auto const step = fit->reweighted(times);
        ASSERT_TRUE(full && step);
        for (Eigen::Index k = 0; k < 3; ++k) {
            double const error = std::sqrt(fit->covariance(k, k));
            worst = std::max(worst, std::abs((*step)[k] - full->coefficients[k]) / error);
        }
    }
    EXPECT_LT(worst, 0.5);
    EXPECT_GT(worst, 0) << "else it is no step";
}

}  // namespace
}  // namespace overturn
