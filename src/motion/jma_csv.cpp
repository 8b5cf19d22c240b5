#include <array>
#include <string>

#include "core/units.hpp"
#include "motion/detail/record_readers.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

constexpr std::string_view first_key = "SITE CODE=";
constexpr std::size_t component_count = 3;

/// The text after `key` on the next line, which must begin with it; blanks around the equals sign do not count.
std::string_view value_of(TextLines& lines, std::string_view key, std::string const& file) {
    auto const line = lines.next();
    auto const text = trimmed(line.value_or(""));
    auto const equals = text.find('=');
    if (!line || !text.starts_with(key) || equals == std::string_view::npos) {
        throw InputError({file, lines.number()},
                         fmt::format("{} (a JMA csv has '{} =' here). Fetch the file anew", in_quotes(text), key));
    }
    return trimmed(text.substr(equals + 1));
}

double sampling_rate_hz(std::string_view text, Location const& where) {
    double rate = 0;
    auto const hertz = text.find("Hz");
    if (hertz == std::string_view::npos || !parse_number(trimmed(text.substr(0, hertz)), rate) || !(rate > 0)) {
        throw InputError(where,
                         fmt::format("SAMPLING RATE {} (must read like 100Hz). Mend the header", in_quotes(text)));
    }
    return rate;
}

/// NS,EW,UD in the file's own order.
std::array<std::string, component_count> component_names(TextLines& lines, std::string const& file) {
    auto const line = lines.next();
    std::array<std::string, component_count> names;
    auto rest = trimmed(line.value_or(""));
    for (auto& name : names) {
        auto const comma = rest.find(',');
        name = trimmed(rest.substr(0, comma));
        rest = comma == std::string_view::npos ? std::string_view{} : rest.substr(comma + 1);
        if (direction_of(name) == Direction::unknown) {
            throw InputError({file, lines.number()}, fmt::format("{} (a JMA csv names its columns NS,EW,UD here). "
                                                                 "Fetch the file anew",
                                                                 in_quotes(trimmed(line.value_or("")))));
        }
    }
    return names;
}

void append_row(std::string_view line, Location const& where, Recording& recording) {
    auto rest = line;
    for (auto& component : recording.components) {
        auto const comma = rest.find(',');
        auto const text = trimmed(rest.substr(0, comma));
        double gal = 0;
        if (!parse_number(text, gal)) {
            throw InputError(where, fmt::format("{} under {} (not a finite number; the row is damaged or cut short). "
                                                "Fetch the file anew",
                                                in_quotes(text), component.name));
        }
        component.acceleration_mps2.push_back(gal * gal_mps2);
        rest = comma == std::string_view::npos ? std::string_view{} : rest.substr(comma + 1);
    }
    if (rest.find_first_not_of(", \t") != std::string_view::npos) {  // later exports end in empty columns
        throw InputError(where, fmt::format("{} after the third column (a JMA csv has NS,EW,UD). Mend the row",
                                            in_quotes(trimmed(rest))));
    }
}

}  // namespace

bool recognises_jma_csv(std::string_view content) {
    auto const first = TextLines(content).next();
    return first && trimmed(*first).starts_with(first_key);
}

Recording read_jma_csv(std::string_view content, RecordRequest const& request) {
    TextLines lines(content);
    auto const place_of = [&] { return Location{request.name, lines.number()}; };
    Recording recording;
    recording.unit_mps2 = gal_mps2;
    (void)value_of(lines, "SITE CODE", request.name);
    (void)value_of(lines, "LAT.", request.name);
    (void)value_of(lines, "LON.", request.name);
    auto const rate = value_of(lines, "SAMPLING RATE", request.name);
    recording.time_step_s = 1 / sampling_rate_hz(rate, place_of());
    check_stated_time_step(request, recording.time_step_s, place_of());
    auto const unit = lowered(value_of(lines, "UNIT", request.name));
    if (!unit.starts_with("gal")) {
        throw InputError(place_of(), fmt::format("unit {} (a JMA csv is in gal). Convert it to columns and state the "
                                                 "unit",
                                                 in_quotes(unit)));
    }
    check_stated_unit(request, gal_mps2, place_of());
    (void)value_of(lines, "INITIAL TIME", request.name);
    for (auto const& name : component_names(lines, request.name)) {
        recording.components.push_back({name, direction_of(name), {}});
    }
    while (auto const line = lines.next()) {
        if (!trimmed(*line).empty()) {
            append_row(*line, place_of(), recording);
        }
    }
    if (recording.components.front().acceleration_mps2.empty()) {
        throw InputError(place_of(), "no row of numbers (the file is cut short). Fetch it anew");
    }
    check_last_value_is_whole(content, place_of());
    return recording;
}

}  // namespace overturn
