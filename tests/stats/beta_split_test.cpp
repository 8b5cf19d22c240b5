// Requirement R-705: beta_R (waves) and beta_U (what is not known of the body) are distinguished from one sampled
// campaign.
#include "stats/beta_split.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>
#include <gtest/gtest.h>

#include "core/random_stream.hpp"
#include "stats/detail/probit_regression.hpp"

namespace overturn {
namespace {

constexpr double median = 8;
constexpr double beta_r = 0.25;

// Trials of the model itself: ln of a body's capacity is normal about ln median + sum c_k z_k.
std::vector<DrawnTrial> simulated(std::uint64_t seed, std::size_t count, std::vector<double> const& shifts) {
    std::vector<DrawnTrial> trials;
    for (std::size_t i = 0; i < count; ++i) {
        RandomStream stream(seed, i, Purpose::body_scatter);
        DrawnTrial trial;
        trial.wave = static_cast<std::int64_t>(i);
        double capacity = std::log(median) + gsl_ran_gaussian(stream.gsl(), beta_r);
        for (double const shift : shifts) {
            trial.scores.push_back(gsl_ran_ugaussian(stream.gsl()));
            capacity += shift * trial.scores.back();
        }
        trial.log_intensity = std::log(median) + gsl_ran_flat(stream.gsl(), -1, 1);
        trial.overturned = trial.log_intensity > capacity;
        trials.push_back(trial);
    }
    return trials;
}

// Known answer: the shifts that made the trials come back within four of the stated standard errors.
TEST(BetaSplit, FindsWhatMadeTheTrials) {
    std::vector<double> const shifts{0.2, -0.1};
    auto const split = split_beta(simulated(1, 40000, shifts));
    ASSERT_TRUE(split);
    for (std::size_t k = 0; k < shifts.size(); ++k) {
        EXPECT_NEAR(split->per_score[k], shifts[k], 4 * split->per_score_error[k]);
        EXPECT_LT(split->per_score_error[k], 0.01);
    }
    EXPECT_NEAR(split->beta_r, beta_r, 0.01);
    EXPECT_NEAR(split->beta_u, std::hypot(0.2, 0.1), 0.01);
}

// Closed form: E shift^2 = c^2 + error^2, which is taken off; what is left of nothing is not below nothing.
TEST(BetaSplit, TakesOffWhatChanceAdds) {
    for (auto const& shifts : {std::vector<double>{0.2, -0.1}, {0.05}, {0.0, 0.0}}) {
        auto const split = split_beta(simulated(3, 400, shifts));
        ASSERT_TRUE(split);
        double squares = 0;
        for (std::size_t k = 0; k < shifts.size(); ++k) {
            squares +=
                split->per_score[k] * split->per_score[k] - split->per_score_error[k] * split->per_score_error[k];
        }
        EXPECT_NEAR(split->beta_u * split->beta_u, std::max(0.0, squares), 1e-12);
    }
}

// Closed form: of k falls in n waves of one trial each Phi(b) = k / n = p, and b's variance is p q / ((n - 1)
// phi(b)^2).
TEST(ProbitRegression, ScatterOfWavesIsTheBinomialOne) {
    constexpr int waves = 20;
    constexpr int fell = 6;
    ProbitDesign design{Eigen::MatrixXd::Ones(waves, 1), {}, {}};
    for (int i = 0; i < waves; ++i) {
        design.overturned.push_back(i < fell);
        design.waves.push_back(i);
    }
    auto const fit = regress(design);
    ASSERT_TRUE(fit);

    double const b = gsl_cdf_ugaussian_Pinv(0.3);
    EXPECT_NEAR(fit->coefficients[0], b, 1e-9);
    EXPECT_NEAR(fit->covariance(0, 0), 0.3 * 0.7 / (waves - 1) / std::pow(gsl_ran_ugaussian_pdf(b), 2), 1e-9);
}

// Property: over 300 repetitions the standard errors are those of the estimates, and beta_U^2 is not biased upwards.
TEST(BetaSplit, KnowsItsOwnError) {
    double sum = 0;
    double squares = 0;
    double stated = 0;
    double u_squares = 0;
    constexpr int repetitions = 300;
    for (std::uint64_t seed = 0; seed < repetitions; ++seed) {
        auto const split = split_beta(simulated(100 + seed, 600, {0.15}));
        ASSERT_TRUE(split);
        sum += split->per_score[0];
        squares += split->per_score[0] * split->per_score[0];
        stated += split->per_score_error[0];
        u_squares += split->beta_u * split->beta_u;
    }
    double const mean = sum / repetitions;
    double const spread = std::sqrt(squares / repetitions - mean * mean);
    EXPECT_NEAR(mean, 0.15, 4 * spread / std::sqrt(repetitions));
    EXPECT_NEAR(stated / repetitions / spread, 1, 0.15);
    EXPECT_NEAR(u_squares / repetitions, 0.15 * 0.15, 4 * 2 * 0.15 * spread / std::sqrt(repetitions));
}

TEST(BetaSplit, OfDrawsThatDoNothingIsNearNothing) {
    auto const split = split_beta(simulated(7, 40000, {0.0}));
    ASSERT_TRUE(split);
    EXPECT_LT(split->beta_u, 4 * split->per_score_error[0]);
}

TEST(BetaSplit, IsNothingWhereNoCurveIs) {
    auto all = simulated(1, 100, {0.1});
    for (auto& trial : all) {
        trial.overturned = false;
    }
    EXPECT_FALSE(split_beta(all));
    for (auto& trial : all) {
        trial.overturned = trial.log_intensity > std::log(median);  // separated
    }
    EXPECT_FALSE(split_beta(all));
    for (auto& trial : all) {
        trial.overturned = gsl_cdf_ugaussian_P(trial.scores[0]) > 0.5 && trial.log_intensity < std::log(median);
    }
    EXPECT_FALSE(split_beta(all));
    EXPECT_FALSE(split_beta({}));
}

// Property: trials that repeat what their wave has said already make nothing surer.
TEST(BetaSplit, RepeatedTrialsOfAWaveTeachNothing) {
    auto const once = simulated(7, 2000, {0.2});
    std::vector<DrawnTrial> often;
    for (auto const& trial : once) {
        often.insert(often.end(), 4, trial);
    }
    auto const single = split_beta(once);
    auto const repeated = split_beta(often);
    ASSERT_TRUE(single && repeated);

    EXPECT_NEAR(repeated->per_score[0], single->per_score[0], 1e-9);
    EXPECT_NEAR(repeated->per_score_error[0], single->per_score_error[0], 1e-9);
    EXPECT_NEAR(repeated->beta_u, single->beta_u, 1e-9);
}

}  // namespace
}  // namespace overturn
