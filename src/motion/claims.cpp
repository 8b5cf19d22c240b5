#include "motion/claims.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/ranges.h>

#include "core/units.hpp"
#include "motion/column_unit.hpp"
#include "motion/detail/claim_words.hpp"
#include "motion/detail/claimed_unit.hpp"
#include "motion/detail/quantity_words.hpp"
#include "motion/detail/record_readers.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

bool same(double a, double b) {
    constexpr double printed = 1e-3;
    return std::abs(a - b) <= printed * std::abs(b);
}

bool holds(Text text, Text part) { return text.find(part) != Text::npos; }

/// A unit in such a line is of one value, not of all.
bool is_of_one_value(Text lower) {
    constexpr std::array words{"pga",       "pgv",      "pgd",   "peak",   "max", "min",     "trigger",
                               "threshold", "sensitiv", "scale", "full",   "rms", "initial", "arias",
                               "filter",    "vs30",     "vs,30", "offset", "mean"};
    return std::ranges::any_of(words, [&](Text word) { return holds(lower, word); });
}

/// What such a line says is not of the numbers: where, when, by what.
bool is_provenance(Text lower) {
    constexpr std::array words{"station",   "date",   "event",     "earthquake", "epicent",  "hypocent",  "magnitude",
                               "depth",     "latit",  "longit",    "coordinate", "altitude", "copyright", "instrument",
                               "recorder",  "site",   "location",  "origin",     "network",  "place",     "source",
                               "reference", "author", "processed", "generated",  "version",  "sensor",    "name"};
    return std::ranges::any_of(words, [&](Text word) { return holds(lower, word); });
}

bool says_nothing(Text line) { return line.find_first_not_of(" \t-=*#%;!/|:+.,_") == Text::npos; }

std::vector<std::string> words_of(Text text) {
    std::vector<std::string> words;
    for (std::size_t at = 0; at < text.size();) {
        at = std::min(text.find_first_not_of(" \t,;/", at), text.size());
        auto const end = std::min(text.find_first_of(" \t,;/", at), text.size());
        if (end > at) {
            words.emplace_back(text.substr(at, end - at));
        }
        at = end;
    }
    return words;
}

/// The component names behind "comp", one each or one in two words ("N10E", "360 deg"); empty if any is none.
std::vector<std::string> components_behind(Text text) {
    text = trimmed(text.substr(std::min(text.find_first_not_of(" \t:=."), text.size())));
    auto const known = [](std::string const& name) { return component_named(name).direction != Direction::unknown; };
    auto words = words_of(text);
    constexpr std::size_t most = 3;
    if (!words.empty() && words.size() <= most && std::ranges::all_of(words, known)) {
        return words;
    }
    return !text.empty() && known(std::string(text)) ? std::vector{std::string(text)} : std::vector<std::string>{};
}

}  // namespace

void Claims::Claim::take(double stated, int number) {
    if (value && !same(stated, *value)) {
        contradicted = true;
        value.reset();
    } else if (!contradicted && !value) {
        value = stated;
        line = number;
    }
}

bool Claims::take_unit(std::string const& lower, int number) {
    if (of_ == Dimension::none) {
        return false;
    }
    bool const one = is_of_one_value(lower);
    bool found = false;
    std::optional<double> of_peak;
    each_unit(lower, of_, [&](double unit) {
        found = true;
        one ? (void)(of_peak = unit) : unit_.take(unit, number);
    });
    if (auto const peak = peak_in(lower)) {
        peaks_.push_back({*peak, of_peak, number});
        return true;
    }
    if (!found && !one && !is_provenance(lower)) {
        auto const claimed = claimed_unit(lower, of_);
        claimed.si ? unit_.take(*claimed.si, number) : void();
        if (!claimed.si && !claimed.unknown.empty() && unknown_unit_.empty()) {
            unknown_unit_ = claimed.unknown;
            unknown_unit_line_ = number;
        }
        found = claimed.si || !claimed.unknown.empty();
    }
    return found && !one;
}

std::string_view Claims::other_than_own(Quantity quantity) const {
    bool const own = (of_ == Dimension::velocity && quantity == Quantity::velocity)
                     || (of_ == Dimension::length && quantity == Quantity::displacement)
                     || (of_ == Dimension::acceleration && quantity == Quantity::acceleration);
    return own ? Text{} : quantity == Quantity::acceleration ? Text("accelerations") : plural_of(quantity);
}

/// "velocity in cm/s", "displacement (cm)", "FLOAT, M/S", "units: counts".
bool Claims::take_other_quantity(std::string const& lower, int number) {
    if (is_of_one_value(lower) || holds(lower, "wave velocity") || holds(lower, "shear wave")
        || holds(lower, "shear-wave") || holds(lower, "shear vel")) {
        return false;
    }
    std::string found;
    for (auto const& [dimension, quantity] : {std::pair{Dimension::acceleration, Quantity::acceleration},
                                              {Dimension::velocity, Quantity::velocity},
                                              {Dimension::length, Quantity::displacement}}) {
        if (auto const other = other_than_own(quantity);
            !other.empty() && (dimension != Dimension::length || holds(lower, "displ"))) {
            each_unit(lower, dimension, [&](double /*si*/) { found = other; });
        }
    }
    if (found.empty() && of_ != Dimension::velocity && claimed_unit(lower, Dimension::velocity).si) {
        found = "velocities";  // "micrometers per second"
    }
    bool const per_count = holds(lower, "/count") || holds(lower, "per count");
    auto const said = per_count ? Quantity::unknown : quantity_in_prose(lower);
    auto const word = other_than_own(said);
    spectrum_ = spectrum_ || said == Quantity::spectrum;
    bool const counts = said == Quantity::counts || (holds_word(lower, "counts") && !per_count);
    bool const by_word = found.empty() && !counts && !word.empty();
    found = counts ? "counts" : by_word ? std::string(word) : found;
    if (found.empty()) {
        return false;
    }
    // "acceleration, velocity in cm/s" speaks of several; "unit: cm/s" of the numbers.
    bool const of_several = by_word || holds(lower, "veloc") || holds(lower, "displ");
    if (other_line_ == 0 || (other_of_several_ && !of_several)) {
        other_line_ = number;
        other_ = found;
        other_of_several_ = of_several;
    }
    return true;
}

bool Claims::take_components(std::string_view line, std::string const& lower, int number) {
    for (Text const key : {"components", "component", "comp", "direction", "dir", "channel", "orientation"}) {
        auto const at = lower.find(key);
        if (at == std::string::npos || !holds_word(lower, key)) {
            continue;
        }
        auto const found = components_behind(line.substr(at + key.size()));
        if (!found.empty() && components_.empty()) {
            components_ = found;
            components_line_ = number;
        }
        return !found.empty();
    }
    return false;
}

void Claims::take(std::span<TextLine const> lines, int names_line) {
    for (auto const& line : lines) {
        if (line.number != names_line) {
            take(line.text, line.number);
        }
    }
}

void Claims::take(std::string_view line, int number) {
    if (says_nothing(line)) {
        return;
    }
    auto const lower = lowered(line);
    bool understood = take_unit(lower, number);
    understood = take_other_quantity(lower, number) || understood;
    understood = take_components(line, lower, number) || understood;
    if (auto const step = step_in(lower)) {
        step_.take(*step, number);
        understood = true;
    }
    if (auto const count = count_in(lower)) {
        count_.take(static_cast<double>(*count), number);
        understood = true;
    }
    bool const instrument = holds(lower, "accelero");  // -graph, -meter, -gram
    auto const said = quantity_in_prose(lower);        // "acceleration spectrum", "integrated accelerations"
    bool const of_others = said != Quantity::unknown && said != Quantity::acceleration;
    if ((holds(lower, "accel") && !instrument && !of_others) || holds_word(lower, "acc")
        || holds(lower, "\xE5\x8A\xA0\xE9\x80\x9F\xE5\xBA\xA6")) {
        accelerations_ = true;
        understood = true;
    }
    bool const qualified = holds(lower, "normali") || holds(lower, "relative");
    if (qualified || (!understood && !is_provenance(lower))) {
        unread_.push_back(fmt::format("line {}: {}", number, in_quotes(trimmed(line))));
    }
}

std::vector<std::string> Claims::used() const {
    std::vector<std::string> lines;
    if (unit_.value) {
        lines.push_back(fmt::format("line {}: {}", unit_.line, name_of_unit(*unit_.value, of_)));
    }
    if (step_.value) {
        lines.push_back(fmt::format("line {}: {:.6g} s", step_.line, *step_.value));
    }
    if (count_.value) {
        lines.push_back(fmt::format("line {}: {:.0f} samples", count_.line, *count_.value));
    }
    return lines;
}

std::optional<double> Claims::unit_beside(std::optional<double> named, std::optional<double> stated,
                                          Location const& names, std::string_view advice) const {
    constexpr double rounding = 1e-9;
    auto const differ = [&](std::optional<double> a, std::optional<double> b) {
        return a && b && std::abs(*a - *b) > rounding * *b;
    };
    Location const line{names.file, unit_.line};
    if (differ(unit_.value, named)) {
        throw InputError(line, fmt::format("unit {}, line {} says {} (they contradict each other). Mend one of them",
                                           name_of_unit(*unit_.value, of_), names.line, name_of_unit(*named, of_)));
    }
    auto const said = named ? named : unit_.value;
    if (differ(said, stated)) {
        throw InputError(named ? names : line,
                         fmt::format("unit {} in the file, {} stated (they contradict each other). {}",
                                     name_of_unit(*said, of_), name_of_unit(*stated, of_), advice));
    }
    return said ? said : stated;
}

void Claims::check(RecordRequest const& request) const {
    bool const beside_accelerations = named_ || (accelerations_ && other_of_several_);
    bool const other = other_line_ > 0 && !beside_accelerations && (!unit_.value || spectrum_);
    if (unit_.value && !other) {
        check_stated_unit(request, *unit_.value, {request.name, unit_.line});
    } else if (other) {
        throw InputError({request.name, other_line_},
                         fmt::format("{}, says the text (accelerations are read). Take the accelerations of the same "
                                     "record, or mend the text",
                                     other_));
    }
    if (step_.value) {
        auto own = request;
        own.may_be_resampled = false;  // the stated step is how the values are read, not what they are resampled to
        check_stated_time_step(own, *step_.value, {request.name, step_.line});
    }
}

void Claims::check_unit_of(std::string_view column, std::string const& file) const {
    if (of_ != Dimension::none && other_line_ > 0 && !other_of_several_ && !unit_.value) {
        throw InputError(
            {file, other_line_},
            fmt::format("a unit of {}, column '{}' (they contradict each other). Mend one of them", other_, column));
    }
}

void Claims::check_unit_is_known(std::string const& file) const {
    if (!unit_.value && !unknown_unit_.empty()) {
        throw InputError({file, unknown_unit_line_},
                         fmt::format("'{}' (no unit of {} that is known). Write {}, or leave it out and state the unit",
                                     unknown_unit_, name_of(of_),
                                     of_ == Dimension::acceleration ? "m/s2, gal or g" : si_symbol(of_)));
    }
}

void Claims::check_times(double step_s, std::string const& file) const {
    if (step_.value && !same(step_s, *step_.value)) {
        throw InputError({file, step_.line},
                         fmt::format("time step {:.6g} s where the times rise by {:.6g} s (one of them is wrong). Mend "
                                     "the text or the times",
                                     *step_.value, step_s));
    }
}

void Claims::check_count(std::span<std::size_t const> counts, std::string const& file) const {
    if (!count_.value) {
        return;
    }
    auto const claimed = static_cast<std::size_t>(*count_.value);
    if (std::ranges::find(counts, claimed) == counts.end()) {
        throw InputError({file, count_.line},
                         fmt::format("{} samples claimed, {} found (the file is cut short, or the text is another "
                                     "file's). Fetch the file anew, or mend the text",
                                     claimed, counts.front()));
    }
}

void Claims::check_peaks(std::span<double const> peaks_mps2, double unit_mps2, std::string const& file) const {
    constexpr double printed = 0.01;
    constexpr std::array confused{9.80665, 980.665, 100.0, 1000.0, 9806.65};
    for (auto const& peak : peaks_) {
        double const claimed = peak.value * peak.unit.value_or(unit_mps2);
        auto const off_by = [&](double factor) {
            return std::ranges::any_of(
                peaks_mps2, [&](double found) { return std::abs(found * factor - claimed) <= printed * claimed; });
        };
        if (off_by(1)) {
            continue;
        }
        for (double const factor : confused) {
            if (off_by(factor) || off_by(1 / factor)) {
                throw InputError({file, peak.line},
                                 fmt::format("peak of {:.6g} m/s2 claimed, {:.6g} m/s2 found (a wrong unit, by a "
                                             "factor of {:g}). State the right unit",
                                             claimed, std::ranges::max(peaks_mps2), factor));
            }
        }
    }
}

std::string not_understood(std::span<std::string const> lines) {
    constexpr std::size_t most = 3;
    auto const shown = lines.first(std::min(lines.size(), most));
    return lines.empty() ? std::string()
                         : fmt::format(" (not understood: {}{})", fmt::join(shown, "; "),
                                       lines.size() > most ? fmt::format("; {} more", lines.size() - most) : "");
}

}  // namespace overturn
