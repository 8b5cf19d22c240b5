#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "core/units.hpp"
#include "motion/column_unit.hpp"
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

/// The last word of the line that begins the series: "M/S**2", "COUNTS". Empty where it has fewer words.
std::string_view unit_text_of(std::string_view line) {
    auto const comma = line.rfind(',');
    return comma == std::string_view::npos ? std::string_view{} : trimmed(line.substr(comma + 1));
}

/// [m/s2]; nothing of counts, which are refused with the text, or where the line states none.
/// \throws InputError at a unit of anything but accelerations, whatever is stated, or at another one stated
std::optional<double> unit_of_series(std::string_view content, RecordRequest const& request) {
    TextLines lines(content);
    auto line = lines.next();
    while (line && lowered(line->substr(0, begins_series.size())) != begins_series) {
        line = lines.next();
    }
    auto const unit = unit_text_of(line.value_or(""));
    auto const lower = lowered(unit);
    bool const counts = lower.starts_with("count") || lower == "cts";
    constexpr std::array others{"float", "integer", "ascii", "slist", "tspair"};  // such a line states no unit
    if (unit.empty() || counts || std::ranges::find(others, lower) != others.end()) {
        return std::nullopt;
    }
    Location const where{request.name, lines.number()};
    if (auto const si = unit_spelled(unit, Dimension::acceleration)) {
        check_stated_unit(request, *si, where);
        return si;
    }
    bool const velocity = unit_spelled(unit, Dimension::velocity).has_value();
    bool const length = unit_spelled(unit, Dimension::length).has_value();
    throw InputError(
        where, fmt::format("unit {} of the series ({}). Take the accelerations of the same record", in_quotes(unit),
                           velocity ? "velocities; accelerations are read"
                           : length ? "displacements; accelerations are read"
                                    : "no unit of acceleration that is known"));
}

}  // namespace

bool recognises_earthscope(std::string_view content) { return has_marks(content, table); }

Recording read_earthscope(std::string_view content, RecordRequest const& request) {
    check_one_series(content, request.name);
    auto own = request;
    auto const unit = unit_of_series(content, request);
    own.unit_mps2 = unit ? unit : request.unit_mps2;
    auto recording = read_described(content, own, table);
    auto const channel = channel_of(content);
    if (recording.components.size() == 1 && component_named(channel).direction != Direction::unknown) {
        recording.components.front().name = channel;
        recording.components.front().direction = direction_of(channel);
    }
    return recording;
}

}  // namespace overturn
