/// A record as the program reads and places it.
#pragma once

#include <string_view>

#include "motion/record.hpp"

namespace overturn {

/// The motion that the file holds, placed by place(). \throws InputError as read_recording and place
[[nodiscard]] inline PlacedRecord read_placed(std::string_view content, RecordRequest const& request) {
    auto placed = place(read_recording(content, request), request.component, request.components, {request.name});
    validate_motion(placed.motion);
    return placed;
}

namespace testing {

/// Only the motion of read_placed.
[[nodiscard]] inline GroundMotion read_record(std::string_view content, RecordRequest const& request) {
    return read_placed(content, request).motion;
}

}  // namespace testing
}  // namespace overturn
