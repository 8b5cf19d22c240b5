#include "rare/detail/chain_states.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "rare/detail/normals.hpp"

namespace overturn::rare {
namespace {

DrawKey draw_of(DrawKey key, SubsetNode const& node) {
    key.level = node.level;
    key.step = node.step;
    key.index = node.index;
    return key;
}

}  // namespace

ChainStates::State ChainStates::root(SubsetNode const& node) {
    draw_normals(draw_of(key_, node), scratch_);
    State state(scratch_.size());
    std::transform(scratch_.begin(), scratch_.end(), state.begin(), [](double x) { return static_cast<float>(x); });
    return state;
}

ChainStates::State ChainStates::moved(State const& from, SubsetNode const& to) {
    draw_normals(draw_of(key_, to), scratch_);
    double const s = to.step_size;
    double const rest = std::sqrt(1 - s * s);
    State state(from.size());
    for (std::size_t i = 0; i < state.size(); ++i) {
        state[i] = static_cast<float>(rest * static_cast<double>(from[i]) + s * scratch_[i]);
    }
    return state;
}

ChainStates::State ChainStates::state_of(std::vector<SubsetNode> const& nodes, std::int64_t node) {
    std::vector<std::int64_t> descent;
    auto at = node;
    while (!kept_.contains(at) && nodes.at(at).parent >= 0) {
        descent.push_back(at);
        at = nodes[at].parent;
    }
    auto const kept = kept_.find(at);
    auto state = kept != kept_.end() ? kept->second : root(nodes.at(at));
    std::reverse(descent.begin(), descent.end());
    for (auto const next : descent) {
        state = moved(state, nodes[next]);
    }
    return state;
}

void ChainStates::keep_only(std::span<std::int64_t const> nodes) {
    std::map<std::int64_t, State> left;
    for (auto const node : nodes) {
        if (auto const kept = kept_.find(node); kept != kept_.end()) {
            left.insert_or_assign(node, std::move(kept->second));
            kept_.erase(kept);
        }
    }
    kept_ = std::move(left);
}

}  // namespace overturn::rare
