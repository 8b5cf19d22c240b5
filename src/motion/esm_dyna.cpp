#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/units.hpp"
#include "motion/detail/record_readers.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

constexpr std::string_view first_key = "EVENT_NAME:";

struct Entry {
    std::string value;
    int line = 0;
};

/// `KEY: value` lines; values may hold colons and may be empty.
class Header {
  public:
    explicit Header(std::string file) : file_(std::move(file)) {}

    /// True if `line` is of the header.
    bool take(std::string_view line, int number) {
        auto const colon = line.find(':');
        if (colon == std::string_view::npos) {
            return false;
        }
        entries_[std::string(trimmed(line.substr(0, colon)))] = {std::string(trimmed(line.substr(colon + 1))), number};
        return true;
    }

    [[nodiscard]] Entry text(std::string const& key) const {
        auto const at = entries_.find(key);
        if (at == entries_.end() || at->second.value.empty()) {
            throw InputError({file_}, fmt::format("{}: missing (a DYNA header states it). Fetch the file anew", key));
        }
        return at->second;
    }

    [[nodiscard]] bool has(std::string const& key) const {
        auto const at = entries_.find(key);
        return at != entries_.end() && !at->second.value.empty();
    }

    [[nodiscard]] Location where(std::string const& key) const {
        auto const at = entries_.find(key);
        return {file_, at == entries_.end() ? 0 : at->second.line};
    }

    [[nodiscard]] double number(std::string const& key) const {
        auto const entry = text(key);
        double value = 0;
        if (!parse_number(entry.value, value)) {
            throw InputError({file_, entry.line},
                             fmt::format("{}: {} (not a finite number). Mend the header", key, in_quotes(entry.value)));
        }
        return value;
    }

    [[nodiscard]] double positive(std::string const& key) const {
        double const value = number(key);
        if (!(value > 0)) {
            throw InputError(where(key), fmt::format("{}: {} (must be above 0). Mend the header", key, value));
        }
        return value;
    }

  private:
    std::string file_;
    std::map<std::string, Entry> entries_;
};

/// HNE, HGN, HLZ: the last letter of the stream.
Direction direction_of_stream(std::string_view stream) { return direction_of(stream.substr(stream.size() - 1)); }

double unit_of(Header const& header) {
    auto const unit = header.text("UNITS");
    try {
        return unit_factor(unit.value, Dimension::acceleration);
    } catch (InputError const&) {
        throw InputError(header.where("UNITS"),
                         fmt::format("UNITS: {} (not a unit of acceleration: one of {}). Take "
                                     "the acceleration file of the same record",
                                     in_quotes(unit.value), accepted_units(Dimension::acceleration)));
    }
}

void check_quantity(Header const& header) {
    if (header.has("DATA_TYPE") && lowered(header.text("DATA_TYPE").value) != "acceleration") {
        throw InputError(header.where("DATA_TYPE"), fmt::format("DATA_TYPE: {} (an acceleration is needed). Take the "
                                                                "acceleration file of the same record",
                                                                in_quotes(header.text("DATA_TYPE").value)));
    }
}

void check_peak(Header const& header, double peak_mps2) {
    static std::string const key = "PGA_CM/S^2";
    constexpr double printed_share = 1e-3;
    if (header.has(key)) {
        double const stated = header.number(key) * gal_mps2;
        check_stated_peak(peak_mps2, stated, printed_share * std::abs(stated), header.where(key));
    }
}

}  // namespace

bool recognises_esm_dyna(std::string_view content) {
    auto const first = TextLines(content).next();
    return first && trimmed(*first).starts_with(first_key);
}

std::string station_of_esm_dyna(std::string_view head) {
    TextLines lines(head);
    Header header({});
    for (auto line = lines.next(); line && header.take(*line, lines.number()); line = lines.next()) {}
    check_quantity(header);
    auto const or_nothing = [&](char const* key) { return header.has(key) ? header.text(key).value : ""; };
    auto const stream = header.text("STREAM").value;
    return fmt::format("{}.{}.{}.{}, {}, {}", or_nothing("NETWORK"), header.text("STATION_CODE").value,
                       or_nothing("LOCATION"), stream.substr(0, stream.size() - 1), or_nothing("EVENT_ID"),
                       or_nothing("EVENT_DATE_YYYYMMDD"));
}

Recording read_esm_dyna(std::string_view content, RecordRequest const& request) {
    TextLines lines(content);
    Header header(request.name);
    std::vector<double> values;
    while (auto const line = lines.next()) {
        if (!values.empty() || !header.take(*line, lines.number())) {
            append_numbers(*line, request.name, lines.number(), values);
        }
    }
    check_quantity(header);
    double const unit = unit_of(header);
    double const step = header.positive("SAMPLING_INTERVAL_S");
    check_stated_unit(request, unit, header.where("UNITS"));
    check_stated_time_step(request, step, header.where("SAMPLING_INTERVAL_S"));
    if (static_cast<double>(values.size()) != header.number("NDATA")) {
        throw InputError({request.name, lines.number()},
                         fmt::format("{} values where NDATA promises {} (the file is cut short). Fetch it anew",
                                     values.size(), header.number("NDATA")));
    }
    for (double& value : values) {
        value *= unit;
    }
    check_peak(header, peak_of(values));
    auto const stream = header.text("STREAM").value;
    return {step, {{stream, direction_of_stream(stream), std::move(values)}}, unit};
}

}  // namespace overturn
