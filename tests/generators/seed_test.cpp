// Requirement R-102: a measured motion can be the seed of a match, and keeps its phases.
#include <cmath>
#include <complex>

#include "core/units.hpp"
#include "generators/detail/real_fft.hpp"
#include "motion/intensity.hpp"
#include "spectra/response_spectrum.hpp"
#include "support/expect_input_error.hpp"
#include "support/sources.hpp"
#include "support/waves.hpp"

namespace overturn {
namespace {

std::string column(std::vector<double> const& a, std::vector<double> const& v = {}) {
    std::string text;
    for (std::size_t i = 0; i < a.size(); ++i) {
        text += fmt::format("{:.2f},{:.17g}", 0.01 * static_cast<double>(i), a[i]);
        text += v.empty() ? "\n" : fmt::format(",{:.17g}\n", v[i]);
    }
    return text;
}

std::string const source_key = "source='spectrum-compatible'\n";
std::string const tables = "[target]\nspectrum='mlit-ch1'\nlongest=5\n[seed]\nfiles=['a.csv','b.csv']\nunit='m/s2'\n";
std::string const keys = source_key + "acceptance='japan'\n" + tables;

// Faded at its ends, as records are that were cut with care.
std::vector<double> record() {
    auto wave = testing::broad_wave(6001, 0.01);
    for (std::size_t i = 0; i < wave.size(); ++i) {
        double const t = 0.01 * static_cast<double>(i);
        wave[i] *= std::exp(-std::pow((t - 25) / 12, 4));
    }
    return wave;
}

std::map<std::string, std::string> files() {
    auto const one = record();
    return {{"a.csv", column(one)}, {"b.csv", column({one.rbegin(), one.rend()})}};
}

std::vector<std::complex<double>> lines_of(std::vector<double> series) {
    RealFft const fft(RealFft::good_length(series.size()));
    series.resize(fft.length(), 0.0);
    std::vector<std::complex<double>> lines(fft.length() / 2);
    fft.analyse(series, lines);
    return lines;
}

TEST(Seed, MatchKeepsThePhasesOfTheRecord) {
    auto const source = testing::source_of(source_key + tables, files());
    auto const made = source->make(1, 0);

    EXPECT_EQ(source->about().available, 2U);
    EXPECT_NE(made.label.find("a.csv"), std::string::npos);
    ASSERT_EQ(made.motion.samples(), 6001U);
    EXPECT_TRUE(made.match.matched);
    auto const before = lines_of(record());
    auto const after = lines_of(made.motion.horizontal_mps2);
    double turned = 0, weight = 0;  // by power: fade and baseline move what is faint
    for (std::size_t k = 13; k < before.size(); ++k) {
        double const angle = std::arg(after[k] / before[k]);
        turned += std::norm(after[k]) * angle * angle;
        weight += std::norm(after[k]);
    }
    EXPECT_LT(std::sqrt(turned / weight), 0.02);  // of 1.8 if they were drawn anew
}

// matches of two components of one recording are one sample, and so is what shares a drawn target.
TEST(Seed, ComponentsOfOneRecordingAreNoTwoSamples) {
    auto const one = record();
    std::map<std::string, std::string> contents;
    std::string list;
    for (std::string const name : {"k_NS.csv", "taft.csv", "b.csv", "k_EW.csv"}) {
        auto other = one;
        other[100 + 10 * contents.size()] += 0.1;
        contents[name] = column(other);
        list += "'" + name + "',";
    }
    auto const target = "[target]\nspectrum='mlit-ch1'\nlongest=5\n[seed]\nunit='m/s2'\nfiles=[" + list + "]\n";
    using Numbers = std::vector<std::int64_t>;
    auto const matched = testing::source_of(source_key + target, contents);
    EXPECT_EQ(matched->about().shared.of, (Numbers{0, 1, 2, 0}));
    EXPECT_EQ(matched->about().began_with_names.back().substr(0, 4), "k_EW");
    auto const varied = testing::source_of(
        source_key + target + "[variability]\ncorrelation='none'\nsigma=0.3\nper_target=2\n", contents);
    EXPECT_EQ(varied->about().shared.of, (Numbers{0, 0, 0, 0})) << "0 and 3 by the recording, 0 and 1, 2 and 3 by it";
    EXPECT_EQ(varied->about().shared.most, 4);
    EXPECT_TRUE(testing::source_of(keys, files())->about().shared.of.empty());
}

//
// matched to its own spectrum up to 5 s, a seed keeps what it has at 7 s: Sa there, PGV, which is most of that.
TEST(Seed, SlowShakingBeyondTheMatchIsKept) {
    std::vector<double> slow;
    for (int i = 0; i <= 9000; ++i) {
        double const t = 0.01 * i;
        double const burst = std::pow(std::sin(pi * t / 90), 2);
        slow.push_back(burst * (std::sin(2 * pi * t / 7) + 0.5 * std::sin(2 * pi * t / 0.5)));
    }
    auto const periods = log_periods(0.05, 5, 60);
    auto const spectrum = response_spectrum(slow, 0.01, periods, 0.05);
    std::string points;
    for (std::size_t i = 0; i < periods.size(); ++i) {
        points += fmt::format("[{:.17g},{:.17g}],", periods[i], spectrum.psa_mps2[i]);
    }
    auto const source = testing::source_of(source_key + "[target]\nkind='acceleration'\nlongest=5\npoints=[" + points
                                               + "]\n[seed]\nfiles=['a.csv']\nunit='m/s2'\n",
                                           {{"a.csv", column(slow)}});
    auto const made = source->make(1, 0).motion;
    ASSERT_NE(source->began_with(0), nullptr);
    EXPECT_EQ(source->began_with(1), nullptr);
    constexpr double kept = 0.05;
    double const pgv = intensity_of(slow, 0.01).pgv_mps;
    EXPECT_NEAR(intensity_of(made.horizontal_mps2, 0.01).pgv_mps, pgv, kept * pgv);
    std::vector<double> const slow_period{7};
    auto const before = displacement_spectrum(slow, 0.01, slow_period, 0.05)[0];
    EXPECT_NEAR(displacement_spectrum(made.horizontal_mps2, 0.01, slow_period, 0.05)[0], before, kept * before);
}

TEST(Seed, EachRecordIsOneWaveWhateverTheSeed) {
    auto const source = testing::source_of(keys, files());

    EXPECT_EQ(source->make(1, 0).motion.horizontal_mps2, source->make(2, 0).motion.horizontal_mps2);
    EXPECT_NE(source->make(1, 0).motion.horizontal_mps2, source->make(1, 1).motion.horizontal_mps2);
    EXPECT_FALSE(source->make(1, 0).clauses.empty());
    testing::expect_input_error([&] { (void)source->make(1, 2); }, "2 of 2");
}

TEST(Seed, RefusesWhatItCannotKeep) {
    using testing::expect_input_error;
    auto const make = [](std::string const& text) { (void)testing::source_of(text, files()); };
    expect_input_error([&] { make("time_step=0.02\n" + keys); }, "seed", "State waves.seed.time_step");
    expect_input_error([&] { make("match='none'\n" + source_key + tables); }, "beside seed");
    expect_input_error([&] { make(keys + "[envelope]\nrise=3\n"); }, "envelope", "nothing reads it");
    expect_input_error([&] { make(keys + "[vertical]\nratio=0.5\n"); }, "vertical", "phases are missing");
}

}  // namespace
}  // namespace overturn
