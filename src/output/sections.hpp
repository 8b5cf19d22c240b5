/// Printed results: the answer, and the sections that a user requests.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/rows.hpp"
#include "output/answer.hpp"
#include "results/hand_check.hpp"
#include "results/telling_trials.hpp"
#include "results/together.hpp"

namespace overturn::output {

/// All of them, in the order in which they are printed.
[[nodiscard]] std::vector<std::string_view> section_names();

/// The user's choice of sections.
struct TextOptions {
    std::vector<std::string> sections = {};        ///< names of them, beside the answer
    bool full = false;                             ///< all of them
    std::optional<IntensityUnit> velocities = {};  ///< in which velocities are printed; none: the levels' unit, or m/s

    /// Is it requested by name?
    [[nodiscard]] bool names(std::string_view section) const;
    /// Is it requested? Costly results that are printed nowhere else are computed only then.
    [[nodiscard]] bool wants(std::string_view section) const { return full || names(section); }
};
/// \throws InputError for a name that is no section's
[[nodiscard]] std::vector<std::string> read_sections(std::string const& text);

/// Data that can be printed, as text or JSON; all outlive it.
struct Printed {
    Answered answered;
    std::span<TrialRow const> few = {};          ///< trials_of_few_waves
    std::span<TellingTrial const> telling = {};  ///< where "trials" is wanted
    std::span<HandCheck const> by_hand = {};     ///< where "hand" is wanted
    std::span<TwoMeasures const> pairs = {};     ///< none: not asked for
    HazardCurve const* hazard = nullptr;         ///< null: no annual frequencies
    std::string notes = {};                      ///< further lines below the answer
    std::string file = {};                       ///< the results file, as the user names it
};

/// The answer, its remarks, and the requested sections.
[[nodiscard]] std::string results_text(Printed const& printed, TextOptions const& options);

}  // namespace overturn::output
