/// Least distance of a body from its surroundings and from the edge of its pad, for a trial.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "campaign/base_reach.hpp"
#include "campaign/body_spec.hpp"
#include "campaign/rows.hpp"
#include "campaign/site.hpp"
#include "response/model_selector.hpp"

namespace overturn {

/// Until when a trial follows its body [s]: infinite: all the way; before 0: never, as effects that decide where it is
/// were called for and left out. A rigid body is followed until it flies, one without a verdict to its last instant.
[[nodiscard]] double followed_until_s(TrialRow const& row);

/// Fills the columns least_clearance and edge_margin of trials. They stay unknown where effects that decide them were
/// called for and left out, where a trial has no verdict, and where a rigid body fell through the air.
///
/// A direction's reach is bounded from above: how far the base's edge went that way, what of the body reaches beyond
/// its base, and its height times the sine of its largest tilt, as if all were at the same instant and the tilt that
/// way. (A body of height H that turns by theta about its leading corner has its top H sin theta beyond that corner; a
/// place o beyond the base and z high is o cos theta + z sin theta beyond it.) The way of the base's edge is known for
/// each side; in a plane nothing moves across it. To which side it tilted only points in a plane tell: elsewhere it may
/// have been either. On a slope it leans towards the valley from the first.
class SiteJudge {
  public:
    /// \param bodies and `site` outlive it
    SiteJudge(Site const& site, std::span<BodySpec const> bodies, ModelSelector const& selector);

    /// A trial of one of the bodies, and what models have to say of their own.
    struct Trial {
        TrialRow const& row;  ///< of which the body, its drawn height and the response count
        std::span<std::byte const> extra;
    };
    /// \param row of `trial`
    /// \param neighbour the trial of neighbour_of its body, under the same wave at the same level; without one the
    /// other cask is like the body itself: it may come as far as the body went to either side
    void fill(TrialRow& row, Trial const& trial, std::optional<Trial> const& neighbour = {}) const;
    /// The body whose own trial says how the other cask moves; empty: it is like the body itself.
    [[nodiscard]] std::optional<std::size_t> neighbour_of(std::int64_t body) const;
    /// Is there a site? Else nothing is filled, and no such record read.
    [[nodiscard]] bool asked() const { return site_.has_gaps() || site_.has_edges(); }

  private:
    using PerSide = std::array<double, Sides::count>;
    /// Largest travel of a body to each side of its place: of its base, and of any part of it [m]
    struct Ways {
        PerSide base_m, all_m;
    };
    [[nodiscard]] std::optional<Ways> ways_of(Trial const& trial) const;
    [[nodiscard]] PerSide base_ways(Trial const& trial) const;
    [[nodiscard]] PerSide leans(Trial const& trial) const;
    [[nodiscard]] double tilt_towards(std::size_t side, Trial const& trial) const;

    struct OfModel {
        std::int64_t model;
        // What it has of these; their offsets are those in the record.
        std::array<std::optional<Field>, Sides::count> edges;
        std::optional<Field> yaw;
        std::array<std::optional<Field>, 2> rotations;  ///< towards +x and -x

        [[nodiscard]] bool is_spatial() const { return yaw && edges[2] && edges[3]; }
    };
    [[nodiscard]] OfModel const* model_of(Trial const& trial) const;
    [[nodiscard]] PerSide spatial_ways(Trial const& trial, OfModel const& model) const;
    [[nodiscard]] PerSide planar_ways(Trial const& trial, OfModel const& model) const;

    Site const& site_;
    std::span<BodySpec const> bodies_;
    std::vector<BaseReach> bases_;
    std::vector<OfModel> models_;  ///< those that give the travel of the base's edge
};

}  // namespace overturn
