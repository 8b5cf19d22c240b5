/// Fields of a kernel's lanes, field by field, so that a register takes one field of several lanes.
#pragma once

#include <array>
#include <cstddef>

namespace overturn::simd {

/// Lanes that a kernel works on side by side at most: two of the widest registers of doubles.
inline constexpr int most_lanes = 16;

/// \tparam Field an enum of the numbers that a lane holds, `count` the last
/// \tparam Wave an enum of the sample series that a lane reads, `count` the last
template <class Field, class Wave, int Lanes> struct LaneFields {
    static constexpr std::size_t fields = static_cast<std::size_t>(Field::count);
    static constexpr std::size_t waves = static_cast<std::size_t>(Wave::count);

    alignas(64) std::array<double, fields * Lanes> values{};  ///< `Lanes` of the first field, of the second, ...
    std::array<double const*, waves * Lanes> samples{};       ///< first ones; likewise

    [[nodiscard]] double& at(Field field, int lane) { return values[place(field, lane)]; }
    [[nodiscard]] double at(Field field, int lane) const { return values[place(field, lane)]; }
    [[nodiscard]] double const*& at(Wave wave, int lane) { return samples[place(wave, lane)]; }
    [[nodiscard]] double const* at(Wave wave, int lane) const { return samples[place(wave, lane)]; }

    void copy_lane(int from, int to) {
        for (std::size_t field = 0; field < fields; ++field) {
            values[field * Lanes + to] = values[field * Lanes + from];
        }
        for (std::size_t wave = 0; wave < waves; ++wave) {
            samples[wave * Lanes + to] = samples[wave * Lanes + from];
        }
    }

  private:
    template <class Name> static std::size_t place(Name name, int lane) {
        return static_cast<std::size_t>(name) * Lanes + static_cast<std::size_t>(lane);
    }
};

}  // namespace overturn::simd
