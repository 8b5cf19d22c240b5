// Requirement R-106, R-1104: a wave that misses its acceptance rule is never used: its trials are failed rows with that
// reason, and everybody is told how many there are. How right a wave is, is stored where each body rocks.
#include "campaign/wave_check.hpp"

#include <cmath>
#include <span>

#include "results/statistics.hpp"
#include "results/stripe_table.hpp"
#include "support/campaign_rows.hpp"
#include "support/campaigns.hpp"
#include "support/expect_input_error.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

std::string waves(std::string const& keys) {
    return "[waves]\nsource='spectrum-compatible'\ncount=4\nduration='60 s'\n" + keys
           + "[waves.target]\nspectrum='mlit-ch1'\ntime_scale=0.632\n"
             "[waves.envelope]\nrise='5 s'\nlevel_end='30 s'\nend='55 s'\n";
}

std::string const rest = testing::type_a + testing::type_b + testing::levels("values=['600 gal']\n");

TEST(WaveCheck, AcceptedWavesAreUsed) {
    auto const spec = testing::campaign_from(waves("acceptance='srp-3.7.1'\n") + rest);
    auto const rows = testing::rows_of(spec);

    Statistics statistics(spec);
    for (std::size_t w = 0; w < rows.waves.size(); ++w) {
        auto const& row = rows.waves[w];
        EXPECT_EQ(row.accepted, Accepted::yes);
        EXPECT_EQ(row.acceptance_failures, 0);
        EXPECT_GE(row.match_lowest_ratio, 0.9);
        EXPECT_LE(row.match_highest_ratio, 1.3);
        EXPECT_LE(row.match_longest_below, 9);
        EXPECT_GT(row.duration_5_95_s, row.duration_5_75_s);
        EXPECT_LT(std::abs(row.residual_velocity_mps), 1e-6 * row.pgv_mps);
        statistics.add(row, std::span(rows.measures).subspan(w * spec.bodies.size(), spec.bodies.size()));
    }
    for (auto const& row : rows.measures) {
        EXPECT_LE(row.band_mean_misfit, 0.05);
        EXPECT_GT(row.band_mean_misfit, 0);
        EXPECT_NEAR(row.band_mean_ratio, 1.02, 0.04);
    }
    for (auto const& row : rows.trials.rows) {
        EXPECT_NE(row.verdict, Verdict::failed);
    }
    EXPECT_EQ(statistics.waves().text("srp-3.7.1"), "4 waves, 0 not accepted by srp-3.7.1");
}

TEST(WaveCheck, OthersAreFailedRowsWithTheirReason) {
    auto const spec = testing::campaign_from(waves("acceptance='srp-3.7.1'\nmatch_iterations=1\n") + rest);
    auto const rows = testing::rows_of(spec);

    Statistics statistics(spec);
    for (std::size_t w = 0; w < rows.waves.size(); ++w) {
        auto const& row = rows.waves[w];
        EXPECT_EQ(row.failed, 0) << "it was made";
        EXPECT_EQ(row.accepted, Accepted::no);
        EXPECT_NE(row.acceptance_failures, 0);
        statistics.add(row, std::span(rows.measures).subspan(w * spec.bodies.size(), spec.bodies.size()));
    }
    for (auto const& row : rows.trials.rows) {
        EXPECT_EQ(row.verdict, Verdict::failed);
        EXPECT_EQ(row.failure, FailureReason::wave_not_accepted);
        EXPECT_EQ(row.steps, 0);
        statistics.add(row);
    }
    EXPECT_EQ(statistics.bodies()[0].stripes[0].failed, 4);
    EXPECT_NE(
        stripe_table(spec, statistics).find("4 waves, 4 not accepted by srp-3.7.1 (their trials are failed rows)"),
        std::string::npos);
}

TEST(WaveCheck, WithoutARuleNoWaveIsRefused) {
    auto const spec = testing::campaign_from(waves("match_iterations=1\n") + rest);
    for (auto const& row : testing::rows_of(spec).waves) {
        EXPECT_EQ(row.accepted, Accepted::not_asked);
        EXPECT_GT(row.match_mean_misfit, 0.02) << "and is reported on all the same";
    }
}

// The clause on a body's band is the mean misfit over [0.05, 0.5] sqrt(R in cm), by hand from the ratios.
TEST(WaveCheck, BandIsThatOfTheBody) {
    auto const spec = testing::campaign_from(waves("acceptance='japan'\n") + rest);
    auto const made = spec.source->make(spec.seed, 0);
    auto const check = check_wave(made, spec.bodies, spec.measures.radius_unit);
    double const root = std::sqrt(100 * spec.bodies[0].body.radius_m());
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < made.ratios.size(); ++i) {
        if (made.judged_periods_s[i] >= 0.05 * root && made.judged_periods_s[i] <= 0.5 * root) {
            sum += std::abs(made.ratios[i] - 1);
            count += 1;
        }
    }
    ASSERT_EQ(check.bands.size(), 2U);
    EXPECT_TRUE(testing::near(check.bands[0].mean_misfit, sum / count, testing::exact_formula));
    EXPECT_EQ(check.clauses[check.clauses.size() - 2].name, "rocking band [T0, T1] of type-a");
    EXPECT_TRUE(testing::near(check.clauses[check.clauses.size() - 2].figure, sum / count, testing::exact_formula));
}

// A body that rocks at longer periods than its waves are matched to cannot be judged, and is told so at once.
TEST(WaveCheck, RefusesABodyBeyondTheTarget) {
    auto const big =
        "[[bodies]]\nname='tower'\nmass='900 t'\nbase_width='6 m'\ncentre_height='9 m'\n"
        "inertia='uniform-block'\n"
        + testing::levels("values=['600 gal']\n");
    testing::expect_input_error([&] { (void)testing::campaign_from(waves("acceptance='srp-3.7.1'\n") + big); },
                                "c.toml:6:", "'tower'", "T1");
    EXPECT_NO_THROW((void)testing::campaign_from(waves("") + big));
}

}  // namespace
}  // namespace overturn
