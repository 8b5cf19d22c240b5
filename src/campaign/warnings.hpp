/// Warnings about possible but unlikely input, a line each before any work, by plan, run, wave and report.
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
[[nodiscard]] std::string warning_of_shared_draws(CampaignSpec const& spec);

/// Effects that the bodies call for under this wave at the highest level and that no model holds together, and what
/// stated effects leave out.
[[nodiscard]] std::vector<std::string> warnings_of_effects(CampaignSpec const& spec, PreparedWave const& wave,
                                                           ModelSelector const& selector);

/// Properties of a body or its motion that the stated effects or the models ignore: friction, base and pad, further
/// components.
[[nodiscard]] std::vector<std::string> warnings_of_stated_effects(BodySpec const& body, GroundMotion const& motion,
                                                                  EffectRequest const& effects);

/// Warnings about one body: sizes, mass and inertia that hardly belong together, parts that would move on each other
/// first.
[[nodiscard]] std::vector<std::string> warnings_of(BodySpec const& body);

/// Warnings about one motion: too few samples, too long a step.
[[nodiscard]] std::vector<std::string> warnings_of(GroundMotion const& motion);

/// Does a target that is compared over these periods leave some of a body's band without a word, at either end?
[[nodiscard]] bool ends_inside(ComparedPeriods const& judged, PeriodBand const& band);

/// Residuals of the first measured waves, a line each: the part of PGV and PGD that comes from their baseline. Empty
/// without records.
[[nodiscard]] std::vector<std::string> ends_of_records(CampaignSpec const& spec);

}  // namespace overturn
