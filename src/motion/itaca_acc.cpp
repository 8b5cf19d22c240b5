#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/units.hpp"
#include "motion/column_unit.hpp"
#include "motion/detail/record_readers.hpp"
#include "motion/detail/statement_words.hpp"
#include "motion/text_lines.hpp"
#include "motion/text_statements.hpp"

namespace overturn {
namespace {

constexpr int header_lines_at_least = 8;  // of the form key: value; editions add others
constexpr int header_lines_at_most = 15;

struct Unit {
    double si = 0;
    int line = 0;
    std::string text;  // of that line
};

struct Header {
    std::optional<double> time_step_s, count, peak;
    std::optional<Unit> unit, peak_unit;
    double peak_digit = 0;
    Location peak_line;
    Location other_line;  // of a peak of velocities or displacements
    std::string other;
    std::string component;
};

bool is_numeric(std::string_view line) {
    line = trimmed(line);
    return !line.empty() && line.find_first_not_of("0123456789.+-eEdD \t") == std::string_view::npos;
}

bool is_packed(std::string_view line) {
    constexpr std::size_t values_on_a_line = 5;
    std::vector<double> values;
    try {
        append_numbers(line, "", 0, values);
    } catch (InputError const&) {
        return false;
    }
    return values.size() >= values_on_a_line;
}

bool holds(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

using Units = std::span<std::string_view const>;

constexpr std::array<std::string_view, 4> seconds{"s", "sec", "second", "seconds"};
constexpr std::array<std::string_view, 3> hertz{"hz", "1/s", "sps"};

/// \throws InputError unless `unit`, which a header states in `line`, is empty or one of `units`.
void check_unit(std::string_view unit, Units units, std::string_view line, Location const& where) {
    auto const lower = lowered(trimmed(unit));
    if (!lower.empty() && std::find(units.begin(), units.end(), lower) == units.end()) {
        throw InputError(where, fmt::format("{} ({} where {} belongs). Mend the header", in_quotes(trimmed(line)),
                                            in_quotes(lower), units.empty() ? "a number alone" : units.front()));
    }
}

/// The number behind the colon, in one of `units`, which may stand behind it or in brackets in the key; nothing if
/// there is none. \throws InputError if another unit stands there.
std::optional<double> number_in(std::string_view line, Units units, Location const& where) {
    auto const colon = line.find(':');
    auto const key = line.substr(0, colon);
    auto const open = key.find_first_of("([");
    auto const value = trimmed(line.substr(colon + 1));
    auto const end = std::min(value.find_first_not_of("0123456789+-.eEdD"), value.size());
    double number = 0;
    if (!parse_number(value.substr(0, end), number)) {
        return std::nullopt;
    }
    if (open != std::string_view::npos) {
        check_unit(key.substr(open + 1, key.find_first_of(")]", open) - open - 1), units, line, where);
    }
    check_unit(value.substr(end), units, line, where);
    return number;
}

/// The first unit stays. \throws InputError at another one
void take_unit(double si, std::string_view line, Location const& where, std::optional<Unit> const& other,
               std::optional<Unit>& unit) {
    if (other && other->si != si) {
        throw InputError(where, fmt::format("unit {}, line {} says {} (they contradict each other). Mend one of them",
                                            name_of_acceleration_unit(si), other->line, other->text));
    }
    unit = unit ? unit : Unit{si, where.line, in_quotes(trimmed(line))};
}

/// "Accelaration time series in m/s/s", "Unit : m/s2": what the values are. \throws InputError if they are none
/// of accelerations, or in a unit that is not known or not the stated one
void take_statement(std::string_view line, Location const& where, RecordRequest const& request, Header& header) {
    TextStatements statements;
    statements.take(line, where.line);
    statements.check(request);
    statements.check_unit_is_known(request.name);
    if (auto const si = statements.unit()) {
        take_unit(*si, line, where, header.unit ? header.unit : header.peak_unit, header.unit);
    }
}

/// "PGA (m/s/s) : 0.5", "PGA : 0.5 m/s2". \throws InputError at another unit
void take_peak(std::string_view line, Location const& where, Header& header) {
    auto const colon = std::min(line.find(':'), line.size());
    auto const value = trimmed(line.substr(std::min(colon + 1, line.size())));
    auto const end = std::min(value.find_first_not_of("0123456789+-.eEdD"), value.size());
    double number = 0;
    if (!parse_number(value.substr(0, end), number)) {
        return;
    }
    auto const open = std::min(line.find_first_of("(["), colon);
    auto const in_key = open < colon ? line.substr(open + 1, line.find_first_of(")]", open) - open - 1) : "";
    for (auto const unit : {in_key, value.substr(end)}) {
        auto const si = unit_spelled(unit, Dimension::acceleration);
        if (!trimmed(unit).empty() && !si) {
            throw InputError(where, fmt::format("{} ({} is no unit of acceleration that is known). Mend the header",
                                                in_quotes(trimmed(line)), in_quotes(trimmed(unit))));
        }
        if (si) {
            take_unit(*si, line, where, header.peak_unit ? header.peak_unit : header.unit, header.peak_unit);
        }
    }
    auto const printed = peak_in("pga: " + lowered(value.substr(0, end)), Dimension::acceleration);
    header.peak = number;
    header.peak_digit = printed ? printed->digit : 0;
    header.peak_line = where;
}

/// The archive's editions word their keys differently: a key says what it is by these words or is passed over.
void take(std::string_view line, Location const& where, RecordRequest const& request, Header& header) {
    auto const colon = line.find(':');
    auto const key = lowered(trimmed(line.substr(0, colon)));
    auto const value = trimmed(line.substr(colon + 1));
    if (colon == std::string_view::npos || key.starts_with("unit") || holds(key, "time series")) {
        take_statement(line, where, request, header);
    } else if (key.starts_with("pgv") || key.starts_with("pgd")) {
        header.other = key[2] == 'v' ? "velocities" : "displacements";
        header.other_line = where;
    } else if (holds(key, "sampling") && (holds(key, "rate") || holds(key, "freq"))) {
        auto const rate = number_in(line, hertz, where);
        header.time_step_s = rate ? std::optional(1 / *rate) : std::nullopt;
    } else if ((holds(key, "sampling") && !holds(key, "number")) || holds(key, "time step")
               || holds(key, "time increment")) {
        header.time_step_s = number_in(line, seconds, where);
    } else if (holds(key, "number") || holds(key, "samples") || holds(key, "points")) {
        header.count = number_in(line, {}, where);
    } else if (key.starts_with("pga")) {
        take_peak(line, where, header);
    } else if (holds(key, "component") || holds(key, "channel") || key == "orientation") {
        header.component = value;
    }
}

/// What the values are in; a peak's unit, whose value is compared, where no line says it. [m/s2]
/// \throws InputError without one, at another one stated, or at a peak of another quantity alone
double unit_of(Header const& header, RecordRequest const& request, Location const& where) {
    if (!header.other.empty() && !header.peak) {
        throw InputError(header.other_line,
                         fmt::format("{}, says the header's peak (accelerations are read). Take the accelerations of "
                                     "the same record",
                                     header.other));
    }
    auto const& stated = header.unit ? header.unit : header.peak_unit;
    if (stated) {
        check_stated_unit(request, stated->si, where);
    } else if (!request.unit_mps2) {
        refuse_without_unit(where, "the header does not say it", request);
    }
    return stated ? stated->si : *request.unit_mps2;
}

}  // namespace

bool recognises_itaca_acc(std::string_view content) {
    TextLines lines(content);
    int keyed = 0;
    while (lines.number() < header_lines_at_most) {
        auto const text = trimmed(lines.next().value_or(""));
        if (is_numeric(text)) {
            // One line of prose may follow the keys; the values are packed, where columns would have their time first.
            return keyed >= header_lines_at_least && lines.number() <= keyed + 2 && is_packed(text);
        }
        bool const lettered = !text.empty() && (lowered(text)[0] >= 'a' && lowered(text)[0] <= 'z');
        if (!lettered) {
            return false;
        }
        keyed += text.find(':') == std::string_view::npos ? 0 : 1;
    }
    return false;
}

Recording read_itaca_acc(std::string_view content, RecordRequest const& request) {
    TextLines lines(content);
    Header header;
    auto rest = lines;
    while (auto const line = rest.next()) {
        if (is_numeric(*line)) {
            break;
        }
        (void)lines.next();
        take(*line, {request.name, lines.number()}, request, header);
    }
    Location const where{request.name, lines.number()};
    auto const unit = unit_of(header, request, where);
    auto const step = header.time_step_s ? header.time_step_s : request.time_step_s;
    if (!step || !(*step > 0 && std::isfinite(*step))) {
        throw InputError(where,
                         "time step missing (no sampling interval or rate above 0 in the header). State the "
                         "time step");
    }
    check_stated_time_step(request, *step, where);
    std::vector<double> values;
    while (auto const line = lines.next()) {
        append_numbers(*line, request.name, lines.number(), values);
    }
    if (header.count && static_cast<double>(values.size()) != *header.count) {
        throw InputError({request.name, lines.number()}, fmt::format("{} values where the header promises {} (the file "
                                                                     "is cut short). Fetch it anew",
                                                                     values.size(), *header.count));
    }
    for (double& value : values) {
        value *= unit;
    }
    if (header.peak) {
        constexpr double printed_share = 1e-5, rounded = 0.5;
        double const share = std::max(printed_share * std::abs(*header.peak), rounded * header.peak_digit);
        check_stated_peak(peak_of(values), *header.peak * unit, share * unit, header.peak_line);
    }
    return {*step, {{header.component, direction_of(header.component), std::move(values)}}, unit};
}

}  // namespace overturn
