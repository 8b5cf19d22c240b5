#include <algorithm>
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

// CSMIP's words, and those of Volume II of USC and Caltech.
constexpr std::array data_follows{std::string_view("points of accel data equally spaced at"),
                                  std::string_view("points of acc data equally spaced at")};
constexpr std::string_view points_of = " points of ";
constexpr std::string_view integrated = "accel, veloc and displ data";  // in the text of a channel that has all three
constexpr FixedFormat data_format{8, 10};

/// Where such words end in a line of lower case; npos if there are none.
std::size_t behind_data_follow(std::string_view lower) {
    for (auto const words : data_follows) {
        if (auto const at = lower.find(words); at != std::string_view::npos) {
            return at + words.size();
        }
    }
    return std::string_view::npos;
}

bool begins_data(std::string_view lower) { return behind_data_follow(lower) != std::string_view::npos; }

/// What the text lines before a channel's data say.
struct Channel {
    std::string name;     ///< "90 DEG", "UP"
    std::string number;   ///< of the channel, as printed
    double peak_gal = 0;  ///< 0: not stated in gal
    Location peak_line;
    int blocks_promised = 1;  ///< acceleration; velocity and displacement too if the text says so
    std::size_t count = 0;    ///< of each block's points
    int blocks = 0;
    bool begun = false;
};

/// `CHAN  1:  90 DEG     FROM` -> 1 and "90 DEG"; blanks in a row mean one.
void read_channel_name(std::string_view line, Channel& channel) {
    auto const at = lowered(line).find("chan");  // capitals until some time after 2000
    auto const colon = line.find(':', std::min(at, line.size()));
    if (at == std::string_view::npos || colon == std::string_view::npos) {
        auto const comp = lowered(line).find(" comp ");
        constexpr std::size_t length = 6;
        auto const behind = comp == std::string::npos ? std::string_view{} : trimmed(line.substr(comp + length));
        channel.name = behind.substr(0, behind.find("   "));
        return;
    }
    channel.number = trimmed(line.substr(at + 4, colon - at - 4));
    auto text = trimmed(line.substr(colon + 1));
    text = trimmed(text.substr(0, text.find("   ")));
    channel.name = text;
}

/// `PEAK ACCELERATION =  -267.957    CM/SEC/SEC  AT   10.940   SEC.`
void read_peak(std::string_view line, Location const& where, Channel& channel) {
    auto const equals = line.find('=');
    auto const text = trimmed(line.substr(std::min(equals + 1, line.size())));
    double peak = 0;
    if ((lowered(line).find("cm/sec/sec") != std::string::npos
         || lowered(line).find("cms/sec/sec") != std::string::npos)
        && parse_number(text.substr(0, text.find_first_of(" \t")), peak)) {
        channel.peak_gal = peak;
        channel.peak_line = where;
    }
}

bool is_of(std::string_view lower, std::string_view quantity) {
    auto const at = lower.find(points_of);
    return at != std::string_view::npos && lower.substr(at + points_of.size()).starts_with(quantity)
           && lower.find("data equally spaced at", at) != std::string_view::npos;
}

/// Nothing of velocity and displacement is kept: their values are read to find a file that ends within them.
void skip_block(std::string_view line, TextLines& lines, std::string const& file, Channel& channel) {
    Location const where{file, lines.number()};
    double count = 0;
    if (!parse_number(trimmed(line.substr(0, lowered(line).find(points_of))), count)
        || count != static_cast<double>(channel.count)) {
        throw InputError(where, fmt::format("{} ({} points belong here, as in the acceleration). Fetch the file anew",
                                            in_quotes(trimmed(line)), channel.count));
    }
    std::vector<double> values;
    append_fixed(lines, fixed_format_in(line).value_or(data_format), channel.count, file, values);
    ++channel.blocks;
}

/// \throws InputError if a block that the channel's text promises has not come.
void check_whole(Channel const& channel, Location const& where) {
    if (channel.begun && channel.blocks < channel.blocks_promised) {
        throw InputError(where,
                         fmt::format("channel {} ends after {} of {} blocks of data (the file is cut short). Fetch "
                                     "it anew",
                                     channel.number, channel.blocks, channel.blocks_promised));
    }
}

/// The number in front of and the one behind `data_follow`. \param peak_in_gal a line on the peak says the unit
std::pair<std::size_t, double> read_size(std::string_view line, bool peak_in_gal, Location const& where) {
    auto const lower = lowered(line);
    auto const at = lower.find("points of");
    auto const after = trimmed(std::string_view(lower).substr(behind_data_follow(lower)));
    double count = 0;
    double step = 0;
    constexpr double most = 1e9;
    if (!parse_number(trimmed(std::string_view(lower).substr(0, at)), count) || !(count >= 1 && count <= most)
        || !parse_number(after.substr(0, after.find_first_of(" \t")), step) || !(step > 0)) {
        throw InputError(where, fmt::format("{} (a count of points and a step above 0 s belong here). Mend the header",
                                            in_quotes(trimmed(line))));
    }
    bool const in_gal = lower.find("cm/sec/sec") != std::string::npos || lower.find("cm/sec2") != std::string::npos;
    bool const by_peak = peak_in_gal && lower.find("unit") == std::string::npos;  // the values must then have that peak
    if (!in_gal && !by_peak) {
        throw InputError(where,
                         "unit other than CM/SEC/SEC or cm/sec2 (corrected CSMIP data are in it). Convert the data to "
                         "columns and state the unit");
    }
    return {static_cast<std::size_t>(count), step};
}

void read_channel(std::string_view line, TextLines& lines, Channel& channel, RecordRequest const& request,
                  Recording& recording) {
    Location const where{request.name, lines.number()};
    auto const [count, step] = read_size(line, channel.peak_gal != 0, where);
    check_stated_unit(request, gal_mps2, where);
    check_stated_time_step(request, step, where);
    if (!recording.components.empty() && step != recording.time_step_s) {
        throw InputError(where, fmt::format("time step of {} s after a channel of {} s (components must agree). Put "
                                            "the channels into files of their own",
                                            step, recording.time_step_s));
    }
    std::vector<double> values;
    append_fixed(lines, fixed_format_in(line).value_or(data_format), count, request.name, values);
    for (double& value : values) {
        value *= gal_mps2;
    }
    if (channel.peak_gal != 0) {
        constexpr double half_of_last_digit = 0.0005;
        check_stated_peak(peak_of(values), channel.peak_gal * gal_mps2, half_of_last_digit * gal_mps2,
                          channel.peak_line);
    }
    channel.count = count;
    ++channel.blocks;
    recording.time_step_s = step;
    recording.unit_mps2 = gal_mps2;
    bool const taken = std::any_of(recording.components.begin(), recording.components.end(),
                                   [&](RecordComponent const& c) { return c.name == channel.name; });
    auto const name = taken ? fmt::format("{} (channel {})", channel.name, channel.number) : channel.name;
    recording.components.push_back({name, direction_of(channel.name), std::move(values)});
}

}  // namespace

bool recognises_csmip_v2(std::string_view content) {
    constexpr int header_lines_at_most = 60;
    TextLines lines(content);
    while (lines.number() < header_lines_at_most) {
        auto const line = lines.next();
        bool const volume_one = line && lines.number() == 1 && lowered(*line).starts_with("uncorrected accelerogram");
        if (!line || volume_one) {
            return false;
        }
        if (begins_data(lowered(*line))) {
            return true;
        }
    }
    return false;
}

Recording read_csmip_v2(std::string_view content, RecordRequest const& request) {
    TextLines lines(content);
    Recording recording;
    Channel channel;
    while (auto const line = lines.next()) {
        auto const lower = lowered(*line);
        Location const where{request.name, lines.number()};
        if (lower.starts_with("corrected accelerogram")) {
            check_whole(channel, where);
            channel = {};
            channel.begun = true;
            read_channel_name(*line, channel);
        } else if (lower.find(integrated) != std::string::npos) {
            channel.blocks_promised = 3;
        } else if (lower.starts_with("peak acceleration")) {
            read_peak(*line, where, channel);
        } else if (begins_data(lower)) {
            read_channel(*line, lines, channel, request, recording);
        } else if (is_of(lower, "vel") || is_of(lower, "dis")) {
            skip_block(*line, lines, request.name, channel);
        }
    }
    check_whole(channel, {request.name, lines.number()});
    if (recording.components.empty()) {
        throw InputError({request.name},
                         "no line 'POINTS OF ACCEL DATA EQUALLY SPACED AT' (a CSMIP V2 file has one). "
                         "State another format");
    }
    return recording;
}

}  // namespace overturn
