#include "contact/planar_contact.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "contact/detail/contact_run.hpp"
#include "core/error.hpp"
#include "simd/lane_scheduler.hpp"
#include "simd/run_batch.hpp"

namespace overturn {
namespace {

// Of the lowest point of a leaning rim of points, so deep that all that touch bear the weight: neighbours lie little
// higher.
double leaning_depth(ContactBlock const& block, double slope) {
    double low = 0;
    double high = block.settlement_m() / block.points.front().stiffness_share;
    for (int i = 0; i < 60; ++i) {
        double const middle = (low + high) / 2;
        double borne = 0;
        for (auto const& point : block.points) {
            borne += point.stiffness_share * std::max(0.0, middle - slope * (block.half_width_m - point.offset_m));
        }
        (borne < block.settlement_m() ? low : high) = middle;
    }
    return low;
}

}  // namespace

template <> Fields const& fields_of<ContactQuantities>() {
    using Q = ContactQuantities;
    static Fields const fields{
        field<&Q::peak_crush_m>("peak_crush", "m", "deepest permanent crush of the pad; 0: elastic"),
        field<&Q::peak_contact_force_ratio>("peak_contact_force_ratio", "1", "max N / (m g)"),
        field<&Q::peak_rise_m>("peak_rise", "m", "highest rise of the centre of gravity"),
        field<&Q::residual_x_m>("residual_x", "m", "x of the base's centre at the end"),
        field<&Q::edge_x_most_m>("edge_x_most", "m", "largest x of the base's edge, from the initial axis"),
        field<&Q::edge_x_least_m>("edge_x_least", "m", "the same towards -x, negative"),
        field<&Q::peak_top_m>(
            "peak_top", "m",
            "largest displacement of the top in plan: on the axis, at twice the height of the centre of "
            "gravity"),
        field<&Q::rotation_most_rad>("rotation_most", "rad", "largest rotation towards +x; pi/2 if it fell that way"),
        field<&Q::rotation_least_rad>("rotation_least", "rad", "the same towards -x, negative"),
        field<&Q::restitution>("restitution", "1",
                               "ratio of angular velocities after and before an impact, from base and pad"),
        field<&Q::corner_share>("corner_share", "1", "share of the stiffness on the corners; NaN: a round base"),
        field<&Q::normal_restitution>("normal_restitution", "1",
                                      "restitution of one point of the base in a flat drop")};
    return fields;
}

ContactOutcome simulate_contact(ContactBlock const& block, Excitation const& shaking, ContactAccuracy const& accuracy,
                                std::optional<ContactStart> const& start, ContactObserver* observer) {
    contact::ContactRun run(block, shaking, accuracy, start);
    while (run.advance()) {
        if (observer == nullptr) {
            contact::step_lanes(run.lane());
            continue;
        }
        do {
            observer->at(run.instant());
        } while (!contact::step_lane_once(run.lane()));
    }
    if (observer != nullptr) {
        observer->at(run.instant());
    }
    return run.finish();
}

void simulate_contact(std::span<ContactTrial const> trials, ContactAccuracy const& accuracy,
                      std::span<ContactOutcome> outcomes, std::function<void()> const& before_each) {
    OVERTURN_EXPECT(trials.size() == outcomes.size());
    std::map<std::pair<std::size_t, bool>, std::vector<std::size_t>> by_kind;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        auto const& block = *trials[i].block;
        by_kind[{block.points.size(), block.of_rim}].push_back(i);
    }
    for (auto const& [kind, queue] : by_kind) {
        simd::RunBatch<contact::ContactRun> batch(trials, queue, accuracy, outcomes, before_each);
        simd::LaneScheduler(batch).run();
    }
}

ContactStart leaning_start(ContactBlock const& block, double rotation_rad) {
    double const b = std::copysign(block.half_width_m, rotation_rad);  // the corner that it leans on
    double const h = block.centre_height_m;
    double const s = std::sin(rotation_rad);
    double const c = std::cos(rotation_rad);
    double const depth =
        block.of_rim ? leaning_depth(block, std::abs(s)) : block.settlement_m() / block.points.front().stiffness_share;
    return {.sway_m = b * (1 - c) + h * s,
            .rise_m = b * s - h * (1 - c) - depth + block.settlement_m(),
            .rotation_rad = rotation_rad};
}

}  // namespace overturn
