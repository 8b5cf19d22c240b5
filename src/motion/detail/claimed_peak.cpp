#include <algorithm>
#include <array>

#include "motion/column_unit.hpp"
#include "motion/detail/claim_words.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

struct PeakKey {
    Text text;
    bool with_unit = false;  ///< of anything, unless a unit of the numbers stands behind the value
};
// The longer ones first.
constexpr auto keys_of_peaks = std::to_array<PeakKey>({{"peak ground acceleration"},
                                                       {"maximum ground acceleration"},
                                                       {"peak ground acc"},
                                                       {"peak acceleration"},
                                                       {"peak accel"},
                                                       {"peak acc"},
                                                       {"maximum acceleration"},
                                                       {"maximum accel"},
                                                       {"maximum acc"},
                                                       {"max. acceleration"},
                                                       {"max acceleration"},
                                                       {"max. accel"},
                                                       {"max accel"},
                                                       {"max. acc"},
                                                       {"max acc"},
                                                       {"pga"},
                                                       {"peak value"},
                                                       {"maximum value", true},
                                                       {"peak", true},
                                                       {"maximum", true},
                                                       {"max", true},
                                                       {"amax", true}});

/// Behind the key's colon, or the blanks, brackets and words between it and a figure.
Text at_figure(Text behind) {
    auto const colon = behind.find_first_of(":=");
    if (colon != Text::npos) {
        return trimmed(behind.substr(colon + 1));
    }
    behind = trimmed(behind.substr(behind.starts_with('.') ? 1 : 0));
    if (behind.starts_with('(') || behind.starts_with('[')) {
        behind = trimmed(behind.substr(std::min(behind.find_first_of(")]"), behind.size() - 1) + 1));
    }
    for (Text const filling : {"of", "is", "was", "equals", "about", "approx.", "~"}) {
        behind = trimmed(behind.substr(behind.starts_with(filling) ? filling.size() : 0));
    }
    return behind;
}

/// What stands behind a value, without the brackets around it.
Text unit_behind(Text text) {
    text = trimmed(text);
    text = text.substr(text.starts_with('(') || text.starts_with('[') ? 1 : 0);
    auto unit = text.substr(0, text.find_first_of(" \t,;)]"));
    while (unit.ends_with('.')) {
        unit.remove_suffix(1);
    }
    return unit;
}

bool is_of_another(Text unit) {
    return unit_spelled(unit, Dimension::time) || unit_spelled(unit, Dimension::length)
           || unit_spelled(unit, Dimension::velocity) || unit_spelled(unit, Dimension::frequency);
}

}  // namespace

std::optional<ClaimedPeak> peak_in(std::string_view line, Dimension dimension) {
    for (auto const& key : keys_of_peaks) {
        if (!holds_word(line, key.text)) {
            continue;
        }
        auto behind = at_figure(line.substr(line.find(key.text) + key.text.size()));
        behind = behind.substr(behind.starts_with('-') || behind.starts_with('+') ? 1 : 0);
        auto const value = cut_number(behind);
        auto const text = unit_behind(behind);
        auto const unit = unit_spelled(text, dimension);
        if (value && (unit || (!key.with_unit && !is_of_another(text)))) {
            return ClaimedPeak{*value, unit};
        }
    }
    return std::nullopt;
}

bool tells_peak(std::string_view line) {
    return std::ranges::any_of(keys_of_peaks, [&](PeakKey const& key) {
        auto const at = line.find(key.text);
        return !key.with_unit && holds_word(line, key.text)
               && line.find_first_of("0123456789", at + key.text.size()) != Text::npos;
    });
}

}  // namespace overturn
