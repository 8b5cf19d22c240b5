/// Tables of a campaign's rows in its results file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "campaign/rows.hpp"
#include "store/results_file.hpp"

namespace overturn {

/// Group of a table of one body: "stripes/type-a", and for a limit state other than overturning
/// "limits/touches/stripes/type-a".
[[nodiscard]] std::string group_of(std::string const& table, std::string const& body, std::string const& limit);

/// /trials: amplitudes in the unit of the levels' measure, bodies by name.
[[nodiscard]] store::TableSpec trial_table(CampaignSpec const& spec);
[[nodiscard]] store::TableSpec wave_table(CampaignSpec const& spec);
/// /refused_waves: those that missed waves.acceptance, with the columns of /waves. They are no trials.
[[nodiscard]] store::TableSpec refused_wave_table(CampaignSpec const& spec);
/// /waves/<body>: the energy measures for the body of that number; those with R in the other unit where requested.
[[nodiscard]] store::TableSpec measure_table(CampaignSpec const& spec, std::size_t body);
/// Those of all bodies, in their order.
[[nodiscard]] std::vector<store::TableSpec> measure_tables(CampaignSpec const& spec);
/// The column of /stripes/<body> that counts a verdict, "contact-lost": "contact_lost".
[[nodiscard]] std::string column_of(std::string_view verdict);
/// /trials/<model>: what models that may run here have to say beyond a row of /trials, as columns of a trial's record.
[[nodiscard]] std::vector<store::TableSpec> extra_tables(ModelSelector const& selector);

}  // namespace overturn
