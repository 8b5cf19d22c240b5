/// What a campaign may state and hardly means: said in one line each before any work, by plan, run, wave and report.
#pragma once

#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "campaign/trial.hpp"
#include "response/model_selector.hpp"

namespace overturn {

/// One line each, without "warning: ". Nothing here is an error: a study may want it.
[[nodiscard]] std::vector<std::string> warnings_of(CampaignSpec const& spec);

/// Waves that share what was drawn, and what that does to intervals; empty where none do.
[[nodiscard]] std::string warning_of_alike_waves(CampaignSpec const& spec);

/// Effects that the bodies call for under this wave at the highest level and that no model holds together, and what
/// stated effects leave out.
[[nodiscard]] std::vector<std::string> warnings_of_effects(CampaignSpec const& spec, PreparedWave const& wave,
                                                           ModelSelector const& selector);

/// What a body or its motion states and stated effects leave out: friction, base and pad, further components.
[[nodiscard]] std::vector<std::string> warnings_of_stated_effects(BodySpec const& body, GroundMotion const& motion,
                                                                  EffectRequest const& effects);

/// Of one body: sizes, mass and inertia that hardly belong together.
[[nodiscard]] std::vector<std::string> warnings_of(BodySpec const& body);

/// Of one motion: too few samples, too long a step.
[[nodiscard]] std::vector<std::string> warnings_of(GroundMotion const& motion);

/// Does a target that is compared over these periods leave some of a body's band without a word, at either end?
[[nodiscard]] bool ends_inside(ComparedPeriods const& judged, PeriodBand const& band);

/// How the first measured waves end, a line each: what of PGV and PGD is their baseline's. Empty without records.
[[nodiscard]] std::vector<std::string> ends_of_records(CampaignSpec const& spec);

}  // namespace overturn
