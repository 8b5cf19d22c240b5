#include "campaign/body_spec.hpp"

#include <array>
#include <cmath>
#include <variant>

#include <gsl/gsl_randist.h>

#include "body/parts.hpp"
#include "body/similarity.hpp"
#include "core/random_stream.hpp"

namespace overturn {
namespace {

using config::Kind;
using config::Range;
using config::Table;

std::vector<Part> read_parts(Table const& table) {
    std::vector<Part> parts;
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

BodyInput read_shape(Table const& table) {
    double const width = table.number("base_width", Dimension::length, Range::positive());
    if (table.has("parts")) {
        return table.located("parts", [&] { return assemble(read_parts(table), width); });
    }
    BodyInput input;
    input.half_width_m = 0.5 * width;
    input.mass_kg = table.number("mass", Dimension::mass, Range::positive());
    input.centre_height_m = table.number("centre_height", Dimension::length, Range::positive());
    if (table.kind("inertia") == Kind::text && table.text("inertia") == "uniform-block") {
        double const b = input.half_width_m;
        double const h = input.centre_height_m;
        input.inertia_kgm2 = input.mass_kg * (b * b + h * h) / 3;
    } else {
        input.inertia_kgm2 = table.number("inertia", Dimension::inertia, Range::positive());
    }
    return input;
}

// similarity = { direction = "to-model" | "to-prototype", length = 0.4, ... }
BodyInput read_similarity(Table const& table, BodyInput const& input) {
    if (!table.has("similarity")) {
        return input;
    }
    auto const given = table.child("similarity");
    SimilarityLaw law;
    law.length = given.number("length", Dimension::none, Range::positive(), law.length);
    law.mass_factor = given.number("mass_factor", Dimension::none, Range::positive(), law.mass_factor);
    static constexpr std::array directions{config::Entry<bool>{"to-model", "the keys describe the prototype", true},
                                           config::Entry<bool>{"to-prototype", "the keys describe the model", false}};
    bool const to_model = given.choice<bool>("direction", directions);
    given.finish();
    return to_model ? model_of(input, law) : prototype_of(input, law);
}

std::optional<Friction> read_friction(Table const& table) {
    if (!table.has("friction")) {
        return std::nullopt;
    }
    if (table.kind("friction") != Kind::table) {
        double const mu = table.number("friction", Dimension::none, Range::not_negative());
        return Friction{mu, mu};
    }
    auto const given = table.child("friction");
    Friction const friction{given.number("static", Dimension::none, Range::not_negative()),
                            given.number("kinetic", Dimension::none, Range::not_negative())};
    given.finish();
    if (friction.kinetic_coefficient > friction.static_coefficient) {
        given.fail("kinetic",
                   fmt::format("{} above static {} (a sliding base would hold better than a resting one). Swap them?",
                               friction.kinetic_coefficient, friction.static_coefficient));
    }
    return friction;
}

std::optional<RestitutionScatter> read_restitution(Table const& table, BodyInput& input) {
    switch (table.kind("restitution")) {
        case Kind::absent:
            return std::nullopt;
        case Kind::text:
            if (auto const word = table.text("restitution"); word != "housner") {
                table.fail("restitution",
                           fmt::format("'{}' (unknown). Write a number, \"housner\" or a distribution", word));
            }
            return std::nullopt;
        case Kind::table:
            break;
        default:
            input.restitution = table.number("restitution", Dimension::none, Range::between(0, 1));
            return std::nullopt;
    }
    auto const given = table.child("restitution");
    if (auto const kind = given.text("distribution"); kind != "lognormal") {
        given.fail("distribution", fmt::format("'{}' (unknown). Use lognormal", kind));
    }
    RestitutionScatter const scatter{given.number("median", Dimension::none, {.low = 0, .high = 1, .low_open = true}),
                                     given.number("beta", Dimension::none, {.low = 0, .high = 2})};
    given.finish();
    input.restitution = scatter.median;
    return scatter;
}

void require_no_jamming(Table const& table, Friction const& friction, RigidBody const& body) {
    double const bound = painleve_bound(body.inertia_ratio());
    if (friction.static_coefficient >= bound) {
        table.fail("friction",
                   fmt::format("{} (from {:.4f} up a slipping corner may jam, Painleve's paradox, and rigid "
                               "sliding has no answer). Lower it, or leave it out: no slip",
                               friction.static_coefficient, bound));
    }
}

BodySpec build(Table const& table, std::string name) {
    auto input = read_similarity(table, read_shape(table));
    input.gravity_mps2 = table.number("gravity", Dimension::acceleration, Range::positive(), g0);
    auto const scatter = read_restitution(table, input);
    auto const friction = read_friction(table);
    table.finish();
    auto body = table.located("", [&] { return RigidBody(input); });
    if (friction) {
        require_no_jamming(table, *friction, body);
    }
    return {std::move(name), input, body, friction, scatter};
}

}  // namespace

BodySpec read_body(Table const& table, InputFiles& files) {
    if (!table.has("file")) {
        return build(table, table.text("name", "body"));
    }
    auto const file = table.text("file");
    auto const name = table.text("name", "");
    auto const inner =
        Table::parse(table.located("file", [&]() -> std::string const& { return files.read(file); }), file);
    auto spec = build(inner, inner.text("name", "body"));
    if (!name.empty()) {
        spec.name = name;
    }
    // What stands beside `file` outranks the file.
    if (table.has("restitution")) {
        spec.input.restitution.reset();
        spec.restitution_scatter = read_restitution(table, spec.input);
        spec.body = table.located("restitution", [&] { return RigidBody(spec.input); });
    }
    if (auto const friction = read_friction(table)) {
        require_no_jamming(table, *friction, spec.body);
        spec.friction = friction;
    }
    table.finish();
    return spec;
}

RigidBody BodySpec::for_wave(std::uint64_t seed, std::uint64_t wave, std::uint64_t index) const {
    if (!restitution_scatter) {
        return body;
    }
    RandomStream stream(seed, wave, Purpose::restitution_scatter, index);
    auto drawn = input;
    do {
        drawn.restitution =
            restitution_scatter->median * std::exp(gsl_ran_gaussian_ziggurat(stream.gsl(), restitution_scatter->beta));
    } while (*drawn.restitution > 1);
    return RigidBody(drawn);
}

}  // namespace overturn
