/// Hazard curves as tables of two columns: what is exceeded, and how often in a year.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "campaign/campaign_input.hpp"
#include "campaign/level_spec.hpp"
#include "core/units.hpp"
#include "stats/hazard.hpp"
#include "stats/intensity_unit.hpp"

namespace overturn {

/// The intensities that a hazard curve is joined with, and what they are called.
struct HazardAxis {
    std::string label;  ///< "pga", "sa(1.9 s)"; empty: whatever the hazard curve is over
    Dimension dimension = Dimension::none;
    IntensityUnit unit;              ///< as the user wrote them
    double lowest = 0, highest = 0;  ///< that were tried [SI]; both 0: a stated curve, which was not tried anywhere
    std::string column = {};         ///< "IM [g]", where the levels are a table's column that names no measure
};
[[nodiscard]] HazardAxis hazard_axis(LevelSpec const& levels);

/// A table of two columns under a line of names, "pga [gal], annual_exceedance": the levels' own measure with its unit,
/// and the mean number of exceedances in a year (or MAFE, "annual rate of exceedance" and their likes); or an export of
/// OpenQuake. `#` begins a comment. A first row of no motion and last rows of no exceedance are left out, with a
/// remark. \throws InputError with `name:line` at what is none, is of another measure, or of one that the table's
/// column does not name, states no unit of it, speaks of a time of investigation or a probability in so many years,
/// does not rise and fall as a hazard curve does, or has no intensity in common with those that were tried
[[nodiscard]] HazardCurve parse_hazard(std::string_view content, std::string const& name, HazardAxis const& axis);
[[nodiscard]] inline HazardCurve parse_hazard(std::string_view content, std::string const& name,
                                              LevelSpec const& levels) {
    return parse_hazard(content, name, hazard_axis(levels));
}

/// The hazard curve that the campaign states; none: it states none. \throws InputError as parse_hazard
[[nodiscard]] std::optional<HazardCurve> stated_hazard(CampaignInput const& input, LevelSpec const& levels);

/// An intensity in the unit that the hazard curve states.
[[nodiscard]] std::string hazard_text(HazardCurve const& hazard, double intensity);

}  // namespace overturn
