#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/digit.hpp"
#include "core/units.hpp"
#include "motion/detail/record_readers.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

// Converse and Brady (1992), USGS Open-File Report 92-296A, as the archive's files have it.
constexpr int text_lines = 11;
constexpr int integer_lines = 6;
constexpr FixedFormat integers_format{8, 10};
constexpr std::size_t integer_count = 48;
constexpr FixedFormat reals_format{5, 15};
constexpr std::size_t real_count = 50;
constexpr double no_integer = -32768;
constexpr double no_real = 1.7e38;

// Numbers of header values, counted from 1 as the report does.
constexpr std::size_t vertical_angle = 13, azimuth = 14, comments = 16, samples = 17, layout = 47;
constexpr std::size_t sampling_rate = 2, largest = 30, smallest = 32;

struct Header {
    std::string title, event, place;
    std::vector<double> integers, reals;

    [[nodiscard]] double integer(std::size_t number) const { return integers.at(number - 1); }
    [[nodiscard]] double real(std::size_t number) const { return reals.at(number - 1); }
};

Header read_header(TextLines& lines, std::string const& file) {
    constexpr int event_line = 4, place_line = 6;
    Header header;
    while (lines.number() < text_lines) {
        auto const found = lines.next();
        if (!found) {
            break;  // what follows will say so
        }
        auto const line = trimmed(*found);
        switch (lines.number()) {
            case 1:
                header.title = line;
                break;
            case event_line:
                header.event = line;
                break;
            case place_line:
                header.place = line;
                break;
            default:
                break;
        }
    }
    append_fixed(lines, integers_format, integer_count, file, header.integers);
    append_fixed(lines, reals_format, real_count, file, header.reals);
    return header;
}

/// "270", "UP", "DOWN" from the angles of the sensor; what stands behind "component=" where the header has none.
std::string component_of(Header const& header) {
    constexpr double up = 0, down = 180, level = 90;
    double const vertical = header.integer(vertical_angle);
    if (vertical == up || vertical == down) {
        return vertical == up ? "UP" : "DOWN";
    }
    if (vertical == level && header.integer(azimuth) != no_integer) {
        return fmt::format("{}", header.integer(azimuth));
    }
    constexpr std::string_view key = "component=";
    auto const at = header.place.find(key);
    return at == std::string::npos ? std::string() : std::string(trimmed(header.place.substr(at + key.size())));
}

/// "2 CORRECTED ACCELEROGRAM"; where processing is not stated, the layout decides.
bool is_title(std::string_view line) {
    auto const lower = lowered(trimmed(line));
    bool const numbered = lower.size() > 2 && is_digit(lower[0]) && lower[1] == ' ';
    return numbered && (lower.substr(2).starts_with("corrected acc") || lower.substr(2).starts_with("uncorrected acc"));
}

void check_quantity(Header const& header, std::string const& file) {
    auto const title = lowered(header.title);
    for (std::string_view const quantity : {"velocity", "displacement", "response"}) {
        if (title.find(quantity) != std::string::npos) {
            throw InputError({file, 1}, fmt::format("a {} file (an acceleration is needed). Take the acceleration file "
                                                    "of the same record",
                                                    quantity));
        }
    }
}

std::size_t count_of(Header const& header, std::string const& file) {
    double const count = header.integer(samples);
    constexpr double most = 1e9;
    if (!(count >= 1 && count <= most)) {
        throw InputError({file, text_lines + 3}, fmt::format("{} samples (integer-header value 17 must be at least 1). "
                                                             "Mend the header",
                                                             count));
    }
    return static_cast<std::size_t>(count);
}

void skip_comments(TextLines& lines, double count, std::string const& file) {
    for (int i = 0; i < static_cast<int>(count); ++i) {
        auto const line = lines.next().value_or("");
        if (!line.starts_with('|')) {
            throw InputError({file, lines.number()}, fmt::format("{} ({} comment lines beginning with | belong here). "
                                                                 "Fetch the file anew",
                                                                 in_quotes(line), count));
        }
    }
}

}  // namespace

bool recognises_smc(std::string_view content) {
    TextLines lines(content);
    while (lines.number() < text_lines) {
        auto const line = lines.next();
        if (line && lines.number() == 1 && is_title(*line)) {
            return true;
        }
        if (!line) {
            return false;
        }
    }
    for (int i = 0; i < integer_lines; ++i) {
        auto const line = lines.next().value_or("");
        for (std::size_t field = 0; field < integers_format.per_line; ++field) {
            double value = 0;
            auto const at = field * integers_format.width;
            bool const whole = at + integers_format.width <= line.size();
            if (!whole || !parse_number(trimmed(line.substr(at, integers_format.width)), value)
                || value != std::floor(value)) {
                return false;
            }
        }
    }
    return true;
}

std::string station_of_smc(std::string_view head) {
    TextLines lines(head);
    auto const header = read_header(lines, {});
    return fmt::format("{}, {}", header.event, header.place.substr(0, header.place.find("component=")));
}

Recording read_smc(std::string_view content, RecordRequest const& request) {
    TextLines lines(content);
    auto const& file = request.name;
    auto const header = read_header(lines, file);
    Location const where{file, lines.number()};
    check_quantity(header, file);
    auto const count = count_of(header, file);
    double const rate = header.real(sampling_rate);
    if (rate >= no_real) {
        throw InputError({file, text_lines + integer_lines + 1},
                         "no rate in the header (an uncorrected record, whose values stand beside times of their own). "
                         "Take the corrected file of the same record");
    }
    if (!(rate > 0)) {
        throw InputError(
            {file, text_lines + integer_lines + 1},
            fmt::format("{} samples a second (real-header value 2 must be above 0). Mend the header", rate));
    }
    check_stated_unit(request, gal_mps2, where);
    check_stated_time_step(request, 1 / rate, where);
    if (double const lines_of_comment = header.integer(comments); lines_of_comment > 0) {
        skip_comments(lines, lines_of_comment, file);
    }
    constexpr double wide = 8;
    constexpr FixedFormat wide_format{5, 14}, plain_format{8, 10};
    std::vector<double> values;
    append_fixed(lines, header.integer(layout) == wide ? wide_format : plain_format, count, file, values);
    for (double& value : values) {
        value *= gal_mps2;
    }
    double const high = header.real(largest);
    double const low = header.real(smallest);
    if (std::abs(high) < no_real && std::abs(low) < no_real) {
        constexpr double printed_share = 1e-3;
        double const stated = std::max(std::abs(high), std::abs(low)) * gal_mps2;
        check_stated_peak(peak_of(values), stated, printed_share * stated, where);
    }
    auto const name = component_of(header);
    return {1 / rate, {{name, direction_of(name), std::move(values)}}, gal_mps2};
}

}  // namespace overturn
