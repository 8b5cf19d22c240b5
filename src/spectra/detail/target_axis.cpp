#include "spectra/detail/target_axis.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/units.hpp"
#include "motion/column_unit.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

/// What a label of few words says of an axis.
struct AxisWords {
    bool frequency = false, period = false;
    std::optional<double> hertz, seconds;  ///< SI value of a unit beside it
};

bool begins_so(Text word, std::initializer_list<Text> stems) {
    return std::ranges::any_of(stems, [&](Text stem) { return word.starts_with(stem); });
}

/// Of a corner, of exceedance, a return period: none of the axis.
bool is_of_others(Text word) {
    return begins_so(word, {"return", "annual", "exceed", "corner", "sampl", "filter", "year", "yr", "poe", "natural",
                            "fundamental", "band", "range", "from", "to", "damp", "high", "low"});
}

AxisWords words_in(Text lower) {
    constexpr std::size_t label = 7;
    auto const words = parted_at(lower, " \t:=()[]{},;#!%*\"'/");
    if (words.size() > label || std::ranges::any_of(words, is_of_others)) {
        return {};
    }
    AxisWords axis;
    for (auto const word : words) {
        axis.frequency = axis.frequency || word == "f" || begins_so(word, {"freq", "fr\xC3\xA9q", "frec"});
        axis.period = axis.period || word == "t" || begins_so(word, {"perio", "p\xC3\xA9rio"});
        if (auto const hertz = unit_spelled(word, Dimension::frequency)) {
            axis.hertz = hertz;
        } else if (auto const seconds = unit_spelled(word, Dimension::time); seconds && word != "t") {
            axis.seconds = seconds;
        }
    }
    return axis;
}

[[noreturn]] void contradict(TextLine const& line, std::string_view what, std::string const& file) {
    throw InputError({file, line.number},
                     fmt::format("{}, where the first column is of {} (they contradict each other). Name it T (s), T "
                                 "(ms) or f (Hz), or mend the text",
                                 in_quotes(trimmed(line.text)), what));
}

}  // namespace

void check_axis_text(PairTable const& table, bool frequencies, double period_unit_s, std::string const& file) {
    for (auto const& line : table.text) {
        auto const axis = words_in(lowered(line.text));
        if (axis.frequency == axis.period) {
            continue;  // neither, or both: "frequency or period"
        }
        if (axis.frequency && !frequencies) {
            contradict(line, "periods", file);
        }
        if (axis.period && frequencies && !axis.hertz) {
            contradict(line, "frequencies", file);
        }
        if (axis.period && !frequencies && axis.seconds && *axis.seconds != period_unit_s) {
            contradict(line, "periods in another unit", file);
        }
    }
}

}  // namespace overturn
