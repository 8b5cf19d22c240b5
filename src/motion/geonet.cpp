#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/units.hpp"
#include "motion/detail/record_readers.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

// GNS Science (New Zealand): 16 lines of text, 10 by 10 numbers, then values ten to a line, for each component.
constexpr int text_lines = 16;
constexpr std::size_t number_count = 100;
constexpr FixedFormat layout{10, 8};
constexpr double unit_mps2 = 1e-3;

// Numbers of values among the hundred, from 0.
constexpr std::size_t raw_samples = 30, samples = 33, velocities = 34, displacements = 35, raw_step = 64, step = 65;

bool holds(std::string_view lower, std::string_view part) { return lower.find(part) != std::string_view::npos; }

bool is_first_line(std::string_view line) {
    auto const lower = lowered(line);
    return holds(lower, "corrected accelerogram") && holds(lower, "gns science");
}

/// Text and numbers above one component's values.
struct Head {
    bool raw = false;
    std::string component;
    double peak = 0;  ///< in the file's unit, with its sign
    Location peak_line;
    std::vector<double> numbers;
    double stated_step_s = 0;  ///< 0: no line states it
    Location step_line;
};

/// `at intervals of 0.005 s`, `data at 0.020 sec intervals`; 0 if it says none. [s]
double step_in_line(std::string_view lower) {
    if (!holds(lower, "interval")) {
        return 0;
    }
    for (std::string_view const before : {"intervals of ", "interval of ", " at "}) {
        auto const at = lower.find(before);
        auto const text = at == std::string_view::npos ? std::string_view{} : trimmed(lower.substr(at + before.size()));
        auto const end = std::min(text.find_first_not_of("0123456789."), text.size());
        double seconds = 0;
        if (parse_number(text.substr(0, end), seconds) && trimmed(text.substr(end)).starts_with('s')) {
            return seconds;
        }
    }
    return 0;
}

/// `Acceleration:  Peak -11026.2 mm/s/s at  44.87 s`
double peak_in_line(std::string_view lower, Location const& where) {
    auto const at = lower.find("peak");
    auto const text = at == std::string_view::npos ? std::string_view{} : trimmed(lower.substr(at + 4));
    double peak = 0;
    if (at == std::string_view::npos || !holds(lower, "mm/s/s")
        || !parse_number(text.substr(0, text.find_first_of(" \t")), peak)) {
        throw InputError(
            where, fmt::format("{} (a peak in mm/s/s belongs here). Fetch the file anew", in_quotes(trimmed(lower))));
    }
    return peak;
}

Head read_head(std::string_view first, TextLines& lines, std::string const& file) {
    Head head;
    head.raw = holds(lowered(first), "uncorrected");
    for (int i = 1; i < text_lines; ++i) {
        auto const line = trimmed(lines.next().value_or(""));
        auto const lower = lowered(line);
        Location const where{file, lines.number()};
        if (auto const step_s = step_in_line(lower); step_s > 0 && head.stated_step_s == 0) {
            head.stated_step_s = step_s;
            head.step_line = where;
        }
        if (lower.starts_with("component ")) {
            auto const name = trimmed(line.substr(std::string_view("component ").size()));
            head.component = name.substr(0, name.find(' '));
        } else if (lower.starts_with("acceleration:")) {
            head.peak = peak_in_line(lower, where);
            head.peak_line = where;
        } else if (lower.starts_with("raw readings in units") && !holds(lower, "units of 1.00 mm/s/s")) {
            throw InputError(where, fmt::format("{} (1.00 mm/s/s is known). Take the corrected file of the same record",
                                                in_quotes(line)));
        }
    }
    append_fixed(lines, layout, number_count, file, head.numbers);
    return head;
}

std::size_t count_at(Head const& head, std::size_t number, Location const& where) {
    constexpr double most = 1e9;
    double const count = head.numbers[number];
    if (!(count >= 0 && count <= most)) {
        throw InputError(where, fmt::format("{} values (a count belongs here). Mend the header", count));
    }
    return static_cast<std::size_t>(count);
}

/// That of the numbers, or of the text where these have none. \throws InputError if they contradict each other
double step_of(Head const& head, Location const& where) {
    double const numbered = head.numbers[head.raw ? raw_step : step];
    constexpr double printed = 1e-2;
    if (numbered > 0 && head.stated_step_s > 0 && std::abs(numbered - head.stated_step_s) > printed * numbered) {
        throw InputError(head.step_line, fmt::format("time step of {} s, {} s in the numbers that end at line {} (they "
                                                     "contradict each other). Fetch the file anew",
                                                     head.stated_step_s, numbered, where.line));
    }
    return numbered > 0 ? numbered : head.stated_step_s;
}

void read_component(std::string_view first, TextLines& lines, RecordRequest const& request, Recording& recording) {
    auto const& file = request.name;
    auto const head = read_head(first, lines, file);
    Location const where{file, lines.number()};
    auto const count = count_at(head, head.raw ? raw_samples : samples, where);
    double const step_s = step_of(head, where);
    if (count == 0 || !(step_s > 0)) {
        throw InputError(where,
                         fmt::format("{} samples of {} s (both must be above 0). Mend the header", count, step_s));
    }
    check_stated_unit(request, unit_mps2, where);
    check_stated_time_step(request, step_s, where);
    if (!recording.components.empty() && step_s != recording.time_step_s) {
        throw InputError(where, fmt::format("time step of {} s after a component of {} s (they must agree). Put them "
                                            "into files of their own",
                                            step_s, recording.time_step_s));
    }
    std::vector<double> values;
    append_fixed(lines, layout, count, file, values);
    for (double& value : values) {
        value *= unit_mps2;
    }
    constexpr double five_figures = 1e4;  // values from there on have no decimals, those below one
    double const last_digit = std::abs(head.peak) < five_figures ? 0.1 : 1;
    check_stated_peak(peak_of(values), head.peak * unit_mps2, 0.5 * last_digit * unit_mps2, head.peak_line);
    if (!head.raw) {  // read to find a file that ends within them
        std::vector<double> others;
        append_fixed(lines, layout, count_at(head, velocities, where), file, others);
        append_fixed(lines, layout, count_at(head, displacements, where), file, others);
    }
    recording.time_step_s = step_s;
    recording.unit_mps2 = unit_mps2;
    recording.components.push_back({head.component, direction_of(head.component), std::move(values)});
}

}  // namespace

bool recognises_geonet(std::string_view content) { return is_first_line(TextLines(content).next().value_or("")); }

Recording read_geonet(std::string_view content, RecordRequest const& request) {
    TextLines lines(content);
    Recording recording;
    while (auto const line = lines.next()) {
        if (is_first_line(*line)) {
            read_component(*line, lines, request, recording);
        } else if (!trimmed(*line).empty()) {
            throw InputError({request.name, lines.number()},
                             fmt::format("{} (a GeoNet file has 'accelerogram ... GNS Science' here). Fetch it anew",
                                         in_quotes(trimmed(*line))));
        }
    }
    if (recording.components.empty()) {
        throw InputError({request.name}, "no component in it (a GeoNet file has three). State another format");
    }
    return recording;
}

}  // namespace overturn
