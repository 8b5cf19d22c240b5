#include "cli/report_bodies.hpp"

#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "body/parts.hpp"
#include "cli/json_values.hpp"

namespace overturn::cli {
namespace {

constexpr double degree = pi / 180;

std::string placement_of(BodySpec const& spec) {
    auto const& body = spec.body;
    std::vector<std::string> remarks;
    if (body.slope_rad() != 0) {
        remarks.push_back(fmt::format("on ground that falls by {:.3g}° towards +x", body.slope_rad() / degree));
    }
    if (body.offset_m() != 0) {
        remarks.push_back(fmt::format("its centre {:.3g} {} off the base's middle, towards +x",
                                      body.offset_m() / spec.units.length.si, spec.units.length.symbol));
    }
    if (body.initial_tilt_rad() != 0) {
        remarks.push_back(fmt::format("let go at {:.3g}°", body.initial_tilt_rad() / degree));
    }
    auto text = fmt::format("{}: {}.", spec.name, fmt::join(remarks, "; "));
    if (body.lopsided()) {
        text += fmt::format(
            " It tips at {:.4g}° towards +x and at {:.4g}° towards -x; what the table says is of the weaker side.",
            body.corner(1).alpha_rad / degree, body.corner(-1).alpha_rad / degree);
    }
    return text;
}

}  // namespace

Json outlines_of(CampaignSpec const& spec) {
    auto all = Json::object();
    for (auto const& body : spec.bodies) {
        auto& parts = all[body.name] = Json::array();
        for (auto const& part : body.parts) {
            if (auto const* const cylinder = std::get_if<Cylinder>(&part)) {
                parts.push_back({2 * cylinder->radius_m, cylinder->height_m, cylinder->bottom_height_m});
            } else if (auto const* const box = std::get_if<Box>(&part)) {
                parts.push_back({box->width_m, box->height_m, box->bottom_height_m});
            } else {
                parts.push_back({0, 0, std::get<PointMass>(part).height_m});
            }
        }
    }
    return all;
}

Json placements_of(CampaignSpec const& spec) {
    auto lines = Json::array();
    for (auto const& body : spec.bodies) {
        if (body.body.needs_planar_rocking()) {
            lines.push_back(placement_of(body));
        }
    }
    return lines;
}

}  // namespace overturn::cli
