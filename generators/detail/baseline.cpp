#include "generators/detail/baseline.hpp"

#include <array>
#include <cstddef>

#include "simd/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "generators/detail/baseline.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes first: it includes this file once per instruction set
#include "simd/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::HWY_NAMESPACE {

using SomeLanes = simd::HWY_NAMESPACE::Doubles<2>;

void subtract(BaselinePolynomial const& taken, double per_sample, std::span<double> values) {
    std::array<double, SomeLanes::count> numbers;
    for (std::size_t lane = 0; lane < numbers.size(); ++lane) {
        numbers[lane] = static_cast<double>(lane);
    }
    auto number = SomeLanes::load(numbers.data());
    std::size_t i = 0;
    for (; i + numbers.size() <= values.size(); i += numbers.size()) {
        auto const s = number * per_sample;
        auto const arch = s * (1 - s);
        (SomeLanes::load(&values[i]) - (taken.bump * arch + taken.wave * (arch * (2 * s - 1)))).store(&values[i]);
        number = number + static_cast<double>(numbers.size());
    }
    for (; i < values.size(); ++i) {
        values[i] -= taken(static_cast<double>(i) * per_sample);
    }
}

}  // namespace overturn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overturn {

HWY_EXPORT(subtract);

namespace {

// From rest, of accelerations on straight lines: a sample's share in the end velocity is 1, in the end displacement the
// number of samples that follow; the first and the last have half of a triangle. Four sums side by side, as one would
// wait for itself.
GroundEnd end_of(std::span<double const> a, int last) {
    constexpr int width = 4;
    std::array<double, width> velocity{}, displacement{};
    int i = 1;
    for (; i + width <= last; i += width) {
        for (int j = 0; j < width; ++j) {
            double const value = a[i + j];
            velocity[j] += value;
            displacement[j] += (last - i - j) * value;
        }
    }
    for (; i < last; ++i) {
        velocity[0] += a[i];
        displacement[0] += (last - i) * a[i];
    }
    GroundEnd end{0.5 * (a[0] + a[last]), (0.5 * last - 1.0 / 6) * a[0] + a[last] / 6};
    for (int j = 0; j < width; ++j) {
        end.velocity += velocity[j];
        end.displacement += displacement[j];
    }
    return end;
}

}  // namespace

BaselinePolynomial polynomial_ending(GroundEnd end, std::size_t samples) {
    auto const n = static_cast<double>(samples - 1);
    double const squares = (n - 1) * (2 * n - 1) / (6 * n);  // sums of (i/n)^k over 0 < i < n
    double const cubes = (n - 1) * (n - 1) / (4 * n);
    double const fourths = (n - 1) * (2 * n - 1) * (3 * n * n - 3 * n - 1) / (30 * n * n * n);
    GroundEnd const by_bump{(n * n - 1) / (6 * n), (n * n - 1) / 12};
    double const displacement_by_wave = n * (2 * fourths - 3 * cubes + squares);
    double const bumps = end.velocity / by_bump.velocity;
    return {bumps, (end.displacement - bumps * by_bump.displacement) / displacement_by_wave};
}

void correct_baseline(std::span<double> acceleration_mps2) { correct_baseline_to(acceleration_mps2, {0, 0}); }

void correct_baseline_to(std::span<double> acceleration_mps2, GroundEnd wanted) {
    if (acceleration_mps2.size() < 5) {
        return;
    }
    int const last = static_cast<int>(acceleration_mps2.size()) - 1;
    double const per_sample = 1.0 / last;
    for (int pass = 0; pass < 2; ++pass) {  // the second removes what rounding left
        auto const end = end_of(acceleration_mps2, last);
        auto const taken = polynomial_ending({end.velocity - wanted.velocity, end.displacement - wanted.displacement},
                                             acceleration_mps2.size());
        HWY_DYNAMIC_DISPATCH(subtract)(taken, per_sample, acceleration_mps2);
    }
}

}  // namespace overturn
#endif
