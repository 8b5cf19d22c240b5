/// Surroundings of a body: other casks, walls and the edge of the pad.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>

#include "campaign/body_spec.hpp"
#include "config/table.hpp"

namespace overturn {

/// Distances from the base's edge as it stands at first, by direction: +x, -x, +y, -y; infinite: nothing is there [m].
struct Sides {
    static constexpr std::size_t count = 4;
    /// The side that looks the other way.
    [[nodiscard]] static constexpr std::size_t opposite(std::size_t side) { return side ^ 1U; }

    std::array<double, count> m = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
                                   std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};

    [[nodiscard]] bool any() const;
};

/// Surroundings of every body of a campaign.
struct Site {
    Sides cask;                                 ///< to another cask, which moves too
    Sides wall;                                 ///< to what stands still
    Sides edge;                                 ///< to the pad's edge
    std::optional<std::size_t> cask_body = {};  ///< place of the other cask's body; empty: one of the kind
    std::optional<double> height_m = {};        ///< of a body's highest point above its base, where it is stated
    std::optional<double> width_m = {};         ///< of a body where it is widest, where that is stated

    [[nodiscard]] bool has_gaps() const { return cask.any() || wall.any(); }
    [[nodiscard]] bool has_edges() const { return edge.any(); }
    /// Height of a body's highest point above its base: as stated, that of its parts, or twice the height of its centre
    /// of gravity [m]
    [[nodiscard]] double top_m(BodySpec const& body, double centre_height_m) const;
    /// From a body's axis to where it is widest: as stated, or as its parts; 0: nothing is known to reach beyond its
    /// base [m]
    [[nodiscard]] double widest_m(BodySpec const& body) const;
};

/// Keys of [site].
extern config::KeyTable const site_table;
/// All but which body the other cask is. \throws InputError
[[nodiscard]] Site read_site(config::Table const& table);
/// The place of the other cask among these bodies, if [site] states it. \throws InputError
[[nodiscard]] std::optional<std::size_t> read_cask_body(config::Table const& table, std::span<BodySpec const> bodies);

}  // namespace overturn
