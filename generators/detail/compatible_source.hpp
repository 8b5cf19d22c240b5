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

/// What the campaign says about all components alike.
struct CompatibleRequest {
    SpectrumMatcherInput input;
    Match match = Match::each;
    Acceptance acceptance = {};
    std::optional<TargetVariability> variability = {};
    std::vector<GroundMotion> seeds = {};
    std::vector<std::string> seed_labels = {};
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
    [[nodiscard]] std::optional<std::uint64_t> available() const override {
        return seeds_.empty() ? std::nullopt : std::optional<std::uint64_t>(seeds_.size());
    }
    [[nodiscard]] GroundMotion const* began_with(std::uint64_t wave) const override {
        return wave < seeds_.size() ? &seeds_[wave] : nullptr;
    }
    [[nodiscard]] std::string describe() const override { return summary_; }
    [[nodiscard]] std::string variability() const override;
    [[nodiscard]] bool draws_targets() const override { return variability_.has_value(); }
    [[nodiscard]] bool draws_events() const override { return variability_ && variability_->parted(); }
    [[nodiscard]] std::optional<StatedSigma> stated_sigma() const override;
    /// By some draws, or by the seeds: does what is slower than the wave is meant to be rule the displacement?
    [[nodiscard]] std::string pgd_drift() const override;
    [[nodiscard]] bool of_one_spectrum() const override { return !variability_; }
    [[nodiscard]] std::uint64_t waves_alike() const override {
        return variability_ ? variability_->input().per_target * variability_->input().targets_per_event : 1;
    }
    [[nodiscard]] Acceptance acceptance() const override { return acceptance_; }
    /// What lies beyond the target's own first and last period is compared with nothing that anybody stated.
    [[nodiscard]] std::optional<ComparedPeriods> compared_periods() const override {
        return ComparedPeriods{stated_from_s_, std::min(parts_.front().input.longest_s, stated_to_s_)};
    }

  private:
    using Judging = SpectrumMatcher::Judging;

    struct Part {
        ComponentKind kind;
        SpectrumMatcherInput input;
        SpectrumMatcher matcher;
        std::optional<double> correlation;  // stated, with the horizontal one
        double of_horizontal;               // ratio of the targets
        double defined_to_s;                // how far a rule asks for the target
    };

    void add(ComponentKind const& kind, SpectrumMatcherInput const& input, std::optional<double> correlation,
             double of_horizontal);
    void summarise(SpectrumMatcherInput const& input);
    [[nodiscard]] GeneratedWave make(std::uint64_t seed, std::uint64_t wave, Judging judging) const;
    [[nodiscard]] static SpectrumMatcher::Component drawn(Part const& part, SpectrumMatcher const& matcher,
                                                          GroundMotion const& before, std::uint64_t seed,
                                                          std::uint64_t wave, Judging judging);
    [[nodiscard]] static SpectrumMatcher::Component mixed(Part const& part, SpectrumMatcher const& matcher,
                                                          std::vector<double> const& horizontal, std::uint64_t seed,
                                                          std::uint64_t wave);
    void add_clauses(Part const& part, MatchReport const& match, std::vector<Clause>& clauses) const;

    AcceptanceRule rule_;
    Acceptance acceptance_;
    Match match_;
    double time_step_s_;
    std::optional<TargetVariability> variability_;
    std::vector<GroundMotion> seeds_;
    std::vector<std::string> seed_labels_;
    std::vector<Part> parts_;
    double stated_from_s_, stated_to_s_;
    std::string summary_;
};

}  // namespace overturn
