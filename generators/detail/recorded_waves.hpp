/// Measured motions as a source of waves.
#pragma once

#include <memory>
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
    std::string withheld;  ///< name of a file that is not there
    std::string name;      ///< of its file (of the horizontal component's), as the campaign says it
};

/// They in their order. \pre there is one
[[nodiscard]] std::unique_ptr<WaveSource> recorded_waves(std::vector<Record> records);

}  // namespace overturn
