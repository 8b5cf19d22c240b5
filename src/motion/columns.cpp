#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/units.hpp"
#include "motion/column_unit.hpp"
#include "motion/detail/column_rows.hpp"
#include "motion/detail/printed_times.hpp"
#include "motion/detail/record_readers.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

/// What a column's name says: `a_vertical`, `az_mps2`, `UD`, `acc_EW (gal)`.
Direction direction_in_name(std::string_view name) {
    auto lower = lowered(name);
    for (std::string_view const prefix : {"acceleration_", "acc_", "acc-", "a_", "a"}) {
        if (lower.starts_with(prefix) && direction_of(lower) == Direction::unknown) {
            lower.erase(0, prefix.size());
            break;
        }
    }
    lower = lower.substr(0, lower.find_first_of("_([ "));
    return lower == "transverse" ? Direction::horizontal : direction_of(lower);
}

/// Components from column `first` on: horizontal, then transverse and vertical, or one of them (vertical behind a time,
/// transverse without). Names that say
/// otherwise are obeyed where the order stays the same and refused where it does not.
std::vector<RecordComponent> components_of(Rows& rows, std::size_t first, Location const& where) {
    std::vector<RecordComponent> components;
    auto const count = rows.columns - first;
    bool const named = rows.named();
    for (std::size_t i = 0; i < count; ++i) {
        auto const said = named ? direction_in_name(rows.names[first + i]) : Direction::unknown;
        bool const second =
            i == 1 && (said == Direction::horizontal || (first == 0 && count == 2 && said == Direction::unknown));
        bool const vertical = i > 0 && i + 1 == count && !second;
        auto const taken = vertical ? Direction::up : Direction::horizontal;
        bool const contradicts = said != Direction::unknown && (said == Direction::horizontal) == vertical;
        if (count > 1 && contradicts) {
            throw InputError(where, fmt::format("column '{}' where the {} component belongs (columns are time, "
                                                "a_horizontal, a_transverse, a_vertical). Bring them into this order",
                                                rows.names[first + i], vertical ? "vertical" : "horizontal"));
        }
        auto const name = named       ? rows.names[first + i]
                          : count > 1 ? fmt::format("column {}", first + i + 1)
                                      : std::string();
        components.push_back({name,
                              said == Direction::up || said == Direction::down ? said
                              : count > 1                                      ? taken
                                                                               : Direction::unknown,
                              std::move(rows.column[first + i])});
    }
    return components;
}

/// Is it called a velocity or a displacement, or in a unit of one? Nothing if it may be an acceleration.
std::optional<std::string_view> another_quantity(std::string_view name) {
    auto const lower = lowered(name);
    auto const [text, bracketed] = unit_text_in_name(name);
    bool const telling = bracketed || text.size() > 1;
    if (lower.starts_with("vel") || (telling && unit_spelled(text, Dimension::velocity))) {
        return "a velocity";
    }
    if (lower.starts_with("dis") || (telling && unit_spelled(text, Dimension::length))) {
        return "a displacement";
    }
    return std::nullopt;
}

/// \throws InputError if what stands in the brackets of an acceleration's name may be a unit that is not known
void check_name(std::string const& name, Location const& where) {
    if (auto const other = another_quantity(name)) {
        throw InputError(where, fmt::format("column '{}' ({}: columns are a time and accelerations, "
                                            "time,a_horizontal[,a_transverse][,a_vertical]). Leave it out",
                                            name, *other));
    }
    auto const [text, bracketed] = unit_text_in_name(name);
    if (bracketed && !text.empty() && !unit_spelled(text, Dimension::acceleration)
        && direction_in_name(text) == Direction::unknown) {
        throw InputError(where,
                         fmt::format("column '{}' ('{}' is no unit of acceleration that is known). Write m/s2, gal or "
                                     "g, or leave the brackets out and state the unit",
                                     name, text));
    }
}

/// Of all columns of accelerations, in the unit that their names say or that is stated. [m/s2]
double unit_of(Rows const& rows, std::size_t first, RecordRequest const& request) {
    std::optional<double> named;
    Location const where{request.name, rows.names_line};
    for (std::size_t i = first; rows.named() && i < rows.columns; ++i) {
        check_name(rows.names[i], where);
        auto const unit = unit_in_name(rows.names[i]);
        if (unit && named && *unit != *named) {
            throw InputError(where, "columns in different units (one is meant for all). Bring them into one");
        }
        named = unit ? unit : named;
    }
    if (named) {
        check_stated_unit(request, *named, where);
        return *named;
    }
    rows.prose.check(request);
    if (!request.unit_mps2) {
        refuse_without_unit({request.name, rows.line[0]},
                            "columns of numbers do not say theirs" + rows.prose.unit_hint(), request);
    }
    return *request.unit_mps2;
}

/// As times do, whatever their column is called: "x,y" of a digitiser.
bool rises_evenly(std::vector<double> const& values) {
    constexpr std::size_t fewest = 3;
    bool even = values.size() >= fewest && values[1] > values[0];
    for (std::size_t i = 2; even && i < values.size(); ++i) {
        constexpr double printed = 0.1;  // of a step
        double const step = values[1] - values[0];
        even = std::abs(values[i] - values[i - 1] - step) <= printed * step;
    }
    return even;
}

}  // namespace

bool recognises_columns(std::string_view content) {
    TextLines lines(content);
    bool names_seen = false;
    while (auto const line = lines.next()) {
        if (is_skipped(*line)) {
            continue;
        }
        auto const fields = split_fields(*line);
        if (!is_names(fields)) {
            return fields.count <= columns_at_most;
        }
        if (names_seen) {
            return false;
        }
        names_seen = true;
    }
    return false;
}

void check_not_nearly_columns(std::string_view content, RecordRequest const& request) {
    constexpr int text_lines_at_most = 3;  // names, units and a rule under them; more are another format's header
    TextLines lines(content);
    int text_lines = 0;
    bool may_be_names = false;
    while (auto const line = lines.next()) {
        if (is_skipped(*line)) {
            continue;
        }
        auto const fields = split_fields(*line);
        double value = 0;
        if (parse_number(fields.text[0], value) && (fields.count < 2 || parse_number(fields.text[1], value))) {
            (void)read_rows(content, request.name);
            return;
        }
        may_be_names = fields.count > 1 && is_names(fields);
        if (++text_lines > text_lines_at_most) {
            return;
        }
    }
    if (text_lines == 1 && may_be_names) {
        (void)read_rows(content, request.name);
    }
}

namespace {

/// Times in the unit that their column's name says, "time (ms)"; seconds without one.
void time_in_seconds(Rows& rows) {
    auto const unit = rows.named() ? unit_in_name(rows.names[0], Dimension::time) : std::nullopt;
    if (!unit || *unit == 1) {
        return;
    }
    for (double& time : rows.column[0]) {
        time *= *unit;
    }
    rows.decimals -= static_cast<int>(std::lround(std::log10(*unit)));
}

Recording recording_of(Rows& rows, std::size_t first, RecordRequest const& request) {
    Location const start{request.name, rows.line[0]};
    Recording recording;
    recording.unit_mps2 = unit_of(rows, first, request);
    if (first == 0 && !request.time_step_s) {
        throw InputError(start, fmt::format("time step missing (columns without a time hold none{}). State the time "
                                            "step, or put a time column first",
                                            rows.prose.time_step_hint()));
    }
    if (first == 0) {
        recording.time_step_s = *request.time_step_s;
    } else {
        time_in_seconds(rows);
        recording.time_step_s = time_step_of(rows, request);
        rows.prose.check_times(recording.time_step_s, request.name);
    }
    recording.components = components_of(rows, first, start);
    for (auto& component : recording.components) {
        for (double& value : component.acceleration_mps2) {
            value *= recording.unit_mps2;
        }
    }
    return recording;
}

}  // namespace

Recording read_columns(std::string_view content, RecordRequest const& request) {
    auto rows = read_rows(content, request.name);
    return recording_of(rows, rows.columns > 1 ? 1 : 0, request);
}

bool recognises_components(std::string_view content) {
    constexpr std::size_t rows_looked_at = 8;
    TextLines lines(content);
    std::vector<std::string> names;
    std::vector<double> first;
    while (first.size() < rows_looked_at) {
        auto const line = lines.next();
        if (!line) {
            break;
        }
        if (is_skipped(*line)) {
            continue;
        }
        auto const fields = split_fields(*line);
        if (names.empty()) {
            if (!is_names(fields)) {
                return false;
            }
            names = names_on(*line);
            continue;
        }
        double value = 0;
        if (fields.count != names.size() || !parse_number(fields.text[0], value)) {
            return false;
        }
        first.push_back(value);
    }
    return names.size() > 1 && !first.empty() && !rises_evenly(first) && lowered(names.front()) != "t"
           && std::all_of(names.begin(), names.end(),
                          [](std::string const& name) { return direction_in_name(name) != Direction::unknown; });
}

Recording read_components(std::string_view content, RecordRequest const& request) {
    auto rows = read_rows(content, request.name);
    if (rows.columns == columns_at_most) {
        throw InputError({request.name, rows.line[0]},
                         "4 columns (components are three at most, and a time is none of them). State --format "
                         "columns");
    }
    return recording_of(rows, 0, request);
}

}  // namespace overturn
