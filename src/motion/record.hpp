/// Recorded accelerograms: from the bytes of a file to a GroundMotion.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "config/registry.hpp"
#include "motion/ground_motion.hpp"

namespace overturn {

/// What is known about a record besides its bytes. Nothing that is missing is ever guessed.
struct RecordRequest {
    std::string name = "record";             ///< the file's name, for messages
    std::string format = "auto";             ///< a name of record_formats(), or "auto": decided by the content
    std::optional<double> unit_mps2 = {};    ///< SI value of one unit of the numbers, from unit_factor() [m/s2]
    std::optional<double> time_step_s = {};  ///< where the file states none [s]
};

/// The motion in the file's `content` (all its bytes). Formats that hold one component fill horizontal_mps2, whatever
/// its direction: the caller places it.
/// \throws InputError naming file and line if the format is not known, the content is damaged, or a unit or time step
/// is missing or contradicts what the file says.
[[nodiscard]] GroundMotion read_record(std::string_view content, RecordRequest const& request);

using RecordReader = GroundMotion (*)(std::string_view content, RecordRequest const& request);

/// How a format is recognised (by content, never by the file's extension) and read.
struct RecordFormat {
    bool (*recognises)(std::string_view content);
    RecordReader read;
};

/// All formats, in the order in which "auto" asks them.
[[nodiscard]] std::span<config::Entry<RecordFormat> const> record_formats();

}  // namespace overturn
