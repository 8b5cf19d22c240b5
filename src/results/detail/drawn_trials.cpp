#include "results/detail/drawn_trials.hpp"

#include <cmath>
#include <cstdint>
#include <map>

#include "campaign/plan.hpp"

namespace overturn {
namespace {

// The standard normal scores of what was drawn for the waves of these trials, and no others: a campaign may be huge.
std::map<std::int64_t, std::vector<double>> scores_of(CampaignSpec const& spec, std::size_t body,
                                                      std::span<SingleTrial const> trials) {
    std::map<std::int64_t, std::vector<double>> scores;
    for (auto const& trial : trials) {
        scores.try_emplace(trial.id);
    }
    Plan const plan(spec);
    auto left = scores.size();
    for (std::int64_t wave = 0; wave < plan.waves() && left > 0; ++wave) {
        if (auto const found = scores.find(static_cast<std::int64_t>(plan.wave_id(wave))); found != scores.end()) {
            auto const& drawn = spec.bodies[body];
            found->second = drawn.scores(drawn.for_wave(plan.drawn_for(spec, wave), body));
            --left;
        }
    }
    return scores;
}

}  // namespace

std::optional<BetaSplit> split_by_draws(CampaignSpec const& spec, std::size_t body, std::span<SingleTrial const> trials,
                                        BootstrapKey const& key) {
    if (spec.bodies[body].scattering().empty()) {
        return std::nullopt;
    }
    auto const scores = scores_of(spec, body, trials);
    std::vector<DrawnTrial> drawn;
    drawn.reserve(trials.size());
    for (auto const& trial : trials) {
        drawn.push_back({std::log(trial.intensity), scores.at(trial.id), trial.overturned, trial.wave});
    }
    return split_beta(drawn, key);
}

}  // namespace overturn
