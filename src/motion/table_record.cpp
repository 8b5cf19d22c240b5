#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/ranges.h>

#include "motion/column_unit.hpp"
#include "motion/detail/columns_by_text.hpp"
#include "motion/detail/component_mapping.hpp"
#include "motion/detail/list_head.hpp"
#include "motion/detail/motion_look.hpp"
#include "motion/detail/printed_times.hpp"
#include "motion/detail/record_readers.hpp"
#include "motion/detail/table_checks.hpp"
#include "motion/detail/table_columns.hpp"
#include "motion/operators_in_name.hpp"
#include "motion/telling_words.hpp"
#include "motion/text_lines.hpp"
#include "motion/text_statements.hpp"
#include "motion/text_table.hpp"

namespace overturn {
namespace {

enum class Reading { by_content, components, list };

/// "acc_g" may be in g; "a_g" is the ground's. \throws InputError if another unit is stated
void check_suffix_g(TableColumns const& columns, RecordRequest const& request, Location const& names) {
    for (auto const& [column, role] : columns.motions) {
        auto const lower = lowered(role.name);
        bool const suffix = lower.ends_with("_g") || lower.ends_with(" g");
        constexpr std::size_t symbol = 3;
        if (suffix && lower.size() > symbol && request.unit_mps2 && *request.unit_mps2 != g0) {
            throw InputError(names, fmt::format("column '{}', {} stated (is it in g, or the ground's?). Mend the name",
                                                role.name, name_of_acceleration_unit(*request.unit_mps2)));
        }
    }
}

/// Of all accelerations, in the unit that their names or the text state, or that is stated. [m/s2]
double unit_of(TextTable const& table, TableColumns const& columns, TextStatements const& statements,
               RecordRequest const& request) {
    std::optional<double> named;
    Location const names{request.name, columns.names_line};
    for (auto const& [column, role] : columns.motions) {
        if (!role.unit && !role.unknown_unit.empty()) {
            throw InputError(names, fmt::format("column '{}' ('{}' is no unit of acceleration that is known). Write "
                                                "m/s2, gal or g, or leave the brackets out and state the unit",
                                                role.name, role.unknown_unit));
        }
        if (!columns.stated && (tells_factor(lowered(role.name)) || tells_operation_in_name(role.name))) {
            throw InputError(names, fmt::format("column '{}' (a factor in its name: are its numbers that, or to be "
                                                "multiplied by it?). Give accelerations as such, or state the columns",
                                                role.name));
        }
        if (role.unit && named && *role.unit != *named) {
            throw InputError(names, "columns in different units (one is meant for all). Bring them into one");
        }
        named = role.unit ? role.unit : named;
    }
    if (!named) {
        statements.check_unit_is_known(request.name);
        check_suffix_g(columns, request, names);
    }
    auto const unit = statements.unit_beside(named, request.unit_mps2, names, request.unit_conflict);
    if (!unit) {
        refuse_without_unit({request.name, table.line[0]},
                            statements.doubt().empty() ? "neither names nor text say it" : statements.doubt(), request);
    }
    return *unit;
}

void time_in_seconds(TextTable& table, std::size_t column, std::optional<double> unit) {
    if (!unit || *unit == 1) {
        return;
    }
    for (double& time : table.column[column]) {
        time *= *unit;
    }
    table.digits.at(column).decimals -= static_cast<int>(std::lround(std::log10(*unit)));
}

double step_of(TextTable& table, TableColumns const& columns, TextStatements const& statements,
               RecordRequest const& request) {
    Location const start{request.name, table.line[0]};
    if (columns.time) {
        if (*columns.time >= TextTable::looked_at) {
            throw InputError(start, fmt::format("the time in column {} (it is looked for in the first three). Put it "
                                                "first",
                                                *columns.time + 1));
        }
        auto const unit = unit_of_times(columns, statements, request.name);
        time_in_seconds(table, *columns.time, unit);
        auto const step = time_step_of(table, *columns.time, request);
        statements.check_times(step, request.name);
        check_pair_above(table, step, request.name);
        return statements.time_step_s().value_or(step);  // times are printed to fewer digits than a rate
    }
    auto const beside_count = step_beside_count(table, request.name);
    if (beside_count) {
        auto own = request;
        own.may_be_resampled = false;
        check_stated_time_step(own, *beside_count, {request.name, table.head.back().number});
    }
    auto const in_text = beside_count ? beside_count : statements.time_step_s();
    if (!in_text && !request.time_step_s) {
        throw InputError(start,
                         "time step missing (no column of times, and no line says it). State the time step, or "
                         "put a time column first");
    }
    return in_text.value_or(request.time_step_s.value_or(0));
}

void account_for(TextTable const& table, TableColumns const& columns, TextStatements const& statements,
                 Recording& recording) {
    recording.statements = statements.used();
    if (auto const pair = pair_above(table); !pair.empty()) {
        recording.statements.push_back(
            fmt::format("line {}: {:.0f} samples, {:.6g} s", table.head.back().number, pair[0], pair[1]));
    }
    if (!columns.left_out.empty()) {
        recording.statements.push_back(fmt::format("left out: {}", fmt::join(columns.left_out, ", ")));
    }
    recording.unread = statements.unread();
    tell_mapped(columns, recording.statements, recording.unread);
    auto const names = telling_names(columns);
    recording.unread.insert(recording.unread.begin(), names.begin(), names.end());
    auto const other = statements.beside_names();
    if (!other.empty() && std::ranges::find(recording.unread, other) == recording.unread.end()) {
        recording.unread.insert(recording.unread.begin(), other);
    }
}

// Behind account_for.
void check_peaks(Recording& recording, TableColumns const& columns, TextStatements const& statements,
                 RecordRequest const& request) {
    std::vector<double> peaks;
    bool const whole = !request.by_place && (!columns.stated || columns.left_out.empty());
    for (auto const& component : recording.components) {
        peaks.push_back(peak_of(component.acceleration_mps2));
    }
    std::ranges::move(statements.check_peaks(peaks, recording.unit_mps2, request.name, whole),
                      std::back_inserter(recording.unread));
}

bool has_times_first(TextTable const& table) {
    constexpr std::size_t enough = 4;
    return table.columns() > 1 && table.line.size() >= enough && rises_evenly(table.column[0]);
}

Recording list_of(TextTable& table, TableColumns columns, RecordRequest const& request) {
    auto const statements = statements_of(table, columns);
    Location const start{request.name, table.line[0]};
    check_name_of_list(table, request.name);
    check_first_of_list(table, request);
    if (has_times_first(table)) {
        throw InputError(start,
                         "first values that rise in equal steps (a time column, not a list). "
                         "Keep time,a_horizontal[,a_transverse][,a_vertical], with their names");
    }
    statements.check(request);
    std::array const counts{table.values()};
    statements.check_count(counts, request.name);
    ColumnRole role{statements.components().size() == 1 ? statements.components().front() : std::string()};
    role.component = component_named(role.name);
    columns.motions = {{0, role}};
    take_stated_component(columns, statements, request.name, how_to_state(request, 1));
    Recording recording;
    recording.unit_mps2 = unit_of(table, columns, statements, request);
    recording.time_step_s = step_of(table, columns, statements, request);
    for (std::size_t i = 0; i < table.columns(); ++i) {
        check_gaps(table, i, request);
    }
    check_are_packed(table, request);
    auto values = table.columns() == 1 ? std::move(table.column[0]) : table.in_rows();
    check_look(values, role, 1, statements, request, start);
    for (double& value : values) {
        value *= recording.unit_mps2;
    }
    recording.components.push_back({role.name, role.component.direction, std::move(values)});
    account_for(table, columns, statements, recording);
    check_peaks(recording, columns, statements, request);
    return recording;
}

Recording columns_of(TextTable& table, TableColumns columns, RecordRequest const& request) {
    auto const statements = statements_of(table, columns);
    place_columns(table, statements, request, columns);
    statements.check(request);
    std::array const counts{table.line.size(), table.line.size() * columns.motions.size()};
    statements.check_count(counts, request.name);
    Recording recording;
    recording.unit_mps2 = unit_of(table, columns, statements, request);
    recording.time_step_s = step_of(table, columns, statements, request);
    for (auto& [column, role] : columns.motions) {
        check_gaps(table, column, request);
        check_look(table.column[column], role, table.columns(), statements, request, {request.name, table.line[0]});
        for (double& value : table.column[column]) {
            value *= recording.unit_mps2;
        }
        recording.components.push_back({role.name, role.component.direction, std::move(table.column[column])});
    }
    account_for(table, columns, statements, recording);
    check_peaks(recording, columns, statements, request);
    return recording;
}

void check_whole_rows(TextTable const& table, std::string const& file) {
    if (table.last_row_short) {
        throw InputError({file, table.line.back()},
                         fmt::format("a row of fewer numbers than the first, {} (the file is cut short). Fetch it anew",
                                     table.columns()));
    }
}

Recording read_table(std::string_view content, RecordRequest const& request, Reading reading) {
    auto table = read_text_table(content, request.name);
    auto columns = named_columns(table, request);
    bool const named = !columns.roles.empty() || !request.columns.empty();
    bool const many = table.columns() >= fewest_to_a_line;
    bool const list =
        reading == Reading::list
        || (reading == Reading::by_content && !named && (table.columns() == 1 || (many && !has_times_first(table))));
    if (list && request.columns.empty()) {
        return list_of(table, {}, request);
    }
    check_whole_rows(table, request.name);
    if (!named && many && reading == Reading::by_content) {
        throw InputError({request.name, table.line[0]},
                         fmt::format("{} columns without names, the first a time column (their order is ambiguous). "
                                     "Name them, or state the columns",
                                     table.columns()));
    }
    return columns_of(table, std::move(columns), request);
}

}  // namespace

bool has_marks(std::string_view content, TableFormat const& format) {
    TextLines lines(content);
    std::string head;
    constexpr int looked_at = 40;
    while (lines.number() < looked_at) {
        auto const line = lines.next();
        if (!line) {
            break;
        }
        head += lowered(*line) + '\n';
    }
    return std::ranges::all_of(format.marks,
                               [&](std::string_view mark) { return head.find(mark) != std::string::npos; });
}

Recording read_described(std::string_view content, RecordRequest const& request, TableFormat const& format) {
    if (format.unit_mps2 > 0) {
        check_stated_unit(request, format.unit_mps2, {request.name});
        auto own = request;
        own.unit_mps2 = format.unit_mps2;
        return read_table(content, own, Reading::by_content);
    }
    return read_table(content, request, Reading::by_content);
}

bool recognises_list(std::string_view /*content*/) { return false; }
Recording read_list(std::string_view content, RecordRequest const& request) {
    return read_table(content, request, Reading::list);
}

bool recognises_components(std::string_view /*content*/) { return false; }
Recording read_components(std::string_view content, RecordRequest const& request) {
    return read_table(content, request, Reading::components);
}

bool recognises_columns(std::string_view content) { return holds_text_table(content); }
Recording read_columns(std::string_view content, RecordRequest const& request) {
    return read_table(content, request, Reading::by_content);
}

}  // namespace overturn
