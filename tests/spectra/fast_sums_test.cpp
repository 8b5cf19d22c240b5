// Requirement R-203: the fast sums behind ouV_E and V_WES are the plain sums that their definitions name.
#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include <gtest/gtest.h>

#include "core/units.hpp"
#include "spectra/band_rule.hpp"
#include "spectra/detail/phase_sums.hpp"
#include "spectra/detail/sliding_products.hpp"
#include "spectra/detail/thinned_sums.hpp"
#include "spectra/detail/window_kernel.hpp"
#include "spectra/detail/window_sweep.hpp"
#include "support/waves.hpp"

namespace overturn {
namespace {

// Even, odd and tiny lengths; phases at zero, between grid points, at the Nyquist frequency and far beyond it.
TEST(FastSums, PhaseSumsEqualPlainSums) {
    for (std::size_t const samples : {1U, 2U, 7U, 64U, 1001U, 4096U}) {
        auto const wave = testing::broad_wave(samples, 0.01);
        double total = 0;
        for (double const a : wave) {
            total += std::abs(a);
        }
        std::vector<double> const x{0, 1e-9, 0.0123, 0.5, 1, 2, 3, pi, 3.2, 6, 2 * pi, 7.5, -0.4};

        auto const fast = PhaseSums(samples, x).of(wave);

        for (std::size_t i = 0; i < x.size(); ++i) {
            std::complex<double> plain = 0;
            for (std::size_t j = 0; j < samples; ++j) {
                plain += wave[j] * std::polar(1.0, -x[i] * static_cast<double>(j));
            }
            EXPECT_LE(std::abs(fast[i] - plain), 1e-12 * total) << samples << " samples, x = " << x[i];
        }
    }
    EXPECT_TRUE(PhaseSums(2, {}).of(std::vector{1.0, 2.0}).empty());
}

// Phases from zero to where thinning just begins, each kind of them alone: strides of 1 to 64, beside strong content at
// phases that thinning folds onto slow ones.
TEST(FastSums, ThinnedSumsEqualPlainSums) {
    for (std::size_t const samples : {3U, 104U, 700U, 5001U}) {
        auto wave = testing::broad_wave(samples, 0.01);
        for (std::size_t j = 0; j < samples; ++j) {
            for (double const folding : {2 * pi / 64, 2 * pi / 16, 2 * pi / 4, 3 * pi / 4, pi}) {
                wave[j] += 10 * std::cos(folding * static_cast<double>(j) + 0.3);
            }
        }
        double total = 0;
        for (double const a : wave) {
            total += std::abs(a);
        }
        for (double const fastest : {0.0, pi / 128, pi / 64, 0.0491, 0.114, pi / 8, pi / 4, 0.786, 2.0, 2 * pi, 7.5}) {
            std::vector<double> const x{0, 1e-3 * fastest, 0.4 * fastest, -0.7 * fastest, fastest};

            auto const thinned = ThinnedSums(samples, x).of(wave);

            for (std::size_t i = 0; i < x.size(); ++i) {
                std::complex<double> plain = 0;
                for (std::size_t j = 0; j < samples; ++j) {
                    plain += wave[j] * std::polar(1.0, -x[i] * static_cast<double>(j));
                }
                EXPECT_LE(std::abs(thinned[i] - plain), 1e-12 * total) << samples << " samples, x = " << x[i];
            }
        }
    }
    EXPECT_TRUE(ThinnedSums(500, {}).of(std::vector<double>(500, 1.0)).empty());
}

TEST(FastSums, SlidingProductsEqualPlainSums) {
    for (std::size_t const samples : {1U, 5U, 90U, 1000U}) {
        auto const wave = testing::broad_wave(samples, 0.01);
        for (std::size_t const taps : {1U, 3U, 40U, 200U}) {
            std::vector<std::vector<double>> kernels(2, std::vector<double>(taps));
            for (std::size_t d = 0; d < taps; ++d) {
                kernels[0][d] = std::cos(0.3 * static_cast<double>(d));
                kernels[1][d] = 1.0 / static_cast<double>(d + 1);
            }

            auto const products = SlidingKernels(kernels, samples).products(wave);

            for (std::size_t k = 0; k < kernels.size(); ++k) {
                for (std::size_t n = 0; n < samples; ++n) {
                    double before = 0;
                    double after = 0;
                    for (std::size_t d = 1; d <= taps; ++d) {
                        before += n >= d ? kernels[k][d - 1] * wave[n - d] : 0;
                        after += n + d < samples ? kernels[k][d - 1] * wave[n + d] : 0;
                    }
                    ASSERT_NEAR(products[k].before[n], before, 1e-11) << samples << ", " << taps << ", " << n;
                    ASSERT_NEAR(products[k].after[n], after, 1e-11) << samples << ", " << taps << ", " << n;
                }
            }
        }
    }
}

// Waves of no, one and few samples, and windows just shorter than, as long as and just longer than the wave.
TEST(FastSums, WindowsOfShortWaves) {
    for (std::size_t const samples : {0U, 1U, 2U, 3U, 40U}) {
        auto const wave = testing::broad_wave(samples, 0.01);
        for (std::size_t const window : {1U, 2U, 3U, 39U, 40U, 41U}) {
            auto const rule = band_rule({0.5, 5.0}, static_cast<double>(window) * 0.01, 20);

            auto const fast = WindowKernel(samples, 0.01, window, rule).squares(wave);

            ASSERT_EQ(fast.size(), samples);
            if (samples < 2) {
                continue;
            }
            auto const swept =
                swept_window_squares(wave, 0.01, std::min(window, samples), rule, WindowReading::restarted);
            double const largest = *std::max_element(swept.begin(), swept.end());
            for (std::size_t n = 0; n < samples; ++n) {
                EXPECT_NEAR(fast[n], swept[n], 1e-12 * largest) << samples << ", window " << window << ", " << n;
            }
        }
    }
}

// The oscillators of the definition, swept one by one, against the kernel: also for windows of one sample and longer
// than the wave, and behind a burst a thousand times as strong.
TEST(FastSums, WindowsEqualTheSweptOscillators) {
    for (std::size_t const window : {1U, 2U, 31U, 500U, 3000U}) {
        auto wave = testing::broad_wave(2500, 0.01);
        auto const rule = band_rule({0.5, 5.0}, static_cast<double>(window) * 0.01, 20);
        for (bool const burst : {false, true}) {
            if (burst) {
                for (std::size_t n = 600; n < 700; ++n) {
                    wave[n] *= 1e3;
                }
            }

            auto const fast = WindowKernel(wave.size(), 0.01, window, rule).squares(wave);
            auto const swept =
                swept_window_squares(wave, 0.01, std::min(window, wave.size()), rule, WindowReading::restarted);

            double const largest = *std::max_element(swept.begin(), swept.end());
            for (std::size_t n = 0; n < wave.size(); ++n) {
                ASSERT_NEAR(fast[n], swept[n], 1e-12 * largest) << "window " << window << ", sample " << n;
            }
        }
    }
}

}  // namespace
}  // namespace overturn
