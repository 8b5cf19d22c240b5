#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/units.hpp"
#include "motion/column_unit.hpp"
#include "motion/detail/record_readers.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

constexpr int header_lines_at_most = 10;

struct Header {
    std::size_t samples = 0;
    double time_step_s = 0;
    bool in_g = false;
    std::string station;    // event and station
    std::string component;  // 090, UP, DWN
};

/// The number that begins `text` after blanks and, if asked for, an equals sign; NaN if there is none.
double leading_number(std::string_view text, bool after_equals) {
    text = trimmed(text);
    if (after_equals) {
        if (!text.starts_with('=')) {
            return NAN;
        }
        text = trimmed(text.substr(1));
    }
    double value = NAN;
    auto const token = text.substr(0, text.find_first_not_of("0123456789.+-ed"));
    return parse_number(token, value) ? value : NAN;
}

/// SI value of the unit behind the number that begins `text`: 1 where none stands, NaN where it is one of no time. [s]
double unit_behind_number(std::string_view text) {
    auto const number = text.find_first_of("0123456789.");
    auto rest = text.substr(std::min(number, text.size()));
    rest = trimmed(rest.substr(std::min(rest.find_first_not_of("0123456789.+-ed"), rest.size())));
    auto const word = rest.substr(0, rest.find_first_not_of("abcdefghijklmnopqrstuvwxyz"));
    if (word == "hz" || word == "min") {
        return NAN;
    }
    bool const known = word.starts_with("s") || word.starts_with("m") || word.starts_with("us");
    return known ? unit_spelled(word, Dimension::time).value_or(1) : 1;
}

/// `NPTS = n , DT = dt [SEC]` in any spacing, or `n dt NPTS, DT`. \pre `line` is lower case and holds "npts".
void read_size(std::string_view line, Location const& where, Header& header) {
    auto const npts = line.find("npts");
    auto const after = line.substr(npts + 4);
    double count = NAN;
    double step = NAN;
    if (auto const dt = after.find("dt"); trimmed(after).starts_with('=') && dt != std::string_view::npos) {
        count = leading_number(after, true);
        step = leading_number(after.substr(dt + 2), true) * unit_behind_number(after.substr(dt + 2));
    } else {
        auto const before = trimmed(line.substr(0, npts));
        count = leading_number(before, false);
        step = leading_number(before.substr(std::min(before.find_first_of(" \t,"), before.size())), false);
    }
    constexpr double most = 1e9;
    if (!(count >= 1 && count <= most && count == std::floor(count))) {
        throw InputError(where, fmt::format("no count of values in {} (NPTS must be a whole number of at least 1). "
                                            "Mend the header",
                                            in_quotes(trimmed(line))));
    }
    if (!(step > 0)) {
        throw InputError(where,
                         fmt::format("no time step in {} (DT must be a number of seconds above 0). Mend the header",
                                     in_quotes(trimmed(line))));
    }
    header.samples = static_cast<std::size_t>(count);
    header.time_step_s = step;
}

/// What follows the word "units" ("of g. filter points ...", "are (g)"), without filling words; empty if it is not
/// there. \pre `line` is lower case.
std::string_view stated_unit(std::string_view line) {
    auto const units = line.find("units");
    if (units == std::string_view::npos) {
        return {};
    }
    auto rest = line.substr(units + 5);
    for (std::string_view const filling : {"of ", "are ", "in ", ":", "="}) {
        rest = trimmed(rest);
        rest.remove_prefix(rest.starts_with(filling) ? filling.size() : 0);
    }
    rest = rest.substr(std::min(rest.find_first_not_of(" \t(["), rest.size()));
    return rest.substr(0, rest.find_first_of(" \t)].,;"));
}

void read_header_line(std::string_view lower, Location const& where, Header& header) {
    for (std::string_view const quantity : {"velocity", "displacement"}) {
        if (lower.find(quantity) != std::string_view::npos && lower.find("acceleration") == std::string_view::npos) {
            throw InputError(where, fmt::format("a {} series (an acceleration is needed). Take the AT2 file of the "
                                                "same record",
                                                quantity));
        }
    }
    auto const unit = stated_unit(lower);
    if (!unit.empty() && unit != "g") {
        throw InputError(where, fmt::format("unit {} (an AT2 file is in units of g). Convert it to columns and state "
                                            "the unit",
                                            in_quotes(unit)));
    }
    header.in_g = header.in_g || unit == "g";
}

/// `<event>, <date>, <station>, <component>[ (remark)]`; the station itself may hold commas.
void read_identity(std::string_view line, Header& header) {
    auto const comma = line.rfind(',');
    if (comma == std::string_view::npos) {
        return;
    }
    header.station = trimmed(line.substr(0, comma));
    auto const component = trimmed(line.substr(comma + 1));
    header.component = component.substr(0, component.find_first_of(" \t("));
}

/// Reads up to and including the line with NPTS and DT.
Header read_header(TextLines& lines, std::string const& file) {
    Header header;
    while (lines.number() < header_lines_at_most) {
        auto const line = lines.next();
        if (!line) {
            break;
        }
        auto const lower = lowered(*line);
        Location const where{file, lines.number()};
        read_header_line(lower, where, header);
        constexpr int identity_line = 2;
        if (lines.number() == identity_line) {
            read_identity(*line, header);
        }
        if (lower.find("npts") != std::string::npos) {
            read_size(lower, where, header);
            return header;
        }
    }
    throw InputError({file}, fmt::format("no line with NPTS and DT among the first {} (an AT2 header has one). "
                                         "State another format",
                                         header_lines_at_most));
}

bool is_trailer(std::string_view line) {
    return trimmed(line).starts_with('*') && lowered(line).find("end") != std::string::npos;
}

/// Do words stand right below, names of columns or further text? An AT2 has its values there.
bool words_follow(TextLines lines) {
    auto line = lines.next();
    while (line && trimmed(*line).empty()) {
        line = lines.next();
    }
    auto const text = lowered(trimmed(line.value_or("")));
    constexpr std::string_view comments_and_quotes = "#%;!\"";
    return !text.empty()
           && ((text.front() >= 'a' && text.front() <= 'z')
               || comments_and_quotes.find(text.front()) != std::string::npos);
}

}  // namespace

bool recognises_peer_at2(std::string_view content) {
    TextLines lines(content);
    while (lines.number() < header_lines_at_most) {
        auto const line = lines.next();
        if (!line) {
            return false;
        }
        auto const lower = lowered(*line);
        auto const npts = lower.find("npts");
        if (npts != std::string::npos && lower.find("dt", npts) != std::string::npos) {
            return !words_follow(lines);
        }
    }
    return false;
}

std::string station_of_peer_at2(std::string_view head) {
    TextLines lines(head);
    return read_header(lines, {}).station;
}

Recording read_peer_at2(std::string_view content, RecordRequest const& request) {
    TextLines lines(content);
    auto const header = read_header(lines, request.name);
    Location const header_end{request.name, lines.number()};
    if (!header.in_g && !request.unit_mps2) {
        refuse_without_unit(header_end, "the header does not say 'units of g'", request);
    }
    if (header.in_g) {
        check_stated_unit(request, g0, header_end);
    }
    check_stated_time_step(request, header.time_step_s, header_end);

    std::vector<double> values;
    Location last = header_end;
    while (auto const line = lines.next()) {
        if (is_trailer(*line)) {
            break;
        }
        auto const before = values.size();
        append_numbers(*line, request.name, lines.number(), values);
        last.line = values.size() > before ? lines.number() : last.line;
    }
    if (values.size() != header.samples) {
        throw InputError(last, fmt::format("{} values where NPTS promises {} (the file is cut short, or the header "
                                           "belongs to another record). Fetch the file anew",
                                           values.size(), header.samples));
    }
    check_last_value_is_whole(content, last);
    double const unit = request.unit_mps2.value_or(g0);
    for (double& value : values) {
        value *= unit;
    }
    check_believable_peak(values, header_end);
    return {header.time_step_s, {{header.component, direction_of(header.component), std::move(values)}}, unit};
}

}  // namespace overturn
