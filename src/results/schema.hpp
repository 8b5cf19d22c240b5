/// Where the rows of a campaign stand in its results file.
#pragma once

#include <vector>

#include "campaign/campaign_spec.hpp"
#include "campaign/rows.hpp"
#include "store/results_file.hpp"

namespace overturn {

/// /trials: amplitudes in the unit of the levels' measure, bodies by name.
[[nodiscard]] store::TableSpec trial_table(CampaignSpec const& spec);
[[nodiscard]] store::TableSpec wave_table(CampaignSpec const& spec);
/// /waves/<body>: the energy measures for the body of that number; those with R in the other unit where asked for.
[[nodiscard]] store::TableSpec measure_table(CampaignSpec const& spec, std::size_t body);
/// The column of /stripes/<body> that counts a verdict: "contact_lost".
[[nodiscard]] std::string column_of(VerdictEntry const& verdict);
/// /trials/<model>: what models that may run here have to say beyond a row of /trials, as columns of a trial's record.
[[nodiscard]] std::vector<store::TableSpec> own_tables(Ladder const& ladder);

}  // namespace overturn
