// Requirement R-101, R-1002: lines that are drawn in vector lanes, on every instruction set, have the bits of those
// that GSL and the C library give one by one.
#include "generators/detail/line_draws.hpp"

#include <bit>
#include <cmath>

#include <gsl/gsl_randist.h>
#include <gtest/gtest.h>

#include "core/units.hpp"
#include "simd/instruction_sets.hpp"
#include "simd/stream_words.hpp"

namespace overturn {
namespace {

using Bits = std::pair<std::uint64_t, std::uint64_t>;

Bits bits(std::complex<double> z) {
    return {std::bit_cast<std::uint64_t>(z.real()), std::bit_cast<std::uint64_t>(z.imag())};
}

Lines one_by_one(LineStreams const& streams, std::vector<double> const& amplitude, LineAmplitudes kind) {
    RandomStream phases(streams.phases);
    RandomStream amplitudes(streams.amplitudes);
    Lines lines(amplitude.size());
    for (std::size_t k = 1; k < lines.size(); ++k) {
        double const scatter =
            kind == LineAmplitudes::gaussian ? gsl_ran_rayleigh(amplitudes.gsl(), std::sqrt(0.5)) : 1.0;
        lines[k] = std::polar(scatter * amplitude[k], gsl_ran_flat(phases.gsl(), 0, 2 * pi));
    }
    return lines;
}

// Of lengths below, at and above what is made at once.
TEST(LineDraws, AreThoseOfGslAndTheCLibrary) {
    for (auto const set : simd::instruction_sets()) {
        simd::OnlyInstructionSet const only(set);
        for (std::size_t const count : {0UL, 1UL, 2UL, 32UL, 33UL, 257UL, 258UL, 20'000UL}) {
            std::vector<double> amplitude(count);
            for (std::size_t k = 0; k < count; ++k) {
                amplitude[k] = k % 5 == 0 ? 0 : 1 / static_cast<double>(k);
            }
            for (auto const kind : {LineAmplitudes::fixed, LineAmplitudes::gaussian}) {
                LineStreams const streams{{7, count, Purpose::wave_phase, 2}, {7, count, Purpose::wave_amplitude, 2}};
                auto const wanted = one_by_one(streams, amplitude, kind);
                auto const lines = draw_lines(streams, amplitude, kind);
                ASSERT_EQ(lines.size(), count);
                for (std::size_t k = 0; k < count; ++k) {
                    ASSERT_EQ(bits(lines[k]), bits(wanted[k])) << simd::name_of(set) << " " << count << " " << k;
                }
            }
        }
    }
}

void expect_scatters_of_the_c_library(std::vector<double> numbers, std::string_view where) {
    numbers.resize((numbers.size() + simd::counters_together - 1) / simd::counters_together * simd::counters_together,
                   0.5);
    std::vector<double> scatters(numbers.size());
    scatters_of(numbers, scatters.data());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        double const wanted = std::sqrt(0.5) * std::sqrt(-2 * std::log(numbers[i]));
        ASSERT_EQ(std::bit_cast<std::uint64_t>(scatters[i]), std::bit_cast<std::uint64_t>(wanted))
            << where << " " << numbers[i];
    }
}

// Numbers of any size, the least and the largest that are drawn, and the least steps about the borders of the table's
// 128 parts and of what is near 1.
TEST(LineDraws, ScattersAreThoseOfTheCLibrary) {
    std::vector<double> numbers;
    for (int power = 1; power <= 53; ++power) {
        for (double const times : {1.0, 3.0, 5.0}) {
            numbers.push_back(times * std::ldexp(1, -power - 3));
            numbers.push_back(1 - times * std::ldexp(1, -power - 3));
        }
    }
    for (int part = 0; part <= 256; ++part) {
        double const border = 0.5 + part / 512.0;
        for (int step = -3; step <= 3; ++step) {
            numbers.push_back(border + step * 0x1p-53);
            numbers.push_back((border + step * 0x1p-53) / 1024);
        }
    }
    RandomStream stream(StreamKey{3, 1, Purpose::wave_amplitude, 0});
    for (int i = 0; i < 300'000; ++i) {
        numbers.push_back(gsl_rng_uniform_pos(stream.gsl()));
        numbers.push_back(1 - gsl_rng_uniform_pos(stream.gsl()) / 16);
        numbers.push_back(std::ldexp(gsl_rng_uniform_pos(stream.gsl()), -(i % 40)));
    }
    std::erase_if(numbers, [](double u) { return u < 0x1p-53 || u >= 1; });
    for (auto const set : simd::instruction_sets()) {
        simd::OnlyInstructionSet const only(set);
        expect_scatters_of_the_c_library(numbers, simd::name_of(set));
    }
}

void expect_turns_of_the_c_library(std::vector<std::uint64_t> words, std::string const& where) {
    words.resize((words.size() + simd::words_together - 1) / simd::words_together * simd::words_together);
    std::vector<std::complex<double>> turns(words.size());
    turns_of(words, turns.data());
    for (std::size_t i = 0; i < words.size(); ++i) {
        double const angle = static_cast<double>(words[i] >> 11U) * 0x1p-53 * (2 * pi);
        ASSERT_EQ(bits(turns[i]), bits({std::cos(angle), std::sin(angle)})) << where << " " << angle;
    }
}

// Where the reduction by pi/2 changes its count, and where it needs more digits: about every eighth of a turn, from one
// step of the words' numbers to a thousandth of a turn off it.
TEST(LineDraws, TurnsAboutEighthsAreThoseOfTheCLibrary) {
    for (auto const set : simd::instruction_sets()) {
        simd::OnlyInstructionSet const only(set);
        for (std::uint64_t eighth = 0; eighth <= 8; ++eighth) {
            std::vector<std::uint64_t> words;
            for (unsigned power = 11; power < 54; ++power) {
                for (std::uint64_t const times : {1UL, 3UL, 5UL}) {
                    auto const middle = eighth << 61U;  // the last is 0 again, and what lies below it the end of a turn
                    words.push_back(middle + (times << power));
                    words.push_back(middle - (times << power));
                }
            }
            expect_turns_of_the_c_library(std::move(words), std::string(simd::name_of(set)));
        }
    }
}

TEST(LineDraws, AMillionTurnsAreThoseOfTheCLibrary) {
    for (auto const set : simd::instruction_sets()) {
        simd::OnlyInstructionSet const only(set);
        std::vector<std::uint64_t> words(1U << 20U);
        simd::stream_words({2013, 1, Purpose::wave_phase}, 0, words);
        expect_turns_of_the_c_library(std::move(words), std::string(simd::name_of(set)));
    }
}

}  // namespace
}  // namespace overturn
