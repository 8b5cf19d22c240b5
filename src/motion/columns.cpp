#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/units.hpp"
#include "motion/column_unit.hpp"
#include "motion/detail/record_readers.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

constexpr std::size_t columns_at_most = 4;  // time and three components
constexpr double time_tolerance = 1e-3;     // of a step: what printing the times to a few digits costs

/// The fields of one row; one more than allowed is kept, to be told from the allowed ones.
struct Fields {
    std::array<std::string_view, columns_at_most + 1> text;
    std::size_t count = 0;
};

/// Fields are parted by blanks and tabs, by a comma or semicolon, or by both.
Fields split(std::string_view line) {
    Fields fields;
    line = trimmed(line);
    while (fields.count < fields.text.size()) {
        auto const end = line.find_first_of(",; \t");
        fields.text[fields.count++] = line.substr(0, end);
        if (end == std::string_view::npos) {
            break;
        }
        bool const comma = line[end] == ',' || line[end] == ';';
        line = trimmed(line.substr(end + (comma ? 1 : 0)));
        if (!comma && (line.starts_with(',') || line.starts_with(';'))) {
            line = trimmed(line.substr(1));
        }
    }
    return fields;
}

bool is_skipped(std::string_view line) {
    line = trimmed(line);
    return line.empty() || line.front() == '#' || line.front() == '%' || line.front() == ';';
}

/// A line of names: its first field begins no number, and is no "nan" or "inf" either.
bool is_names(Fields const& fields) {
    auto const first = lowered(fields.text[0]);
    auto const bare = first.substr(std::min(first.find_first_not_of("+-"), first.size()));
    bool const numeric = !bare.empty() && (bare[0] == '.' || (bare[0] >= '0' && bare[0] <= '9'));
    return !bare.empty() && !numeric && bare != "nan" && bare != "inf" && bare != "infinity";
}

/// Names may hold blanks where commas or semicolons part them.
std::vector<std::string> names_on(std::string_view line) {
    std::string_view const separators = line.find_first_of(",;") != std::string_view::npos ? ",;" : " \t";
    std::vector<std::string> names;
    for (auto rest = trimmed(line); !rest.empty();) {
        auto const end = rest.find_first_of(separators);
        names.emplace_back(trimmed(rest.substr(0, end)));
        rest = end == std::string_view::npos ? std::string_view{} : trimmed(rest.substr(end + 1));
    }
    return names;
}

struct Rows {
    std::array<std::vector<double>, columns_at_most> column;
    std::vector<int> line;
    std::size_t columns = 0;
    std::vector<std::string> names;  // of the columns, if a line of names stands above them
    int names_line = 0;
};

/// A number with a decimal comma where semicolons part the fields.
bool has_decimal_comma(std::string_view line) {
    auto const comma = line.find(',');
    return line.find(';') != std::string_view::npos && comma != std::string_view::npos;
}

void append_row(Fields const& fields, Location const& where, Rows& rows) {
    if (rows.columns == 0) {
        rows.columns = fields.count;
        if (fields.count > columns_at_most) {
            throw InputError(where,
                             "more than 4 columns (which is which cannot be told). Keep "
                             "time,a_horizontal[,a_transverse][,a_vertical]");
        }
    }
    if (fields.count != rows.columns) {
        throw InputError(where,
                         fmt::format("a row of {}{} where the first has {} (columns must not change). Mend the "
                                     "row",
                                     fields.count, fields.count > columns_at_most ? " or more" : "", rows.columns));
    }
    for (std::size_t i = 0; i < fields.count; ++i) {
        double value = 0;
        if (!parse_number(fields.text[i], value)) {
            throw InputError(where, fmt::format("{} in column {} (not a finite number). Mend the row",
                                                in_quotes(fields.text[i]), i + 1));
        }
        rows.column[i].push_back(value);
    }
    rows.line.push_back(where.line);
}

Rows read_rows(std::string_view content, std::string const& file) {
    TextLines lines(content);
    Location where{file};
    Rows rows;
    bool names_seen = false;
    while (auto const line = lines.next()) {
        if (is_skipped(*line)) {
            continue;
        }
        where.line = lines.number();
        auto const fields = split(*line);
        if (rows.line.empty() && is_names(fields)) {
            if (names_seen) {
                throw InputError(where,
                                 "a second line of text before the numbers (columns have one line of names at "
                                 "most). Begin further ones with #");
            }
            names_seen = true;
            rows.names = names_on(*line);
            rows.names_line = where.line;
            continue;
        }
        if (has_decimal_comma(*line)) {
            throw InputError(where,
                             "comma and semicolon on one line (is the comma a decimal point?). Write decimal "
                             "points");
        }
        append_row(fields, where, rows);
    }
    if (rows.line.empty()) {
        throw InputError({file, where.line},
                         "no row of numbers (nothing to shake with). Give columns time,a_horizontal");
    }
    return rows;
}

/// \throws InputError at the row whose gap to the one before differs most from the mean step.
[[noreturn]] void refuse_times(Rows const& rows, double step, std::string const& file) {
    auto const& time = rows.column[0];
    std::size_t worst = 1;
    for (std::size_t i = 2; i < time.size(); ++i) {
        if (std::abs(time[i] - time[i - 1] - step) > std::abs(time[worst] - time[worst - 1] - step)) {
            worst = i;
        }
    }
    throw InputError(
        {file, rows.line[worst]},
        fmt::format("time goes from {} to {} s where the mean step is {:.6g} s (samples must be uniform in "
                    "time). Resample the record, or put its time into the first column",
                    time[worst - 1], time[worst], step));
}

double time_step_of(Rows const& rows, std::string const& file) {
    auto const& time = rows.column[0];
    if (time.size() < 2) {
        throw InputError({file, rows.line[0]}, "one row only (a time step needs two). Give the whole record");
    }
    double const step = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
    if (!(step > 0)) {
        refuse_times(rows, step, file);
    }
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (!(std::abs(time[i] - time[0] - static_cast<double>(i) * step) <= time_tolerance * step)) {
            refuse_times(rows, step, file);
        }
    }
    return step;
}

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

/// Components from column `first` on: horizontal, then transverse and vertical, or one of them. Names that say
/// otherwise are obeyed where the order stays the same and refused where it does not.
std::vector<RecordComponent> components_of(Rows& rows, std::size_t first, Location const& where) {
    std::vector<RecordComponent> components;
    auto const count = rows.columns - first;
    bool const named = rows.names.size() == rows.columns;
    for (std::size_t i = 0; i < count; ++i) {
        auto const said = named ? direction_in_name(rows.names[first + i]) : Direction::unknown;
        bool const vertical = i > 0 && i + 1 == count && !(i == 1 && said == Direction::horizontal);
        auto const taken = vertical ? Direction::up : Direction::horizontal;
        bool const contradicts = said != Direction::unknown && (said == Direction::horizontal) == vertical;
        if (count > 1 && contradicts) {
            throw InputError(where, fmt::format("column '{}' where the {} component belongs (columns are time, "
                                                "a_horizontal, a_transverse, a_vertical). Bring them into this order",
                                                rows.names[first + i], vertical ? "vertical" : "horizontal"));
        }
        constexpr std::array plain{"column 2", "column 3", "column 4"};
        auto const name = named ? rows.names[first + i] : std::string(count > 1 ? plain.at(i) : "");
        components.push_back({name,
                              said == Direction::up || said == Direction::down ? said
                              : count > 1                                      ? taken
                                                                               : Direction::unknown,
                              std::move(rows.column[first + i])});
    }
    return components;
}

/// Of all columns of accelerations, in the unit that their names say or that is stated. [m/s2]
double unit_of(Rows const& rows, std::size_t first, RecordRequest const& request) {
    std::optional<double> named;
    Location const where{request.name, rows.names_line};
    for (std::size_t i = first; rows.names.size() == rows.columns && i < rows.columns; ++i) {
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
    if (!request.unit_mps2) {
        refuse_without_unit({request.name, rows.line[0]}, "columns of numbers do not say theirs", request);
    }
    return *request.unit_mps2;
}

}  // namespace

bool recognises_columns(std::string_view content) {
    TextLines lines(content);
    bool names_seen = false;
    while (auto const line = lines.next()) {
        if (is_skipped(*line)) {
            continue;
        }
        auto const fields = split(*line);
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
        auto const fields = split(*line);
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

Recording read_columns(std::string_view content, RecordRequest const& request) {
    auto rows = read_rows(content, request.name);
    Location const start{request.name, rows.line[0]};
    bool const timed = rows.columns > 1;
    double const unit_mps2 = unit_of(rows, timed ? 1 : 0, request);
    if (!timed && !request.time_step_s) {
        throw InputError(start,
                         "time step missing (one column of numbers holds none). State the time step, or put a "
                         "time column first");
    }
    Recording recording;
    if (timed) {
        recording.time_step_s = time_step_of(rows, request.name);
        check_stated_time_step(request, recording.time_step_s, start);
    } else {
        recording.time_step_s = *request.time_step_s;
    }
    recording.components = components_of(rows, timed ? 1 : 0, start);
    for (auto& component : recording.components) {
        for (double& value : component.acceleration_mps2) {
            value *= unit_mps2;
        }
    }
    return recording;
}

}  // namespace overturn
