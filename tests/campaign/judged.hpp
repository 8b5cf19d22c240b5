/// Trials of a campaign with a site, as its judge sees them.
#pragma once

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "campaign/site_judge.hpp"
#include "contact/contact_model.hpp"
#include "core/units.hpp"
#include "response/registry.hpp"
#include "rocking/rocking_models.hpp"
#include "spatial/spatial_model.hpp"
#include "support/campaigns.hpp"

namespace overturn::testing {

inline std::string const slides = type_b + "friction=0.3\n";
inline std::string const square_slides = slides + "base={shape='square'}\n";

inline std::string with_site(std::string const& site, std::string const& bodies = slides) {
    return quick_waves + bodies + levels("values=[4,8]\n") + "[site]\n" + site;
}

/// Twice the height of the centre of gravity of these.
inline constexpr double height_m = 2 * 1.045;

class Judged {
  public:
    explicit Judged(std::string const& site, std::string const& bodies = slides)
        : spec(campaign_from(with_site(site, bodies))),
          selector(spec.effects, spec.accuracy),
          judge(spec.site, spec.bodies, selector),
          extra(selector.extra_bytes()) {
        selector.put_defaults(extra);
    }

    /// Of a body that slid so far and tilted so far in a plane.
    [[nodiscard]] TrialRow moved(double slip_m, double tilt_rad, std::int64_t body = 0) const {
        TrialRow row;
        row.body = body;
        row.verdict = tilt_rad >= pi / 2 ? Verdict::overturned : Verdict::slid_and_rocked;
        row.peak_slip_m = slip_m;
        row.peak_rotation_rad = tilt_rad;
        row.centre_height_m = spec.bodies[static_cast<std::size_t>(body)].body.centre_height_m();
        return row;
    }
    [[nodiscard]] TrialRow filled(TrialRow row) const {
        judge.fill(row, {row, extra});
        return row;
    }
    [[nodiscard]] TrialRow filled(double slip_m, double tilt_rad) const { return filled(moved(slip_m, tilt_rad)); }

    /// Of a body in space. \param edges_m where the circle round its base reached towards +x, -x, +y, -y
    TrialRow in_space(double tilt_rad, double yaw_rad, std::array<double, Sides::count> const& edges_m) {
        put("edge_x_most", edges_m[0]);
        put("edge_x_least", -edges_m[1]);
        put("edge_y_most", edges_m[2]);
        put("edge_y_least", -edges_m[3]);
        put("peak_yaw", yaw_rad);
        auto row = moved(0, tilt_rad);
        row.model = spatial_traits().number;
        row.effects = mask_of(Effect::contact) | mask_of(Effect::spatial);
        return filled(row);
    }

    /// Of a body on points in a plane. \param edges_m where its base reached towards +x and -x \param rotations_rad to
    /// either side
    TrialRow on_points(std::array<double, 2> const& edges_m, std::array<double, 2> const& rotations_rad) {
        auto const number = contact_traits().number;
        put("edge_x_most", edges_m[0], number);
        put("edge_x_least", -edges_m[1], number);
        put("rotation_most", rotations_rad[0], number);
        put("rotation_least", -rotations_rad[1], number);
        auto row = moved(std::max(edges_m[0], edges_m[1]), std::max(rotations_rad[0], rotations_rad[1]));
        row.model = number;
        row.effects = mask_of(Effect::contact) | mask_of(Effect::sliding);
        return filled(row);
    }
    /// Of a rigid body in a plane, that came as far towards +x and -x.
    TrialRow sliding(double tilt_rad, std::array<double, 2> const& edges_m) {
        put("edge_x_most", edges_m[0], sliding_traits().number);
        put("edge_x_least", -edges_m[1], sliding_traits().number);
        auto row = moved(std::max(edges_m[0], edges_m[1]), tilt_rad);
        row.model = sliding_traits().number;
        row.effects = mask_of(Effect::sliding);
        return filled(row);
    }

    CampaignSpec spec;
    ModelSelector selector;
    SiteJudge judge;
    std::vector<std::byte> extra;

  private:
    void put(std::string_view name, double value, std::int64_t model = spatial_traits().number) {
        for (auto const& [traits, offset] : selector.extra_parts()) {
            auto const field = std::ranges::find(traits->fields, name, &Field::name);
            if (traits->number == model) {
                ASSERT_NE(field, traits->fields.end());
                std::memcpy(extra.data() + offset + field->offset, &value, sizeof value);
            }
        }
    }
};

}  // namespace overturn::testing
