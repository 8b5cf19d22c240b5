/// The normals of Markov chains, kept where they were made and made again where they are missing.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "rare/subset.hpp"

namespace overturn::rare {

/// States of one replicate's chains. The set kept here depends on which rank did the work; the states do not.
class ChainStates {
  public:
    /// \param key of the replicate: the identity of its draws but for level, step and index
    ChainStates(DrawKey const& key, std::size_t normals) : key_(key), scratch_(normals) {}

    using State = std::vector<float>;

    /// \param nodes those so far
    [[nodiscard]] State state_of(std::vector<SubsetNode> const& nodes, std::int64_t node);
    /// sqrt(1 - s^2) x + s draw, rounded.
    [[nodiscard]] State moved(State const& from, SubsetNode const& to);
    void keep(std::int64_t node, State state) { kept_.insert_or_assign(node, std::move(state)); }
    /// Forgets all others.
    void keep_only(std::span<std::int64_t const> nodes);

    /// State of a node without a parent: its draw, rounded.
    [[nodiscard]] State root(SubsetNode const& node);

  private:
    DrawKey key_;
    std::vector<double> scratch_;
    std::map<std::int64_t, State> kept_;
};

}  // namespace overturn::rare
