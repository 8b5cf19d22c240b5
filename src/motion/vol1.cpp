#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/units.hpp"
#include "motion/detail/record_readers.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

// Volume 1 as BHRC (Iran) and RENADIC (Chile) write it: text, 7 lines of integers, 7 of reals, values in G/10; BHRC's
// ten to a line, RENADIC's behind their times; a line "/&" ends each channel.
constexpr double unit_mps2 = 0.1 * g0;
constexpr int text_lines = 13;
constexpr int number_lines = 14;

enum class Network { none, bhrc, renadic };

struct Layout {
    FixedFormat format;
    bool times = false;
};
Layout layout_of(Network network) {
    constexpr Layout bhrc{{10, 13}, false};
    constexpr Layout renadic{{10, 7}, true};
    return network == Network::bhrc ? bhrc : renadic;
}

Network network_of(std::string_view content) {
    TextLines lines(content);
    bool volume = false;
    while (lines.number() < text_lines) {
        auto const line = lines.next();
        if (!line) {
            break;
        }
        auto const lower = lowered(trimmed(*line));
        volume = volume || lower.starts_with("* vol1ds");
        if (volume && lower.starts_with("units are seconds and g/10")) {
            return Network::bhrc;
        }
        if (lower.starts_with("universidad de chile - renadic")) {
            return Network::renadic;
        }
    }
    return Network::none;
}

struct Channel {
    std::string name;
    double points = 0, seconds = 0;
    double peak_g = 0;  ///< 0: not stated
    Location points_line, peak_line, unit_line;
};

/// The number behind `key` and an equals sign; false if there is none.
bool number_behind(std::string_view lower, std::string_view key, double& value) {
    auto const at = lower.find(key);
    auto const equals = lower.find('=', std::min(at, lower.size()));
    if (at == std::string_view::npos || equals == std::string_view::npos) {
        return false;
    }
    auto const text = trimmed(lower.substr(equals + 1));
    return parse_number(text.substr(0, text.find_first_not_of("0123456789.+-")), value);
}

void take_line(std::string_view line, Location const& where, Channel& channel) {
    auto const lower = lowered(line);
    auto const plain = trimmed(line);
    auto const colon = line.find(':');
    if (lower.starts_with("chan") && colon != std::string_view::npos) {
        auto const text = trimmed(line.substr(colon + 1));
        channel.name = text.substr(0, text.find(' '));
    } else if (plain.size() == 1 && channel.name.empty()) {  // BHRC's line of the letter alone
        channel.name = plain;
    } else if (lower.starts_with("no. of points")) {
        channel.points_line = where;
        (void)number_behind(lower, "points", channel.points);
        if (!number_behind(lower, "duration", channel.seconds)) {
            (void)number_behind(lower, "length", channel.seconds);
        }
    } else if (lower.find("g/10") != std::string::npos) {
        channel.unit_line = where;
        if (number_behind(lower, "max", channel.peak_g)) {
            channel.peak_line = where;
        }
    }
}

Channel read_text(std::string_view first, TextLines& lines, std::string const& file) {
    Channel channel;
    take_line(first, {file, lines.number()}, channel);
    for (int i = 1; i < text_lines; ++i) {
        auto const line = lines.next().value_or("");
        take_line(line, {file, lines.number()}, channel);
    }
    constexpr double most = 1e9;
    bool const sound = channel.points >= 2 && channel.points <= most && channel.points == std::floor(channel.points)
                       && channel.seconds > 0 && channel.unit_line.line > 0;
    if (!sound) {
        throw InputError({file, channel.points_line.line > 0 ? channel.points_line.line : lines.number()},
                         fmt::format("{} points of {} s (NO. OF POINTS, a length and UNITS of G/10 belong into this "
                                     "header). Fetch the file anew",
                                     channel.points, channel.seconds));
    }
    for (int i = 0; i < number_lines; ++i) {
        (void)lines.next();
    }
    return channel;
}

/// Of pairs of a time and a value. \throws InputError if the times are not those of the step
std::vector<double> values_behind_times(std::vector<double> const& pairs, double step_s, Location const& where) {
    constexpr double printed_s = 0.00051;
    std::vector<double> values;
    values.reserve(pairs.size() / 2);
    for (std::size_t i = 0; i + 1 < pairs.size(); i += 2) {
        auto const row = i / 2;
        double const expected = pairs[0] + static_cast<double>(row) * step_s;
        if (std::abs(pairs[i] - expected) > printed_s) {
            throw InputError(where, fmt::format("time {} of value {} ({:.6g} belongs there by the header's step of {} "
                                                "s). Fetch the file anew",
                                                pairs[i], row + 1, expected, step_s));
        }
        values.push_back(pairs[i + 1]);
    }
    return values;
}

void read_channel(std::string_view first, TextLines& lines, Network network, RecordRequest const& request,
                  Recording& recording) {
    auto const& file = request.name;
    auto const channel = read_text(first, lines, file);
    double const step_s = channel.seconds / channel.points;
    check_stated_unit(request, unit_mps2, channel.unit_line);
    check_stated_time_step(request, step_s, channel.points_line);
    constexpr double same = 1e-6;
    if (!recording.components.empty() && std::abs(step_s - recording.time_step_s) > same * step_s) {
        throw InputError(channel.points_line,
                         fmt::format("time step of {} s after a channel of {} s (they must agree). "
                                     "Put them into files of their own",
                                     step_s, recording.time_step_s));
    }
    auto const [format, times] = layout_of(network);
    auto const count = static_cast<std::size_t>(channel.points);
    std::vector<double> values;
    append_fixed(lines, format, times ? 2 * count : count, file, values);
    if (times) {
        values = values_behind_times(values, step_s, {file, lines.number()});
    }
    for (double& value : values) {
        value *= unit_mps2;
    }
    if (channel.peak_line.line > 0) {
        constexpr double half_of_last_digit_g = 0.00055;
        check_stated_peak(peak_of(values), channel.peak_g * g0, half_of_last_digit_g * g0, channel.peak_line);
    }
    auto const end = lines.next().value_or("");
    if (!end.starts_with("/&")) {
        throw InputError({file, lines.number()},
                         fmt::format("{} (a line /& ends a channel). Fetch the file anew", in_quotes(trimmed(end))));
    }
    recording.time_step_s = step_s;
    recording.unit_mps2 = unit_mps2;
    recording.components.push_back({channel.name, direction_of(channel.name), std::move(values)});
}

}  // namespace

bool recognises_vol1(std::string_view content) { return network_of(content) != Network::none; }

Recording read_vol1(std::string_view content, RecordRequest const& request) {
    auto const network = network_of(content);
    if (network == Network::none) {
        throw InputError({request.name}, "neither BHRC's nor RENADIC's marks in its head. State another format");
    }
    TextLines lines(content);
    Recording recording;
    while (auto const line = lines.next()) {
        if (!trimmed(*line).empty()) {
            read_channel(*line, lines, network, request, recording);
        }
    }
    return recording;
}

}  // namespace overturn
