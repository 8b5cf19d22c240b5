#include "spatial/spatial_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <vector>

#include "core/error.hpp"
#include "simd/lane_scheduler.hpp"
#include "simd/run_batch.hpp"
#include "spatial/detail/spatial_run.hpp"

namespace overturn {

template <> Fields const& fields_of<SpatialQuantities>() {
    using Q = SpatialQuantities;
    static Fields const fields{
        field<&Q::peak_crush_m>("peak_crush", "m", "deepest permanent crush of the pad; 0: elastic"),
        field<&Q::peak_contact_force_ratio>("peak_contact_force_ratio", "1", "max N / (m g)"),
        field<&Q::peak_rise_m>("peak_rise", "m", "highest rise of the centre of gravity"),
        field<&Q::yaw_rad>("yaw", "rad", "rotation about the body's axis at the end"),
        field<&Q::peak_yaw_rad>("peak_yaw", "rad", "largest rotation about the body's axis"),
        field<&Q::slip_path_m>("slip_path", "m", "path length of the base in plan, by slip, rolling or walking"),
        field<&Q::residual_x_m>("residual_x", "m", "x of the base's centre at the end"),
        field<&Q::residual_y_m>("residual_y", "m", "y of the base's centre at the end"),
        field<&Q::edge_x_most_m>("edge_x_most", "m",
                                 "largest x of the base's edge, from the initial axis; of a "
                                 "base with corners the circle round them"),
        field<&Q::edge_x_least_m>("edge_x_least", "m", "the same towards -x, negative"),
        field<&Q::edge_y_most_m>("edge_y_most", "m", "the same towards +y"),
        field<&Q::edge_y_least_m>("edge_y_least", "m", "the same towards -y, negative"),
        field<&Q::peak_top_m>(
            "peak_top", "m",
            "largest displacement of the top in plan: on the axis, at twice the height of the centre of gravity"),
        field<&Q::landing_azimuth_rad>(
            "landing_azimuth", "rad",
            "direction in plan in which an overturned body lies, from x towards y; NaN: none"),
        field<&Q::restitution>("restitution", "1",
                               "ratio of angular velocities after and before an impact, from base and pad"),
        field<&Q::corner_share>("corner_share", "1", "share of the stiffness on the corners; NaN: no square base"),
        field<&Q::normal_restitution>("normal_restitution", "1",
                                      "restitution of one point of the base in a flat drop")};
    return fields;
}

double SpatialInstant::tilt_rad() const {
    return 2 * std::asin(std::min(1.0, std::hypot(quaternion[1], quaternion[2])));
}

double SpatialInstant::azimuth_rad() const {
    auto const& [w, x, y, z] = quaternion;
    return std::atan2(y * z - w * x, x * z + w * y);
}

std::array<double, 2> SpatialInstant::tilts_rad() const {
    double const tilt = tilt_rad();
    auto const& [w, x, y, z] = quaternion;
    double const across = y * z - w * x;  // of the body's axis, halved
    double const along = x * z + w * y;
    double const length = std::hypot(across, along);
    return length > 0 ? std::array{-tilt * across / length, tilt * along / length} : std::array{0.0, 0.0};
}

SpatialOutcome simulate_spatial(SpatialBlock const& block, Excitation const& shaking, ContactAccuracy const& accuracy,
                                std::optional<SpatialStart> const& start, SpatialObserver* observer) {
    spatial::SpatialRun run(block, shaking, accuracy, start);
    while (run.advance()) {
        if (observer == nullptr) {
            spatial::step_on(run.lane());
            continue;
        }
        for (bool care = false; !care;) {
            auto instant = run.instant();
            care = spatial::step_once(run.lane());
            instant.contact_force_ratio = run.instant().contact_force_ratio;  // at the start of that step
            observer->at(instant);
        }
    }
    if (observer != nullptr) {
        observer->at(run.instant());
    }
    return run.finish();
}

void simulate_spatial(std::span<SpatialTrial const> trials, ContactAccuracy const& accuracy,
                      std::span<SpatialOutcome> outcomes, std::function<void()> const& before_each) {
    OVERTURN_EXPECT(trials.size() == outcomes.size());
    std::map<spatial::BaseKind, std::vector<std::size_t>> by_kind;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        by_kind[spatial::kind_of(*trials[i].block)].push_back(i);
    }
    for (auto const& [kind, queue] : by_kind) {
        simd::RunBatch<spatial::SpatialRun> batch(trials, queue, accuracy, outcomes, before_each);
        // Too large for the stack.
        auto const scheduler = std::make_unique<simd::LaneScheduler<simd::RunBatch<spatial::SpatialRun>>>(batch);
        scheduler->run();
    }
}

}  // namespace overturn
