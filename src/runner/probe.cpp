#include "runner/probe.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/elapsed.hpp"

namespace overturn {
namespace {

constexpr double probe_s = 1;
constexpr std::int64_t most_waves = 16;  // matches of some take twice as many iterations as those of others
constexpr std::size_t waves_of_trials = 4;
constexpr std::size_t one_level_of = 4;  // levels, of which one is tried first

// The campaign with one level in four, from the second on: weak ones cost nothing, strong ones end early.
class ThinnedLevels {
  public:
    explicit ThinnedLevels(CampaignSpec& spec) : spec_(spec), all_(spec.levels.levels) {
        std::vector<Level> some;
        for (std::size_t i = one_level_of / 2; i < all_.size(); i += one_level_of) {
            some.push_back(all_[i]);
        }
        spec_.levels.levels = std::move(some);
    }
    ~ThinnedLevels() { spec_.levels.levels = std::move(all_); }
    ThinnedLevels(ThinnedLevels const&) = delete;
    ThinnedLevels& operator=(ThinnedLevels const&) = delete;
    ThinnedLevels(ThinnedLevels&&) = delete;
    ThinnedLevels& operator=(ThinnedLevels&&) = delete;

    [[nodiscard]] double share() const {
        return static_cast<double>(spec_.levels.levels.size()) / static_cast<double>(all_.size());
    }

  private:
    CampaignSpec& spec_;
    std::vector<Level> all_;
};

// Of 16 places every fourth first: those whose trials are answered lie over the whole campaign.
std::int64_t spread(std::int64_t drawn, std::int64_t wanted) {
    constexpr std::int64_t apart = 4;
    return wanted == most_waves ? drawn % apart * apart + drawn / apart : drawn;
}

double timed_trials(CampaignSpec const& spec, Plan const& plan, std::span<PreparedWave const> waves,
                    PhaseSeconds& models) {
    TrialRows trials;
    models = {};
    auto const begin = Clock::now();
    append_trials(spec, plan, waves, trials, models);
    return seconds_since(begin);
}

// Of one wave.
double trials_s(CampaignSpec& spec, Plan const& plan, std::span<PreparedWave const> waves, PhaseSeconds& models) {
    auto const together = static_cast<std::size_t>(std::min<std::int64_t>(std::ssize(waves), waves_together(plan)));
    auto const first = waves.first(std::min<std::size_t>(2, together));
    auto const count = static_cast<double>(waves.size());
    if (!spec.levels.independent_waves && spec.levels.levels.size() > one_level_of) {
        ThinnedLevels const thinned(spec);
        double const each =
            timed_trials(spec, Plan(spec), first, models) / thinned.share() / static_cast<double>(first.size());
        if (each * count > probe_s) {
            return each;
        }
    }
    double const each = timed_trials(spec, plan, waves.first(together), models) / static_cast<double>(together);
    return each * (count - static_cast<double>(together)) > probe_s || together == waves.size()
               ? each
               : timed_trials(spec, plan, waves, models) / count;
}

}  // namespace

ProbedCost probe(CampaignSpec& spec, Plan const& plan) {
    auto const& acceptance = spec.source->about().acceptance;
    std::int64_t const wanted = std::min<std::int64_t>(most_waves, plan.asked());
    ProbedCost cost;
    PhaseSeconds phases;
    std::vector<PreparedWave> tried;
    auto const begin = Clock::now();
    std::int64_t drawn = 0;
    while (drawn < wanted && (drawn == 0 || seconds_since(begin) < probe_s)) {
        auto const wave = plan.without_refusals().number(spread(drawn, wanted) * plan.asked() / wanted);
        auto prepared = prepare_wave(spec, plan, wave, phases);
        ++drawn;
        if (!is_tried(acceptance, prepared.row)) {
            ++cost.waves.refused;
            continue;
        }
        cost.waves.add(prepared.row);
        tried.push_back(std::move(prepared));
    }
    auto const n = static_cast<double>(drawn);
    cost.generation_s = phases.waves / n;
    cost.measures_s = phases.measures / n;
    cost.refused_per_wave = (n - static_cast<double>(tried.size())) / std::max(1.0, static_cast<double>(tried.size()));
    if (!tried.empty()) {
        auto const some = std::span(tried).first(std::min(tried.size(), waves_of_trials));
        cost.trials_s = trials_s(spec, plan, some, cost.models);
    }
    return cost;
}

}  // namespace overturn
