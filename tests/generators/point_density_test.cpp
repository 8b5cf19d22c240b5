// Requirement R-105: noise of a stated power spectral density has that density, the stated rms, and nothing where none
// is stated.
#include "generators/detail/point_density.hpp"

#include <cmath>
#include <complex>

#include <fmt/format.h>

#include "generators/detail/filtered_noise.hpp"
#include "generators/detail/real_fft.hpp"
#include "support/expect_input_error.hpp"
#include "support/sources.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;
using testing::near;

std::string const steady = "source='filtered-noise'\nmodel='points'\nrms=2\nduration='81.92 s'\n";
std::string const constant = "[envelope]\nshape='constant'\n";

TEST(PointDensity, IsStraightBetweenItsPointsAndNothingOutside) {
    PointDensity const density({{0.5, 1}, {1, 3}, {4, 0}});

    EXPECT_EQ(density.at(0.5), 1);
    EXPECT_EQ(density.at(0.75), 2);
    EXPECT_EQ(density.at(1), 3);
    EXPECT_EQ(density.at(3), 1);
    EXPECT_EQ(density.at(4), 0);
    EXPECT_EQ(density.at(0.499), 0);
    EXPECT_EQ(density.at(4.001), 0);
    EXPECT_EQ(density.integral_hz(), 1 + 4.5);
}

// The mean power of many draws, band by band, is the stated one.
TEST(PointDensity, NoiseHasTheStatedPower) {
    auto const source =
        testing::source_of(steady + constant + "[density]\npoints=[['0.5 Hz',0],['1 Hz',2],['4 Hz',2],['8 Hz',0]]\n");
    PointDensity const density({{0.5, 0}, {1, 2}, {4, 2}, {8, 0}});
    constexpr int waves = 200;
    constexpr double dt = 0.01;
    std::size_t const length = source->make(1, 0).motion.horizontal_mps2.size();
    RealFft const fft(RealFft::good_length(length));
    double const spacing_hz = 1 / (dt * static_cast<double>(fft.length()));
    std::vector<double> power(fft.length() / 2, 0.0);
    double square = 0;
    for (std::uint64_t wave = 0; wave < waves; ++wave) {
        auto series = source->make(1, wave).motion.horizontal_mps2;
        for (double const a : series) {
            square += a * a / static_cast<double>(length) / waves;
        }
        series.resize(fft.length(), 0.0);
        std::vector<std::complex<double>> lines(fft.length() / 2);
        fft.analyse(series, lines);
        for (std::size_t k = 0; k < lines.size(); ++k) {
            power[k] += std::norm(lines[k]);
        }
    }
    EXPECT_NEAR(square, 4, 0.12) << "rms 2; one wave's square scatters by 0.17";
    auto const band = [&](double from_hz, double to_hz) {
        double seen = 0;
        double stated = 0;
        for (std::size_t k = 1; k < power.size(); ++k) {
            double const f = spacing_hz * static_cast<double>(k);
            seen += f >= from_hz && f < to_hz ? power[k] : 0;
            stated += f >= from_hz && f < to_hz ? density.at(f) : 0;
        }
        return std::pair(seen, stated);
    };
    auto const whole = band(0, 50);
    for (auto const& [from, to] : {std::pair{0.5, 1.0}, {1.0, 2.0}, {2.0, 4.0}, {4.0, 6.0}, {6.0, 8.0}}) {
        auto const [seen, stated] = band(from, to);
        EXPECT_NEAR(seen / whole.first, stated / whole.second, 0.02 * (stated / whole.second) + 0.002) << from << " Hz";
    }
    EXPECT_LT(band(8.1, 50).first, 1e-3 * whole.first) << "beyond the last point lies nothing but leakage";
}

// Tabulated finely, the filter of the ground gives the filter's own waves.
TEST(PointDensity, ATabulatedFilterIsTheFilter) {
    GroundFilter const filter{.ground_radps = 2 * pi * 2.5, .ground_damping = 0.6};
    std::string points;
    for (int k = 0; k <= 5000; ++k) {
        double const f = 0.01 * k;
        points += fmt::format("{}[{:.17g},{:.17g}]", k == 0 ? "" : ",", f, filter.shape(2 * pi * f));
    }
    auto const stated = testing::source_of(steady + constant + "[density]\npoints=[" + points + "]\n");
    auto const known =
        testing::source_of("source='filtered-noise'\nmodel='kanai-tajimi'\nrms=2\nduration='81.92 s'\n" + constant);
    auto const one = stated->make(5, 3).motion.horizontal_mps2;
    auto const other = known->make(5, 3).motion.horizontal_mps2;
    ASSERT_EQ(one.size(), other.size());
    double apart = 0;
    double square = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        apart += (one[i] - other[i]) * (one[i] - other[i]);
        square += other[i] * other[i];
    }
    EXPECT_LT(std::sqrt(apart / square), 1e-5) << "an eighth of the second difference of the table";
}

TEST(PointDensity, IsReadFromAFileAndInAnyUnit) {
    auto const from = [](std::string const& scale_text) {
        return testing::source_of(steady + constant + "[density]\nfile='psd.txt'\n", {{"psd.txt", scale_text}})
            ->make(1, 2)
            .motion.horizontal_mps2;
    };
    auto const one = from("# site\nfrequency_hz, psd\n0.5, 1\n2, 4\n\n8, 1\n");
    auto const other = from("0.5 10\n2 40\n8 10\n");
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
        ASSERT_NEAR(one[i], other[i], 1e-12) << "rms sets the scale";
    }
}

TEST(PointDensity, RefusesWhatIsNone) {
    auto const noise = [](std::string const& keys, std::map<std::string, std::string> files = {}) {
        (void)testing::source_of(steady + keys, std::move(files));
    };
    expect_input_error([&] { noise(""); }, "density");
    expect_input_error([&] { noise("ground_frequency=2\n[density]\npoints=[[1,1],[2,1]]\n"); }, "ground_frequency");
    expect_input_error([&] { noise("[density]\npoints=[[1,1]]\n"); }, "c.toml:6:", "at least two");
    expect_input_error([&] { noise("[density]\npoints=[[1,1],[1,2]]\n"); }, "must rise");
    expect_input_error([&] { noise("[density]\npoints=[[1,1],[2,-1]]\n"); }, "must not be negative");
    expect_input_error([&] { noise("[density]\npoints=[[1,0],[2,0]]\n"); }, "nothing shakes");
    expect_input_error(
        [&] {
            noise("[density]\npoints=[[1,1],[2,1]]\nfile='x'\n", {{"x", "1 1\n2 1\n"}});
        },
        "Keep one");
    expect_input_error([&] { noise("[density]\nfile='x'\n", {{"x", "0.5 1\n2 no\n"}}); }, "x:2: 'no' in column 2");
    for (char const* names : {"omega (rad/s),S", "T (s),S", "f (kHz),S", "f (Hz),Fourier amplitude"}) {
        expect_input_error(
            [&] {
                noise("[density]\nfile='x'\n", {{"x", fmt::format("{}\n0.5 1\n2 1\n", names)}});
            },
            "x:1: ", "must be frequency in Hz and power density");
    }
    EXPECT_NO_THROW(noise("[density]\nfile='x'\n", {{"x", "# of a site\nf (Hz),S (m2/s3)\n0.5 1\n2 1\n"}}));
    expect_input_error([&] { noise("[density]\npoints=[[60,1],[70,1]]\n"); }, "no line of the wave");
}

}  // namespace
}  // namespace overturn
