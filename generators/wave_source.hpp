/// Where waves come from: every source makes its n-th wave from (seed, n) alone.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "config/table.hpp"
#include "core/input_files.hpp"
#include "motion/ground_motion.hpp"

namespace overturn {

/// How computed/target psa is spread over periods in equal ratios; all 0 where there is nothing to compare.
struct MatchFigures {
    double mean_misfit = 0;          ///< mean |ratio - 1| [-]
    double max_misfit = 0;           ///< largest |ratio - 1| [-]
    double max_misfit_period_s = 0;  ///< where [s]
    double mean_ratio = 0;           ///< [-]
    double cov = 0;                  ///< standard deviation of the ratio over its mean [-]
    double below_fraction = 0;       ///< share of periods where the wave stays below its target [-]
};

/// The match of a finished wave, after every correction.
struct MatchReport {
    bool matched = false;      ///< iterated, and the tolerance was reached
    int iterations = 0;        ///< spectra computed after the first draw
    MatchFigures all;          ///< from two time steps or 0.02 s to the longest matched period
    MatchFigures long_period;  ///< the part of it within 1 s to 10 s
};

struct GeneratedWave {
    GroundMotion motion;
    MatchReport match;           ///< of the horizontal component
    MatchReport vertical_match;  ///< of the vertical one
    std::string label;           ///< one line that tells this wave from its neighbours
};

/// A source of numbered waves. make is pure: the same wave alone or in a crowd, from any thread.
class WaveSource {
  public:
    WaveSource() = default;
    WaveSource(WaveSource const&) = delete;
    WaveSource& operator=(WaveSource const&) = delete;
    WaveSource(WaveSource&&) = delete;
    WaveSource& operator=(WaveSource&&) = delete;
    virtual ~WaveSource() = default;

    /// \throws InputError if `wave` is not below available().
    [[nodiscard]] virtual GeneratedWave make(std::uint64_t seed, std::uint64_t wave) const = 0;
    /// How many different waves there are; nothing if as many as one likes.
    [[nodiscard]] virtual std::optional<std::uint64_t> available() const { return std::nullopt; }
    /// One line on what it makes.
    [[nodiscard]] virtual std::string describe() const = 0;
};

/// What makes a source from the [waves] table. It reads its own keys and finishes its own child tables; finishing
/// [waves] is its caller's.
using WaveSourceMaker = std::unique_ptr<WaveSource> (*)(config::Table const& waves, InputFiles& files);

[[nodiscard]] std::span<config::Entry<WaveSourceMaker> const> wave_sources();

/// The source that `waves.source` names. \throws InputError at the key concerned.
[[nodiscard]] std::unique_ptr<WaveSource> make_wave_source(config::Table const& waves, InputFiles& files);

/// \throws InputError unless wave < available.
void validate_wave(std::uint64_t wave, std::uint64_t available);

}  // namespace overturn
