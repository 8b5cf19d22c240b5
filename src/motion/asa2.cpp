#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/units.hpp"
#include "motion/column_unit.hpp"
#include "motion/detail/record_readers.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

// Archivo Estandar de Aceleracion (Instituto de Ingenieria, UNAM, Mexico): lines KEY : value, or KEY :
// /one/each/channel, then a column of numbers for each channel between rules.
constexpr std::string_view mark = "archivo estandar de aceleracion";
constexpr std::string_view data_follow = "datos de aceleracion";
constexpr int head_lines_at_most = 200;

struct Value {
    std::string text;
    int line = 0;
};

class Head {
  public:
    Head(TextLines& lines, std::string file) : file_(std::move(file)) {
        while (auto const line = lines.next()) {
            auto const lower = lowered(*line);
            if (lower.find(data_follow) == 0 || lines.number() > head_lines_at_most) {
                break;
            }
            if (auto const colon = line->find(':'); colon != std::string_view::npos) {
                auto const key = lowered(trimmed(line->substr(0, colon)));
                values_.try_emplace(key, Value{std::string(trimmed(line->substr(colon + 1))), lines.number()});
            }
        }
    }

    /// Of the key that begins with `key`. \throws InputError if there is none
    [[nodiscard]] Value at(std::string const& key) const {
        auto const found = values_.lower_bound(key);
        if (found == values_.end() || !found->first.starts_with(key)) {
            throw InputError({file_}, fmt::format("no line '{}' (the format has one). Fetch the file anew", key));
        }
        return found->second;
    }

    /// "/a/b/c", one each channel.
    [[nodiscard]] std::vector<std::string> each(std::string const& key, std::size_t channels) const {
        auto const value = at(key);
        std::vector<std::string> parts;
        std::string_view rest = value.text;
        rest = rest.substr(rest.starts_with('/') ? 1 : 0);
        while (parts.size() < channels) {
            auto const end = std::min(rest.find('/'), rest.size());
            parts.emplace_back(trimmed(rest.substr(0, end)));
            rest = rest.substr(std::min(end + 1, rest.size()));
        }
        return parts;
    }

    [[nodiscard]] std::vector<double> numbers(std::string const& key, std::size_t channels) const {
        std::vector<double> values;
        for (auto const& part : each(key, channels)) {
            double value = 0;
            if (!parse_number(part, value)) {
                throw InputError({file_, at(key).line},
                                 fmt::format("{} (a number for each of {} channels belongs here). Mend the header",
                                             in_quotes(part), channels));
            }
            values.push_back(value);
        }
        return values;
    }

    /// The one number of all channels.
    [[nodiscard]] double one(std::string const& key, std::size_t channels) const {
        auto const values = numbers(key, channels);
        if (std::ranges::adjacent_find(values, std::ranges::not_equal_to{}) != values.end() || !(values[0] > 0)) {
            throw InputError({file_, at(key).line}, fmt::format("{} (channels must agree, above 0). Put those that do "
                                                                "into a file of their own",
                                                                in_quotes(at(key).text)));
        }
        return values[0];
    }

  private:
    std::string file_;
    std::map<std::string, Value> values_;
};

std::size_t channels_of(Head const& head, std::string const& file) {
    auto const value = head.at("numero de canales");
    double channels = 0;
    constexpr double most = 6;  // the lines of C7 to C12 are left
    if (!parse_number(value.text, channels) || !(channels >= 1 && channels <= most)) {
        throw InputError({file, value.line},
                         fmt::format("{} channels (1 to 6 are read). Put three into a file of their "
                                     "own",
                                     value.text));
    }
    return static_cast<std::size_t>(channels);
}

std::string component_name_of(std::string const& text) {
    auto const begin = text.find_first_not_of("+; ");
    return begin == std::string::npos ? std::string() : text.substr(begin, text.find(';', begin) - begin);
}

/// \throws InputError if a line of names above the rows has them in another order than the header
void check_names_above(std::string_view line, Location const& where, Recording const& recording) {
    auto const names = parted_at(line, " \t");
    auto const same = [](RecordComponent const& component, std::string_view name) {
        return may_be_one(component_in(component.name), component_named(name));
    };
    if (names.size() == recording.components.size() && !std::ranges::equal(recording.components, names, same)) {
        throw InputError(where, fmt::format("{} above the columns, another order than the header's (they contradict "
                                            "each other). Fetch the file anew",
                                            in_quotes(trimmed(line))));
    }
}

/// All rows of as many numbers as there are channels; what lies behind the promised ones is left out, and listed.
void read_rows(TextLines& lines, std::size_t count, std::string const& file, Recording& recording) {
    auto const channels = recording.components.size();
    std::vector<double> row;
    std::size_t rows = 0;
    while (auto const line = lines.next()) {
        bool const text = line->find_first_not_of("0123456789.+-eE \t") != std::string_view::npos;
        bool const rule = line->find_first_of("0123456789") == std::string_view::npos;
        if (rule || (text && rows == 0)) {
            check_names_above(*line, {file, lines.number()}, recording);
            continue;
        }
        row.clear();
        append_numbers(*line, file, lines.number(), row);
        if (row.size() != channels) {
            throw InputError({file, lines.number()},
                             fmt::format("row {} of {} numbers ({} rows of {} belong here). Fetch the file anew",
                                         rows + 1, row.size(), count, channels));
        }
        for (std::size_t i = 0; i < channels && rows < count; ++i) {
            recording.components[i].acceleration_mps2.push_back(row[i] * gal_mps2);
        }
        ++rows;
    }
    if (rows > count) {
        recording.unread.push_back(
            fmt::format("line {}: {} rows more than the header promises, left out", lines.number(), rows - count));
    }
    if (rows < count) {
        throw InputError(
            {file, lines.number()},
            fmt::format("{} rows where the header promises {} (the file is cut short). Fetch it anew", rows, count));
    }
}

void check_peaks(Head const& head, Recording const& recording, std::string const& file) {
    auto const channels = recording.components.size();
    auto const peaks = head.each("acel. max.(gal), c1-c6", channels);
    for (std::size_t i = 0; i < channels; ++i) {
        double peak = 0;
        if (parse_number(peaks[i], peak)) {
            constexpr double printed_gal = 0.01;  // two decimals in older files
            check_stated_peak(peak_of(recording.components[i].acceleration_mps2), peak * gal_mps2,
                              printed_gal * gal_mps2, {file, head.at("acel. max.(gal), c1-c6").line});
        }
    }
}

}  // namespace

bool recognises_asa2(std::string_view content) {
    constexpr int looked_at = 20;
    TextLines lines(content);
    while (lines.number() < looked_at) {
        auto const line = lines.next();
        if (!line || lowered(trimmed(*line)).starts_with(mark)) {
            return line.has_value();
        }
    }
    return false;
}

Recording read_asa2(std::string_view content, RecordRequest const& request) {
    auto const& file = request.name;
    TextLines lines(content);
    Head const head(lines, file);
    auto const channels = channels_of(head, file);
    auto const unit = head.at("unidades de los datos");
    if (!lowered(unit.text).starts_with("gal")) {
        throw InputError({file, unit.line}, fmt::format("{} (Gal is known). Convert the data to columns and state the "
                                                        "unit",
                                                        in_quotes(unit.text)));
    }
    auto const step_s = head.one("intervalo de muestreo, c1-c6", channels);
    auto const count = static_cast<std::size_t>(head.one("num. total de muestras, c1-c6", channels));
    check_stated_unit(request, gal_mps2, {file, unit.line});
    check_stated_time_step(request, step_s, {file, head.at("intervalo de muestreo, c1-c6").line});
    Recording recording;
    recording.time_step_s = step_s;
    recording.unit_mps2 = gal_mps2;
    for (auto const& text : head.each("orientacion c1-c6", channels)) {
        auto const name = component_name_of(text);
        recording.components.push_back({name, direction_of(name), {}});
    }
    read_rows(lines, count, file, recording);
    check_peaks(head, recording, file);
    return recording;
}

}  // namespace overturn
