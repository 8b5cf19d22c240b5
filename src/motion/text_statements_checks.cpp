#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/units.hpp"
#include "motion/column_unit.hpp"
#include "motion/detail/record_readers.hpp"
#include "motion/detail/statement_words.hpp"
#include "motion/text_statements.hpp"

namespace overturn {

std::optional<double> TextStatements::unit_beside(std::optional<double> named, std::optional<double> stated,
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
    auto const in_file = named ? named : unit_.value;
    if (differ(in_file, stated)) {
        throw InputError(named ? names : line,
                         fmt::format("unit {} in the file, {} stated (they contradict each other). {}",
                                     name_of_unit(*in_file, of_), name_of_unit(*stated, of_), advice));
    }
    return in_file ? in_file : stated;
}

void TextStatements::check(RecordRequest const& request) const {
    if (!plainly_other_.empty() && named_ && alone_) {
        throw InputError({request.name, plainly_other_line_},
                         fmt::format("{}, says the text, where names say accelerations (they contradict each "
                                     "other). Take the accelerations of the same record, or mend the text",
                                     plainly_other_));
    }
    bool const beside_accelerations = named_ || (accelerations_ && other_of_several_);
    bool const other = other_line_ > 0 && !beside_accelerations && (!unit_.value || spectrum_);
    if (unit_.value && !other) {
        check_stated_unit(request, *unit_.value, {request.name, unit_.line});
    } else if (other || (named_ && other_unit_ && !unit_.value)) {
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

void TextStatements::check_unit_of(std::string_view column, std::string const& file) const {
    if (of_ != Dimension::none && other_line_ > 0 && !other_of_several_ && !unit_.value) {
        throw InputError(
            {file, other_line_},
            fmt::format("a unit of {}, column '{}' (they contradict each other). Mend one of them", other_, column));
    }
}

void TextStatements::check_unit_is_known(std::string const& file) const {
    if (!unit_.value && !unknown_unit_.empty()) {
        throw InputError({file, unknown_unit_line_},
                         fmt::format("'{}' (no unit of {} that is known). Write {}, or leave it out and state the unit",
                                     unknown_unit_, name_of(of_),
                                     of_ == Dimension::acceleration ? "m/s2, gal or g" : si_symbol(of_)));
    }
}

void TextStatements::check_no_vertical(std::string const& file, std::string_view advice) const {
    if (vertical_line_ > 0 && components_.size() != 1) {
        throw InputError({file, vertical_line_}, fmt::format("{}. {}", vertical_text_, advice));
    }
}

void TextStatements::check_times(double step_s, std::string const& file) const {
    if (step_.value && !same_as_printed(step_s, *step_.value)) {
        throw InputError({file, step_.line},
                         fmt::format("time step {:.6g} s where the times rise by {:.6g} s (one of them is wrong). Mend "
                                     "the text or the times",
                                     *step_.value, step_s));
    }
}

void TextStatements::check_count(std::span<std::size_t const> counts, std::string const& file) const {
    if (!count_.value) {
        return;
    }
    auto const in_text = static_cast<std::size_t>(*count_.value);
    if (std::ranges::find(counts, in_text) == counts.end()) {
        throw InputError({file, count_.line},
                         fmt::format("{} samples stated, {} found (the file is cut short, or the text is another "
                                     "file's). Fetch the file anew, or mend the text",
                                     in_text, counts.front()));
    }
}

bool TextStatements::Peak::is_met_by(double found, double unit_of_numbers) const {
    constexpr double printed = 0.01;
    constexpr double most = 0.05;  // for a value that is cut off
    constexpr double rounded = 0.5, rounding = 1e-9;
    constexpr double nearly = 2;
    double const si = unit.value_or(unit_of_numbers);
    auto const meets = [&](double stated) {
        double const in_text = stated * si;
        double const allowed =
            std::max({printed * in_text, std::min(digit * si, most * in_text), rounded * digit * si * (1 + rounding)});
        bool const near = rough && found <= nearly * in_text && in_text <= nearly * found;
        return near || std::abs(found - in_text) <= allowed;
    };
    return meets(value) || std::ranges::any_of(beside, meets);
}

std::vector<std::string> TextStatements::check_peaks(std::span<double const> peaks_mps2, double unit_mps2,
                                                     std::string const& file, bool whole) const {
    std::vector<std::string> unmet;
    constexpr double printed = 0.01;
    constexpr std::array confused{9.80665, 980.665, 100.0, 1000.0, 9806.65};
    for (auto const& peak : peaks_) {
        double const in_text = peak.value * peak.unit.value_or(unit_mps2);
        auto const off_by = [&](double factor) {
            return std::ranges::any_of(
                peaks_mps2, [&](double found) { return std::abs(found * factor - in_text) <= printed * in_text; });
        };
        if (std::ranges::any_of(peaks_mps2, [&](double found) { return peak.is_met_by(found, unit_mps2); })) {
            continue;
        }
        double const most = std::ranges::max(peaks_mps2);
        for (double const factor : confused) {
            if (off_by(factor) || off_by(1 / factor)) {
                throw InputError({file, peak.line},
                                 fmt::format("peak of {:.6g} m/s2 stated, {:.6g} m/s2 found (a wrong unit, by a "
                                             "factor of {:g}). State the right unit",
                                             in_text, most, factor));
            }
        }
        if (whole && !peak.other) {
            throw InputError({file, peak.line},
                             fmt::format("peak of {:.6g} m/s2 stated, {:.6g} m/s2 found (they contradict each other: a "
                                         "wrong unit, a part of the record, or another one). Mend the line, or fetch "
                                         "the file anew",
                                         in_text, most));
        }
        unmet.push_back(
            fmt::format("line {}: a peak of {:.4g} m/s2, the numbers have {:.4g} m/s2", peak.line, in_text, most));
    }
    return unmet;
}

}  // namespace overturn
