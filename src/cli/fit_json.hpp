/// The statistics as JSON, by the names that scripts depend on. What is not known is null, never 0.
#pragma once

#include <optional>

#include <nlohmann/json_fwd.hpp>

#include "results/analysis.hpp"
#include "results/statistics.hpp"
#include "results/telling_trials.hpp"

namespace overturn::cli {

/// What --beta-u and --confidence (none: the campaign's) may be. \throws InputError
void check_fit_options(double beta_u, std::optional<double> confidence);

/// In which units the sentences of `warnings` are: all numbers beside them are SI, a page tells them as levels are
/// written.
enum class WarningUnits { si, as_written };

/// One stripe; \param body empty for a table that is nobody's campaign \param limit name of the limit state
[[nodiscard]] nlohmann::ordered_json stripe_json(std::string const& body, std::size_t level, Stripe const& stripe,
                                                 double confidence, std::string const& limit = overturning_limit);
[[nodiscard]] nlohmann::ordered_json fragility_json(std::string const& body, MeasuredFragility const& measured,
                                                    double confidence, WarningUnits units = WarningUnits::si);
[[nodiscard]] nlohmann::ordered_json criterion_json(std::string const& body, MeasuredCriterion const& criterion);
/// V_resp / V_Ereq of the trials that V_WES / V_Ereq puts into this bin.
[[nodiscard]] nlohmann::ordered_json response_json(std::string const& body, ResponseBin const& bin);
[[nodiscard]] nlohmann::ordered_json verdict_json(std::string const& body, CriterionVerdict const& verdict);

/// A response of a body at one level.
[[nodiscard]] nlohmann::ordered_json quantiles_json(std::string const& body, LevelQuantiles const& at);

/// The trials worth a look, as `telling_trials` stands in the answer.
[[nodiscard]] nlohmann::ordered_json telling_json(CampaignSpec const& spec, std::vector<TellingTrial> const& trials);

/// All of them: limits, stripes, fragility, grid (of waves that are one: a line per body and wave), quantiles,
/// criterion, response, verdict. Stripes and fragility begin with those of overturning.
[[nodiscard]] nlohmann::ordered_json fit_json(CampaignSpec const& spec, Statistics const& statistics,
                                              std::vector<BodyAnalysis> const& analysis, double confidence,
                                              WarningUnits units = WarningUnits::si);

}  // namespace overturn::cli
