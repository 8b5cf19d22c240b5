// Requirement R-107: miniSEED is read to its samples, rate and channels; its numbers have no unit, which must be
// stated, of counts with what one of them is; gaps, velocities and damage are refused.
#include <bit>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "core/units.hpp"
#include "motion/record.hpp"
#include "support/expect_input_error.hpp"
#include "support/read_record.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

constexpr std::size_t record_bytes = 256;

void put(std::string& record, std::size_t at, std::uint32_t value, std::size_t bytes) {
    for (std::size_t i = 0; i < bytes; ++i) {
        record[at + i] = static_cast<char>(value >> (8 * (bytes - 1 - i)) & 0xFFU);
    }
}

/// One data record of SEED 2, big-endian, at 100 Hz. \param begin_ms behind the full minute
template <class Number>
std::string block(std::string const& channel, std::vector<Number> const& samples, int begin_ms = 0) {
    std::string record(record_bytes, '\0');
    record.replace(0, 20, "000001D STA  00" + channel + "XX");
    put(record, 20, 2020, 2);
    put(record, 22, 60, 2);
    put(record, 26, static_cast<std::uint32_t>(begin_ms / 1000), 1);
    put(record, 28, static_cast<std::uint32_t>(begin_ms % 1000 * 10), 2);
    put(record, 30, static_cast<std::uint32_t>(samples.size()), 2);
    put(record, 32, 100, 2);
    put(record, 34, 1, 2);
    put(record, 39, 1, 1);
    put(record, 44, 64, 2);
    put(record, 46, 48, 2);
    put(record, 48, 1000, 2);
    put(record, 52, std::is_integral_v<Number> ? 3 : 4, 1);
    put(record, 53, 1, 1);
    put(record, 54, 8, 1);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        put(record, 64 + 4 * i, std::bit_cast<std::uint32_t>(samples[i]), 4);
    }
    return record;
}

std::vector<std::int32_t> const counts{-20, 40, -30, 10};
std::vector<float> const numbers{-0.5F, 1.5F, -0.25F, 0};

RecordRequest stated(std::string const& unit) {
    RecordRequest request{.name = "f"};
    state_unit(request, unit);
    return request;
}

class MiniSeed : public ::testing::Test {
  protected:
    void SetUp() override {
        try {
            (void)read_recording(block("HNE", counts), {});
        } catch (InputError const& error) {
            if (std::string(error.what()).find("without libmseed") != std::string::npos) {
                GTEST_SKIP() << error.what();
            }
        }
    }
};

TEST_F(MiniSeed, CountsAreWhatIsStatedOfOne) {
    auto const text = block("HNE", counts) + block("HNE", counts, 40);
    auto const placed = read_placed(text, stated("2e-3 m/s2"));
    EXPECT_EQ(placed.format, "miniseed");
    EXPECT_EQ(placed.motion.time_step_s, 0.01);
    EXPECT_EQ(placed.components, std::vector<std::string>{"HNE"});
    EXPECT_EQ(placed.direction, Direction::horizontal);
    std::vector<double> const once{-20 * 2e-3, 40 * 2e-3, -30 * 2e-3, 10 * 2e-3};
    ASSERT_EQ(placed.motion.samples(), 8U);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(placed.motion.horizontal_mps2[i], once[i % 4]);
    }
}

TEST_F(MiniSeed, ChannelsOfAStationFindTheirPlaces) {
    auto const placed = read_placed(block("HNZ", numbers) + block("HNN", numbers) + block("HNE", numbers), stated("g"));
    EXPECT_EQ(placed.components, (std::vector<std::string>{"HNN", "HNE", "HNZ"}));
    EXPECT_EQ(placed.motion.vertical_mps2[1], 1.5 * g0);
}

TEST_F(MiniSeed, TheUnitIsDemanded) {
    auto const refuse = [](std::string const& text, RecordRequest const& request, char const* part) {
        expect_input_error([&] { (void)read_placed(text, request); }, "f:", part);
    };
    refuse(block("HNE", counts), {.name = "f"}, "unit missing (counts of an instrument");
    refuse(block("HNE", counts), stated("gal"), "unit missing (counts of an instrument");
    refuse(block("HNE", numbers), {.name = "f"}, "unit missing (miniSEED holds none)");
    EXPECT_THROW((void)stated("2e-6"), InputError);
    EXPECT_THROW((void)stated("0 gal"), InputError);
    EXPECT_THROW((void)stated("2e-6 kg"), InputError);
}

TEST_F(MiniSeed, WhatIsNoOneMotionIsRefused) {
    auto const refuse = [](std::string const& text, char const* part) {
        expect_input_error([&] { (void)read_placed(text, stated("1e-3 gal")); }, "f:", part);
    };
    refuse(block("HNE", counts) + block("HNE", counts, 60), "record 2 of the file: HNE goes on 0.02 s later");
    refuse(block("HNE", counts) + block("HNE", counts, 20), "HNE goes on 0.02 s earlier");
    refuse(block("HNE", counts) + block("HNN", counts, 500), "HNN begins 0.5 s from HNE");
    refuse(block("HHE", counts), "channel HHE (its second letter is none of N, L and G");
    refuse(block("BH3", counts), "channel BH3 (its second letter is none of N, L and G");
    auto other = block("HNN", counts);
    refuse(block("HNE", counts) + other.replace(8, 3, "OTH"), "one station is one motion");
    refuse(block("HNE", counts).substr(0, 200), "cut short");
    refuse(block("HNE", counts) + block("HNE", counts, 40).substr(0, 100), "cut short");
    refuse(block("HNE", std::vector{1.0F, std::bit_cast<float>(0x7FC00000U), 1.0F, 1.0F}), "a number that is none");
}

// a step that differs is a contradiction here too.
TEST_F(MiniSeed, AnotherStepContradicts) {
    auto request = stated("1e-3 gal");
    request.time_step_s = 0.02;
    expect_input_error([&] { (void)read_placed(block("HNE", counts), request); }, "f:", "contradict");
}

}  // namespace
}  // namespace overturn
