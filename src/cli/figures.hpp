/// What the verbs know, as figures.
#pragma once

#include <optional>
#include <string>

#include "campaign/campaign_spec.hpp"
#include "cli/scene_files.hpp"
#include "generators/wave_source.hpp"
#include "report/wave_figure.hpp"

namespace overturn::cli {

/// A wave of a campaign with its target and the bodies at their central values.
[[nodiscard]] report::WaveFigure campaign_wave_figure(CampaignInput const& input, CampaignSpec const& spec,
                                                      GeneratedWave const& made);

/// Draws it. \throws as report::draw_wave
void draw_campaign_wave(CampaignInput const& input, CampaignSpec const& spec, GeneratedWave const& made,
                        std::string const& output);

/// Draws a record, with one body if given.
void draw_record(std::string const& name, PlacedRecord const& record, double damping,
                 std::optional<BodySpec> const& body, std::string const& output);

}  // namespace overturn::cli
