#include "campaign/detail/parts_spec.hpp"

#include <variant>

#include <fmt/format.h>

namespace overturn {

using config::Range;
using config::Table;

std::vector<BodyPart> read_parts(Table const& table) {
    std::vector<BodyPart> parts;
    for (auto const& entry : table.children("parts")) {
        auto const kind = entry.text("kind");
        double const mass = entry.number("mass", Dimension::mass, Range::positive());
        if (kind == "cylinder") {
            parts.emplace_back(
                Cylinder{.mass_kg = mass,
                         .radius_m = 0.5 * entry.number("diameter", Dimension::length, Range::positive()),
                         .height_m = entry.number("height", Dimension::length, Range::positive()),
                         .bottom_height_m = entry.number("bottom", Dimension::length, Range::not_negative(), 0)});
        } else if (kind == "box") {
            parts.emplace_back(
                Box{.mass_kg = mass,
                    .width_m = entry.number("width", Dimension::length, Range::positive()),
                    .height_m = entry.number("height", Dimension::length, Range::positive()),
                    .bottom_height_m = entry.number("bottom", Dimension::length, Range::not_negative(), 0)});
        } else if (kind == "point") {
            parts.emplace_back(PointMass{.mass_kg = mass,
                                         .height_m = entry.number("height", Dimension::length, Range::not_negative())});
        } else {
            entry.fail("kind", fmt::format("'{}' (unknown part). Use cylinder, box or point", kind));
        }
        entry.finish();
    }
    return parts;
}

std::vector<BodyPart> with_lengths(std::vector<BodyPart> parts, double factor) {
    for (auto& part : parts) {
        if (auto* const cylinder = std::get_if<Cylinder>(&part)) {
            cylinder->radius_m *= factor;
            cylinder->height_m *= factor;
            cylinder->bottom_height_m *= factor;
        } else if (auto* const box = std::get_if<Box>(&part)) {
            box->width_m *= factor;
            box->height_m *= factor;
            box->bottom_height_m *= factor;
        } else {
            std::get<PointMass>(part).height_m *= factor;
        }
    }
    return parts;
}

}  // namespace overturn
