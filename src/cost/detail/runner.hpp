/// The steps of a study, each of them short, so that the time left can be estimated.
#pragma once

#include <functional>
#include <map>
#include <vector>

#include "cost/study.hpp"

namespace overturn::cost {

/// Waves that a step's time grows with: all of the sample, or the few that are enough for the knobs that act on waves.
enum class Extent { all, few };

/// Waves for the knobs that act on waves: one is much like another.
inline constexpr std::int64_t most_wave_units = 8;

/// Steps before the knobs (the sample, its references) and after them (the number of waves, the conclusions).
inline constexpr std::size_t steps_before = 2;
inline constexpr std::size_t steps_after = 2;

class Runner {
  public:
    /// \param waves of the sample \param rounds over all settings, of which the best time counts \param timing_s see
    /// StudyOptions
    Runner(CampaignInput const& input, std::int64_t waves, int rounds, double timing_s);
    Runner(Runner const&) = delete;
    Runner& operator=(Runner const&) = delete;
    Runner(Runner&&) = delete;
    Runner& operator=(Runner&&) = delete;
    ~Runner() = default;

    [[nodiscard]] std::size_t steps() const { return steps_.size(); }

    /// \param done called after each step with its extent and wall seconds
    [[nodiscard]] Study run(std::function<void(Extent, double)> const& done);

  private:
    struct Step {
        Extent extent;
        std::function<void()> action;
    };

    void list_steps(int rounds);
    void make_sample();
    void run_references();
    [[nodiscard]] Run run_setting(Knob const& knob, Setting const& setting, CampaignSpec const& variant,
                                  Depth depth) const;
    void measure(KnobResult& result, std::size_t s, bool first);
    void judge(KnobResult& result, std::size_t s, Run const& run);
    static void take_verdicts(Measured& row, Knob const& knob, std::vector<TrialRow> const& rows,
                              std::vector<TrialRow> const& exact);
    void count_criterion_flips(Measured& row, std::vector<double> const& values, std::vector<double> const& exact);
    void share_own_times();
    void conclude();

    CampaignInput const& input_;
    double timing_s_;
    CampaignSpec spec_;
    Plan plan_;
    std::vector<std::int64_t> numbers_;
    Sample waves_{spec_, plan_, {}};
    Sample few_{spec_, plan_, {}};                                          // for the knobs that act on waves
    std::map<std::vector<std::string>, std::vector<TrialRow>> references_;  // by their settings
    std::vector<TrialRow> best_matched_;
    std::vector<double> exact_ou_v_e_, exact_v_wes_, exact_spectra_;
    std::vector<Step> steps_;
    Study study_;
};

}  // namespace overturn::cost
