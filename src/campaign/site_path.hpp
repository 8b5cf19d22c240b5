/// The way of a body through the room round it, instant by instant.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "campaign/base_reach.hpp"
#include "campaign/body_spec.hpp"
#include "campaign/rows.hpp"
#include "campaign/site.hpp"
#include "model/history.hpp"

namespace overturn {

struct OtherCask;

/// Adds to a history what a site makes of each instant: how far the edge of the base (edge_plus_x_m, ...) and any of
/// the body (reach_plus_x_m, ...) are beyond the place of that edge at first, to each side, negative where they are
/// short of it; then clearance_m and edge_margin_m, as far as the site has gaps and edges. NaN: nobody followed it.
///
/// What SiteJudge bounds by peaks is here of one instant: another body as the other cask is where it is at that time.
/// One that is like the body itself may be as far this way as the body ever went to either side.
class SitePath : public Observer {
  public:
    using PerSide = std::array<double, Sides::count>;

    /// \param site and `body` outlive it, as do those below \param row of its trial
    /// \param next sees the longer history; null: it is kept here alone
    /// \param other of the other cask, whose path is done; null: there is none
    SitePath(Site const& site, BodySpec const& body, TrialRow const& row, Observer* next = nullptr,
             OtherCask const* other = nullptr);
    /// Is it a channel that such a path adds?
    [[nodiscard]] static bool adds(std::string_view key);

    void begin(std::span<Channel const> channels) override;
    void at(std::span<double const> values) override;

    /// Farthest reach of the body to each side at a time: the larger one of the instants before and after. NaN: not
    /// known, as after the last instant of a trial without a verdict [m]
    [[nodiscard]] PerSide reach_m(double time_s) const;
    /// Farthest reach over the whole trial, to this side or the opposite one; NaN: not known all the way [m]
    [[nodiscard]] PerSide farthest_m() const;

  private:
    struct Place {
        PerSide edge_m, reach_m;
    };
    [[nodiscard]] bool is_lost_at(double time_s) const;
    [[nodiscard]] Place place_of(std::span<double const> values) const;
    [[nodiscard]] Place in_plane(double slip_m, double rotation_rad) const;
    [[nodiscard]] Place in_space(double x_m, double y_m, Pose const& pose) const;
    void add_reach(Place& place, PerSide const& lean_m) const;
    [[nodiscard]] double clearance_m(PerSide const& reach_m, PerSide const& other_m) const;
    [[nodiscard]] double margin_m(PerSide const& edge_m) const;
    [[nodiscard]] std::optional<std::size_t> channel(std::string_view key) const;
    [[nodiscard]] double value(std::span<double const> values, std::string_view key) const;

    Site const& site_;
    BodySpec const& body_;
    BaseReach base_;
    double top_m_;
    double followed_until_s_;
    bool goes_to_its_end_;
    PerSide beyond_base_m_{};
    Observer* next_;
    OtherCask const* other_;
    std::vector<Channel> channels_;  ///< of the model
    std::vector<double> times_s_;
    std::vector<PerSide> reaches_m_;
    PerSide farthest_m_{};
    std::vector<double> row_;
};

/// Motion of the other cask.
struct OtherCask {
    SitePath const& path;  ///< its own, or that of a body like it
    bool is_like = false;  ///< the path is of the body itself: of its like only how far it comes is known, not when

    /// Farthest reach to each side at a time; NaN: not known [m]
    [[nodiscard]] SitePath::PerSide reach_m(double time_s) const {
        return is_like ? path.farthest_m() : path.reach_m(time_s);
    }
};

}  // namespace overturn
