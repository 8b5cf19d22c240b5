#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/units.hpp"
#include "motion/detail/record_readers.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

constexpr int header_lines_at_least = 8;  // of the form key: value; editions add others
constexpr int header_lines_at_most = 15;

struct Header {
    std::optional<double> unit_mps2, time_step_s, count, peak;
    Location peak_line;
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

/// The archive's editions word their keys differently: a key says what it is by these words or is passed over.
void take(std::string_view line, Location const& where, Header& header) {
    auto const colon = line.find(':');
    auto const key = lowered(trimmed(line.substr(0, colon)));
    auto const value = trimmed(line.substr(colon + 1));
    auto const all = lowered(line);
    if (holds(all, "m/s2") || holds(all, "m/s^2") || holds(all, "m/s/s")) {
        header.unit_mps2 = holds(all, "cm/s") ? gal_mps2 : 1;
    }
    if (holds(key, "sampling") && (holds(key, "rate") || holds(key, "freq"))) {
        auto const rate = number_in(line, hertz, where);
        header.time_step_s = rate ? std::optional(1 / *rate) : std::nullopt;
    } else if ((holds(key, "sampling") && !holds(key, "number")) || holds(key, "time step")
               || holds(key, "time increment")) {
        header.time_step_s = number_in(line, seconds, where);
    } else if (holds(key, "number") || holds(key, "samples") || holds(key, "points")) {
        header.count = number_in(line, {}, where);
    } else if (key.starts_with("pga") && header.unit_mps2) {
        header.peak = number_in(line.substr(colon), {}, where);
        header.peak_line = where;
    } else if (holds(key, "component") || holds(key, "channel") || key == "orientation") {
        header.component = value;
    }
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
        take(*line, {request.name, lines.number()}, header);
    }
    Location const where{request.name, lines.number()};
    if (header.unit_mps2) {
        check_stated_unit(request, *header.unit_mps2, where);
    }
    auto const unit = header.unit_mps2 ? header.unit_mps2 : request.unit_mps2;
    if (!unit) {
        refuse_without_unit(where, "the header does not say m/s2", request);
    }
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
        value *= *unit;
    }
    if (header.peak) {
        constexpr double printed_share = 1e-5;
        check_stated_peak(peak_of(values), *header.peak * *unit, printed_share * std::abs(*header.peak * *unit),
                          header.peak_line);
    }
    return {*step, {{header.component, direction_of(header.component), std::move(values)}}, *unit};
}

}  // namespace overturn
