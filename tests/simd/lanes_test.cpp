// Requirement R-1002: lanes give, bit for bit, what plain numbers give: on every instruction set, in any number of
// registers.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "simd/instruction_sets.hpp"
#include "simd/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "simd/lanes_test.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes first: it includes this file once per instruction set
#include "simd/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::HWY_NAMESPACE {
namespace lanes = simd::HWY_NAMESPACE;

// Chaotic: one product that is contracted where it should not be, or not where it should be, would show.
template <class V> void recur_some(typename V::Number* values) {
    using Number = typename V::Number;
    V x = V::load(values);
    for (int n = 0; n < 1000; ++n) {
        V const plain = Number{3.7F} * x * (Number{1} - x) + Number{1e-3F} * x;
        x = max(fma(plain, Number{1e-3F}, Number{0.999F} * plain), fma(x, x, -x));
    }
    x.store(values);
}
template <class V> void recur_all(typename V::Number* values) {
    for (std::size_t lane = 0; lane < simd::sweep_lanes; lane += V::count) {
        recur_some<V>(values + lane);
    }
}
void recur(int registers, double* values) {
    registers == 1   ? recur_all<lanes::SweepDoubles<1>>(values)
    : registers == 2 ? recur_all<lanes::SweepDoubles<2>>(values)
                     : recur_all<lanes::SweepDoubles<4>>(values);
}
void recur_in_floats(int registers, float* values) {
    registers == 1   ? recur_all<lanes::SweepFloats<1>>(values)
    : registers == 2 ? recur_all<lanes::SweepFloats<2>>(values)
                     : recur_all<lanes::SweepFloats<4>>(values);
}

template <class V> std::uint32_t compare_some(double const* a, double const* b, double* to) {
    V const x = V::load(a);
    V const y = V::load(b);
    auto const truth = without((x < y) | (x >= 3.0), !(y <= 2.0)) & (x > -1.0);
    choose(truth, sqrt(abs(x)) / y, min(x, y)).store(to);
    return any(truth) ? bits(truth) : 0;
}
std::uint32_t compare(int registers, double const* a, double const* b, double* to) {
    std::uint32_t all = 0;
    auto const some = [&]<class V>() {
        for (std::size_t lane = 0; lane < simd::sweep_lanes; lane += V::count) {
            all |= compare_some<V>(a + lane, b + lane, to + lane) << lane;
        }
    };
    registers == 1   ? some.template operator()<lanes::SweepDoubles<1>>()
    : registers == 2 ? some.template operator()<lanes::SweepDoubles<2>>()
                     : some.template operator()<lanes::SweepDoubles<4>>();
    return all;
}

void fetch_all(double const* const* samples, double const* index, double* here, double* next) {
    using V = lanes::SweepDoubles<2>;
    for (std::size_t lane = 0; lane < simd::sweep_lanes; lane += V::count) {
        V first;
        V second;
        fetch(samples + lane, V::load(index + lane), first, second);
        first.store(here + lane);
        second.store(next + lane);
    }
}

}  // namespace overturn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overturn {

HWY_EXPORT(recur);
HWY_EXPORT(recur_in_floats);
HWY_EXPORT(compare);
HWY_EXPORT(fetch_all);

namespace {

template <class Number> Number recurred(Number x) {
    for (int n = 0; n < 1000; ++n) {
        Number const plain = Number{3.7F} * x * (1 - x) + Number{1e-3F} * x;
        x = std::max(std::fma(plain, Number{1e-3F}, Number{0.999F} * plain), std::fma(x, x, -x));
    }
    return x;
}

template <class Number> simd::LaneValues<Number> starts() {
    simd::LaneValues<Number> values;
    for (std::size_t lane = 0; lane < values.size(); ++lane) {
        values.at(lane) = Number{0.05F} + Number{0.05F} * static_cast<Number>(lane);
    }
    return values;
}

constexpr std::array register_counts{1, 2, 4};

// The sets compiled here that this machine has; the last is plain doubles.
class Lanes : public testing::TestWithParam<std::int64_t> {
  private:
    simd::OnlyInstructionSet only_{GetParam()};
};

TEST_P(Lanes, DoublesAreThePlainOnes) {
    auto alone = starts<double>();
    std::ranges::transform(alone, alone.begin(), recurred<double>);
    for (int const registers : register_counts) {
        auto together = starts<double>();
        HWY_DYNAMIC_DISPATCH(recur)(registers, together.data());
        EXPECT_EQ(together, alone) << registers;
    }
}

TEST_P(Lanes, FloatsAreThePlainOnes) {
    auto alone = starts<float>();
    std::ranges::transform(alone, alone.begin(), recurred<float>);
    for (int const registers : register_counts) {
        auto together = starts<float>();
        HWY_DYNAMIC_DISPATCH(recur_in_floats)(registers, together.data());
        EXPECT_EQ(together, alone) << registers;
    }
}

TEST_P(Lanes, ComparisonsChooseLaneByLane) {
    simd::LaneValues<> a;
    simd::LaneValues<> b;
    simd::LaneValues<> expected;
    std::uint32_t truths = 0;
    for (std::size_t lane = 0; lane < a.size(); ++lane) {
        double const x = a.at(lane) = static_cast<double>(lane * 7 % 11) - 3;
        double const y = b.at(lane) = static_cast<double>(lane * 5 % 7) - 2;
        bool const truth = (x < y || x >= 3) && y <= 2 && x > -1;
        expected.at(lane) = truth ? std::sqrt(std::abs(x)) / y : std::min(x, y);
        truths |= truth ? 1U << lane : 0;
    }
    EXPECT_NE(truths, 0U);
    EXPECT_NE(truths, 0xffffU);
    for (int const registers : register_counts) {
        simd::LaneValues<> chosen;
        EXPECT_EQ(HWY_DYNAMIC_DISPATCH(compare)(registers, a.data(), b.data(), chosen.data()), truths) << registers;
        EXPECT_EQ(chosen, expected) << registers;
    }
}

TEST_P(Lanes, EachLaneFetchesFromItsOwnSamples) {
    std::vector<double> samples(1000);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        samples[i] = static_cast<double>(i);
    }
    std::array<double const*, simd::sweep_lanes> from{};
    simd::LaneValues<> index;
    simd::LaneValues<> expected;
    simd::LaneValues<> here;
    simd::LaneValues<> next;
    for (std::size_t lane = 0; lane < simd::sweep_lanes; ++lane) {
        std::size_t const first = 41 * lane;
        from.at(lane) = samples.data() + first;
        index.at(lane) = static_cast<double>(3 * lane);
        expected.at(lane) = samples[first + 3 * lane];
    }
    HWY_DYNAMIC_DISPATCH(fetch_all)(from.data(), index.data(), here.data(), next.data());
    EXPECT_EQ(here, expected);
    for (double& value : expected) {
        value += 1;
    }
    EXPECT_EQ(next, expected);
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, Lanes, testing::ValuesIn(simd::instruction_sets()),
                         [](auto const& info) { return std::string(simd::name_of(info.param)); });

}  // namespace
}  // namespace overturn
#endif
