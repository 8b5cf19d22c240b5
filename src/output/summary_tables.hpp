/// Summaries of a body's trials, as tables: the criterion, responses, bodies together, waves, trials to inspect, checks
/// by hand, curves over two measures, annual frequencies, rare events.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "output/table.hpp"
#include "results/analysis.hpp"
#include "results/hand_check.hpp"
#include "results/hazard_frequency.hpp"
#include "results/rare_rows.hpp"
#include "results/telling_trials.hpp"
#include "results/together.hpp"

namespace overturn::output {

/// `criterion` of a body, a row per measure and unit of R.
[[nodiscard]] Table criterion_table(std::string const& body, std::span<MeasuredCriterion const> rows,
                                    double confidence);
/// `response` of a body: V_resp / V_Ereq by bins of V_WES / V_Ereq.
[[nodiscard]] Table response_table(std::string const& body, std::span<ResponseBin const> bins);
/// `limit_states` of a campaign.
[[nodiscard]] Table limit_table(CampaignSpec const& spec);
/// `sigma`: scatter of the waves beside what was stated of their targets. Without rows where no targets are drawn.
[[nodiscard]] Table sigma_table(std::optional<AchievedSigma> const& sigma);
/// `together` (any of the bodies, level by level) and `pairs` (correlation of two bodies).
[[nodiscard]] std::vector<Table> together_tables(CampaignSpec const& spec, std::span<BodiesTogether const> together,
                                                 double confidence);
/// `telling_trials`.
[[nodiscard]] Table telling_trial_table(CampaignSpec const& spec, std::span<TellingTrial const> trials);
/// `hand_check`.
[[nodiscard]] Table hand_check_table(CampaignSpec const& spec, std::span<HandCheck const> checks);
/// `two_measures`.
[[nodiscard]] Table two_measure_table(std::span<TwoMeasures const> fits, double confidence);
/// `frequency` and `frequency_parts`. \param units of intensities
[[nodiscard]] std::vector<Table> frequency_tables(std::string const& units, std::span<BodyFrequency const> frequencies,
                                                  HazardCurve const& hazard, double confidence);
/// `rare` and `rare_health` of one body and limit state.
[[nodiscard]] std::vector<Table> rare_tables(CampaignSpec const& spec, RareBody const& body);

}  // namespace overturn::output
