/// Figures of campaigns and records that the verbs draw.
#pragma once

#include <optional>
#include <string>

#include "campaign/campaign_spec.hpp"
#include "cli/scene_files.hpp"
#include "cli/velocity_unit.hpp"
#include "generators/wave_source.hpp"
#include "report/wave_figure.hpp"

namespace overturn::cli {

/// The target that the campaign states; nothing of sources without one.
[[nodiscard]] std::optional<TargetSpectrum> target_of(CampaignInput const& input);

/// A wave of a campaign with its target and the bodies at their central values.
[[nodiscard]] report::WaveFigure campaign_wave_figure(CampaignInput const& input, CampaignSpec const& spec,
                                                      GeneratedWave const& made);

/// Draws it. \throws as report::draw_wave
void draw_campaign_wave(CampaignInput const& input, CampaignSpec const& spec, GeneratedWave const& made,
                        output::ShownVelocity const& unit, std::string const& output);

/// Draws a record, with one body if given.
void draw_record(std::string const& name, PlacedRecord const& record, double damping,
                 std::optional<BodySpec> const& body, output::ShownVelocity const& unit, std::string const& output);

}  // namespace overturn::cli
