#include "campaign/detail/parts_spec.hpp"

#include <array>
#include <variant>

#include <fmt/format.h>

namespace overturn {

using config::Range;
using config::Table;

namespace {

constexpr std::array<config::Word, 3> part_kinds{{{"cylinder", "upright, solid"},
                                                  {"box", "upright, solid, as deep as wide"},
                                                  {"point", "without inertia of its own"}}};
constexpr config::Keys part_keys{
    config::word_key<part_kinds>("kind", "kind of the part"),
    config::number_key("mass", Dimension::mass, Range::positive(), "mass"),
    config::number_key("diameter", Dimension::length, Range::positive(), "diameter").only("kind = cylinder"),
    config::number_key("width", Dimension::length, Range::positive(), "width").only("kind = box"),
    config::number_key("height", Dimension::length, Range::not_negative(),
                       "height of the part; of a point: its height above the ground"),
    config::number_key("bottom", Dimension::length, Range::not_negative(), "height of the bottom above the ground")
        .otherwise(0)
        .only("kind = cylinder or box"),
    config::boolean_key(
        "fastened", "true: fastened to the part below; false: plan warns if it tips or slides before the whole body")
        .otherwise(false)
        .only("kind = cylinder or box"),
    config::number_key("friction", Dimension::none, Range::not_negative(),
                       "static coefficient of friction on the part below")
        .optional()
        .only("kind = cylinder or box")};

}  // namespace

constinit config::KeyTable const part_table{.meaning = "one part of a body, on its axis", .keys = part_keys.all};

std::vector<BodyPart> read_parts(Table const& table) {
    std::vector<BodyPart> parts;
    auto const standing = [](Table const& entry) {
        return Standing{.fastened = entry.boolean(part_keys["fastened"]),
                        .friction = entry.maybe_number(part_keys["friction"])};
    };
    config::Given const solid{.range = Range::positive()};
    for (auto const& entry : table.children("parts")) {
        auto const kind = entry.text(part_keys["kind"]);
        double const mass = entry.number(part_keys["mass"]);
        if (kind == "cylinder") {
            parts.emplace_back(Cylinder{.mass_kg = mass,
                                        .radius_m = 0.5 * entry.number(part_keys["diameter"]),
                                        .height_m = entry.number(part_keys["height"], solid),
                                        .bottom_height_m = entry.number(part_keys["bottom"]),
                                        .standing = standing(entry)});
        } else if (kind == "box") {
            parts.emplace_back(Box{.mass_kg = mass,
                                   .width_m = entry.number(part_keys["width"]),
                                   .height_m = entry.number(part_keys["height"], solid),
                                   .bottom_height_m = entry.number(part_keys["bottom"]),
                                   .standing = standing(entry)});
        } else if (kind == "point") {
            parts.emplace_back(PointMass{.mass_kg = mass, .height_m = entry.number(part_keys["height"])});
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
