/// A campaign as the program understands it: validated, immutable, the same on every rank.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "campaign/body_spec.hpp"
#include "campaign/campaign_input.hpp"
#include "campaign/level_spec.hpp"
#include "campaign/limit_state.hpp"
#include "campaign/rare_spec.hpp"
#include "campaign/site.hpp"
#include "config/input_value.hpp"
#include "core/input_files.hpp"
#include "generators/wave_source.hpp"
#include "response/model_selector.hpp"
#include "spectra/window_energy.hpp"

namespace overturn {

/// Thresholds of movement: a body that stands has moved beyond them, whatever model ran. Elastic give of a pad is not
/// rocking, and creep of a base is no slip.
struct MovementSpec {
    double slip_m = 1e-3;  ///< largest slip of the base
    /// Largest rise of the edge of the base off the ground: its width times the sine of the tilt, without that by which
    /// a pad gives way before any of the base leaves it.
    double uplift_m = 1e-3;

    bool by_model = false;  ///< instead as each model has it, as in results files up to format 4

    /// Verdict of a trial that stands, by these thresholds; other verdicts stay.
    /// \param may_slip has it friction? Rolling or walking of a base that holds fast is no slip
    /// \param pad under it, where it ran on points
    /// \param peak_rise_m of the centre of gravity; NaN: not known. What rotation and springs do not explain of it was
    /// flight
    [[nodiscard]] Verdict verdict(Response const& response, RigidBody const& body, bool may_slip, Pad const& pad,
                                  double peak_rise_m = never) const;
};

/// Measures of every wave. The unit of R is an option because the original does not print it.
struct MeasureSpec {
    RadiusUnit radius_unit = RadiusUnit::centimetre;
    bool energy = true;              ///< V_WES and ouV_E of every wave and body
    bool wave_quality = true;        ///< match, durations, residuals and correlation of every wave
    bool both_radius_units = false;  ///< measure with the other unit too, to compare
    WindowReading window = WindowReading::restarted;
    double panel_phase_rad = WindowOptions{}.panel_phase_rad;
    /// Pseudo-acceleration at 5 % damping of every wave: at these periods [s], and its geometric mean over a band
    std::vector<double> sa_periods_s = {};
    std::optional<PeriodBand> sa_band = {};
    std::vector<Measure> curves = {};  ///< over which there are curves too
    MovementSpec movement = {};
};

/// Text on the cover of a page beside the title; empty: not stated.
struct CoverText {
    std::string question, prepared, checked, approved, revision;
};

struct CampaignSpec {
    std::string title;
    CoverText cover;
    std::uint64_t seed = 0;
    std::int64_t wave_count = 0;  ///< shared, or per level
    std::unique_ptr<WaveSource> source;
    std::vector<BodySpec> bodies;
    Sampling sampling = Sampling::independent;  ///< of what scatters about the bodies
    LevelSpec levels;
    EffectRequest effects;
    Accuracy accuracy;
    MeasureSpec measures;
    std::optional<RareSpec> rare;  ///< of every body and level, beside the trials
    double confidence = 0.95;
    double beta_u = 0;                       ///< of the curves, beside what is sampled; 0: not stated
    Site site;                               ///< surroundings of every body
    std::vector<LimitState> limits;          ///< overturning, those of the site, then those of [[limits]]
    std::vector<config::InputValue> inputs;  ///< every value that was read, and where it comes from

    /// Does the campaign end before all waves are done where it is precise enough?
    [[nodiscard]] bool has_target() const;
    /// The periods of the waves where these are points of a grid, so that no share of them is a probability; else none.
    [[nodiscard]] std::vector<double> grid_periods_s() const;
    [[nodiscard]] bool is_grid() const { return !grid_periods_s().empty(); }
};

/// \throws InputError naming file, line and column for anything wrong
[[nodiscard]] CampaignSpec parse_campaign(CampaignInput const& input, InputFiles& files);
/// All that a campaign may state: its keys and the tables in it.
extern config::KeyTable const campaign_table;
/// Levels by a PGV or PGD that is drift are no levels of a campaign to be run; a file of results that has them from
/// before that was known is still read. \throws InputError at the key
void refuse_drifting_levels(CampaignInput const& input, CampaignSpec const& spec);
/// From the input's own files alone.
[[nodiscard]] CampaignSpec parse_campaign(CampaignInput const& input);

}  // namespace overturn
