#include <algorithm>
#include <string>

#include "core/units.hpp"
#include "motion/component_name.hpp"
#include "motion/detail/record_readers.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

// EarthScope (IRIS) ASCII: one line of name, count, rate, begin, layout, type and unit, then values, or times and
// values.
constexpr std::string_view begins_series = "timeseries ";
constexpr TableFormat table{.marks = {begins_series, " samples, ", " sps, "}};

/// \throws InputError at a second series: of another channel, or of the same one behind a gap
void check_one_series(std::string_view content, std::string const& file) {
    TextLines lines(content);
    bool found = false;
    while (auto const line = lines.next()) {
        if (!line->starts_with('T') && !line->starts_with('t')) {
            continue;
        }
        bool const begins = lowered(line->substr(0, begins_series.size())) == begins_series;
        if (begins && found) {
            throw InputError({file, lines.number()},
                             "a second series (of another channel, or behind a gap). Put each into a file of its own");
        }
        found = found || begins;
    }
}

/// "HNZ" of "TIMESERIES NET_STA_LOC_HNZ_R, 7 samples": three marks behind the network's; empty if it is written
/// otherwise.
std::string channel_of(std::string_view content) {
    TextLines lines(content);
    auto line = lines.next();
    while (line && lowered(line->substr(0, begins_series.size())) != begins_series) {
        line = lines.next();
    }
    auto name = trimmed(line.value_or("").substr(std::min(begins_series.size(), line.value_or("").size())));
    name = name.substr(0, name.find(','));
    for (int i = 0; i < 3; ++i) {
        auto const mark = name.find('_');
        if (mark == std::string_view::npos) {
            return {};
        }
        name.remove_prefix(mark + 1);
    }
    return std::string(name.substr(0, name.find('_')));
}

}  // namespace

bool recognises_earthscope(std::string_view content) { return has_marks(content, table); }

Recording read_earthscope(std::string_view content, RecordRequest const& request) {
    check_one_series(content, request.name);
    auto recording = read_described(content, request, table);
    auto const channel = channel_of(content);
    if (recording.components.size() == 1 && component_named(channel).direction != Direction::unknown) {
        recording.components.front().name = channel;
        recording.components.front().direction = direction_of(channel);
    }
    return recording;
}

}  // namespace overturn
