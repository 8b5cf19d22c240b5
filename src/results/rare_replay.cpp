#include "results/rare_replay.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "results/rare_replayer.hpp"

namespace overturn {

RareReplay replay_rare(store::ResultsReader const& file, CampaignSpec const& spec, std::string const& body,
                       std::string const& limit, std::int64_t row) {
    auto const found =
        std::find_if(spec.bodies.begin(), spec.bodies.end(), [&](BodySpec const& each) { return each.name == body; });
    validate(spec.rare && found != spec.bodies.end(), "{} (no rare events of such a body in this file). Check the name",
             body);
    auto const state = std::ranges::find(spec.limits, limit, &LimitState::name);
    validate(state != spec.limits.end(), "{} (no such limit state in this file). Check the name", limit);
    RareReplayer const replayer(file, spec, found - spec.bodies.begin(), state - spec.limits.begin());
    validate(row >= 0 && row < replayer.rows(), "row {} of /rare/{}/rows (it has {}, from 0). Choose one of them", row,
             body, replayer.rows());
    auto const stored = replayer.stored(row);
    auto const again = replayer.again(stored, row);
    RareReplay replay;
    replay.different = replayer.differing(stored, again);
    replay.stored = stored;
    replay.factors = replayer.factors(stored);
    for (std::size_t f = 0; f < replay.factors.size(); ++f) {
        replay.passed.push_back((static_cast<std::uint64_t>(again.failed) >> f & 1U) != 0);
    }
    return replay;
}

}  // namespace overturn
