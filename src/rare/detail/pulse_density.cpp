#include "rare/detail/pulse_density.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include "core/error.hpp"
#include "rare/mixture.hpp"
#include "simd/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rare/detail/pulse_density.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes first: it includes this file once per instruction set
#include "rare/detail/lane_functions-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::rare::HWY_NAMESPACE {

// Sums per strength kappa of arrival exp(kappa |r| - kappa^2 square / 2) where these exponents leave the range of
// numbers: each by itself, cut where what it adds is next to nothing or beyond any weight. The pulse of the other sign,
// exp(-2 kappa |r|) of it, is left out. `strength` and `shift` hold kappa and kappa^2 square / 2.
void sum_far_densities(double const* arrival, double const* correlation, std::size_t count, double const* strength,
                       double const* shift, double* sums) {
    constexpr auto lanes = hn::MaxLanes(Real());
    constexpr std::size_t together = 8;
    constexpr double farthest = 690;
    for (std::size_t lane = 0; lane < together; lane += lanes) {
        auto sum = real(0);
        for (std::size_t j = lane; j < count; j += together) {
            auto const r = hn::Abs(hn::LoadU(Real(), correlation + j));
            auto all = real(0);
            for (std::size_t i = 0; i < pulse_strengths.size(); ++i) {
                auto const exponent = hn::Sub(hn::Mul(r, real(strength[i])), real(shift[i]));
                all = hn::Add(all, exp_of(hn::Clamp(exponent, real(-farthest), real(farthest))));
            }
            sum = hn::Add(sum, hn::Mul(hn::LoadU(Real(), arrival + j), all));
        }
        hn::StoreU(sum, Real(), sums + lane);
    }
}

// With E = exp r and F = exp(step r): exp((1 - step) r) = E / F, exp((1 + step) r) = E F. `scale` holds exp(-kappa^2
// square / 2) / 6 of the three strengths. Eight sums, whatever the registers hold.
void sum_densities(double const* arrival, double const* correlation, std::size_t count, double const* scale,
                   double* sums) {
    constexpr auto lanes = hn::MaxLanes(Real());
    constexpr std::size_t together = 8;
    // Beyond it a draw's weight is nothing, if square is no more than `largest_square`: exp(-largest/3) or less.
    constexpr double largest = 600;
    for (std::size_t lane = 0; lane < together; lane += lanes) {
        auto sum = real(0);
        for (std::size_t j = lane; j < count; j += together) {
            auto const r = hn::Min(hn::Abs(hn::LoadU(Real(), correlation + j)), real(largest));
            auto const e = exp_of(r);
            auto const f = exp_of(hn::Mul(r, real(strength_step)));
            auto const under_e = hn::Div(real(1), e);
            auto const under_f = hn::Div(real(1), f);
            auto const weak = hn::Add(hn::Mul(e, under_f), hn::Mul(f, under_e));
            auto const even = hn::Add(e, under_e);
            auto const strong = hn::Add(hn::Mul(e, f), hn::Mul(under_e, under_f));
            auto const all = hn::Add(hn::Add(hn::Mul(weak, real(scale[0])), hn::Mul(even, real(scale[1]))),
                                     hn::Mul(strong, real(scale[2])));
            sum = hn::Add(sum, hn::Mul(hn::LoadU(Real(), arrival + j), all));
        }
        hn::StoreU(sum, Real(), sums + lane);
    }
}

}  // namespace overturn::rare::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overturn::rare {

HWY_EXPORT(sum_densities);
HWY_EXPORT(sum_far_densities);

double pulse_density(std::span<double const> arrival, std::span<double const> correlation, double square) {
    constexpr std::size_t together = 8;
    OVERTURN_EXPECT(arrival.size() == correlation.size() && arrival.size() % together == 0);
    constexpr double largest_square = 750;  // for the largest strength, exp(-kappa^2 square / 2) is then e-215
    constexpr double shares = 2.0 * pulse_strengths.size();
    std::array<double, pulse_strengths.size()> shift{};
    std::array<double, pulse_strengths.size()> scale{};
    for (std::size_t i = 0; i < pulse_strengths.size(); ++i) {
        shift[i] = 0.5 * pulse_strengths[i] * pulse_strengths[i] * square;
        scale[i] = std::exp(-shift[i]) / shares;
    }
    bool const far = square > largest_square;
    std::array<double, together> sums{};
    if (far) {
        HWY_DYNAMIC_DISPATCH(sum_far_densities)
        (arrival.data(), correlation.data(), arrival.size(), pulse_strengths.data(), shift.data(), sums.data());
    } else {
        HWY_DYNAMIC_DISPATCH(sum_densities)
        (arrival.data(), correlation.data(), arrival.size(), scale.data(), sums.data());
    }
    double const sum = ((sums[0] + sums[4]) + (sums[1] + sums[5])) + ((sums[2] + sums[6]) + (sums[3] + sums[7]));
    return far ? sum / shares : sum;
}

}  // namespace overturn::rare
#endif
