#include "motion/text_statements.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/ranges.h>

#include "core/digit.hpp"
#include "core/units.hpp"
#include "motion/column_unit.hpp"
#include "motion/detail/plain_words.hpp"
#include "motion/detail/quantity_words.hpp"
#include "motion/detail/record_readers.hpp"
#include "motion/detail/statement_words.hpp"
#include "motion/detail/time_words.hpp"
#include "motion/detail/unit_in_text.hpp"
#include "motion/telling_words.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

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

std::string without(std::string text, Text part) {
    auto const at = text.find(part);
    return at == std::string::npos ? text : text.erase(at, part.size());
}

/// Between commas and semicolons that no figures surround.
std::vector<Text> parts_of(Text line) {
    constexpr Text marks = ",;";
    auto const digit_at = [&](std::size_t at) { return at < line.size() && is_digit(line[at]); };
    std::vector<Text> found;
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= line.size(); ++i) {
        bool const mark = i == line.size() || marks.find(line[i]) != Text::npos;
        if (mark && !(i > 0 && digit_at(i - 1) && digit_at(i + 1))) {
            found.push_back(line.substr(begin, i - begin));
            begin = i + 1;
        }
    }
    return found;
}

bool says_nothing(Text line) { return line.find_first_not_of(" \t-=*#%;!/|:+.,_") == Text::npos; }

}  // namespace

void TextStatements::Statement::take(double stated, int number) {
    if (value && !same_as_printed(stated, *value)) {
        contradicted = true;
        value.reset();
    } else if (!contradicted && !value) {
        value = stated;
        line = number;
    }
}

bool TextStatements::take_unit(std::string const& lower, int number) {
    if (of_ == Dimension::none) {
        return false;
    }
    bool const one = is_of_one_value(lower);
    auto clauses = unit_clauses(lower, of_);
    clauses.plain = clauses.plain || (number == title_ && is_title_of_unit(lower, of_));
    bool found = false;
    std::optional<double> of_peak;
    auto const take_one = [&](double unit) {
        found = true;
        if (one) {
            of_peak = unit;
        } else if (clauses.plain) {
            unit_.take(unit, number);
        } else if (doubt_.empty()) {
            doubt_ = fmt::format("line {} names {} among other words", number, clauses.name);
        }
    };
    each_unit(lower, of_, take_one);
    if (auto const peak = peak_in(lower, of_)) {
        peaks_.push_back({peak->value, peak->unit ? peak->unit : of_peak, number, peak->digit, peak->beside,
                          peak->rough, peak->other});
        return true;
    }
    if (!found && !one && (!is_provenance(lower) || !clauses.plain)) {
        auto const in_text = unit_in_text(lower, of_);
        in_text.si ? take_one(*in_text.si) : void();
        if (!in_text.si && !in_text.unknown.empty() && unknown_unit_.empty()) {
            unknown_unit_ = in_text.unknown;
            unknown_unit_line_ = number;
        }
        found = in_text.si || !in_text.unknown.empty();
    }
    bool const aside = !found && !one && clauses.any;  // "Source: PEER, g"
    if (aside && doubt_.empty()) {
        doubt_ = fmt::format("line {} names {} among other words", number, clauses.name);
    }
    doubted_ = aside || (found && !one && !clauses.plain);
    return found && !one;
}

std::string_view TextStatements::other_than_own(Quantity quantity) const {
    bool const own = (of_ == Dimension::velocity && quantity == Quantity::velocity)
                     || (of_ == Dimension::length && quantity == Quantity::displacement)
                     || (of_ == Dimension::acceleration && quantity == Quantity::acceleration);
    return own ? Text{} : quantity == Quantity::acceleration ? Text("accelerations") : plural_of(quantity);
}

/// "velocity in cm/s", "displacement (cm)", "FLOAT, M/S", "units: counts".
bool TextStatements::take_other_quantity(Text line, std::string const& lower, int number) {
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
    if (found.empty() && of_ != Dimension::velocity && unit_in_text(lower, Dimension::velocity).si) {
        found = "velocities";  // "micrometers per second"
    }
    bool const per_count = holds(lower, "/count") || holds(lower, "per count");
    auto const quantity = per_count ? Quantity::unknown : quantity_in_prose(lower);
    auto const word = other_than_own(quantity);
    spectrum_ = spectrum_ || quantity == Quantity::spectrum;
    bool const counts = quantity == Quantity::counts || (holds_word(lower, "counts") && !per_count);
    if (counts && beside_counts_ && !holds(lower, "unit")) {
        return false;
    }
    bool const by_word = found.empty() && !counts && !word.empty();
    found = counts ? "counts" : by_word ? std::string(word) : found;
    if (found.empty()) {
        return false;
    }
    bool const beside = (holds(lower, "accel") || holds_word(lower, "acc")) && quantity != Quantity::spectrum;
    if (plainly_other_.empty() && !beside && quantity != Quantity::other && is_of_known_words(lower)) {
        plainly_other_ = found;
        plainly_other_line_ = number;
    }
    // "acceleration, velocity in cm/s" speaks of several; "unit: cm/s" of the numbers.
    bool const of_several = by_word || holds(lower, "veloc") || holds(lower, "displ");
    if (other_line_ == 0 || (other_of_several_ && !of_several)) {
        other_line_ = number;
        other_ = found;
        other_of_several_ = of_several;
        other_unit_ = !counts && !of_several && (!is_provenance(lower) || a_part_has_other_unit(line));
        other_text_ = fmt::format("line {}: {}", number, in_quotes(trimmed(line)));
    }
    return true;
}

// "station ABC, units: m/s"
bool TextStatements::a_part_has_other_unit(Text line) const {
    auto const parts = parts_of(line);
    return parts.size() > 1 && std::ranges::any_of(parts, [&](Text part) {
               TextStatements alone(of_);
               auto const lower = lowered(part);
               return !is_provenance(lower) && alone.take_other_quantity(part, lower, 1) && alone.other_unit_;
           });
}

// Is there a word that may change what the numbers are, and that nothing of the line accounts for?
bool TextStatements::tells_more(std::string const& lower, bool component, bool quantity, bool step) const {
    bool const other = of_ == Dimension::acceleration && !quantity && tells_other_quantity(lower);
    bool const hertz = !step && tells_rate(lower);
    bool const peak =
        of_ == Dimension::acceleration && (tells_peak(lower) || states_value(lower, of_)) && !peak_in(lower, of_);
    bool const change = of_ == Dimension::acceleration && tells_change(lower);
    return other || hertz || peak || change || tells_factor(lower) || tells_share(lower) || tells_statistic(lower)
           || tells_other_span(lower) || (!component && tells_vertical(lower));
}

// "in gal, Fs=200": is there a part between commas with a figure that nothing of it accounts for?
bool TextStatements::leaves_a_part(std::string const& lower) const {
    auto const found = parts_of(lower);
    return found.size() > 1 && std::ranges::any_of(found, [&](Text part) {
               TextStatements alone(of_);
               alone.take(part, 1);
               return holds_open_figure(part) && !alone.unread().empty();
           });
}

std::vector<std::string> TextStatements::unread() const {
    auto all = telling_;
    all.insert(all.end(), unread_.begin(), unread_.end());
    return all;
}

void TextStatements::take(std::span<TextLine const> lines, int names_line) {
    for (auto const& line : lines) {
        if (line.number != names_line) {
            take(line.text, line.number);
        }
    }
}

void TextStatements::take(std::string_view line, int number) {
    if (says_nothing(line)) {
        return;
    }
    auto const lower = lowered(line);
    bool understood = take_unit(lower, number);
    bool const other = take_other_quantity(line, lower, number);
    bool const component = take_components(line, lower, number);
    understood = understood || other || component;
    auto const times = of_ == Dimension::acceleration ? unit_of_times_in(lower) : std::nullopt;
    if (times) {
        time_unit_.take(*times, number);
        understood = true;
    }
    auto const step = step_in(lower);
    if (step) {
        step_.take(*step, number);
        understood = true;
    }
    if (auto const count = count_in(lower)) {
        count_.take(static_cast<double>(*count), number);
        understood = true;
    }
    bool const instrument = holds(lower, "accelero");  // -graph, -meter, -gram
    auto const quantity = quantity_in_prose(lower);    // "acceleration spectrum", "integrated accelerations"
    bool const of_others = quantity != Quantity::unknown && quantity != Quantity::acceleration;
    if ((holds(lower, "accel") && !instrument && !of_others) || holds_word(lower, "acc")
        || holds(lower, "\xE5\x8A\xA0\xE9\x80\x9F\xE5\xBA\xA6")) {
        accelerations_ = true;
        understood = true;
    }
    auto const quoted_line = fmt::format("line {}: {}", number, in_quotes(trimmed(line)));
    bool const of_unit = holds_word(lower, "unit") || holds_word(lower, "units");
    bool const left = understood ? leaves_a_part(lower) : of_unit;
    if (tells_more(times ? without(lower, "time in ") : lower, component, other, step.has_value()) || left
        || std::exchange(doubted_, false)) {
        telling_.push_back(quoted_line);
    } else if (!understood && !is_provenance(lower)) {
        unread_.push_back(quoted_line);
    }
}

std::vector<std::string> TextStatements::used() const {
    std::vector<std::string> lines;
    if (components_.size() == 1 && is_vertical(direction_of(components_.front()))) {
        lines.push_back(fmt::format("line {}: component {}", components_line_, components_.front()));
    }
    if (unit_.value) {
        lines.push_back(fmt::format("line {}: {}", unit_.line, name_of_unit(*unit_.value, of_)));
    }
    if (step_.value) {
        lines.push_back(fmt::format("line {}: {:.6g} s", step_.line, *step_.value));
    }
    if (time_unit_.value && *time_unit_.value != 1) {
        lines.push_back(fmt::format("line {}: times in {}", time_unit_.line, name_of_time_unit(*time_unit_.value)));
    }
    if (count_.value) {
        lines.push_back(fmt::format("line {}: {:.0f} samples", count_.line, *count_.value));
    }
    return lines;
}

std::string not_understood(std::span<std::string const> lines) {
    constexpr std::size_t most = 3;
    auto const shown = lines.first(std::min(lines.size(), most));
    return lines.empty() ? std::string()
                         : fmt::format(" (not understood: {}{})", fmt::join(shown, "; "),
                                       lines.size() > most ? fmt::format("; {} more", lines.size() - most) : "");
}

}  // namespace overturn
