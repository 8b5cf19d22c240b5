// Requirement R-703: 95 % intervals of median and beta hold the truth in 93 % to 97 % of 1000 repeated campaigns, and
// where levels share waves it takes resampled waves to do so.
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <gsl/gsl_randist.h>
#include <gtest/gtest.h>

#include "core/random_stream.hpp"
#include "stats/detail/profile_likelihood.hpp"
#include "stats/fragility.hpp"
#include "stats/precision.hpp"

namespace overturn {
namespace {

constexpr double median = 1.6;
constexpr double beta = 0.3;
constexpr double confidence = 0.95;
constexpr int repetitions = 1000;
constexpr int replicates = 400;

constexpr std::array levels{1.0, 1.2, 1.45, 1.75, 2.1, 2.5};

// One campaign: a wave's capacity has a part that all its levels share and a part that is drawn anew at each; at every
// level by itself P is the lognormal curve, whatever the share.
std::vector<SingleTrial> campaign(int waves, double shared, int repetition) {
    std::vector<SingleTrial> trials;
    for (int wave = 0; wave < waves; ++wave) {
        RandomStream stream(41, static_cast<std::uint64_t>(wave), Purpose::body_scatter,
                            static_cast<std::uint64_t>(repetition));
        double const common = gsl_ran_ugaussian(stream.gsl());
        for (double const level : levels) {
            double const own = gsl_ran_ugaussian(stream.gsl());
            double const capacity =
                std::log(median) + beta * (std::sqrt(shared) * common + std::sqrt(1 - shared) * own);
            trials.push_back({level, wave, std::log(level) > capacity});
        }
    }
    return trials;
}

struct Hits {
    int median = 0, beta = 0, hclpf = 0, of = 0;
    int beta_below = 0, beta_above = 0, hclpf_below = 0, hclpf_above = 0;  ///< where an interval lies that misses

    void add(Interval const& of_median, Interval const& of_beta, Interval const& of_hclpf) {
        double const low = median_of(-1.645);
        beta_below += of_beta.upper < overturn::beta ? 1 : 0;
        beta_above += of_beta.lower > overturn::beta ? 1 : 0;
        hclpf_below += of_hclpf.upper < low ? 1 : 0;
        hclpf_above += of_hclpf.lower > low ? 1 : 0;
        median += of_median.lower <= median_of(0) && median_of(0) <= of_median.upper ? 1 : 0;
        beta += of_beta.lower <= overturn::beta && overturn::beta <= of_beta.upper ? 1 : 0;
        hclpf += of_hclpf.lower <= low && low <= of_hclpf.upper ? 1 : 0;
        ++of;
    }
    static double median_of(double score) { return overturn::median * std::exp(score * overturn::beta); }
    [[nodiscard]] double share(int hits) const { return static_cast<double>(hits) / of; }
};

void expect_nominal(double share) {
    EXPECT_GE(share, 0.93);
    EXPECT_LE(share, 0.97);
}

struct Methods {
    Hits profile, by_waves, by_trials;
};

Methods covered(int waves, double shared) {
    Methods methods;
    for (int r = 0; r < repetitions; ++r) {
        auto const trials = campaign(waves, shared, r);
        auto const points = points_of(trials, 64);
        auto const line = fit_probit(points);
        if (!line) {
            continue;
        }
        ProfileLikelihood const profile(points, *line, confidence);
        BootstrapKey const key{17, static_cast<std::uint64_t>(r), replicates};
        auto const waves_drawn = bootstrap_waves(trials, *line, key);
        auto const trials_drawn = bootstrap_trials(points, *line, key);
        methods.profile.add(profile.intensity(0.5), profile.beta(), profile.intensity(0.05));
        auto const add = [](Hits& hits, Bootstrap const& b) {
            hits.add(b.intensity(0.5, confidence), b.beta(confidence), b.intensity(0.05, confidence));
        };
        add(methods.by_waves, waves_drawn);
        add(methods.by_trials, trials_drawn);
    }
    return methods;
}

/// Independent trials: both kinds of interval hold.
TEST(Coverage, IsNominalForIndependentTrials) {
    auto const methods = covered(100, 0);

    for (auto const* hits : {&methods.profile, &methods.by_trials, &methods.by_waves}) {
        EXPECT_EQ(hits->of, repetitions);
        expect_nominal(hits->share(hits->median));
        expect_nominal(hits->share(hits->beta));
    }
}

/// Levels that share waves: only resampled waves hold; the control, resampled trials, is far too sure of the median.
TEST(Coverage, NeedsWavesWhereLevelsShareThem) {
    auto const methods = covered(100, 0.8);

    EXPECT_EQ(methods.by_waves.of, repetitions);
    expect_nominal(methods.by_waves.share(methods.by_waves.median));
    expect_nominal(methods.by_waves.share(methods.by_waves.beta));
    expect_nominal(methods.by_waves.share(methods.by_waves.hclpf));
    EXPECT_LT(methods.by_trials.share(methods.by_trials.median), 0.85);
    EXPECT_LT(methods.profile.share(methods.profile.median), 0.85);
}

/// The likeliest beta is a little too small, and resampling repeats that: the plain middle of the replicates lies below
/// beta in 4.3 %, and above the 5 % point (the unsafe side) in 4.6 % of campaigns. Bias-corrected it is at most 3.2 %
/// on any side; the limits are 2.5 % and two standard errors of 1000 campaigns.
TEST(Coverage, MissesComeEquallyOnBothSides) {
    auto const methods = covered(100, 0.8);

    auto const& hits = methods.by_waves;
    for (int const misses : {hits.beta_below, hits.beta_above, hits.hclpf_below, hits.hclpf_above}) {
        EXPECT_GE(hits.share(misses), 0.008);
        EXPECT_LE(hits.share(misses), 0.036);
    }
}

// The sizes at which a campaign of 1000 waves may end, and its end.
std::vector<std::int64_t> ends_of_campaign() {
    constexpr std::int64_t most = 1000;
    auto sizes = looks(1, 32, most);
    sizes.push_back(most);
    return sizes;
}

// Ended as soon as the median's interval is as narrow as was asked, that interval still holds the median.
TEST(Coverage, HoldsWhereTheMedianTargetEndsTheCampaign) {
    constexpr double target = 0.055;
    constexpr double shared = 0.8;
    std::map<std::int64_t, int> ended_at;
    Hits hits;
    for (int r = 0; r < repetitions; ++r) {
        for (auto const waves : ends_of_campaign()) {
            auto const trials = campaign(static_cast<int>(waves), shared, r);
            auto const line = fit_probit(points_of(trials, 64));
            if (!line) {
                continue;
            }
            auto const drawn = bootstrap_waves(trials, *line, {17, static_cast<std::uint64_t>(r), replicates});
            auto const ends = drawn.intensity(0.5, confidence);
            if (ends.upper - ends.lower <= 2 * target * std::exp(line->log_median())) {
                hits.add(ends, drawn.beta(confidence), drawn.intensity(0.05, confidence));
                ++ended_at[waves];
                break;
            }
        }
    }
    EXPECT_EQ(hits.of, repetitions);
    EXPECT_GT(ended_at.size(), 1U) << "the rule decides";
    expect_nominal(hits.share(hits.median));
}

}  // namespace
}  // namespace overturn
