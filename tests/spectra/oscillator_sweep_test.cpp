// Requirement R-102: two groups of oscillators that are swept side by side give what each gives alone, to the last bit.
#include "spectra/detail/oscillator_sweep.hpp"

#include <gtest/gtest.h>

#include "core/units.hpp"
#include "simd/instruction_sets.hpp"
#include "support/waves.hpp"

namespace overturn {
namespace {

constexpr double time_step_s = 0.01;

// Sixteen oscillators of rising period.
OscillatorGroup group_of(SweepForm form, std::size_t stride, double shortest_s) {
    OscillatorGroup group;
    group.form = form;
    group.stride = stride;
    double period_s = shortest_s;
    for (std::size_t lane = 0; lane < simd::sweep_lanes; ++lane, period_s *= 1.02) {
        double const w = 2 * pi / period_s;
        group.set(lane, w, 0.05, OscillatorStep(w, 0.05, time_step_s), time_step_s);
    }
    return group;
}

OscillatorGroup const stiff = group_of(SweepForm::amplitude, 1, 0.03);
OscillatorGroup const middle = group_of(SweepForm::samples, 1, 0.15);
OscillatorGroup const soft = group_of(SweepForm::strided, 2, 0.5);
OscillatorGroup const softest = group_of(SweepForm::strided, 8, 2);

TEST(SideBySide, GivesTheBitsOfEachAlone) {
    auto const wave = testing::broad_wave(1000, time_step_s);
    OscillatorGroup const stiffer = group_of(SweepForm::amplitude, 1, 0.02);
    OscillatorGroup const softer = group_of(SweepForm::strided, 2, 0.7);
    OscillatorGroup const slowest = group_of(SweepForm::strided, 8, 3);
    for (auto const set : simd::instruction_sets()) {
        simd::OnlyInstructionSet const only(set);
        for (auto const& groups : {std::array{&stiff, &stiffer}, {&soft, &softer}, {&slowest, &softest}}) {
            std::array<SweepTiles, 2> both;
            sweep(groups, wave, both);
            for (std::size_t i = 0; i < 2; ++i) {
                SweepTiles alone;
                sweep(*groups.at(i), wave, alone);
                EXPECT_EQ(both.at(i).value, alone.value) << simd::name_of(set) << ' ' << i;
                EXPECT_EQ(both.at(i).highest, alone.highest) << simd::name_of(set) << ' ' << i;
            }
        }
    }
}

// In one loop both are looked at equally often. Groups in the form of samples do not wait, so nothing is won.
TEST(SideBySide, TakesGroupsOfOneFormAndStride) {
    for (auto const set : simd::instruction_sets()) {
        simd::OnlyInstructionSet const only(set);
        bool const wins = simd::name_of(set).starts_with("AVX3");  // a group is two registers
        EXPECT_EQ(go_side_by_side(stiff, stiff), wins) << simd::name_of(set);
        EXPECT_EQ(go_side_by_side(soft, soft), wins);
        EXPECT_EQ(go_side_by_side(softest, softest), wins);
        EXPECT_FALSE(go_side_by_side(middle, middle));
        EXPECT_FALSE(go_side_by_side(stiff, middle));
        EXPECT_FALSE(go_side_by_side(stiff, soft));
        EXPECT_FALSE(go_side_by_side(soft, softest));
        EXPECT_FALSE(go_side_by_side(softest, soft));
    }
}

}  // namespace
}  // namespace overturn
