#include "campaign/drawn_trials.hpp"

#include <cmath>

#include "campaign/plan.hpp"

namespace overturn {

DrawnScores::DrawnScores(CampaignSpec const& spec, std::size_t body) {
    auto const& drawn = spec.bodies[body];
    if (drawn.scattering().empty()) {
        return;
    }
    Plan const plan(spec);
    for (std::int64_t wave = 0; wave < plan.waves(); ++wave) {
        scores_[static_cast<std::int64_t>(plan.wave_id(wave))] =
            drawn.scores(drawn.for_wave(plan.drawn_for(spec, wave), body));
    }
}

std::optional<BetaSplit> DrawnScores::split(std::span<SingleTrial const> trials) const {
    if (scores_.empty()) {
        return std::nullopt;
    }
    std::vector<DrawnTrial> drawn;
    drawn.reserve(trials.size());
    for (auto const& trial : trials) {
        drawn.push_back({std::log(trial.intensity), scores_.at(trial.wave), trial.overturned});
    }
    return split_beta(drawn);
}

}  // namespace overturn
