// Requirement R-1107: a known row is taken for a trial of the same motion, scale and drawn body, and for no other.
#include "campaign/detail/known_rows.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace overturn {
namespace {

constexpr std::size_t extra_bytes = 3;

WaveRow motion() {
    WaveRow row;
    row.id = 7;
    row.accepted = Accepted::yes;
    row.duration_s = 20.48;
    row.pga_mps2 = 3;
    row.pgv_mps = 0.4;
    row.pgd_m = 0.1;
    row.arias_mps = 1.5;
    row.vector_pga_mps2 = 3.2;
    row.transverse_pga_mps2 = 2.5;
    row.vertical_pga_mps2 = 2;
    row.turned_rad = 0.1;
    return row;
}

// One that waits for its answer.
TrialRow open_trial() {
    TrialRow row;
    row.wave = 70;
    row.body = 1;
    row.level = 2;
    row.amplitude = 6;
    row.scale = 2;
    row.mass_kg = 12600;
    row.centre_height_m = 1.045;
    row.restitution = 0.85;
    row.static_friction = 0.5;
    row.kinetic_friction = 0.4;
    row.v_ereq_mps = 1.3;
    return row;
}

TrialRow answered() {
    auto row = open_trial();
    row.wave = 5;
    row.body = 0;
    row.level = 0;
    row.verdict = Verdict::rocked;
    row.peak_rotation_rad = 0.2;
    return row;
}

// Two trials of one wave, of which the second is known.
KnownWave known_wave() {
    TrialRows trials{{open_trial(), answered()}, {}};
    for (int const byte : {0, 0, 0, 1, 2, 3}) {
        trials.extra.push_back(static_cast<std::byte>(byte));
    }
    return {motion(), std::move(trials), {false, true}};
}

bool taken(WaveRow const& made, TrialRow open, std::size_t place = 1) {
    std::array<std::byte, extra_bytes> extra{};
    return KnownRows(known_wave(), made).take(place, open, extra);
}

TEST(KnownRows, AreTakenWithTheNumbersOfTheNewCampaign) {
    auto row = open_trial();
    std::array<std::byte, extra_bytes> extra{};
    ASSERT_TRUE(KnownRows(known_wave(), motion()).take(1, row, extra));
    EXPECT_EQ(row.verdict, Verdict::rocked);
    EXPECT_EQ(row.peak_rotation_rad, 0.2);
    EXPECT_EQ((std::array{row.wave, row.body, row.level}), (std::array<std::int64_t, 3>{70, 1, 2}));
    EXPECT_EQ(extra, (std::array{std::byte{1}, std::byte{2}, std::byte{3}}));
}

TEST(KnownRows, OfNothingAndOfOtherTrialsAreNot) {
    EXPECT_FALSE(taken(motion(), open_trial(), 0)) << "this one is not known";
    auto row = open_trial();
    std::array<std::byte, extra_bytes> extra{};
    EXPECT_FALSE(KnownRows(std::nullopt, motion()).take(1, row, extra));
}

// The last bit of any one measure is enough.
TEST(KnownRows, OfAnotherMotionAreNot) {
    ASSERT_TRUE(taken(motion(), open_trial()));
    for (auto const measure : {&WaveRow::duration_s, &WaveRow::pga_mps2, &WaveRow::pgv_mps, &WaveRow::pgd_m,
                               &WaveRow::arias_mps, &WaveRow::vector_pga_mps2, &WaveRow::transverse_pga_mps2,
                               &WaveRow::vertical_pga_mps2, &WaveRow::turned_rad}) {
        auto other = motion();
        other.*measure = std::nextafter(other.*measure, 0);
        EXPECT_FALSE(taken(other, open_trial()));
    }
    for (auto const& change :
         std::vector<std::function<void(WaveRow&)>>{[](auto& row) { row.id = 8; }, [](auto& row) { row.failed = 1; },
                                                    [](auto& row) { row.accepted = Accepted::no; }}) {
        auto other = motion();
        change(other);
        EXPECT_FALSE(taken(other, open_trial()));
    }
}

TEST(KnownRows, OfAnotherScaleOrBodyAreNot) {
    for (auto const value :
         {&TrialRow::amplitude, &TrialRow::scale, &TrialRow::mass_kg, &TrialRow::centre_height_m,
          &TrialRow::restitution, &TrialRow::static_friction, &TrialRow::kinetic_friction, &TrialRow::v_ereq_mps}) {
        auto other = open_trial();
        other.*value = std::nextafter(other.*value, 0);
        EXPECT_FALSE(taken(motion(), other));
    }
}

// What never came is a NaN, of which one is as good as the same other.
TEST(KnownRows, OfABodyWithoutFrictionAreTaken) {
    auto known = known_wave();
    auto open = open_trial();
    known.trials.rows[1].static_friction = known.trials.rows[1].kinetic_friction = never;
    open.static_friction = open.kinetic_friction = never;
    std::array<std::byte, extra_bytes> extra{};
    EXPECT_TRUE(KnownRows(known, motion()).take(1, open, extra));
}

}  // namespace
}  // namespace overturn
