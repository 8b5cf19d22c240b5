#include "runner/probe.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "campaign/accepted_waves.hpp"
#include "core/elapsed.hpp"
#include "response/registry.hpp"

namespace overturn {
namespace {

constexpr double probe_s = 1;
constexpr std::int64_t enough_waves = 16;  // matches of some take twice as many iterations as those of others
constexpr std::int64_t waves_first = 4;    // whose trials are answered
constexpr std::size_t one_level_of = 4;    // levels, of which one is tried first

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

// Every fourth place first: those whose trials are answered lie over the whole campaign.
std::int64_t spread(std::int64_t drawn, std::int64_t wanted) {
    auto const apart = wanted / waves_first;
    return drawn < apart * waves_first ? drawn % waves_first * apart + drawn / waves_first : drawn;
}

double share_of_undecided(CampaignSpec const& spec, TrialRows const& trials) {
    std::set<std::int64_t> bodies;
    for (auto const& row : trials.rows) {
        if (!entry_of(row.verdict).decided) {
            bodies.insert(row.body);
        }
    }
    return static_cast<double>(bodies.size()) / static_cast<double>(spec.bodies.size());
}

// Of one wave, where so many are answered at once, as a run does.
double timed_trials(CampaignSpec const& spec, Plan const& plan, std::span<PreparedWave const> waves, ProbedCost& cost) {
    auto const together = static_cast<std::size_t>(waves_together(plan));
    TrialRows trials;
    cost.models = {};
    auto const begin = Clock::now();
    for (std::size_t next = 0; next < waves.size(); next += together) {
        auto const some = waves.subspan(next, std::min(together, waves.size() - next));
        append_trials(spec, plan, some, trials, cost.models);
    }
    double const taken_s = seconds_since(begin);
    cost.undecided_bodies = share_of_undecided(spec, trials);
    return taken_s / static_cast<double>(waves.size());
}

double trials_s(CampaignSpec& spec, Plan const& plan, std::span<PreparedWave const> waves, ProbedCost& cost) {
    auto const together = waves_together(plan);
    auto const few = static_cast<std::size_t>(std::min({std::ssize(waves), waves_first, together}));
    if (!spec.levels.independent_waves && spec.levels.levels.size() > one_level_of) {
        ThinnedLevels const thinned(spec);
        double const each =
            timed_trials(spec, Plan(spec), waves.first(std::min<std::size_t>(2, few)), cost) / thinned.share();
        if (each * static_cast<double>(few) > probe_s) {
            return each;
        }
    }
    double const each = timed_trials(spec, plan, waves.first(few), cost);
    // Lanes are full or not as in a run where its groups are whole.
    auto const rounds = std::ssize(waves) / together;
    auto const all = rounds > 0 ? static_cast<std::size_t>(rounds * together) : waves.size();
    return all == few || each * static_cast<double>(all) > probe_s ? each
                                                                   : timed_trials(spec, plan, waves.first(all), cost);
}

}  // namespace

ProbedCost probe(CampaignSpec& spec, Plan const& plan) {
    auto const& acceptance = spec.source->about().acceptance;
    auto const wanted = std::min(std::max(enough_waves, waves_together(plan)), plan.asked());
    ProbedCost cost;
    PhaseSeconds phases;
    std::vector<PreparedWave> tried;
    std::vector<WaveRow> refused;
    auto const begin = Clock::now();
    std::int64_t drawn = 0;
    while (drawn < wanted && (drawn == 0 || seconds_since(begin) < probe_s)) {
        auto const wave = plan.without_refusals().number(spread(drawn, wanted) * plan.asked() / wanted);
        auto prepared = prepare_wave(spec, plan, wave, phases);
        ++drawn;
        if (!is_tried(acceptance, prepared.row)) {
            ++cost.waves.refused;
            refused.push_back(prepared.row);
            continue;
        }
        cost.waves.add(prepared.row);
        tried.push_back(std::move(prepared));
    }
    auto const n = static_cast<double>(drawn);
    cost.generation_s = phases.waves / n;
    cost.measures_s = phases.measures / n;
    cost.refused_per_wave = (n - static_cast<double>(tried.size())) / std::max(1.0, static_cast<double>(tried.size()));
    if (tried.empty() && acceptance.refuses()) {
        cost.none_accepted =
            fmt::format("none of {} waves tried meets {} ({})", drawn, acceptance.rule, missed_text(refused));
    }
    if (!tried.empty()) {
        cost.trials_s = trials_s(spec, plan, tried, cost);
    }
    return cost;
}

}  // namespace overturn
