#include "campaign/site_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "campaign/site_judge.hpp"
#include "core/error.hpp"
#include "core/field.hpp"

namespace overturn {
namespace {

constexpr std::array path_channels{Channel{"edge_plus_x_m"},  Channel{"edge_minus_x_m"}, Channel{"edge_plus_y_m"},
                                   Channel{"edge_minus_y_m"}, Channel{"reach_plus_x_m"}, Channel{"reach_minus_x_m"},
                                   Channel{"reach_plus_y_m"}, Channel{"reach_minus_y_m"}};
constexpr Channel clearance_channel{"clearance_m"};
constexpr Channel margin_channel{"edge_margin_m"};
constexpr SitePath::PerSide unknown_m{never, never, never, never};

// What is not known stays so.
double lower(double one, double other) { return std::isnan(one) || other >= one ? one : other; }

}  // namespace

SitePath::SitePath(Site const& site, BodySpec const& body, TrialRow const& row, Observer* next, OtherCask const* other)
    : site_(site),
      body_(body),
      base_(body),
      top_m_(site.top_m(body, row.centre_height_m)),
      followed_until_s_(followed_until_s(row)),
      goes_to_its_end_(entry_of(row.verdict).decided),
      next_(next),
      other_(other) {
    for (std::size_t i = 0; i < Sides::count; ++i) {
        beyond_base_m_.at(i) = std::max(0.0, site.widest_m(body) - base_.within_m(i, 0));
    }
    farthest_m_ = in_plane(0, 0).reach_m;
}

bool SitePath::adds(std::string_view key) {
    return std::ranges::find(path_channels, key, &Channel::key) != path_channels.end() || key == clearance_channel.key
           || key == margin_channel.key;
}

void SitePath::begin(std::span<Channel const> channels) {
    channels_.assign(channels.begin(), channels.end());
    if (next_ == nullptr) {
        return;
    }
    auto all = channels_;
    all.insert(all.end(), path_channels.begin(), path_channels.end());
    if (site_.has_gaps()) {
        all.push_back(clearance_channel);
    }
    if (site_.has_edges()) {
        all.push_back(margin_channel);
    }
    next_->begin(all);
}

void SitePath::at(std::span<double const> values) {
    double const time_s = value(values, "time_s");
    auto const place = time_s <= followed_until_s_ ? place_of(values) : Place{unknown_m, unknown_m};
    times_s_.push_back(time_s);
    reaches_m_.push_back(place.reach_m);
    for (std::size_t i = 0; i < Sides::count; ++i) {
        farthest_m_.at(i) = std::max(farthest_m_.at(i), place.reach_m.at(i));
    }
    if (next_ == nullptr) {
        return;
    }
    row_.assign(values.begin(), values.end());
    row_.insert(row_.end(), place.edge_m.begin(), place.edge_m.end());
    row_.insert(row_.end(), place.reach_m.begin(), place.reach_m.end());
    if (site_.has_gaps()) {
        row_.push_back(clearance_m(place.reach_m, other_ == nullptr ? unknown_m : other_->reach_m(time_s)));
    }
    if (site_.has_edges()) {
        row_.push_back(margin_m(place.edge_m));
    }
    next_->at(row_);
}

bool SitePath::is_lost_at(double time_s) const {
    bool const has_ended = times_s_.empty() || time_s > times_s_.back();
    return time_s > followed_until_s_ || (has_ended && !goes_to_its_end_);
}

SitePath::PerSide SitePath::farthest_m() const {
    if (is_lost_at(std::numeric_limits<double>::max())) {
        return unknown_m;
    }
    auto farthest_m = farthest_m_;
    for (std::size_t i = 0; i < Sides::count; ++i) {
        farthest_m.at(i) = std::max(farthest_m_.at(i), farthest_m_.at(Sides::opposite(i)));
    }
    return farthest_m;
}

SitePath::PerSide SitePath::reach_m(double time_s) const {
    if (is_lost_at(time_s)) {
        return unknown_m;
    }
    if (times_s_.empty()) {
        return in_plane(0, 0).reach_m;  // at rest
    }
    auto const last = static_cast<std::ptrdiff_t>(times_s_.size()) - 1;
    auto const after = std::ranges::lower_bound(times_s_, time_s) - times_s_.begin();
    auto farther = reaches_m_[std::min(after, last)];
    auto const& before = reaches_m_[std::clamp<std::ptrdiff_t>(after - 1, 0, last)];
    for (std::size_t i = 0; i < Sides::count; ++i) {
        farther.at(i) = -lower(-farther.at(i), -before.at(i));
    }
    return farther;
}

std::optional<std::size_t> SitePath::channel(std::string_view key) const {
    auto const found = std::ranges::find(channels_, key, &Channel::key);
    return found == channels_.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - channels_.begin()));
}

double SitePath::value(std::span<double const> values, std::string_view key) const {
    auto const found = channel(key);
    OVERTURN_EXPECT(found.has_value());
    return values[*found];
}

// The corner that it leans on is where slip took it; the other one is drawn in by 2 b (1 - cos theta).
SitePath::Place SitePath::in_plane(double slip_m, double rotation_rad) const {
    double const drawn_in_m = 2 * body_.body.half_width_m() * (1 - std::cos(rotation_rad));
    double const lean_m = top_m_ * std::sin(rotation_rad + body_.body.slope_rad());
    Place place{{slip_m - (rotation_rad < 0 ? drawn_in_m : 0), -slip_m - (rotation_rad > 0 ? drawn_in_m : 0), 0, 0},
                {}};
    add_reach(place, {lean_m, -lean_m, 0, 0});
    return place;
}

SitePath::Place SitePath::in_space(double x_m, double y_m, Pose const& pose) const {
    Place place{{x_m, -x_m, y_m, -y_m}, {}};
    for (std::size_t i = 0; i < Sides::count; ++i) {
        place.edge_m.at(i) += base_.posed_m(i, pose) - base_.within_m(i, 0);
    }
    double const lean_m = top_m_ * std::sin(pose.tilt_rad);
    double const along_x_m = lean_m * std::cos(pose.azimuth_rad);
    double const along_y_m = lean_m * std::sin(pose.azimuth_rad);
    add_reach(place, {along_x_m, -along_x_m, along_y_m, -along_y_m});
    return place;
}

// The top is the base moved along the axis; what is wider than the base is so at any height.
void SitePath::add_reach(Place& place, PerSide const& lean_m) const {
    for (std::size_t i = 0; i < Sides::count; ++i) {
        place.reach_m.at(i) = place.edge_m.at(i) + beyond_base_m_.at(i) + std::max(0.0, lean_m.at(i));
    }
}

SitePath::Place SitePath::place_of(std::span<double const> values) const {
    auto const of = [&](std::string_view key) { return value(values, key); };
    return channel("slip_m") ? in_plane(of("slip_m"), of("rotation_rad"))
                             : in_space(of("x_m"), of("y_m"), {of("yaw_rad"), of("tilt_rad"), of("azimuth_rad")});
}

double SitePath::clearance_m(PerSide const& reach_m, PerSide const& other_m) const {
    double least_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < Sides::count; ++i) {
        if (std::isfinite(site_.cask.m.at(i))) {
            least_m = lower(least_m, site_.cask.m.at(i) - reach_m.at(i) - other_m.at(Sides::opposite(i)));
        }
        least_m = lower(least_m, site_.wall.m.at(i) - reach_m.at(i));
    }
    return least_m;
}

double SitePath::margin_m(PerSide const& edge_m) const {
    double least_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < Sides::count; ++i) {
        least_m = lower(least_m, site_.edge.m.at(i) - edge_m.at(i));
    }
    return least_m;
}

}  // namespace overturn
