#include "spatial/detail/base_outline.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/error.hpp"
#include "core/units.hpp"

namespace overturn::spatial {
namespace {

using Corner = std::array<double, 2>;

double cross(Corner const& a, Corner const& b) { return a[0] * b[1] - a[1] * b[0]; }
double dot(Corner const& a, Corner const& b) { return a[0] * b[0] + a[1] * b[1]; }
Corner between(Corner const& a, Corner const& b) { return {b[0] - a[0], b[1] - a[1]}; }

// A point mirrored at both axes: a pair that lies opposite each other, then its mirror image.
void add_quad(std::vector<SpatialPoint>& points, double x, double y, double share) {
    points.insert(points.end(), {{-x, -y, share}, {x, y, share}, {-x, y, share}, {x, -y, share}});
}

// One without a partner stands as two of half its stiffness.
void complete_pairs(std::vector<SpatialPoint>& points) {
    if (points.size() % 2 != 0) {
        points.back().stiffness_share /= 2;
        points.push_back(points.back());
    }
}

std::vector<Corner> counterclockwise(std::vector<Corner> corners) {
    double area = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        area += cross(corners[i], corners[(i + 1) % corners.size()]);
    }
    if (area < 0) {
        std::ranges::reverse(corners);
    }
    return corners;
}

void validate_polygon(std::vector<Corner> const& corners) {
    validate(corners.size() >= 3 && corners.size() <= most_spatial_points,
             "a polygon of {} corners (a base takes 3 to {}). State its outline", corners.size(), most_spatial_points);
    double turning = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        auto const& [x, y] = corners[i];
        validate(std::isfinite(x) && std::isfinite(y),
                 "corner {} at ({}, {}) m is no place on a base (it is no number). Mend it", i + 1, x, y);
        auto const& next = corners[(i + 1) % corners.size()];
        auto const& beyond = corners[(i + 2) % corners.size()];
        auto const edge = between(corners[i], next);
        double const bend = cross(edge, between(next, beyond));
        validate(bend >= 0,
                 "the polygon turns inwards at ({}, {}) m (a body stands on its convex hull). Leave that corner out",
                 next[0], next[1]);
        validate(cross(corners[i], next) > 0,
                 "the axis is not inside the polygon (the edge from ({}, {}) m passes it). State corners from the "
                 "body's axis",
                 x, y);
        turning += std::atan2(bend, dot(edge, between(next, beyond)));
    }
    validate(turning < 3 * pi,
             "the polygon's corners go round more than once (they would cover each other). State them in their order");
}

// Least change from equal shares that puts the centroid of the weight on the axis.
std::vector<SpatialPoint> shared(std::vector<Corner> const& corners) {
    auto const count = static_cast<double>(corners.size());
    Corner mean{};
    for (auto const& corner : corners) {
        mean = {mean[0] + corner[0] / count, mean[1] + corner[1] / count};
    }
    double xx = 0;
    double xy = 0;
    double yy = 0;
    for (auto const& corner : corners) {
        auto const [x, y] = between(mean, corner);
        xx += x * x;
        xy += x * y;
        yy += y * y;
    }
    double const determinant = xx * yy - xy * xy;
    Corner const slope{(yy * mean[0] - xy * mean[1]) / determinant, (xx * mean[1] - xy * mean[0]) / determinant};
    std::vector<SpatialPoint> points;
    for (auto const& corner : corners) {
        double const share = 1 / count - dot(slope, between(mean, corner));
        validate(share > 0,
                 "the corner at ({}, {}) m bears nothing (the polygon is too lopsided about the axis). Leave it out",
                 corner[0], corner[1]);
        points.push_back({corner[0], corner[1], share});
    }
    return points;
}

}  // namespace

BaseOutline square_outline(std::vector<ContactPoint> const& row, double half_width_m) {
    BaseOutline outline{.points = {},
                        .area_m2 = 4 * half_width_m * half_width_m,
                        .edge_m = half_width_m,
                        .polar_radius2_m2 = 2 * half_width_m * half_width_m / 3};
    auto const half = row.size() / 2;
    auto& points = outline.points;
    for (std::size_t i = 0; i < half; ++i) {
        for (std::size_t j = 0; j < half; ++j) {
            add_quad(points, row[i].offset_m, row[j].offset_m, row[i].stiffness_share * row[j].stiffness_share);
        }
    }
    if (row.size() % 2 != 0) {
        double const middle = row[half].stiffness_share;
        for (std::size_t i = 0; i < half; ++i) {
            double const x = row[i].offset_m;
            double const share = row[i].stiffness_share * middle;
            points.insert(points.end(), {{-x, 0, share}, {x, 0, share}, {0, -x, share}, {0, x, share}});
        }
        points.push_back({0, 0, middle * middle});
        complete_pairs(points);
    }
    return outline;
}

BaseOutline rim_outline(double radius_m) {
    return {.points = {},
            .area_m2 = pi * radius_m * radius_m,
            .edge_m = radius_m,
            .polar_radius2_m2 = radius_m * radius_m / 2};
}

BaseOutline round_outline(int points, double radius_m) {
    validate(points >= fewest_rim_points && points <= most_spatial_points,
             "a rim of {} points (it takes {} to {}). Leave them out: the rim is then continuous", points,
             fewest_rim_points, most_spatial_points);
    BaseOutline outline{.points = {},
                        .area_m2 = pi * radius_m * radius_m,
                        .edge_m = radius_m * std::cos(pi / points),
                        .polar_radius2_m2 = radius_m * radius_m / 2};
    double const share = 1.0 / points;
    double const angle = 2 * pi / points;
    if (points % 4 == 0) {
        int const quarter = points / 4;
        // From the nearer axis, so that x and y are the same numbers on both sides of the diagonal.
        auto const along = [&](int i) {
            return radius_m * (2 * i <= quarter ? std::cos(angle * i) : std::sin(angle * (quarter - i)));
        };
        for (int i = 1; i < quarter; ++i) {
            add_quad(outline.points, along(i), along(quarter - i), share);
        }
        outline.points.insert(
            outline.points.end(),
            {{-radius_m, 0, share}, {radius_m, 0, share}, {0, -radius_m, share}, {0, radius_m, share}});
        return outline;
    }
    bool const even = points % 2 == 0;
    for (int i = 0; i < (even ? points / 2 : points); ++i) {
        double const x = radius_m * std::cos(angle * i);
        double const y = radius_m * std::sin(angle * i);
        outline.points.push_back({x, y, share});
        if (even) {
            outline.points.push_back({-x, -y, share});
        }
    }
    complete_pairs(outline.points);
    return outline;
}

BaseOutline polygon_outline(std::vector<Corner> const& corners_m) {
    auto const corners = counterclockwise(corners_m);
    validate_polygon(corners);
    BaseOutline outline{.points = shared(corners), .edge_m = std::numeric_limits<double>::infinity()};
    double second = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        auto const& a = corners[i];
        auto const& b = corners[(i + 1) % corners.size()];
        double const twice = cross(a, b);
        outline.area_m2 += twice / 2;
        second += twice * (dot(a, a) + dot(a, b) + dot(b, b)) / 12;
        auto const edge = between(a, b);
        outline.edge_m = std::min(outline.edge_m, twice / std::sqrt(dot(edge, edge)));
    }
    outline.polar_radius2_m2 = second / outline.area_m2;
    complete_pairs(outline.points);
    return outline;
}

}  // namespace overturn::spatial
