#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/units.hpp"
#include "motion/record_readers.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

constexpr int header_lines = 10;

struct Header {
    std::optional<double> unit_mps2, time_step_s, count;
    std::string component;
};

bool holds(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

/// The number at the front of `text`, whatever follows a blank; nothing if there is none.
std::optional<double> number_in(std::string_view text) {
    double value = 0;
    return parse_number(text.substr(0, text.find_first_of(" \t")), value) ? std::optional(value) : std::nullopt;
}

/// The archive's editions word their keys differently: a key says what it is by these words or is passed over.
void take(std::string_view line, Header& header) {
    auto const colon = line.find(':');
    auto const key = lowered(trimmed(line.substr(0, colon)));
    auto const value = trimmed(line.substr(colon + 1));
    auto const all = lowered(line);
    if (holds(all, "m/s2") || holds(all, "m/s^2") || holds(all, "m/s/s")) {
        constexpr double gal_mps2 = 0.01;
        header.unit_mps2 = holds(all, "cm/s") ? gal_mps2 : 1;
    }
    if (holds(key, "sampling") && (holds(key, "rate") || holds(key, "freq"))) {
        auto const rate = number_in(value);
        header.time_step_s = rate ? std::optional(1 / *rate) : std::nullopt;
    } else if ((holds(key, "sampling") && !holds(key, "number")) || holds(key, "time step")) {
        header.time_step_s = number_in(value);
    } else if (holds(key, "number") || holds(key, "samples") || holds(key, "points")) {
        header.count = number_in(value);
    } else if (holds(key, "component") || holds(key, "channel")) {
        header.component = value;
    }
}

}  // namespace

bool recognises_itaca_acc(std::string_view content) {
    TextLines lines(content);
    for (int i = 0; i < header_lines; ++i) {
        auto const line = lines.next();
        auto const text = trimmed(line.value_or(""));
        bool const lettered = !text.empty() && (lowered(text)[0] >= 'a' && lowered(text)[0] <= 'z');
        if (!lettered || text.find(':') == std::string_view::npos) {
            return false;
        }
    }
    auto const line = lines.next();
    return line && trimmed(*line).find_first_not_of("0123456789.+-eEdD \t") == std::string_view::npos;
}

Recording read_itaca_acc(std::string_view content, RecordRequest const& request) {
    TextLines lines(content);
    Header header;
    for (int i = 0; i < header_lines; ++i) {
        take(lines.next().value_or(":"), header);
    }
    Location const where{request.name, lines.number()};
    if (header.unit_mps2) {
        check_stated_unit(request, *header.unit_mps2, where);
    }
    auto const unit = header.unit_mps2 ? header.unit_mps2 : request.unit_mps2;
    if (!unit) {
        throw InputError(where, "unit missing (the header does not say m/s2). State --unit gal|g|m/s2");
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
    return {*step, {{header.component, direction_of(header.component), std::move(values)}}};
}

}  // namespace overturn
