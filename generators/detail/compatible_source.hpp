/// The source behind make_spectrum_compatible, once its keys are read.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "generators/detail/components.hpp"
#include "generators/detail/spectrum_matcher.hpp"
#include "generators/detail/target_variability.hpp"
#include "generators/wave_source.hpp"

namespace overturn {

enum class Match { each, ensemble, none };

/// A component, and where its match goes.
struct ComponentKind : FurtherComponent {
    MatchReport GeneratedWave::*match;
};
inline constexpr ComponentKind horizontal_kind{{"horizontal", &GroundMotion::horizontal_mps2, 0},
                                               &GeneratedWave::match};
inline constexpr std::array further_kinds{ComponentKind{further_components[0], &GeneratedWave::transverse_match},
                                          ComponentKind{further_components[1], &GeneratedWave::vertical_match}};

/// A component beside the horizontal one, as its table says.
struct FurtherTarget {
    ComponentKind kind;
    TargetSpectrum target;
    std::optional<double> correlation;
};

/// Settings that are common to all components.
struct CompatibleRequest {
    SpectrumMatcherInput input;
    Match match = Match::each;
    Acceptance acceptance = {};
    std::optional<TargetVariability> variability = {};
    std::vector<GroundMotion> seeds = {};
    std::vector<std::string> seed_labels = {};
    SharedDraws seeds_shared = {};  ///< seeds that are components of one recording
};

class SpectrumCompatible : public WaveSource {
  public:
    SpectrumCompatible(CompatibleRequest request, std::vector<FurtherTarget> const& further);

    [[nodiscard]] GeneratedWave make(std::uint64_t seed, std::uint64_t wave) const override {
        return make(seed, wave, Judging::whole);
    }
    [[nodiscard]] GeneratedWave make_unjudged(std::uint64_t seed, std::uint64_t wave) const override {
        return make(seed, wave, Judging::least);
    }
    [[nodiscard]] std::unique_ptr<NormalWaves> from_normals() const override;
    /// By some draws, or by the seeds: does what is slower than the wave is meant to be rule the displacement?
    [[nodiscard]] std::string pgd_drift() const override;
    [[nodiscard]] std::string text() const override { return summary(Median::reached); }
    void prepare(ShareRows const& share) const override;

  private:
    using Judging = SpectrumMatcher::Judging;

    struct Part {
        ComponentKind kind;
        SpectrumMatcherInput input;
        SpectrumMatcher matcher;
        std::optional<double> correlation;  // stated, with the horizontal one
        double of_horizontal;               // ratio of the targets
        double defined_to_s;                // longest period of the target that a rule checks [s]
    };

    void add(ComponentKind const& kind, SpectrumMatcherInput const& input, std::optional<double> correlation,
             double of_horizontal);
    enum class Median { reached, not_yet };  // how it follows the target: known once that is calibrated
    [[nodiscard]] std::string summary(Median median) const;
    [[nodiscard]] std::string variability() const;
    [[nodiscard]] std::optional<StatedSigma> stated_sigma() const;
    [[nodiscard]] SharedDraws shared_of(SharedDraws const& seeds) const;
    [[nodiscard]] GeneratedWave make(std::uint64_t seed, std::uint64_t wave, Judging judging) const;
    [[nodiscard]] static SpectrumMatcher::Component drawn(Part const& part, SpectrumMatcher const& matcher,
                                                          GroundMotion const& before, std::uint64_t seed,
                                                          std::uint64_t wave, Judging judging);
    [[nodiscard]] static SpectrumMatcher::Component mixed(Part const& part, SpectrumMatcher const& matcher,
                                                          std::vector<double> const& horizontal, std::uint64_t seed,
                                                          std::uint64_t wave);
    void add_clauses(Part const& part, MatchReport const& match, std::vector<Clause>& clauses) const;

    AcceptanceRule rule_;
    std::string rule_name_;
    Match match_;
    double time_step_s_;
    std::optional<TargetVariability> variability_;
    std::vector<GroundMotion> seeds_;
    std::vector<std::string> seed_labels_;
    std::vector<Part> parts_;
};

}  // namespace overturn
