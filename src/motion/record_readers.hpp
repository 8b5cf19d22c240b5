/// The readers behind record_formats(), one source file each, and the checks that they share.
#pragma once

#include <string_view>

#include "core/error.hpp"
#include "motion/record.hpp"

namespace overturn {

/// PEER strong-motion AT2: a header with NPTS and DT in its first ten lines, then accelerations in g.
[[nodiscard]] bool recognises_peer_at2(std::string_view content);
[[nodiscard]] GroundMotion read_peer_at2(std::string_view content, RecordRequest const& request);

/// K-NET and KiK-net ASCII (NIED): 17 header lines, then counts; the mean is removed.
[[nodiscard]] bool recognises_knet(std::string_view content);
[[nodiscard]] GroundMotion read_knet(std::string_view content, RecordRequest const& request);

/// Columns: [time,] a_horizontal [, a_vertical]; the unit must be stated.
[[nodiscard]] bool recognises_columns(std::string_view content);
[[nodiscard]] GroundMotion read_columns(std::string_view content, RecordRequest const& request);

/// \throws InputError if the user stated a unit other than the file's own.
void check_stated_unit(RecordRequest const& request, double file_unit_mps2, Location const& where);

/// \throws InputError if the user stated a time step that differs from the file's own by more than printed rounding.
void check_stated_time_step(RecordRequest const& request, double file_time_step_s, Location const& where);

}  // namespace overturn
