/// What stands round a body and where its pad ends, and how near a trial came to either.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "campaign/body_spec.hpp"
#include "campaign/rows.hpp"
#include "config/table.hpp"
#include "response/ladder.hpp"

namespace overturn {

/// Distances from the base's edge as it stands at first, by direction; infinite: nothing is there [m].
struct Sides {
    static constexpr std::size_t count = 4;
    std::array<double, count> m = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
                                   std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};

    [[nodiscard]] bool any() const;
};

/// What is round every body of a campaign.
struct Site {
    Sides
        cask;  ///< to another cask of the kind, which moves too: it may come as far towards the body as the body to it
    Sides wall;                           ///< to what stands still
    Sides edge;                           ///< to the pad's edge
    std::optional<double> height_m = {};  ///< of a body's highest point above its base, where it is stated

    [[nodiscard]] bool has_gaps() const { return cask.any() || wall.any(); }
    [[nodiscard]] bool has_edges() const { return edge.any(); }
    /// Of a body's highest point above its base: as stated, that of its parts, or twice the height of its centre of
    /// gravity [m]
    [[nodiscard]] double top_m(BodySpec const& body, double centre_height_m) const;
};

/// Of [site].
extern config::KeyTable const site_table;
/// \throws InputError
[[nodiscard]] Site read_site(config::Table const& table);

/// Fills the columns least_clearance and edge_margin of trials; where effects that decide them were called for and left
/// out they stay unknown.
///
/// A direction's reach is bounded from above: how far the base went that way, and the body's height times the sine of
/// its largest tilt, as if both were at the same instant and the tilt that way. In a plane neither is known to be to
/// one side rather than the other; across it nothing moves. In space the way of the base's edge is known for each side.
class SiteJudge {
  public:
    /// \param bodies and `site` outlive it
    SiteJudge(Site const& site, std::span<BodySpec const> bodies, Ladder const& ladder);

    /// \param row whose response is known \param own of what models have to say of their own
    void fill(TrialRow& row, std::size_t body, std::span<std::byte const> own) const;
    /// Is there a site? Else nothing is filled, and no such record read.
    [[nodiscard]] bool asked() const { return site_.has_gaps() || site_.has_edges(); }

  private:
    struct Ways {
        std::array<double, Sides::count> base_m, all_m;
    };
    [[nodiscard]] Ways ways_of(TrialRow const& row, std::size_t body, std::span<std::byte const> own) const;

    struct OfModel {
        std::int64_t rung;
        std::array<Field, Sides::count> edges;  ///< their offsets are those in the record
    };
    Site const& site_;
    std::span<BodySpec const> bodies_;
    std::vector<OfModel> models_;  ///< those that tell the way of the base's edge
};

}  // namespace overturn
