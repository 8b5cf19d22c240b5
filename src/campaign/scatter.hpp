/// Uncertain properties of a body, and how a campaign draws them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "config/table.hpp"
#include "core/random_stream.hpp"
#include "stats/distribution.hpp"

namespace overturn {

/// `key` as a number, or as { distribution = "fixed" | "normal" | "lognormal" | "uniform", ... }: value; mean,
/// deviation; median, beta; low, high. `low` and `high` truncate a normal or lognormal one.
/// Every draw lies in the key's range: what that forbids is cut off. \throws InputError
[[nodiscard]] Distribution read_distribution(config::Table const& table, config::Key const& key);

/// Has a table a key of a distribution, with or without the one that names it?
[[nodiscard]] bool looks_like_distribution(config::Table const& table);

extern config::KeyTable const distribution_table;
/// A number that may be stated as a distribution.
[[nodiscard]] constexpr config::Key distribution_key(std::string_view name, Dimension dimension, config::Range range,
                                                     std::string_view meaning) {
    return config::number_key(name, dimension, range, meaning).or_as(config::table_key<distribution_table>(name, ""));
}

/// The uncertain quantities of a body: one draw of each per wave, the same at every level. Empty: known exactly.
struct BodyScatter {
    std::optional<Distribution> mass, centre_height;  ///< in SI units, as stated (before any similarity law)
    std::optional<Distribution> restitution;
    std::optional<Distribution> friction;  ///< of the static coefficient; the kinetic one keeps its ratio to it
};

/// Spread of the draws over the waves.
enum class Sampling {
    independent,     ///< each wave for itself: more waves change no earlier one
    latin_hypercube  ///< one draw from each of n equally likely slices, n the number of waves, in shuffled order
};

/// The wave that a body is drawn for.
struct DrawnFor {
    std::uint64_t seed = 0;
    std::uint64_t wave = 0;  ///< identity in every random stream
    Sampling sampling = Sampling::independent;
    std::uint64_t place = 0, count = 1, group = 0;  ///< wave `place` of `count` that are sliced together, as `group`
};

/// A number in (0, 1): pure function of the wave, the purpose and the index (body and quantity).
[[nodiscard]] double uniform_for(DrawnFor const& wave, Purpose purpose, std::uint64_t index);

}  // namespace overturn
