/// Hazard curves and uniform hazard spectra as the OpenQuake engine exports them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace overturn {

/// A hazard curve of an export, and remarks on it.
struct OpenQuakeHazard {
    /// The curve as two columns, "sa(1 s) [g], annual_exceedance": the frequency of a Poisson process, -ln(1 - poe) /
    /// t, where poe is the probability of exceedance in the investigation time t that the first line states. Levels of
    /// certainty (poe 1) or of none (0) are left out.
    std::string table;
    std::vector<std::string> remarks;
};

/// Nothing if the content has no columns of probabilities below a first line.
/// \throws InputError naming `name` if it holds several sites, states no time or measure, or rises
[[nodiscard]] std::optional<OpenQuakeHazard> hazard_of_openquake(std::string_view content, std::string const& name);

/// A uniform hazard spectrum as a table "T (s),Sa (g)", its PGA at period 0. Nothing if the content is no such export.
/// \throws InputError naming `name` if it holds several sites or several probabilities of exceedance
[[nodiscard]] std::optional<std::string> uniform_hazard_of_openquake(std::string_view content, std::string const& name);

}  // namespace overturn
