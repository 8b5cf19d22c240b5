/// Measured motions as a source of waves.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "generators/wave_source.hpp"
#include "motion/drift.hpp"
#include "motion/ground_motion.hpp"
#include "motion/record.hpp"

namespace overturn {

/// One wave as it was read and prepared.
struct Record {
    GroundMotion motion;
    std::string label;
    Direction direction = Direction::unknown;
    double turned_rad = 0;
    Drift drift;
    std::string withheld;   ///< name of a file that is not there
    std::string name;       ///< of its file (of the horizontal component's), as the campaign says it
    std::string recording;  ///< what the components of one station and event have in common
};

/// Largest difference between two recordings of one motion, over their largest sample [-]: files hold rounded values.
inline constexpr double same_motion_share = 1e-3;

/// Two of a list that are one motion.
struct SameMotion {
    std::size_t first = 0;
    std::size_t second = 0;
    double factor = 1;  ///< the second's horizontal component over the first's
};

/// Two of them whose components are multiples of each other, to `same_motion_share` of their peak, zeros around them
/// apart; empty: all differ.
[[nodiscard]] std::optional<SameMotion> same_motion_twice(std::span<Record const> records);

/// Source of these records in their order. \pre there is one
[[nodiscard]] std::unique_ptr<WaveSource> recorded_waves(std::vector<Record> records);

}  // namespace overturn
