// Requirement: a random wave is a function of (seed, number, component) alone.
#include "generators/spectrum_compatible.hpp"

#include <array>
#include <cmath>
#include <numeric>
#include <thread>

#include "generators/wave_quality.hpp"
#include "support/expect_input_error.hpp"
#include "support/sources.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;
using testing::source_of;

std::string const base = "source='spectrum-compatible'\nduration='41 s'\n";
std::string const target = "[target]\nspectrum='mlit-ch1'\n";

TEST(SpectrumCompatible, SameWaveAloneAndInACrowd) {
    auto const source = source_of(base + target);
    auto const alone = source->make(2013, 3).motion.horizontal_mps2;

    for (std::uint64_t const wave : {9U, 3U, 0U}) {
        auto const again = source->make(2013, wave).motion.horizontal_mps2;
        EXPECT_EQ(again == alone, wave == 3);
    }
    EXPECT_EQ(source_of(base + target)->make(2013, 3).motion.horizontal_mps2, alone);
    EXPECT_NE(source->make(2014, 3).motion.horizontal_mps2, alone);
}

TEST(SpectrumCompatible, ThreadsShareASource) {
    auto const source = source_of(base + target);
    std::array<GeneratedWave, 2> made;
    {
        std::jthread const first([&] { made[0] = source->make(1, 1); });
        std::jthread const second([&] { made[1] = source->make(1, 2); });
    }
    EXPECT_EQ(made[0].motion.horizontal_mps2, source->make(1, 1).motion.horizontal_mps2);
    EXPECT_EQ(made[1].motion.horizontal_mps2, source->make(1, 2).motion.horizontal_mps2);
}

TEST(SpectrumCompatible, VerticalLeavesTheHorizontalAlone) {
    auto const flat = source_of(base + target)->make(1, 4);
    auto const made = source_of(base + target + "[vertical]\nratio=0.667\n")->make(1, 4);

    EXPECT_EQ(made.motion.horizontal_mps2, flat.motion.horizontal_mps2);
    EXPECT_TRUE(flat.motion.vertical_mps2.empty());
    EXPECT_EQ(made.motion.vertical_mps2.size(), made.motion.samples());
}

TEST(SpectrumCompatible, ComponentsAreIndependentAndInProportion) {
    auto const source = source_of(base + target + "[vertical]\nratio=0.667\n[transverse]\nratio=1\n");
    double correlation = 0;
    constexpr int waves = 20;
    for (std::uint64_t wave = 0; wave < waves; ++wave) {
        auto const motion = source->make(1, wave).motion;
        auto const& h = motion.horizontal_mps2;
        auto const& t = motion.transverse_mps2;
        auto const& v = motion.vertical_mps2;
        double const hh = std::inner_product(h.begin(), h.end(), h.begin(), 0.0);
        double const vv = std::inner_product(v.begin(), v.end(), v.begin(), 0.0);
        double const tt = std::inner_product(t.begin(), t.end(), t.begin(), 0.0);
        EXPECT_NEAR(std::sqrt(vv / hh), 0.667, 0.1);
        EXPECT_NEAR(std::sqrt(tt / hh), 1, 0.15);
        EXPECT_LE(std::abs(correlation_of(h, v)), 0.16);
        EXPECT_LE(std::abs(correlation_of(h, t)), 0.16);
        EXPECT_LE(std::abs(correlation_of(t, v)), 0.16);
        correlation += correlation_of(h, v) / waves;
    }
    EXPECT_LT(std::abs(correlation), 0.06);  // one wave scatters by about 0.08
}

TEST(SpectrumCompatible, ComponentsMayBeCorrelatedAsStated) {
    auto const source = source_of(base + target + "[transverse]\nratio=0.8\ncorrelation=0.5\n");
    int close = 0;
    for (std::uint64_t wave = 0; wave < 20; ++wave) {
        auto const made = source->make(1, wave);
        double const found = correlation_of(made.motion.horizontal_mps2, made.motion.transverse_mps2);
        EXPECT_NEAR(found, 0.5, 0.06) << wave;
        close += std::abs(found - 0.5) < 0.02 ? 1 : 0;
        EXPECT_LT(made.transverse_match.all.mean_misfit, 0.05);
    }
    EXPECT_GE(close, 17) << "the match of few takes more than mixtures make good";
    EXPECT_NE(source->about().text.find("correlation 0.5"), std::string::npos);
    EXPECT_EQ(source->make(1, 3).motion.horizontal_mps2, source_of(base + target)->make(1, 3).motion.horizontal_mps2);
}

// Mean power over ten seconds each, relative to what (t/20)^2, 1, exp(-ln 10 (t-60)/50) ask for.
std::vector<double> power_over_envelope(std::string const& match) {
    auto const source = source_of("source='spectrum-compatible'\nduration='120 s'\nmatch='" + match + "'\n" + target
                                  + "[envelope]\nrise=20\nlevel_end=60\nend=110\n");
    std::vector<double> power(11, 0.0);
    for (std::uint64_t wave = 0; wave < 40; ++wave) {
        auto const a = source->make(5, wave).motion.horizontal_mps2;
        for (std::size_t i = 0; i < 11000; ++i) {
            power[i / 1000] += a[i] * a[i];
        }
    }
    double const level = (power[2] + power[3] + power[4] + power[5]) / 4;
    double const decay = 2 * std::log(10.0) / 50;
    power[0] /= 1.0 / 80;  // means of (t/20)^4
    power[1] /= 31.0 / 80;
    for (int i = 6; i < 11; ++i) {
        double const from = 10.0 * (i - 6);
        power[i] /= (std::exp(-decay * from) - std::exp(-decay * (from + 10))) / (10 * decay);
    }
    for (double& value : power) {
        value /= level;
    }
    return power;
}

TEST(SpectrumCompatible, DrawnWavesHoldTheEnvelope) {
    for (double const ratio : power_over_envelope("none")) {
        EXPECT_NEAR(ratio, 1, 0.1);
    }
}

TEST(SpectrumCompatible, MatchedWavesNearlyHoldTheEnvelope) {
    for (double const ratio : power_over_envelope("each")) {
        EXPECT_GT(ratio, 0.85);
        EXPECT_LT(ratio, 1.5);
    }
}

TEST(SpectrumCompatible, MatchNoneTakesNoMatchingKeys) {
    expect_input_error([] { (void)source_of(base + "match='none'\nmatch_tolerance=0.1\n" + target); },
                       "match_tolerance", "nothing reads it");
}

// the vertical motion is an independent wave compatible with its own target.
TEST(SpectrumCompatible, VerticalMayHaveATargetOfItsOwn) {
    auto const source = source_of(base + target + "[vertical.target]\nspectrum='mlit-ka1'\ndamping=0.05\n");
    auto const made = source->make(1, 4);
    auto const without = source_of(base + target)->make(1, 4);

    EXPECT_EQ(made.motion.horizontal_mps2, without.motion.horizontal_mps2) << "the horizontal motion keeps its bits";
    EXPECT_LT(made.vertical_match.all.mean_misfit, 0.05 * 1.0001);
    EXPECT_NE(peak_of(made.motion.vertical_mps2), peak_of(made.motion.horizontal_mps2));
}

TEST(SpectrumCompatible, RefusesWhatItCannotMake) {
    expect_input_error([] { (void)source_of("source='spectrum-compatable'"); }, "c.toml:1:", "'spectrum-compatible'?");
    expect_input_error([] { (void)source_of("source='spectrum-compatible'\nduration=0\n" + target); },
                       "c.toml:2:", "duration: 0 s");
    expect_input_error([] { (void)source_of("source='spectrum-compatible'\nduration='0.2 s'\n" + target); },
                       "c.toml:2:", "20 time steps");
    expect_input_error([] { (void)source_of(base + "match='ensemble'\nacceptance='japan'\n" + target); },
                       "c.toml:4:", "single waves");
    expect_input_error([] { (void)source_of(base + "acceptance='srp-371'\n" + target); }, "c.toml:3:", "'srp-3.7.1'?");
    expect_input_error(
        [] {
            (void)source_of(base + "acceptance='japan'\n[target]\nkind='energy-velocity'\npoints=[[0.1,1],[5,1]]\n");
        },
        "c.toml:3:", "5 % damping");
    expect_input_error([] { (void)source_of(base); }, "target: missing");
    expect_input_error([] { (void)source_of(base + target + "[envelope]\nrise=30\nlevel_end=20\nend=40\n"); },
                       "c.toml:5:", "must follow each other");
    expect_input_error([] { (void)source_of(base + target + "[envelope]\nend=50\n"); }, "c.toml:6:", "end: 50 s");
    expect_input_error([] { (void)source_of(base + "[target]\nkind='acceleration'\npoints=[[0.1,1],[1,0]]\n"); },
                       "c.toml:5:", "ordinate 0");
    expect_input_error([] { (void)source_of(base + target + "longest=30\n"); }, "c.toml:5:", "longest: 30 s");
    expect_input_error([] { (void)source_of(base + target + "dampign=0.05\n"); }, "c.toml:5:", "'damping'?");
    expect_input_error([] { (void)source_of(base + target + "[vertical]\nration=1\n"); }, "'ratio'?");
}

TEST(SpectrumCompatible, PriceListHasSummaries) {
    for (auto const& entry : wave_sources()) {
        EXPECT_FALSE(entry.summary.empty()) << entry.name;
    }
    EXPECT_NE(source_of(base + target)->about().text.find("mlit-ch1"), std::string::npos);
    EXPECT_FALSE(source_of(base + target)->about().available);
}

}  // namespace
}  // namespace overturn
