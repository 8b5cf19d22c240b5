#include "motion/prose.hpp"

#include <array>
#include <cmath>

#include "core/units.hpp"
#include "motion/column_unit.hpp"
#include "motion/detail/record_readers.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

constexpr Text letters = "abcdefghijklmnopqrstuvwxyz";

bool is_letter(char c) { return letters.find(c) != Text::npos; }

/// The word that ends before `at`, without blanks, colons and equals signs between.
Text word_before(Text line, std::size_t at) {
    auto const end = line.find_last_not_of(" \t:=", at == 0 ? 0 : at - 1);
    if (at == 0 || end == Text::npos || !is_letter(line[end])) {
        return {};
    }
    auto const begin = line.find_last_not_of(letters, end);
    return line.substr(begin == Text::npos ? 0 : begin + 1, end - (begin == Text::npos ? 0 : begin + 1) + 1);
}

/// A letter is a unit where it stands in brackets, or behind a word that says so.
bool is_marked(Text line, std::size_t at, std::size_t length) {
    bool const bracketed = at > 0 && (line[at - 1] == '(' || line[at - 1] == '[') && at + length < line.size()
                           && (line[at + length] == ')' || line[at + length] == ']');
    auto const word = word_before(line, at);
    return bracketed || word == "in" || word == "of" || word == "unit" || word == "units";
}

/// "9.81 m/s2", "300 gal": a quantity, which says nothing of the file's numbers.
bool is_quantity(Text line, std::size_t at) {
    auto const end = line.find_last_not_of(" \t", at == 0 ? 0 : at - 1);
    return at > 0 && end != Text::npos && ((line[end] >= '0' && line[end] <= '9') || line[end] == '.');
}

/// Units of acceleration anywhere in a line of lower case.
template <class Take> void each_unit(Text line, Take&& take) {
    constexpr Text ends = " \t()[]{},;:=\"|";
    for (std::size_t at = 0; at < line.size();) {
        at = std::min(line.find_first_not_of(ends, at), line.size());
        auto const end = std::min(line.find_first_of(ends, at), line.size());
        auto word = line.substr(at, end - at);
        while (word.ends_with('.')) {
            word.remove_suffix(1);
        }
        auto const unit = word.empty() ? std::nullopt : unit_spelled(word, Dimension::acceleration);
        if (unit && !is_quantity(line, at) && (word.size() > 1 || is_marked(line, at, word.size()))) {
            take(*unit);
        }
        at = end;
    }
}

/// The number that begins `text` behind a unit in brackets, an equals sign or a colon, in SI; nothing if it is none.
std::optional<double> number_behind(Text text, Dimension dimension) {
    double factor = 1;
    text = trimmed(text);
    if (text.starts_with('(') || text.starts_with('[')) {
        auto const close = text.find_first_of(")]");
        auto const unit = close == Text::npos ? std::nullopt : unit_spelled(text.substr(1, close - 1), dimension);
        if (!unit) {
            return std::nullopt;
        }
        factor = *unit;
        text = trimmed(text.substr(close + 1));
    }
    for (Text const filling : {"of", "is", "=", ":"}) {
        text = trimmed(text.substr(text.starts_with(filling) ? filling.size() : 0));
    }
    constexpr Text number = "0123456789.+-";
    auto end = std::min(text.find_first_not_of(number), text.size());
    if (end + 1 < text.size() && text[end] == 'e' && number.find(text[end + 1]) != Text::npos) {
        end = std::min(text.find_first_not_of(number, end + 1), text.size());
    }
    double value = 0;
    if (!parse_number(text.substr(0, end), value) || !(value > 0)) {
        return std::nullopt;
    }
    auto unit = trimmed(text.substr(end));
    unit = unit.substr(0, unit.find_first_of(" \t,;)]."));
    return value * factor * unit_spelled(unit, dimension).value_or(1);
}

struct Key {
    Text text;
    bool is_rate = false;
};
constexpr std::array keys{Key{"time increment"},
                          Key{"time step"},
                          Key{"timestep"},
                          Key{"time interval"},
                          Key{"sampling interval"},
                          Key{"sample interval"},
                          Key{"sampling period"},
                          Key{"sampling step"},
                          Key{"equally spaced at"},
                          Key{"intervals of"},
                          Key{"points at"},
                          Key{"delta t"},
                          Key{"dt"},
                          Key{"sampling rate", true},
                          Key{"sample rate", true},
                          Key{"samplerate", true},
                          Key{"sampling frequency", true}};

std::optional<double> step_in(Text line) {
    for (auto const& key : keys) {
        auto const at = line.find(key.text);
        auto const end = at + key.text.size();
        bool const whole =
            at != Text::npos && (at == 0 || !is_letter(line[at - 1])) && (end == line.size() || !is_letter(line[end]));
        if (!whole) {
            continue;
        }
        auto const value = number_behind(line.substr(end), key.is_rate ? Dimension::frequency : Dimension::time);
        if (value) {
            return key.is_rate ? 1 / *value : *value;
        }
    }
    return std::nullopt;
}

bool same(double a, double b) {
    constexpr double printed = 1e-3;
    return std::abs(a - b) <= printed * b;
}

}  // namespace

void Prose::Said::take(double heard, int number) {
    if (value && !same(heard, *value)) {
        twice = true;
        value.reset();
    } else if (!twice && !value) {
        value = heard;
        line = number;
    }
}

void Prose::take(std::string_view line, int number) {
    auto const lower = lowered(line);
    each_unit(lower, [&](double unit) { unit_.take(unit, number); });
    if (auto const step = step_in(lower)) {
        step_.take(*step, number);
    }
}

std::string Prose::unit_hint() const {
    return unit_.value ? fmt::format("; line {} says {}", unit_.line, name_of_acceleration_unit(*unit_.value)) : "";
}

std::string Prose::time_step_hint() const {
    return step_.value ? fmt::format("; line {} says {:.6g} s", step_.line, *step_.value) : "";
}

void Prose::check(RecordRequest const& request) const {
    if (unit_.value) {
        check_stated_unit(request, *unit_.value, {request.name, unit_.line});
    }
    if (step_.value) {
        auto own = request;
        own.may_be_resampled = false;  // the stated step is how the values are read, not what they are resampled to
        check_stated_time_step(own, *step_.value, {request.name, step_.line});
    }
}

}  // namespace overturn
