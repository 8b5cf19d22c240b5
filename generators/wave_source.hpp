/// Sources of waves: every source makes its n-th wave from (seed, n) alone.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "config/table.hpp"
#include "core/input_files.hpp"
#include "core/shared_draws.hpp"
#include "core/shared_rows.hpp"
#include "generators/acceptance.hpp"
#include "generators/drawn_target.hpp"
#include "generators/normal_waves.hpp"
#include "motion/drift.hpp"
#include "motion/ground_motion.hpp"

namespace overturn {

/// The match of a finished component, after every correction.
struct MatchReport {
    bool matched = false;        ///< iterated, and the tolerance and the rule's spectrum were met
    int iterations = 0;          ///< spectra computed after the first draw
    MatchFigures all;            ///< from two time steps or 0.02 s to the longest matched period
    MatchFigures long_period;    ///< the part of it within 1 s to 10 s
    double worst_decade = 0;     ///< worst_decade_misfit [-]
    double intensity_ratio = 0;  ///< spectral_intensity_ratio [-]
    /// Lowest power spectral density over the one that fits the target, both averaged over 20 % of frequency to either
    /// side, 0.3 Hz to 24 Hz as in SRP 3.7.1, appendix A [-]
    double psd_lowest_ratio = 0;
    double psd_lowest_hz = 0;  ///< where [Hz]
};

struct GeneratedWave {
    GroundMotion motion;
    MatchReport match;                 ///< of the horizontal component
    MatchReport transverse_match;      ///< of the other horizontal one
    MatchReport vertical_match;        ///< of the vertical one
    double turned_rad = 0;             ///< axes of the horizontal components, from those of the record [rad]
    std::optional<DrawnTarget> drawn;  ///< its own target, where targets vary
    std::string label;                 ///< one line that identifies this wave among its neighbours

    std::vector<double> judged_periods_s;  ///< of the horizontal component [s]; empty without a target
    std::vector<double> ratios;            ///< computed over target there
    AcceptanceRule rule;                   ///< rule that the source's waves must meet
    std::vector<Clause> clauses;           ///< of that rule, on the spectra of all components; empty without one
};

/// From which period to which a target says something [s].
struct ComparedPeriods {
    double from_s = 0, to_s = 0;
};

/// Standard deviation of ln Sa of the drawn targets, where waves are matched to them.
struct StatedSigma {
    ComparedPeriods matched;                    ///< shortest and longest period of the match
    std::function<double(double period_s)> at;  ///< of ln Sa at a period of the waves, as conditions leave it
};

/// A wave that was measured.
struct MeasuredWave {
    std::string name;  ///< its name in the campaign: its file
    Drift drift;       ///< residuals at its end
    /// Has it such a component? Of one that is withheld nobody knows: it may.
    bool transverse = false, vertical = false;
};

/// Facts of a source that are known before any wave is made.
struct WaveDescription {
    std::string text;  ///< one line on what it makes, but for what WaveSource::text adds
    /// How its input was read, where that is not plain; one line each.
    std::vector<std::string> remarks = {};
    std::string variability;  ///< cause of the differences of its waves, a line beside every curve from them
    std::optional<std::uint64_t> available = {};  ///< number of different waves; empty: unlimited
    /// Periods of a grid [s], for a source whose n-th wave is the grid's n-th point; empty for all others. Such waves
    /// are no random sample, so that shares of them are no probabilities.
    std::vector<double> grid_periods_s = {};
    Acceptance acceptance = {};  ///< the rule its waves must meet; without one any will do
    bool draws_targets = false;  ///< has every wave a target of its own (GeneratedWave::drawn)?
    bool draws_events = false;   ///< is stated what targets of one event share (DrawnTarget::epsilon_between)?
    /// Stated standard deviation, for a source whose waves are each matched to the Sa drawn for it and hold nothing
    /// else. Valid while the source lives.
    std::optional<StatedSigma> stated_sigma = {};
    /// Are all waves of one spectrum or density, matched to it or not, so that they differ by random phases alone?
    /// Their trials cannot show which measure of intensity is the better one among motions of several events and sites.
    bool of_one_spectrum = false;
    SharedDraws shared = {};  ///< waves that may share what was drawn, or are components of one recording
    /// The periods at which its waves are compared with what its target states; nothing if there is none.
    std::optional<ComparedPeriods> compared_periods = {};
    std::optional<TargetPga> target_pga = {};  ///< of the horizontal target, where it is known
    std::vector<MeasuredWave> measured = {};   ///< each wave, where they were measured
    /// The measured motion that the match of each wave began with, where one did; the source's own.
    std::span<GroundMotion const> began_with = {};
    std::span<std::string const> began_with_names = {};  ///< of these
};

/// A source of numbered waves. make is pure: the same wave alone or in a crowd, from any thread.
class WaveSource {
  public:
    WaveSource(WaveSource const&) = delete;
    WaveSource& operator=(WaveSource const&) = delete;
    WaveSource(WaveSource&&) = delete;
    WaveSource& operator=(WaveSource&&) = delete;
    virtual ~WaveSource() = default;

    [[nodiscard]] WaveDescription const& about() const { return about_; }
    /// One line on what it makes, with what has to be computed first, as `prepare` does.
    [[nodiscard]] virtual std::string text() const { return about_.text; }
    /// Does now what must be done once before the first wave, which else does it: dear where waves are matched in the
    /// median. \param share who does it; of many, all must call this
    virtual void prepare(ShareRows const& share) const { (void)share; }
    /// \throws InputError if `wave` is not below available.
    [[nodiscard]] virtual GeneratedWave make(std::uint64_t seed, std::uint64_t wave) const = 0;
    /// The motion that make gives, with only those figures that cost no time: no match for waves that are not iterated,
    /// the figures of the iteration for others.
    [[nodiscard]] virtual GeneratedWave make_unjudged(std::uint64_t seed, std::uint64_t wave) const {
        return make(seed, wave);
    }
    /// Its waves as a map of normals; null where they are not random. \pre the source outlives it
    [[nodiscard]] virtual std::unique_ptr<NormalWaves> from_normals() const { return nullptr; }
    /// Why PGD of its waves is no amplitude of the ground but what their baseline does; empty: it is one. Makes some
    /// waves to see.
    [[nodiscard]] virtual std::string pgd_drift() const { return {}; }

    /// Residuals at the end of a measured wave; empty for waves that were not measured. \throws InputError as make
    [[nodiscard]] std::optional<Drift> drift(std::uint64_t wave) const;
    /// The campaign's name of a measured wave; empty for all others. \throws InputError as make
    [[nodiscard]] std::string name(std::uint64_t wave) const;
    /// In messages: "record 'kobe.csv'", "wave 3". \throws InputError as make
    [[nodiscard]] std::string called(std::uint64_t wave) const;
    /// The measured motion that the match of a wave began with; null of all others.
    [[nodiscard]] GroundMotion const* began_with(std::uint64_t wave) const;

  protected:
    WaveSource() = default;
    explicit WaveSource(WaveDescription about) : about_(std::move(about)) {}
    /// For sources that know it only once they are made.
    void describe(WaveDescription about) { about_ = std::move(about); }

  private:
    WaveDescription about_;
};

/// Function that makes a source from the [waves] table. It reads its own keys and finishes its own child tables; its
/// caller finishes [waves].
using WaveSourceMaker = std::unique_ptr<WaveSource> (*)(config::Table const& waves, InputFiles& files);

/// A kind of source, and what [waves] may state of it.
struct WaveSourceKind {
    WaveSourceMaker make;
    config::KeyTable const* keys;
};
[[nodiscard]] std::span<config::Entry<WaveSourceKind> const> wave_sources();
/// The possible tables [waves]: one for each source.
[[nodiscard]] std::vector<config::KeyTable const*> wave_tables();

/// Keys of [waves] that every source has.
extern config::KeyTable const every_wave_table;
inline constexpr config::Key wave_count_key =
    config::integer_key("count", 1, 1'000'000'000, "number of waves")
        .otherwise_in_words("all available waves; required for generated ones");
/// Key `duration` of waves that are drawn.
inline constexpr config::Key wave_duration_key =
    config::number_key("duration", Dimension::time, config::Range::positive(), "length of every wave");

/// The source that `waves.source` names. \throws InputError at the key concerned.
[[nodiscard]] std::unique_ptr<WaveSource> make_wave_source(config::Table const& waves, InputFiles& files);

/// Samples of a wave of the table's `duration`, the first at 0 and the last at it. \throws InputError unless they are
/// 100 to 5 million.
[[nodiscard]] std::size_t read_samples(config::Table const& waves, double time_step_s);

/// \throws InputError unless wave < available.
void validate_wave(std::uint64_t wave, std::uint64_t available);

}  // namespace overturn
