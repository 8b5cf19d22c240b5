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

constexpr std::array<std::string_view, 17> keys{"Origin Time",
                                                "Lat.",
                                                "Long.",
                                                "Depth. (km)",
                                                "Mag.",
                                                "Station Code",
                                                "Station Lat.",
                                                "Station Long.",
                                                "Station Height",
                                                "Record Time",
                                                "Sampling Freq(Hz)",
                                                "Duration Time(s)",
                                                "Dir.",
                                                "Scale Factor",
                                                "Max. Acc. (gal)",
                                                "Last Correction",
                                                "Memo."};
constexpr std::size_t value_column = 18;  // the header's values begin after 18 characters of key
constexpr std::size_t count_width = 9;    // of a count and the blank behind it

/// The header values, each on the line of its key.
class Header {
  public:
    Header(TextLines& lines, std::string const& file) : file_(file) {
        for (std::size_t i = 0; i < keys.size(); ++i) {
            auto const next = lines.next();
            if (!next) {
                throw InputError({file, lines.number()},
                                 fmt::format("{} header lines (a K-NET file has {}). Fetch the file anew",
                                             lines.number(), keys.size()));
            }
            if (!next->starts_with(keys.at(i))) {
                throw InputError({file, lines.number()},
                                 fmt::format("{} (a K-NET header has '{}' here). Fetch the file anew", in_quotes(*next),
                                             keys.at(i)));
            }
            lines_.at(i) = *next;
        }
    }

    [[nodiscard]] Location where(int number) const { return {file_, number}; }

    [[nodiscard]] static std::string_view key(int number) { return keys.at(number - 1); }

    [[nodiscard]] std::string_view value(int number) const {
        auto const line = lines_.at(number - 1);
        return trimmed(line.substr(std::min(value_column, line.size())));
    }

    /// A positive number on line `number`, with `ending` cut off.
    [[nodiscard]] double positive(int number, std::string_view ending = "") const {
        auto text = value(number);
        if (!ending.empty() && text.ends_with(ending)) {
            text.remove_suffix(ending.size());
        }
        return positive_number(text, number);
    }

    [[nodiscard]] double positive_number(std::string_view text, int number) const {
        double read = 0;
        if (!parse_number(trimmed(text), read) || !(read > 0)) {
            throw InputError(where(number), fmt::format("{} {} (must be a number above 0). Mend the header",
                                                        key(number), in_quotes(text)));
        }
        return read;
    }

  private:
    std::string file_;
    std::array<std::string_view, keys.size()> lines_;
};

/// `3920(gal)/6182761` -> acceleration of one count [m/s2].
double scale_factor(Header const& header) {
    constexpr int line = 14;
    constexpr std::string_view unit = "(gal)/";
    auto const text = header.value(line);
    auto const at = text.find(unit);
    if (at == std::string_view::npos) {
        throw InputError(header.where(line), fmt::format("{} {} (must read like 3920(gal)/6182761). Mend the header",
                                                         Header::key(line), in_quotes(text)));
    }
    return header.positive_number(text.substr(0, at), line) * gal_mps2
           / header.positive_number(text.substr(at + unit.size()), line);
}

/// The peak must be the header's to its printed digits, or the file is damaged.
void check_peak(Header const& header, double peak_mps2) {
    constexpr int line = 15;
    auto const text = header.value(line);
    double const stated = header.positive_number(text, line);
    auto const point = text.find('.');
    auto const decimals = point == std::string_view::npos ? 0 : text.size() - point - 1;
    double const half_of_last_digit = 0.5 * std::pow(10.0, -static_cast<double>(decimals));
    check_stated_peak(peak_mps2, stated * gal_mps2, half_of_last_digit * gal_mps2, header.where(line));
}

/// A record is of whole seconds and holds rate times duration to the sample: so do the published files of both
/// networks, at 100 Hz (138 s, 13800 counts) and 200 Hz (119 s, 23800 counts).
void check_count(std::size_t count, double frequency_hz, double duration_s, Location const& where) {
    double const promised = std::round(frequency_hz * duration_s);
    if (count == 0 || static_cast<double>(count) != promised) {
        throw InputError(where,
                         fmt::format("{} values where the header promises {} s at {} Hz, {} values (the file {}). "
                                     "Fetch it anew",
                                     count, duration_s, frequency_hz, promised,
                                     static_cast<double>(count) < promised ? "is cut short" : "holds too many"));
    }
}

/// The last count may have lost digits only where the file has lost its last line end; whole, it fills its field.
void check_last_count_is_whole(std::string_view content, Location const& where) {
    auto const line = content.substr(content.find_last_of("\r\n") + 1);
    if (auto const rest = line.size() % count_width; rest != 0 && rest + 1 != count_width) {
        throw InputError(where,
                         fmt::format("{} at the end of the file (a count and its blank fill {} columns: the file "
                                     "is cut short). Fetch it anew",
                                     in_quotes(trimmed(line.substr(line.size() - rest))), count_width));
    }
}

/// `N-S` as it stands; KiK-net's 1 to 3 and 4 to 6 are NS, EW, UD in the borehole and at the surface.
std::string direction_name(std::string_view text) {
    static constexpr std::array names{"NS", "EW", "UD"};
    if (text.size() == 1 && text[0] >= '1' && text[0] <= '6') {
        return names.at(static_cast<std::size_t>(text[0] - '1') % names.size());
    }
    return std::string(text);
}

bool is_in_borehole(std::string_view direction) {
    return direction.size() == 1 && direction[0] >= '1' && direction[0] <= '3';
}

/// Equal for the files of one sensor and event.
std::string sensor_of(Header const& header) {
    auto const direction = header.value(13);
    std::string_view const depth = direction.size() != 1       ? ""
                                   : is_in_borehole(direction) ? in_borehole_mark
                                                               : ", surface";
    return fmt::format("{}, {}{}", header.value(6), header.value(10), depth);
}

}  // namespace

bool recognises_knet(std::string_view content) {
    auto const first = TextLines(content).next();
    return first && first->starts_with("Origin Time");
}

std::string station_of_knet(std::string_view head) {
    TextLines lines(head);
    return sensor_of(Header(lines, {}));
}

Recording read_knet(std::string_view content, RecordRequest const& request) {
    TextLines lines(content);
    Header const header(lines, request.name);
    double const frequency_hz = header.positive(11, "Hz");
    double const duration_s = header.positive(12);
    double const unit_mps2 = scale_factor(header);
    check_stated_unit(request, gal_mps2, header.where(14));
    check_stated_time_step(request, 1 / frequency_hz, header.where(11));

    std::vector<double> values;
    while (auto const line = lines.next()) {
        append_numbers(*line, request.name, lines.number(), values);
    }
    check_count(values.size(), frequency_hz, duration_s, {request.name, lines.number()});
    check_last_count_is_whole(content, {request.name, lines.number()});
    auto const count = static_cast<double>(values.size());
    double sum = 0;  // of whole numbers: exact
    for (double const value : values) {
        sum += value;
    }
    for (double& value : values) {
        value = (value - sum / count) * unit_mps2;
    }
    check_peak(header, peak_of(values));
    auto const name = direction_name(header.value(13));
    Recording recording{1 / frequency_hz, {{name, direction_of(name), std::move(values)}}, gal_mps2};
    recording.in_borehole = is_in_borehole(header.value(13));
    return recording;
}

}  // namespace overturn
