#include "campaign/detail/loose_parts.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "body/joints.hpp"
#include "body/parts.hpp"
#include "core/outward.hpp"

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

// "parts 1 and 2 slide"
std::string moving(Joint const& joint) {
    bool const several = joint.parts.size() > 1;
    return numbers(joint.parts)
           + (joint.slides_first() ? (several ? " slide" : " slides") : (several ? " tip" : " tips"));
}

// At which acceleration of the ground over gravity the whole body moves, and how.
struct WholeBody {
    double moves_at = 0;
    bool slides = false;

    explicit WholeBody(BodySpec const& spec) {
        auto const& body = spec.body;
        double const tips_at = body.uplift_acceleration_mps2() / body.gravity_mps2();
        double const slides_at =
            spec.scatter.friction ? on_slope(spec.scatter.friction->highest(), body.slope_rad()) : tips_at;
        slides = slides_at < tips_at;
        moves_at = std::min(tips_at, slides_at);
    }
};

struct LooseJoint {
    Joint joint;
    double parts_at = 0;  // over gravity
    bool first = false;   // before the whole body moves
};

// A body that slides takes no more of the ground's acceleration than its friction: what parts above that stays whole.
std::vector<LooseJoint> loose_joints(BodySpec const& spec) {
    WholeBody const whole(spec);
    std::vector<LooseJoint> loose;
    for (auto const& joint : joints_of(spec.parts)) {
        double const parts_at = on_slope(joint.parts_at(), spec.body.slope_rad());
        bool const first = parts_at < whole.moves_at;
        if (!joint.fastened && (first || !whole.slides)) {
            loose.push_back({joint, parts_at, first});
        }
    }
    return loose;
}

}  // namespace

std::vector<std::string> loose_parts(BodySpec const& spec) {
    WholeBody const whole(spec);
    auto const& mass = spec.units.mass;
    auto const& length = spec.units.length;
    std::vector<std::string> lines;
    for (auto const& [joint, parts_at, first] : loose_joints(spec)) {
        if (!first) {
            continue;
        }
        lines.push_back(fmt::format(
            "{} on the part below at {:.3g} g, before the whole body {} at {:.3g} g (all parts are computed as one "
            "body). State fastened = true if no motion is possible there; else add a body of the parts above: mass "
            "{:.4g} {}, base_width {:.4g} {}, centre_height {:.4g} {}{}",
            moving(joint), parts_at, whole.slides ? "slides" : "tips", whole.moves_at, joint.mass_kg / mass.si,
            mass.symbol, 2 * joint.half_width_m / length.si, length.symbol, joint.centre_above_m / length.si,
            length.symbol, base_of(joint, spec.parts)));
    }
    for (auto const place : without_joint(spec.parts)) {
        lines.push_back(fmt::format(
            "{} stands above the base, but no other part ends at its bottom: whether it tips or slides was not "
            "checked. Mend its bottom or their heights, or state fastened = true",
            numbers({place})));
    }
    return lines;
}

std::vector<std::string> loose_parts_in_short(BodySpec const& spec, std::optional<double> reached_mps2) {
    std::vector<std::string> lines;
    for (auto const& [joint, parts_at, first] : loose_joints(spec)) {
        if (!reached_mps2 || parts_at * spec.body.gravity_mps2() < *reached_mps2) {
            auto const at = rounded_down(parts_at);
            lines.push_back(
                (first ? fmt::format("{} on the part below at {:.3g} g", moving(joint), at)
                       : fmt::format("whether {} on the part below as the body rocks was not checked (at rest: at "
                                     "{:.3g} g)",
                                     moving(joint), at))
                + fmt::format(": these numbers hold only if {} fastened",
                              joint.parts.size() > 1 ? "they are" : "it is"));
        }
    }
    for (auto const place : without_joint(spec.parts)) {
        lines.push_back(fmt::format(
            "whether {} tips or slides was not checked: these numbers hold only if it is fastened", numbers({place})));
    }
    return lines;
}

}  // namespace overturn
