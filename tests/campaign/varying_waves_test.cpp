// Requirement: rows tell which target a wave was matched to and its Sa at the campaign's periods; levels
// and curves can be stated by Sa; waves that share a target count as one where intervals are made.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

#include "campaign/warnings.hpp"
#include "results/analysis.hpp"
#include "results/schema.hpp"
#include "results/statistics.hpp"
#include "spectra/response_spectrum.hpp"
#include "support/campaign_rows.hpp"
#include "support/campaigns.hpp"
#include "support/expect_input_error.hpp"

namespace overturn {
namespace {

using testing::campaign_from;
using testing::expect_input_error;
using testing::rows_of;

std::string const varying_waves =
    "[waves]\nsource='spectrum-compatible'\ncount=4\nduration='20.48 s'\ntime_step='0.02 s'\n"
    "[waves.target]\nspectrum='mlit-ch1'\ntime_scale=0.632\nlongest='5 s'\n"
    "[waves.envelope]\nshape='jennings'\nrise='2 s'\nlevel_end='10 s'\nend='18 s'\n"
    "[waves.variability]\nsigma=0.6\ncorrelation='baker-jayaram-2008'\n";

// A column of /waves, as a file of the campaign holds it.
std::vector<double> stored(CampaignSpec const& spec, BlockRows const& block, std::string const& name) {
    auto const table = wave_table(spec);
    auto const column = std::ranges::find(table.columns, name, &Field::name);
    std::vector<double> values;
    for (auto const& row : block.waves) {
        std::memcpy(&values.emplace_back(), reinterpret_cast<std::byte const*>(&row) + column->offset, sizeof(double));
    }
    return values;
}

std::set<std::string> columns(CampaignSpec const& spec) {
    std::set<std::string> names;
    for (auto const& column : wave_table(spec).columns) {
        names.insert(column.name);
    }
    return names;
}

TEST(VaryingWaves, RowsHoldTheDrawnTarget) {
    auto const spec =
        campaign_from(varying_waves + "per_target=2\n" + testing::type_b + testing::levels("values=[6]\n"));
    auto const block = rows_of(spec);
    ASSERT_EQ(block.waves.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(block.waves[i].target, static_cast<std::int64_t>(i / 2));
        auto const made = spec.source->make(spec.seed, i);
        EXPECT_EQ(block.waves[i].epsilon[4], made.drawn->epsilon[4]);
        EXPECT_NEAR(0.6 * made.drawn->epsilon[4], std::log(made.drawn->shape.factor(2)), 1e-12) << "2 s is the fifth";
    }
    auto const names = columns(spec);
    for (auto const* name : {"target", "event", "epsilon_0.1s", "epsilon_2s", "epsilon_10s"}) {
        EXPECT_TRUE(names.contains(name)) << name;
    }
    EXPECT_FALSE(names.contains("sa_1"));
    EXPECT_FALSE(names.contains("epsilon_between_2s")) << "no parts are stated";
    auto const plain = columns(campaign_from(testing::quick_waves + testing::type_b + testing::levels("values=[6]\n")));
    for (auto const* name : {"target", "event", "epsilon_1", "epsilon_2s", "sa_average", "sa_1"}) {
        EXPECT_FALSE(plain.contains(name)) << name;
    }
}

// what a campaign stores of 1000 targets has mean 0, standard deviation 1 and the correlations of Baker and
// Jayaram (2008), beyond 0.109 s rho = 1 - sin(0.366 ln(T2 / T1)), within four standard errors: of a correlation that
// of Fisher's z = atanh(rho), 1 / sqrt(n - 3). (3 s lies midway between drawn periods, where targets are straight: of
// their population the standard deviation is 0.989 and rho(3 s, 4 s) 0.906 in place of 0.895, 1.8 of these errors.)
TEST(VaryingWaves, StoredDeviationsOfAThousandTargetsAreThoseOfTheModel) {
    constexpr int n = 1000;
    auto waves = varying_waves;
    waves.replace(waves.find("count=4"), 7, fmt::format("count={}\nmatch_tolerance=1", n));
    auto const spec = campaign_from(waves + testing::type_b + testing::levels("values=[0.1]\n")
                                    + "[measures]\nenergy=false\nwave_quality=false\n");
    auto const block = rows_of(spec);
    ASSERT_EQ(block.waves.size(), std::size_t{n});
    EXPECT_EQ(block.waves.back().target, n - 1);
    auto const mean_of = [](std::vector<double> const& a, std::vector<double> const& b) {
        return std::inner_product(a.begin(), a.end(), b.begin(), 0.0) / n;
    };
    std::vector<double> const ones(n, 1.0);
    auto const deviation = [&](std::vector<double> const& a) {
        double const mean = mean_of(a, ones);
        return std::sqrt(mean_of(a, a) - mean * mean);
    };
    for (double const period : epsilon_periods_s) {
        auto const epsilon = stored(spec, block, fmt::format("epsilon_{:g}s", period));
        EXPECT_NEAR(mean_of(epsilon, ones), 0, 4 / std::sqrt(n)) << period << " s";
        EXPECT_NEAR(deviation(epsilon), 1, 4 / std::sqrt(2.0 * n)) << period << " s";
    }
    for (auto const& [t1, t2] : {std::pair{1.0, 2.0}, std::pair{3.0, 4.0}}) {
        auto const a = stored(spec, block, fmt::format("epsilon_{:g}s", t1));
        auto const b = stored(spec, block, fmt::format("epsilon_{:g}s", t2));
        double const rho = (mean_of(a, b) - mean_of(a, ones) * mean_of(b, ones)) / (deviation(a) * deviation(b));
        double const stated = 1 - std::sin(0.366 * std::log(t2 / t1));
        EXPECT_NEAR(std::atanh(rho), std::atanh(stated), 4 / std::sqrt(n - 3.0)) << t1 << " s and " << t2 << " s";
    }
}

// where the parts are stated, so are their deviations, which make up the whole's in every row.
TEST(VaryingWaves, RowsHoldThePartsOfEventAndTarget) {
    auto waves = varying_waves;
    waves.replace(waves.find("sigma=0.6"), 9, "between=0.3\nwithin=0.4\ntargets_per_event=2");
    auto const spec = campaign_from(waves + testing::type_b + testing::levels("values=[0.1]\n"));
    auto const block = rows_of(spec);
    for (double const period : epsilon_periods_s) {
        auto const epsilon = stored(spec, block, fmt::format("epsilon_{:g}s", period));
        auto const between = stored(spec, block, fmt::format("epsilon_between_{:g}s", period));
        auto const within = stored(spec, block, fmt::format("epsilon_within_{:g}s", period));
        for (std::size_t i = 0; i < epsilon.size(); ++i) {
            EXPECT_NEAR(0.5 * epsilon[i], 0.3 * between[i] + 0.4 * within[i], 1e-12) << period << " s";
        }
        EXPECT_EQ(between[0], between[1]);
        EXPECT_NE(between[1], between[2]);
        EXPECT_NE(within[0], within[1]);
    }
}

// Against the response spectrum of the wave that the source makes.
TEST(VaryingWaves, SaIsMeasuredAtTheCampaignsPeriodsAndLevelsScaleByIt) {
    auto const spec = campaign_from(testing::quick_waves + testing::type_b
                                    + "[levels]\nmeasure='sa'\nperiod='1.5 s'\nvalues=['200 gal', '400 gal']\n"
                                      "[measures]\nsa_periods=['0.5 s', '3 s']\nsa_band=['0.5 s', '2 s']\n");
    EXPECT_EQ(spec.measures.sa_periods_s, (std::vector{0.5, 1.5, 3.0})) << "the levels' own is measured too";
    auto const block = rows_of(spec);
    auto const motion = spec.source->make(spec.seed, 1).motion;
    auto const spectrum =
        response_spectrum(motion.horizontal_mps2, motion.time_step_s, std::vector{0.5, 1.5, 3.0}, 0.05);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(block.waves[1].sa_mps2[i] / spectrum.psa_mps2[i], 1, 1e-12);
    }
    for (auto const& trial : block.trials.rows) {
        auto const& wave = block.waves[static_cast<std::size_t>(trial.wave)];
        EXPECT_NEAR(trial.scale * wave.sa_mps2[1], trial.amplitude, 1e-12);
    }
    // The geometric mean of a smooth spectrum lies within its range and is that of its logarithms.
    auto const band = log_periods_per_decade(0.5, 2, 30);
    auto const over = response_spectrum(motion.horizontal_mps2, motion.time_step_s, band, 0.05);
    double logs = 0;
    for (double const psa : over.psa_mps2) {
        logs += std::log(psa) / static_cast<double>(band.size());
    }
    EXPECT_NEAR(block.waves[1].sa_average_mps2 / std::exp(logs), 1, 1e-12);
    EXPECT_EQ(columns(spec).count("sa_1.5s"), 1U);
    EXPECT_EQ(columns(spec).count("sa_average"), 1U);

    Statistics statistics(spec);
    statistics.add(block);
    std::vector<std::string> labels;
    auto const analysis = analyse(spec, statistics, {.confidence = 0.95, .replicates = 20});
    for (auto const& fit : analysis.front().fragility) {
        labels.push_back(fit.label);
    }
    EXPECT_EQ(labels, (std::vector<std::string>{"sa(1.5 s)", "pga", "pgv", "sa_average", "sa(0.5 s)", "sa(3 s)",
                                                "v_wes", "ou_v_e", "v_wes_ratio"}));
    auto const singles = statistics.measured().singles(0, sa_measure(2));
    ASSERT_FALSE(singles.empty());
    EXPECT_DOUBLE_EQ(singles[0].intensity, block.trials.rows[0].scale * block.waves[0].sa_mps2[2]);
}

//
TEST(VaryingWaves, WavesOfATargetAreResampledTogetherAndThatIsReported) {
    auto const spec =
        campaign_from(varying_waves + "per_target=2\n" + testing::type_b + testing::levels("values=[6, 12]\n"));
    Statistics statistics(spec);
    statistics.add(rows_of(spec));
    std::set<std::int64_t> groups, waves;
    for (auto const& trial : statistics.measured().singles(0, measure_named("level"))) {
        groups.insert(trial.wave);
        waves.insert(trial.id);
    }
    std::set<std::int64_t> judged;
    for (auto const& trial : statistics.measured().criterion_trials(0, measure_named("v_wes"))) {
        judged.insert(trial.wave);
    }
    EXPECT_EQ(judged, (std::set<std::int64_t>{0, 1, 2, 3})) << "the criterion is judged wave by wave";
    EXPECT_EQ(groups, (std::set<std::int64_t>{0, 1}));
    EXPECT_EQ(waves, (std::set<std::int64_t>{0, 1, 2, 3}));
    bool said = false;
    for (auto const& line : warnings_of(spec)) {
        said = said || line.find("Groups of 2 waves share a drawn target") != std::string::npos;
    }
    EXPECT_TRUE(said);
    auto const& stripe = statistics.bodies()[0].stripes[0];
    EXPECT_EQ(stripe.trials, 4);
    auto const two = clopper_pearson(stripe.overturned / 2, 2, 0.95);
    EXPECT_EQ(stripe.interval(0.95).lower, two.lower) << "two targets, of whatever number of waves";
    auto const analysis = analyse(spec, statistics, {});
    EXPECT_EQ(analysis[0].over_levels().fit.group_size, 2);
    EXPECT_EQ(analysis[0].over_levels().fit.waves, 2);
    EXPECT_EQ(analysis[0].over_levels().fit.method, FragilityFit::Method::widest);
    for (auto const& fit : analysis[0].fragility) {
        EXPECT_EQ(fit.fit.group_size, 2) << fit.name;
    }
    auto const one_level =
        campaign_from(varying_waves + "per_target=2\n" + testing::type_b + testing::levels("values=[6]\n"));
    Statistics at_one(one_level);
    at_one.add(rows_of(one_level));
    EXPECT_EQ(fit_over_levels(one_level, at_one, 0, {}).method, FragilityFit::Method::widest);
}

TEST(VaryingWaves, BadPeriodsAreRefusedWithTheirPlace) {
    auto const with = [](std::string const& levels, std::string const& measures) {
        return testing::quick_waves + testing::type_b + levels + "[measures]\n" + measures;
    };
    auto const pga = testing::levels("values=[6]\n");
    expect_input_error([&] { (void)campaign_from(with(pga, "sa_periods=[3, 1]\n")); }, "sa_periods", "rise");
    expect_input_error([&] { (void)campaign_from(with(pga, "sa_periods=[1, 2, 3, 4, 5]\n")); }, "1 to 4");
    expect_input_error([&] { (void)campaign_from(with(pga, "sa_band=[2, 1]\n")); }, "sa_band");
    expect_input_error([&] { (void)campaign_from(with("[levels]\nmeasure='sa'\nvalues=[6]\n", "")); }, "period");
    expect_input_error([&] { (void)campaign_from(with("[levels]\nmeasure='sa-average'\nvalues=[6]\n", "")); },
                       "measures.sa_band");
    expect_input_error(
        [&] {
            (void)campaign_from(with("[levels]\nmeasure='sa'\nperiod=2.5\nvalues=[6]\n", "sa_periods=[1, 2, 3, 4]\n"));
        },
        "none of the 4");
}

}  // namespace
}  // namespace overturn
