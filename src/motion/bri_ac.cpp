#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/digit.hpp"
#include "core/units.hpp"
#include "motion/component_name.hpp"
#include "motion/detail/record_readers.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

// Strong motion network of the Building Research Institute (Japan), smo.kenken.go.jp/docs/acfile: a line of date, time,
// channels, rate, samples and station; for each channel a line of name, peak, its sample, offset and calibration, then
// 8F10.3 in gal.
constexpr FixedFormat data_fields{.per_line = 8, .width = 10};

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    for (auto rest = trimmed(line); !rest.empty();) {
        auto const end = std::min(rest.find_first_of(" \t"), rest.size());
        words.push_back(rest.substr(0, end));
        rest = trimmed(rest.substr(end));
    }
    return words;
}

/// "1993/01/15", "20:06:08": figures where `shape` has noughts, its own marks elsewhere.
bool is_shaped(std::string_view text, std::string_view shape) {
    return std::ranges::equal(text, shape, [](char letter, char wanted) {
        bool const figure = is_digit(letter);
        return wanted == '0' ? figure : letter == wanted;
    });
}

struct Head {
    std::size_t channels = 0;
    double rate_hz = 0;
    std::size_t samples = 0;
};

std::optional<Head> head_in(std::string_view line) {
    constexpr std::size_t named = 6;
    auto const words = words_of(line);
    if (words.size() < named || !is_shaped(words[0], "0000/00/00") || !is_shaped(words[1], "00:00:00")) {
        return std::nullopt;
    }
    std::array<double, 3> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        constexpr double most = 1e7;
        double& number = numbers.at(i);
        if (!parse_number(words[i + 2], number) || !(number >= 1 && number <= most) || number != std::floor(number)) {
            return std::nullopt;
        }
    }
    return Head{static_cast<std::size_t>(numbers[0]), numbers[1], static_cast<std::size_t>(numbers[2])};
}

/// The line above a channel's values: its name and peak.
struct Channel {
    std::string name;
    double peak_gal = 0;
    double last_digit_gal = 0;  ///< of the peak, as printed
};

Channel channel_in(std::string_view line, Location const& where) {
    constexpr std::size_t label = 10;
    Channel channel;
    channel.name = trimmed(line.substr(0, label));
    auto const peak = trimmed(line.size() > label ? line.substr(label, label) : std::string_view());
    if (channel.name.empty() || !parse_number(peak, channel.peak_gal)) {
        throw InputError(where, fmt::format("{} (the name of a channel and its peak belong here). Fetch the file anew",
                                            in_quotes(line)));
    }
    auto const point = peak.find('.');
    auto const decimals = point == std::string_view::npos ? 0 : peak.size() - point - 1;
    channel.last_digit_gal = std::pow(10.0, -static_cast<double>(decimals));
    return channel;
}

/// "063-GL": 63 degrees from north at ground level.
Direction direction_of_channel(std::string_view name) {
    return component_named(trimmed(name.substr(0, name.find('-')))).direction;
}

}  // namespace

bool recognises_bri_ac(std::string_view content) {
    auto const line = TextLines(content).next();
    return line && head_in(*line).has_value();
}

Recording read_bri_ac(std::string_view content, RecordRequest const& request) {
    auto const& file = request.name;
    TextLines lines(content);
    auto const head = head_in(lines.next().value_or(""));
    if (!head) {
        throw InputError({file, 1}, "date, time, channels, rate, samples and station belong here. Fetch the file anew");
    }
    check_stated_unit(request, gal_mps2, {file, 1});
    check_stated_time_step(request, 1 / head->rate_hz, {file, 1});
    Recording recording{.time_step_s = 1 / head->rate_hz, .components = {}, .unit_mps2 = gal_mps2};
    for (std::size_t i = 0; i < head->channels; ++i) {
        auto const line = lines.next();
        Location const where{file, lines.number()};
        if (!line) {
            throw InputError(where, fmt::format("{} channels where line 1 promises {} (the file is cut short). Fetch "
                                                "it anew",
                                                i, head->channels));
        }
        auto const channel = channel_in(*line, where);
        std::vector<double> values;
        append_fixed(lines, data_fields, head->samples, file, values);
        for (double& value : values) {
            value *= gal_mps2;
        }
        check_stated_peak(peak_of(values), channel.peak_gal * gal_mps2, channel.last_digit_gal * gal_mps2, where);
        recording.components.push_back({channel.name, direction_of_channel(channel.name), std::move(values)});
    }
    while (auto const line = lines.next()) {
        if (!trimmed(*line).empty()) {
            throw InputError({file, lines.number()}, fmt::format("{} behind the last of {} channels (which count?). "
                                                                 "Keep one record",
                                                                 in_quotes(trimmed(*line)), head->channels));
        }
    }
    return recording;
}

}  // namespace overturn
