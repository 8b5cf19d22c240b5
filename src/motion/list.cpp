#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/units.hpp"
#include "motion/detail/record_readers.hpp"
#include "motion/prose.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

constexpr int prose_lines_at_most = 10;
constexpr std::size_t fewest_to_a_line = 5;  // fewer are columns, unless the format is stated

bool is_comment(std::string_view line) {
    line = trimmed(line);
    return line.empty() || line.front() == '#' || line.front() == '%' || line.front() == ';';
}

/// How many numbers stand on a line; 0 if anything else does.
std::size_t numbers_on(std::string_view line) {
    std::vector<double> values;
    try {
        append_numbers(line, "", 0, values);
    } catch (InputError const&) {
        return 0;
    }
    return values.size();
}

struct Values {
    std::vector<double> all;
    std::vector<std::size_t> begin;  ///< of each line
    std::vector<int> line;
    Prose prose;  ///< of what stands above them
};

Values read_values(std::string_view content, std::string const& file) {
    TextLines lines(content);
    Values values;
    while (auto const line = lines.next()) {
        bool const trailer = trimmed(*line).starts_with('*') && lowered(*line).find("end") != std::string::npos;
        if (trailer) {
            break;
        }
        bool const prose = values.line.empty() && lines.number() <= prose_lines_at_most && numbers_on(*line) == 0;
        if (is_comment(*line) || prose) {
            if (values.line.empty()) {
                values.prose.take(*line, lines.number());
            }
            continue;
        }
        values.begin.push_back(values.all.size());
        values.line.push_back(lines.number());
        append_numbers(*line, file, lines.number(), values.all);
    }
    if (values.all.empty()) {
        throw InputError({file}, "no line of numbers (nothing to shake with). Give the values of the record");
    }
    return values;
}

/// \throws InputError if a line other than the last is shorter or longer than the first.
void check_lines(Values const& values, std::string const& file) {
    auto const size_of = [&](std::size_t i) {
        return (i + 1 < values.begin.size() ? values.begin[i + 1] : values.all.size()) - values.begin[i];
    };
    for (std::size_t i = 1; i < values.begin.size(); ++i) {
        bool const last = i + 1 == values.begin.size();
        if (size_of(i) > size_of(0) || (!last && size_of(i) < size_of(0))) {
            throw InputError({file, values.line[i]}, fmt::format("{} values on a line where the first has {} (a value "
                                                                 "is lost or too many). Mend the line",
                                                                 size_of(i), size_of(0)));
        }
    }
}

/// \throws InputError if the first values of the lines rise in equal steps: a table with a time column.
void check_no_time_column(Values const& values, std::string const& file) {
    constexpr std::size_t enough = 4;
    auto const lines = values.begin.size();
    if (lines < enough || values.begin[1] < 2) {
        return;
    }
    auto const first_of = [&](std::size_t i) { return values.all[values.begin[i]]; };
    double const step = first_of(1) - first_of(0);
    bool even = step > 0;
    for (std::size_t i = 2; i < lines; ++i) {
        constexpr double printed = 1e-3;
        even = even && std::abs(first_of(i) - first_of(i - 1) - step) <= printed * step;
    }
    if (even) {
        throw InputError({file, values.line[0]},
                         "first values that rise in equal steps (a time column, not a list). "
                         "Keep time,a_horizontal[,a_transverse][,a_vertical]");
    }
}

}  // namespace

bool recognises_list(std::string_view content) {
    TextLines lines(content);
    while (lines.number() <= prose_lines_at_most) {
        auto const line = lines.next();
        if (!line) {
            return false;
        }
        if (auto const count = is_comment(*line) ? 0 : numbers_on(*line); count > 0) {
            return count >= fewest_to_a_line;
        }
    }
    return false;
}

Recording read_list(std::string_view content, RecordRequest const& request) {
    auto values = read_values(content, request.name);
    Location const start{request.name, values.line[0]};
    if (!request.unit_mps2) {
        refuse_without_unit(start, "a list of numbers does not say its own" + values.prose.unit_hint(), request);
    }
    if (!request.time_step_s) {
        throw InputError(start, fmt::format("time step missing (a list of numbers holds none{}). State the time step",
                                            values.prose.time_step_hint()));
    }
    values.prose.check(request);
    check_lines(values, request.name);
    check_no_time_column(values, request.name);
    for (double& value : values.all) {
        value *= *request.unit_mps2;
    }
    return {*request.time_step_s, {{"", Direction::unknown, std::move(values.all)}}, *request.unit_mps2};
}

}  // namespace overturn
