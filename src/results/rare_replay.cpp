#include "results/rare_replay.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

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
    std::vector<std::string> ends;
    auto const factors = replayer.factors(stored);
    for (std::size_t f = 0; f < factors.size(); ++f) {
        bool const fell = (static_cast<std::uint64_t>(again.failed) >> f & 1U) != 0;
        ends.push_back(fmt::format("{} at {:.6g}",
                                   !fell                     ? "stood"
                                   : state->is_overturning() ? "overturned"
                                                             : "passed",
                                   factors[f]));
    }
    replay.text = fmt::format("row {} of {}: {}, replicate {}, stage {}, index {}, weight {:.6g}\n{}\n", row, body,
                              name_of(static_cast<rare::Method>(stored.method)), stored.replicate, stored.stage,
                              stored.index, stored.weight, fmt::join(ends, ", "));
    return replay;
}

}  // namespace overturn
