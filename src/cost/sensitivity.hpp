/// Sensitivity to assumed numbers: each is moved to both ends of its range alone, under the same waves.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "cost/study.hpp"
#include "output/table.hpp"
#include "stats/proportion.hpp"

namespace overturn::cost {

/// Relative change of a number that states no range [-].
inline constexpr double usual_share = 0.1;

/// An assumed number, a word with a range of numbers, or a friction coefficient near tan(alpha), and where it was moved
/// to.
struct VariedInput {
    std::vector<std::string> keys;  ///< several where bodies share a file
    std::string value, source;
    std::array<std::string, 2> ends;     ///< as they would be written
    std::array<std::string, 2> refused;  ///< why a campaign with that end cannot be; empty: it was run
    bool range_stated = false;
};

/// An assumed input that was not moved.
struct UnvariedInput {
    std::string key, value, why;
};

/// Trials of one limit state of one body at all levels, or at one of them.
struct Counts {
    std::int64_t decided = 0, passed = 0;
    [[nodiscard]] std::optional<double> share() const;
};

/// A campaign with one input moved against the same waves without.
struct Shift {
    std::int64_t compared = 0;               ///< trials that both decide, at levels that both have
    std::int64_t passed = 0, no_longer = 0;  ///< of them: newly passed, no longer passed
    /// Moved or not, at most one level has both outcomes: each median lies somewhere between two levels.
    bool levels_too_coarse = false;
    std::optional<double> median_ratio;  ///< moved over unmoved; none: coarse levels, or too few waves identify both
    std::optional<Interval> median_interval;  ///< of it, by resampled waves, the same for both; likewise
    Counts at_design_basis;
    std::int64_t design_passed = 0, design_no_longer = 0;  ///< waves by which that P differs
    /// Chance of so uneven a split of these (McNemar 1947, exact); 1 where none differs.
    double design_p_value = 1;

    [[nodiscard]] std::int64_t flips() const { return passed + no_longer; }
    /// Is the change of the median more than resampled waves make of nothing?
    [[nodiscard]] bool resolved() const;
};

/// One input and one limit state of one body.
struct SensitivityRow {
    std::size_t input = 0, body = 0, limit = 0;
    std::array<std::optional<Shift>, 2> ends;  ///< nothing where the end was refused
};

/// A body and a limit state as the campaign stands.
struct Unmoved {
    std::size_t body = 0, limit = 0;
    Counts all, at_design_basis;
    bool levels_too_coarse = false;  ///< at most one level has both outcomes: no median
    std::optional<double> median;
};

struct Sensitivity {
    std::string title, measure, units;
    std::vector<std::string> bodies, limits;
    std::int64_t waves = 0, campaign_waves = 0;
    double confidence = 0;
    std::optional<double> design_basis;  ///< [SI]
    double shown_si = 1;                 ///< SI value of one of `shown_units`
    std::string shown_units;
    std::vector<VariedInput> inputs;
    std::vector<UnvariedInput> unvaried;
    std::vector<Unmoved> unmoved;
    std::vector<SensitivityRow> rows;  ///< by body and limit, what moves the median most first
};

/// Waves of the campaign that are used unless stated: enough to see a few per cent of the median.
inline constexpr std::int64_t usual_waves = 200;

/// Pure: the same whenever and wherever it is run. \param waves at most so many, spread over the campaign; 0:
/// usual_waves \param tell receives the share that is done and the seconds that are probably left \throws InputError
/// where waves are a grid, which is no sample
[[nodiscard]] Sensitivity study_sensitivity(CampaignInput const& input, std::int64_t waves, Tell const& tell);

/// The campaign with the value of an input replaced by `written` where it stands. \pre its place is known
[[nodiscard]] CampaignInput with_value(CampaignInput const& input, config::InputValue const& value,
                                       std::string const& written);

/// "median of type-b by overturning, ..." for the terminal, one list a body and limit state.
[[nodiscard]] std::string sensitivity_text(Sensitivity const& study);
/// The study in one row, bodies and limit states as they stand, what each end of each input changes (two rows an
/// input, low and high), and what was not moved. They lie in no file.
[[nodiscard]] std::vector<output::Table> sensitivity_tables(Sensitivity const& study);

}  // namespace overturn::cost
