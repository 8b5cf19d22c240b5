#include <algorithm>
#include <array>
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

constexpr std::string_view data_key = "data";
constexpr std::size_t components_of_a_file = 3;

struct Entry {
    std::string value;
    int line = 0;
};

/// Lines `#Key: value` up to `#Data: 4F10.3`; keys in lower case, without their units in brackets.
class Header {
  public:
    Header(TextLines& lines, std::string file) : file_(std::move(file)) {
        while (auto const line = lines.next()) {
            auto const text = trimmed(*line);
            if (!text.empty() && text.front() != '#') {
                break;
            }
            auto const colon = text.find(':');
            if (colon == std::string_view::npos) {
                continue;
            }
            auto key = lowered(trimmed(text.substr(1, colon - 1)));
            key = key.substr(0, key.find('('));
            entries_[key] = {std::string(trimmed(text.substr(colon + 1))), lines.number()};
            if (key == data_key) {
                return;
            }
        }
        throw InputError({file_, lines.number()}, "no line '#Data:' (a CWA file has one). Fetch the file anew");
    }

    [[nodiscard]] Entry const& at(std::string const& key) const {
        auto const found = entries_.find(key);
        if (found == entries_.end()) {
            throw InputError({file_}, fmt::format("#{}: missing (a CWA header states it). Fetch the file anew", key));
        }
        return found->second;
    }
    [[nodiscard]] bool has(std::string const& key) const { return entries_.contains(key); }
    [[nodiscard]] Location where(std::string const& key) const { return {file_, at(key).line}; }

    [[nodiscard]] double positive(std::string const& key) const {
        double value = 0;
        if (!parse_number(at(key).value, value) || !(value > 0)) {
            throw InputError(where(key), fmt::format("{} (a number above 0 belongs behind #{}). Mend the header",
                                                     in_quotes(at(key).value), key));
        }
        return value;
    }

  private:
    std::string file_;
    std::map<std::string, Entry> entries_;
};

/// `Time U(+); N(+); E(+)` -> U, N, E. \throws InputError for any other sign or number of them
std::array<std::string, components_of_a_file> sequence_of(Header const& header) {
    auto const& text = header.at("datasequence").value;
    std::array<std::string, components_of_a_file> names;
    std::string_view rest = text;
    bool good = lowered(rest.substr(0, 4)) == "time";
    rest = trimmed(rest.substr(std::min<std::size_t>(4, rest.size())));
    for (auto& name : names) {
        auto const end = rest.find(';');
        auto const one = trimmed(rest.substr(0, end));
        good = good && one.ends_with("(+)") && one.size() > 3;
        name = one.substr(0, one.find('('));
        rest = end == std::string_view::npos ? std::string_view{} : trimmed(rest.substr(end + 1));
    }
    if (!good || !rest.empty()) {
        throw InputError(header.where("datasequence"),
                         fmt::format("{} (Time and three components with (+) belong here). Bring the columns into the "
                                     "order time,a_horizontal,a_transverse,a_vertical without this header",
                                     in_quotes(text)));
    }
    return names;
}

/// `6.999~   -7.118` behind #AmplitudeMAX. U, where it is there.
void check_peak(Header const& header, RecordComponent const& component) {
    auto const key = "amplitudemax. " + lowered(component.name);
    if (!header.has(key)) {
        return;
    }
    std::string_view const text = header.at(key).value;
    auto const tilde = text.find('~');
    double high = 0;
    double low = 0;
    if (tilde != std::string_view::npos && parse_number(trimmed(text.substr(0, tilde)), high)
        && parse_number(trimmed(text.substr(tilde + 1)), low)) {
        constexpr double half_of_last_digit = 0.0005;
        check_stated_peak(peak_of(component.acceleration_mps2), std::max(std::abs(high), std::abs(low)) * gal_mps2,
                          half_of_last_digit * gal_mps2, header.where(key));
    }
}

void check_times(std::vector<double> const& time, double step, Header const& header, int first_line,
                 std::string const& file) {
    constexpr double printed = 1.5e-3;
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (!(std::abs(time[i] - time[0] - static_cast<double>(i) * step) <= printed)) {
            throw InputError({file, first_line + static_cast<int>(i)},
                             fmt::format("time {} s (sample {} of {} a second: a row is lost). Fetch the file anew",
                                         time[i], i + 1, 1 / step));
        }
    }
    double const promised = header.positive("recordlength");
    double const length = static_cast<double>(time.size()) * step;
    if (std::abs(length - promised) > 1.5 * step) {
        throw InputError(
            {file, first_line + static_cast<int>(time.size())},
            fmt::format("{} rows make {:.6g} s where the header promises {:.6g} s (the file is cut short). "
                        "Fetch it anew",
                        time.size(), length, promised));
    }
}

}  // namespace

bool recognises_cwa(std::string_view content) {
    constexpr int header_lines_at_most = 40;
    TextLines lines(content);
    bool rate_seen = false;
    while (lines.number() < header_lines_at_most) {
        auto const line = lines.next();
        if (!line) {
            return false;
        }
        auto const lower = lowered(trimmed(*line));
        rate_seen = rate_seen || lower.starts_with("#samplerate");
        if (lower.starts_with("#data:")) {
            return rate_seen;
        }
    }
    return false;
}

Recording read_cwa(std::string_view content, RecordRequest const& request) {
    TextLines lines(content);
    auto const& file = request.name;
    Header const header(lines, file);
    if (!lowered(header.at("amplitudeunit").value).starts_with("gal")) {
        throw InputError(header.where("amplitudeunit"),
                         fmt::format("unit {} (CWA files are in gal). Convert the data to columns and state the unit",
                                     in_quotes(header.at("amplitudeunit").value)));
    }
    check_stated_unit(request, gal_mps2, header.where("amplitudeunit"));
    double const step = 1 / header.positive("samplerate");
    check_stated_time_step(request, step, header.where("samplerate"));
    Recording recording{.time_step_s = step, .components = {}, .unit_mps2 = gal_mps2};
    for (auto const& name : sequence_of(header)) {
        recording.components.push_back({name, direction_of(name), {}});
    }
    auto const layout = fixed_format_in("(" + header.at(std::string(data_key)).value + ")");
    if (!layout || layout->per_line != components_of_a_file + 1) {
        throw InputError(header.where(std::string(data_key)),
                         fmt::format("{} (a layout of four numbers such as 4F10.3 belongs here). Mend the header",
                                     in_quotes(header.at(std::string(data_key)).value)));
    }
    int const first_line = lines.number() + 1;
    std::vector<double> time;
    std::vector<double> row;
    for (auto rest = lines; auto const line = rest.next();) {
        if (trimmed(*line).empty()) {
            (void)lines.next();
            continue;
        }
        row.clear();
        append_fixed(lines, *layout, components_of_a_file + 1, file, row);
        time.push_back(row[0]);
        for (std::size_t i = 0; i < components_of_a_file; ++i) {
            recording.components[i].acceleration_mps2.push_back(row[i + 1] * gal_mps2);
        }
    }
    if (time.empty()) {
        throw InputError({file, lines.number()}, "no row of numbers (the file is cut short). Fetch it anew");
    }
    check_times(time, step, header, first_line, file);
    for (auto const& component : recording.components) {
        check_peak(header, component);
    }
    return recording;
}

}  // namespace overturn
