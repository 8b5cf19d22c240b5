/// Measured motions as a source of waves.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
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
    std::string withheld;  ///< name of a file that is not there
    std::string name;      ///< of its file (of the horizontal component's), as the campaign says it
};

/// Two of them that are one motion, in all components and to the last bit; empty: all differ.
[[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> same_motion_twice(std::span<Record const> records);

/// They in their order. \pre there is one
[[nodiscard]] std::unique_ptr<WaveSource> recorded_waves(std::vector<Record> records);

}  // namespace overturn
