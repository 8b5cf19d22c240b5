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

constexpr std::string_view integers_follow = "integer-header values follow";
constexpr std::string_view reals_follow = "real-header values follow";
constexpr int text_lines_at_most = 60;  // 13 by the standard
constexpr double missing = -999;        // a value that the header or the data do not have

// Numbers of header values as the standard counts them, from 1.
constexpr std::size_t start_year = 40, start_month = 42, start_day = 43, start_hour = 44, start_minute = 45;
constexpr std::size_t orientation = 54;
constexpr std::size_t latitude = 1, longitude = 2, step_ms = 62, peak_value = 64;

/// The number that begins `text` after blanks; `otherwise` if there is none.
double leading_number(std::string_view text, double otherwise) {
    text = trimmed(text);
    double value = otherwise;
    return parse_number(text.substr(0, text.find_first_not_of("0123456789.+-")), value) ? value : otherwise;
}

bool holds(std::string_view line, std::string_view part) { return lowered(line).find(part) != std::string::npos; }

/// Header values behind a line `100 Integer-header values follow on 10 lines, Format= (10I8)`.
class HeaderValues {
  public:
    HeaderValues(std::string_view announcement, TextLines& lines, std::string const& file) {
        Location const where{file, lines.number()};
        auto const format = fixed_format_in(announcement);
        double const count = leading_number(announcement, 0);
        constexpr double most = 10000;
        if (!format || !(count >= 1 && count <= most)) {
            throw InputError(where, fmt::format("{} (a COSMOS header states a count and a Format here). Fetch the file "
                                                "anew",
                                                in_quotes(trimmed(announcement))));
        }
        append_fixed(lines, *format, static_cast<std::size_t>(count), file, values_);
    }

    /// Value number `number`; NaN if the header holds none (-999).
    [[nodiscard]] double at(std::size_t number) const {
        bool const there = number <= values_.size() && values_[number - 1] != missing;
        return there ? values_[number - 1] : std::nan("");
    }

  private:
    std::vector<double> values_;
};

/// `42000 acceleration pts, approx 210 secs, units=cm/sec2(04),Format=(1E15.6)`
struct DataLine {
    std::size_t count = 0;
    bool acceleration = false;
    double seconds = 0;
    double unit_mps2 = 0;
    FixedFormat format;
    Location where;
};

double unit_of(std::string_view lower, Location const& where) {
    auto const at = lower.find("units");
    auto text = at == std::string_view::npos ? std::string_view{} : trimmed(lower.substr(at + 5));
    text = trimmed(text.substr(text.starts_with('=') ? 1 : 0));
    text = trimmed(text.substr(0, text.find_first_of("(,")));
    text.remove_suffix(text.ends_with('.') ? 1 : 0);  // "g."
    if (text.find("count") != std::string_view::npos) {
        throw InputError(where,
                         "raw counts (a V0 file: only its instrument's calibration turns them into "
                         "accelerations). Take the V1 or V2 file of the same record");
    }
    for (std::string_view const gal : {"cm/sec2", "cm/sec/sec", "cm/sec^2", "cm/s2", "cm/s/s", "cm/s^2", "gal"}) {
        if (text == gal) {
            return gal_mps2;
        }
    }
    if (text == "g") {
        return g0;
    }
    throw InputError(where, fmt::format("unit {} (cm/sec2 or g is known). Convert the data to columns and state the "
                                        "unit",
                                        in_quotes(text)));
}

DataLine read_data_line(std::string_view line, Location const& where) {
    auto const lower = lowered(line);
    DataLine data;
    data.where = where;
    double const count = leading_number(lower, 0);
    auto const points = lower.find("pts");
    auto const format = fixed_format_in(std::string_view(lower).substr(std::min(lower.find("format"), lower.size())));
    constexpr double most = 1e9;
    if (!(count >= 1 && count <= most) || points == std::string::npos || !format) {
        throw InputError(where, fmt::format("{} (a COSMOS file states points, units and Format here). Fetch it anew",
                                            in_quotes(trimmed(line))));
    }
    data.count = static_cast<std::size_t>(count);
    data.format = *format;
    data.acceleration = lower.substr(0, points).find("accel") != std::string::npos;
    if (auto const approx = lower.find("approx"); approx != std::string::npos) {
        data.seconds = leading_number(std::string_view(lower).substr(approx + 6), 0);
    }
    data.unit_mps2 = data.acceleration ? unit_of(lower, where) : 1;
    return data;
}

void skip_comments(std::string_view announcement, TextLines& lines, std::string const& file) {
    constexpr double most = 1e6;
    auto const promised = static_cast<int>(std::clamp(leading_number(announcement, 0), 0.0, most));
    for (int left = promised; left > 0; --left) {
        auto const line = lines.next();
        if (!line || !trimmed(*line).starts_with('|')) {
            throw InputError({file, lines.number()}, fmt::format("{} ({} comment lines beginning with | were promised "
                                                                 "here). Fetch the file anew",
                                                                 in_quotes(line.value_or("")), promised));
        }
    }
}

std::string_view required(TextLines& lines, std::string const& file) {
    auto const line = lines.next();
    if (!line) {
        throw InputError({file, lines.number()}, "end of the file within its header (it is cut short). Fetch it anew");
    }
    return *line;
}

/// \throws InputError at the line of the first value that the data do not have: no number may stand in for it.
void check_none_missing(std::vector<double> const& values, DataLine const& data) {
    auto const at = std::find(values.begin(), values.end(), missing);
    if (at == values.end()) {
        return;
    }
    auto const before = static_cast<std::size_t>(at - values.begin());
    auto const line = data.where.line + 1 + static_cast<int>(before / data.format.per_line);
    throw InputError({data.where.file, line},
                     fmt::format("{} as value {} of {} (it marks a missing value in a COSMOS file). Take a record "
                                 "without gaps",
                                 missing, before + 1, values.size()));
}

/// dt from real-header value 62 in milliseconds, held against the stated duration.
double time_step_of(HeaderValues const& reals, DataLine const& data, RecordRequest const& request) {
    constexpr double ms_s = 1e-3;
    double const step = reals.at(step_ms) * ms_s;
    if (!(step > 0)) {
        if (request.time_step_s) {
            return *request.time_step_s;
        }
        throw InputError(data.where, "time step missing (real-header value 62 holds none). State the time step");
    }
    double const length = step * static_cast<double>(data.count);
    constexpr double printed_s = 1;
    constexpr double share = 0.01;
    if (data.seconds > 0 && std::abs(length - data.seconds) > printed_s + share * data.seconds) {
        throw InputError(data.where, fmt::format("{} points of {} s make {:.6g} s, not the stated {} s (real-header "
                                                 "value 62 must be the step in milliseconds). Mend the header",
                                                 data.count, step, length, data.seconds));
    }
    check_stated_time_step(request, step, data.where);
    return step;
}

std::string orientation_name(double code) {
    constexpr double full_circle = 360;
    constexpr double up = 400;
    constexpr double down = 401;
    if (code >= 0 && code <= full_circle) {
        return fmt::format("{} DEG", code);
    }
    return code == up ? "UP" : code == down ? "DOWN" : "";
}

/// The two header blocks of a channel, `announcement` being the line before the first.
struct Headers {
    HeaderValues integers, reals;
};

Headers read_headers(std::string_view announcement, TextLines& lines, std::string const& file) {
    HeaderValues integers(announcement, lines, file);
    auto const second = required(lines, file);
    if (!holds(second, reals_follow)) {
        throw InputError({file, lines.number()}, fmt::format("{} (the real header begins here in a COSMOS file). Fetch "
                                                             "it anew",
                                                             in_quotes(trimmed(second))));
    }
    return {std::move(integers), HeaderValues(second, lines, file)};
}

/// Reads the channel whose integer header `announcement` announces; velocity and displacement are passed over.
void read_channel(std::string_view announcement, TextLines& lines, RecordRequest const& request, Recording& recording) {
    auto const& file = request.name;
    auto const [integers, reals] = read_headers(announcement, lines, file);
    auto line = required(lines, file);
    if (holds(line, "comment line")) {
        skip_comments(line, lines, file);
        line = required(lines, file);
    }
    auto const data = read_data_line(line, {file, lines.number()});
    std::vector<double> values;
    append_fixed(lines, data.format, data.count, file, values);
    if (!data.acceleration) {
        return;
    }
    check_none_missing(values, data);
    for (double& value : values) {
        value *= data.unit_mps2;
    }
    check_stated_unit(request, data.unit_mps2, data.where);
    double const step = time_step_of(reals, data, request);
    if (!recording.components.empty() && step != recording.time_step_s) {
        throw InputError(data.where, fmt::format("time step of {} s after a channel of {} s (components must agree). "
                                                 "Put the channels into files of their own",
                                                 step, recording.time_step_s));
    }
    if (double const stated = reals.at(peak_value) * data.unit_mps2; std::isfinite(stated)) {
        constexpr double printed_share = 0.01;
        check_stated_peak(peak_of(values), stated, printed_share * std::abs(stated), data.where);
    }
    recording.time_step_s = step;
    recording.unit_mps2 = data.unit_mps2;
    auto const name = orientation_name(integers.at(orientation));
    recording.components.push_back({name, direction_of(name), std::move(values)});
}

}  // namespace

bool recognises_cosmos(std::string_view content) {
    TextLines lines(content);
    while (lines.number() < text_lines_at_most) {
        auto const line = lines.next();
        if (!line || holds(*line, integers_follow)) {
            return line.has_value();
        }
    }
    return false;
}

std::string station_of_cosmos(std::string_view head) {
    TextLines lines(head);
    auto line = lines.next();
    while (line && !holds(*line, integers_follow)) {
        line = lines.next();
    }
    auto const [integers, reals] = read_headers(line.value_or(""), lines, {});
    if (!std::isfinite(reals.at(latitude)) || !std::isfinite(integers.at(start_year))) {
        return {};
    }
    return fmt::format("{:.4f} {:.4f}, {}/{}/{} {}:{}", reals.at(latitude), reals.at(longitude),
                       integers.at(start_year), integers.at(start_month), integers.at(start_day),
                       integers.at(start_hour), integers.at(start_minute));
}

Recording read_cosmos(std::string_view content, RecordRequest const& request) {
    TextLines lines(content);
    Recording recording;
    bool channel_seen = false;
    while (auto const line = lines.next()) {
        if (holds(*line, integers_follow)) {
            channel_seen = true;
            read_channel(*line, lines, request, recording);
        } else if (double value = 0; !recording.components.empty() && parse_number(trimmed(*line), value)) {
            throw InputError({request.name, lines.number()}, fmt::format("{} after the promised values (the header "
                                                                         "belongs to another record). Fetch the file "
                                                                         "anew",
                                                                         in_quotes(trimmed(*line))));
        }
    }
    if (!channel_seen) {
        throw InputError({request.name},
                         "no line '100 Integer-header values follow' (a COSMOS file has one). State another format");
    }
    if (recording.components.empty()) {
        throw InputError({request.name},
                         "no acceleration in it (velocity or displacement only). Take the acceleration "
                         "file of the same record");
    }
    return recording;
}

}  // namespace overturn
