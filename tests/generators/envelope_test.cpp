// Requirement R-105: envelopes have their published shapes, and finished waves still have their envelope.
#include "generators/envelope.hpp"

#include <cmath>

#include "support/expect_input_error.hpp"
#include "support/sources.hpp"

namespace overturn {
namespace {

Envelope read(std::string const& keys) { return read_envelope(config::Table::parse(keys, "c.toml"), 100); }

// The mean square t^gamma exp(-alpha t) peaks at gamma/alpha; half of the exponent is the amplitude's.
TEST(Envelope, SaragoniHartIsTheGammaFunction) {
    auto const envelope = read("shape='saragoni-hart'\npeak='8 s'\ngamma=3\n");
    double const alpha = 3.0 / 8;
    double const peak = std::pow(8, 3) * std::exp(-3.0);

    EXPECT_DOUBLE_EQ(envelope.at(8), 1);
    EXPECT_EQ(envelope.at(0), 0);
    for (double const t : {1.0, 5.0, 20.0, 60.0}) {
        EXPECT_NEAR(envelope.at(t) * envelope.at(t), std::pow(t, 3) * std::exp(-alpha * t) / peak, 1e-14);
    }
}

TEST(Envelope, PointsAreStraightLinesUnderTheirLargest) {
    auto const envelope = read("shape='points'\npoints=[['1 s',0],['3 s',4],['10 s',2]]\n");

    EXPECT_EQ(envelope.at(0.5), 0);
    EXPECT_DOUBLE_EQ(envelope.at(2), 0.5);
    EXPECT_DOUBLE_EQ(envelope.at(3), 1);
    EXPECT_DOUBLE_EQ(envelope.at(6.5), 0.75);
    EXPECT_DOUBLE_EQ(envelope.at(50), 0.5);
}

// The durations that design-basis motions of M 7.7 are quoted with.
TEST(Envelope, NodaFollowsFromMagnitudeAndDistance) {
    auto const envelope = read("shape='noda-2002'\nmagnitude=7.7\ndistance='20 km'\n");

    EXPECT_NEAR(envelope.rise_s, 8.3, 0.05);
    EXPECT_NEAR(envelope.level_end_s, 28.8, 0.1);
    EXPECT_DOUBLE_EQ(envelope.at(envelope.rise_s / 2), 0.25);
    EXPECT_EQ(envelope.at(20), 1);
    EXPECT_NEAR(envelope.at(envelope.end_s), 0.1, 1e-12);
    auto const farther = read("shape='noda-2002'\nmagnitude=7.7\ndistance='80 km'\n");
    EXPECT_NEAR((farther.end_s - farther.level_end_s) / (envelope.end_s - envelope.level_end_s), std::pow(4, 0.54),
                1e-12);
    testing::expect_input_error([] { (void)read("shape='noda-2002'\nmagnitude=9\ndistance='300 km'\n"); },
                                "c.toml:2:", "Raise waves.duration");
    testing::expect_input_error([] { (void)read("shape='noda-2002'\nmagnitude=7\n"); }, "distance");
}

TEST(Envelope, RefusesWhatIsNone) {
    using testing::expect_input_error;
    expect_input_error([] { (void)read("shape='points'\npoints=[[1,0],[1,1]]\n"); }, "c.toml:2:", "times must rise");
    expect_input_error([] { (void)read("shape='points'\npoints=[[1,0],[2,-1]]\n"); }, "c.toml:2:", "not be negative");
    expect_input_error([] { (void)read("shape='points'\npoints=[[1,0],[2,0]]\n"); }, "c.toml:2:", "silent");
    expect_input_error([] { (void)read("shape='saragoni-hart'\npeak='200 s'\n"); }, "c.toml:2:", "200 s");
    expect_input_error([] { (void)read("shape='saragoni-hart'\nrise='2 s'\n"); }, "rise", "nothing reads it");
    expect_input_error([] { (void)read("shape='saragoni-hard'\n"); }, "'saragoni-hart'?");
}

class FinishedWaves : public ::testing::TestWithParam<std::string> {};

// The share of energy that has come by a time, on the mean of 30 waves matched by a rule, is that of the envelope.
TEST_P(FinishedWaves, StillHaveTheirEnvelope) {
    auto const source = testing::source_of(
        "source='spectrum-compatible'\nduration='100 s'\nacceptance='srp-3.7.1'\n"
        "[target]\nspectrum='mlit-ch1'\n[envelope]\n"
        + GetParam());
    auto const wanted = read(GetParam()).samples(0.01, 10001);
    std::vector<double> come(10001, 0.0), due(10001, 0.025);
    constexpr int waves = 30;
    for (std::uint64_t wave = 0; wave < waves; ++wave) {
        auto const a = source->make(11, wave).motion.horizontal_mps2;
        double sum = 0;
        for (double const value : a) {
            sum += value * value;
        }
        double part = 0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            part += a[i] * a[i];
            come[i] += part / sum / waves;
        }
    }
    double sum = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        sum += wanted[i] * wanted[i];
        due[i] = sum;
    }
    double worst = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        worst = std::max(worst, std::abs(come[i] - due[i] / sum));
    }
    EXPECT_LT(worst, 0.025);
}

INSTANTIATE_TEST_SUITE_P(Shapes, FinishedWaves,
                         ::testing::Values("shape='jennings'\nrise=10\nlevel_end=50\nend=90\n",
                                           "shape='saragoni-hart'\npeak=20\ngamma=3\n",
                                           "shape='points'\npoints=[[0,0],[10,1],[30,0.3],[50,1],[90,0]]\n"),
                         [](auto const& one) { return "shape_" + std::to_string(one.index); });

}  // namespace
}  // namespace overturn
