#include "campaign/detail/friction_spec.hpp"

#include <fmt/format.h>

#include "campaign/detail/body_keys.hpp"
#include "campaign/scatter.hpp"

namespace overturn {

void read_friction(config::Table const& table, BodySpec& spec) {
    if (table.kind("friction") != config::Kind::table || looks_like_distribution(table.child(body_keys["friction"]))) {
        spec.scatter.friction = read_distribution(table, body_keys["friction"]);
        double const mu = spec.scatter.friction->centre();
        spec.friction = Friction{mu, mu};
        return;
    }
    auto const given = table.child(body_keys["friction"]);
    auto const held = read_distribution(given, friction_keys["static"]);
    if (given.has("kinetic_ratio")) {
        double const ratio = given.number(friction_keys["kinetic_ratio"]);
        spec.friction = Friction{held.centre(), ratio * held.centre()};
    } else if (held.scatters()) {
        given.fail("static", "scatters (a fixed kinetic value would not follow it). State kinetic_ratio");
    } else {
        spec.friction = Friction{held.centre(), given.number(friction_keys["kinetic"])};
    }
    given.finish();
    if (spec.friction->kinetic_coefficient > spec.friction->static_coefficient) {
        given.fail("kinetic",
                   fmt::format("{} above static {} (a sliding base would hold better than a resting one). Swap them?",
                               spec.friction->kinetic_coefficient, spec.friction->static_coefficient));
    }
    spec.scatter.friction = held;
}

}  // namespace overturn
