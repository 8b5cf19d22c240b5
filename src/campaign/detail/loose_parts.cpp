#include "campaign/detail/loose_parts.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "body/joints.hpp"
#include "body/parts.hpp"

namespace overturn {
namespace {

// The ground that falls by an angle helps the acceleration: a limit tan(x) is tan(x - slope) towards the valley.
double on_slope(double limit, double slope_rad) { return std::tan(std::atan(limit) - std::abs(slope_rad)); }

std::string numbers(std::vector<std::size_t> const& parts) {
    std::vector<std::size_t> from_one;
    std::ranges::transform(parts, std::back_inserter(from_one), [](std::size_t part) { return part + 1; });
    return fmt::format("part{} {}", parts.size() > 1 ? "s" : "", fmt::join(from_one, " and "));
}

// The foot of what stands there, if it is round: as a body of its own it rolls under two components.
char const* base_of(Joint const& joint, std::vector<BodyPart> const& parts) {
    bool const is_round = std::ranges::any_of(joint.parts, [&](std::size_t place) {
        auto const* const cylinder = std::get_if<Cylinder>(&parts[place]);
        return cylinder != nullptr && cylinder->radius_m == joint.half_width_m;
    });
    return is_round ? ", base = {shape = \"round\"}" : "";
}

}  // namespace

std::vector<std::string> loose_parts(BodySpec const& spec) {
    auto const& body = spec.body;
    double const tips = body.uplift_acceleration_mps2() / body.gravity_mps2();
    double const slides = spec.scatter.friction ? on_slope(spec.scatter.friction->highest(), body.slope_rad()) : tips;
    bool const whole_slides = slides < tips;
    double const whole = std::min(tips, slides);
    auto const& mass = spec.units.mass;
    auto const& length = spec.units.length;
    std::vector<std::string> lines;
    for (auto const& joint : joints_of(spec.parts)) {
        double const parts_at = on_slope(joint.parts_at(), body.slope_rad());
        if (joint.fastened || parts_at >= whole) {
            continue;
        }
        lines.push_back(fmt::format(
            "{} {} on the part below at {:.3g} g, before the whole body {} at {:.3g} g (all parts are computed as one "
            "body). State fastened = true if no motion is possible there; else add a body of the parts above: mass "
            "{:.4g} {}, base_width {:.4g} {}, centre_height {:.4g} {}{}",
            numbers(joint.parts),
            joint.parts.size() > 1 ? (joint.slides_first() ? "slide" : "tip")
                                   : (joint.slides_first() ? "slides" : "tips"),
            parts_at, whole_slides ? "slides" : "tips", whole, joint.mass_kg / mass.si, mass.symbol,
            2 * joint.half_width_m / length.si, length.symbol, joint.centre_above_m / length.si, length.symbol,
            base_of(joint, spec.parts)));
    }
    for (auto const place : without_joint(spec.parts)) {
        lines.push_back(fmt::format(
            "{} stands above the base, but no other part ends at its bottom: whether it tips or slides was not "
            "checked. Mend its bottom or their heights, or state fastened = true",
            numbers({place})));
    }
    return lines;
}

}  // namespace overturn
