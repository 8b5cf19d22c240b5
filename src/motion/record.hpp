/// Recorded accelerograms: from the bytes of a file to what its station felt.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "config/registry.hpp"
#include "motion/recording.hpp"

namespace overturn {

/// Statements about a record besides its bytes. Nothing that is missing is ever guessed.
struct RecordRequest {
    std::string name = "record";             ///< the file's name, for messages
    std::string format = "auto";             ///< a name of record_formats(), or "auto": decided by the content
    std::optional<double> unit_mps2 = {};    ///< SI value of one unit of the numbers, from state_unit() [m/s2]
    bool unit_has_number = false;            ///< "2.4e-6 m/s2": what one count of an instrument is
    std::optional<double> time_step_s = {};  ///< where the file states none [s]
    std::string columns = {};    ///< "time,h1,h2,v": what a table's columns are, where their names do not say it
    std::string component = {};  ///< component in the rocking plane; empty: the first horizontal one
    ComponentChoice components = ComponentChoice::file;
    bool by_place = false;  ///< unnamed columns behind the time: horizontal[, transverse][, vertical], as in old files
    bool may_be_resampled = false;               ///< a stated step other than the file's own is no contradiction
    std::string unit_key = "--unit gal|g|m/s2";  ///< option or key for the unit, for messages
    std::string columns_key = "--columns {}";    ///< option or key for the columns, {} an example
    std::string unit_conflict = "Leave the stated unit out";  ///< advice where the file states another
};

/// Takes a unit as users write it: "gal", or with a number "2.4e-6 m/s2". \throws InputError without a place
void state_unit(RecordRequest& request, std::string_view text);

/// Everything in the file's `content` (all its bytes).
/// \throws InputError naming file and line if the format is not known, the content is damaged, or a unit or time step
/// is missing or contradicts what the file says.
[[nodiscard]] Recording read_recording(std::string_view content, RecordRequest const& request);

/// What it ends with for a sensor in a borehole.
inline constexpr std::string_view in_borehole_mark = ", borehole";
/// Common key of the files of one station, event and time, from their headers alone; empty if `head`, the beginning of
/// a file, does not state it, or its format has several components to a file anyway.
[[nodiscard]] std::string station_of_record(std::string_view head);

/// A table under a head of its own: how it is recognised, and what its head leaves unsaid. Everything else are
/// statements that any table's text makes.
struct TableFormat {
    std::array<std::string_view, 3> marks;  ///< in lower case: all stand in the first lines of text; "" counts not
    double unit_mps2 = 0;                   ///< of all files of the format [m/s2]; 0: their text says it
};

using RecordReader = Recording (*)(std::string_view content, RecordRequest const& request);

/// A format: its recognition (by content, never by the file's extension) and its reader.
struct RecordFormat {
    bool (*recognises)(std::string_view content);
    RecordReader read;
    std::string (*station)(std::string_view head) = nullptr;  ///< for station_of_record; may throw InputError
    TableFormat const* table = nullptr;                       ///< in place of the two above where a description does
};

/// All formats, in the order in which "auto" tries them.
[[nodiscard]] std::span<config::Entry<RecordFormat> const> record_formats();

}  // namespace overturn
