/// A record's motion alone, without how it was placed.
#pragma once

#include <string_view>

#include "motion/record.hpp"

namespace overturn::testing {

/// Only the motion of read_placed.
[[nodiscard]] inline GroundMotion read_record(std::string_view content, RecordRequest const& request) {
    return read_placed(content, request).motion;
}

}  // namespace overturn::testing
