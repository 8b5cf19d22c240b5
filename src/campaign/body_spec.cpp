#include "campaign/body_spec.hpp"

#include <algorithm>
#include <array>
#include <variant>

#include <gsl/gsl_cdf.h>

#include "campaign/detail/body_keys.hpp"
#include "campaign/detail/footing_spec.hpp"
#include "campaign/detail/friction_spec.hpp"
#include "campaign/detail/gyration.hpp"
#include "campaign/detail/parts_spec.hpp"
#include "campaign/detail/placement_spec.hpp"
#include "config/faults.hpp"

namespace overturn {
namespace {

using config::Kind;
using config::Table;

BodyInput read_shape(Table const& table, std::vector<BodyPart>& parts) {
    table.may_have(bodies_table);
    double const width = table.number(body_keys["base_width"]);
    if (table.has("parts")) {
        parts = read_parts(table);
        return table.located("parts", [&] { return assemble(parts, width); });
    }
    BodyInput input;
    input.half_width_m = 0.5 * width;
    input.mass_kg = read_distribution(table, body_keys["mass"]).centre();
    input.centre_height_m = read_distribution(table, body_keys["centre_height"]).centre();
    auto const spelled = table.kind("inertia") == Kind::text ? table.text(body_keys["inertia"]) : std::string();
    bool const word = !spelled.empty() && spelled.find_first_of("0123456789") == std::string::npos;
    if (word && spelled != uniform_block) {
        table.fail("inertia", fmt::format("'{}' (neither a quantity nor '{}'). Write for example \"150 t m2\", or "
                                          "\"{}\" for m (b^2 + h^2) / 3",
                                          spelled, uniform_block, uniform_block));
    }
    if (word) {
        double const b = input.half_width_m;
        double const h = input.centre_height_m;
        input.inertia_kgm2 = input.mass_kg * (b * b + h * h) / 3;
    } else {
        if (!table.has("inertia")) {
            table.fail_missing("inertia",
                               fmt::format("State a quantity, or \"{}\" for m (b^2 + h^2) / 3", uniform_block));
        }
        input.inertia_kgm2 = table.number(body_keys["inertia"]);
    }
    return input;
}

// similarity = { direction = "to-model" | "to-prototype", length = 0.4, ... }
std::optional<Scaling> read_scaling(Table const& table) {
    if (!table.has("similarity")) {
        return std::nullopt;
    }
    auto const given = table.child(body_keys["similarity"]);
    Scaling scaling;
    auto& law = scaling.law;
    law.length = given.number(similarity_keys["length"]);
    law.mass_factor = given.number(similarity_keys["mass_factor"]);
    scaling.to_model = given.choice<bool>(similarity_keys["direction"], scaling_directions);
    given.finish();
    return scaling;
}

// Of a polygon its corners and points say how it lands: where Housner has no answer none is needed.
BodyInput as_it_lands(BodyInput stated, Footing const& footing) {
    if (footing.base.shape == BaseShape::polygon && !stated.restitution) {
        auto squat = stated;
        squat.restitution = 0;
        if (RigidBody(squat).housner_restitution() < 0) {
            return squat;
        }
    }
    return stated;
}

RigidBody scaled(BodyInput const& stated, std::optional<Scaling> const& scaling) {
    if (!scaling) {
        return RigidBody(stated);
    }
    return RigidBody(scaling->to_model ? model_of(stated, scaling->law) : prototype_of(stated, scaling->law));
}

double length_factor(std::optional<Scaling> const& scaling) {
    return !scaling ? 1 : scaling->to_model ? scaling->law.length : 1 / scaling->law.length;
}

void set_mass(BodyInput& stated, double mass_kg) {
    stated.inertia_kgm2 *= mass_kg / stated.mass_kg;
    stated.mass_kg = mass_kg;
}

void read_restitution(Table const& table, BodySpec& spec) {
    spec.stated.restitution.reset();
    spec.scatter.restitution.reset();
    if (table.kind("restitution") == Kind::text) {
        if (auto const word = table.text(body_keys["restitution"]); word != "housner") {
            table.fail("restitution",
                       fmt::format("'{}' (unknown). Write a number, \"housner\" or a distribution", word));
        }
        return;
    }
    spec.scatter.restitution = read_distribution(table, body_keys["restitution"]);
    spec.stated.restitution = spec.scatter.restitution->centre();
}

constexpr double no_surface = 2;  // grips so

// Every draw must be a body that cannot jam.
void validate_draws(Table const& table, BodySpec const& spec) {
    auto const& height = spec.scatter.centre_height;
    auto stated = spec.stated;
    for (double const drawn :
         {height ? height->lowest() : stated.centre_height_m, height ? height->highest() : stated.centre_height_m}) {
        stated.centre_height_m = drawn;
        auto const body = table.located(height ? "centre_height" : "",
                                        [&] { return scaled(as_it_lands(stated, spec.stated_footing), spec.scaling); });
        double const bound = painleve_bound(std::max(body.corner(1).inertia_ratio, body.corner(-1).inertia_ratio));
        auto const& friction = spec.scatter.friction;
        if (friction && friction->highest() >= bound) {
            table.fail("friction",
                       fmt::format("{:.6g} (from {:.6g} up a slipping corner may jam, Painleve's paradox, and rigid "
                                   "sliding has no answer{}). Lower it{}{}, or leave it out: no slip",
                                   friction->highest(), bound, inertia_text(body),
                                   friction->scatters() ? " by its key high" : "",
                                   friction->centre() > no_surface ? " (a coefficient: 0.5 for 50 %)" : ""));
        }
    }
}

// The keys that outrank what the body's parts or file say.
void read_uncertain(Table const& table, BodySpec& spec, bool before_format_5) {
    if (table.kind("mass") == Kind::table) {
        spec.scatter.mass = read_distribution(table, body_keys["mass"]);
        set_mass(spec.stated, spec.scatter.mass->centre());
    }
    if (table.kind("centre_height") == Kind::table) {
        spec.scatter.centre_height = read_distribution(table, body_keys["centre_height"]);
        spec.stated.centre_height_m = spec.scatter.centre_height->centre();
    }
    if (table.has("restitution")) {
        read_restitution(table, spec);
    }
    if (table.has("friction")) {
        read_friction(table, spec);
    }
    read_placement(table, spec);
    read_footing(table, spec.stated_footing, before_format_5);
    spec.axes = static_cast<int>(table.integer(body_keys["axes"], {.otherwise = spec.axes}));
    table.finish();
}

// Only when all is read does it stand: a squat body has no restitution of Housner's to fall back on.
void settle(Table const& table, BodySpec& spec) {
    spec.body = table.located("", [&] { return scaled(as_it_lands(spec.stated, spec.stated_footing), spec.scaling); });
    validate_draws(table, spec);
    validate_placement(table, spec);
    settle_footing(table, spec);
}

BodySpec read_stated(Table const& table, std::string name, bool before_format_5) {
    std::vector<BodyPart> parts;
    auto stated = read_shape(table, parts);
    stated.gravity_mps2 = table.number(body_keys["gravity"]);
    auto const scaling = read_scaling(table);
    constexpr double any = 0.5;
    auto unsettled = stated;
    unsettled.restitution = any;
    auto const body = table.located("", [&] { return scaled(unsettled, scaling); });
    if (auto const excess = gyration_excess(body); !excess.empty() && table.has("inertia")) {
        table.fail("inertia", excess);
    }
    BodySpec spec{std::move(name), stated, scaling, body, {}, {}, 3, {}, {}, {}};
    spec.parts = with_lengths(std::move(parts), length_factor(scaling));
    spec.stated_footing.base.points = usual_points_across(before_format_5);
    read_uncertain(table, spec, before_format_5);
    return spec;
}

constexpr std::array quantities{
    std::pair{"mass", &BodyScatter::mass}, std::pair{"centre_height", &BodyScatter::centre_height},
    std::pair{"restitution", &BodyScatter::restitution}, std::pair{"friction", &BodyScatter::friction}};

bool scatters(std::optional<Distribution> const& quantity) { return quantity && quantity->scatters(); }

double drawn(std::optional<Distribution> const& quantity, DrawnFor const& wave, Purpose purpose, std::uint64_t index) {
    return quantity->scatters() ? quantity->quantile(uniform_for(wave, purpose, index)) : quantity->centre();
}

using Values = std::array<std::optional<double>, quantities.size()>;  // in their order; empty: as stated

DrawnBody with(BodySpec const& spec, Values const& values) {
    auto const& [mass, centre_height, restitution, static_friction] = values;
    DrawnBody one{spec.body, spec.friction};
    auto input = spec.stated;
    if (mass) {
        set_mass(input, *mass);
    }
    input.centre_height_m = centre_height.value_or(input.centre_height_m);
    if (restitution) {
        input.restitution = restitution;
    }
    one.body = scaled(as_it_lands(input, spec.stated_footing), spec.scaling);
    if (scatters(spec.scatter.friction)) {
        double const ratio = spec.friction->kinetic_coefficient / spec.friction->static_coefficient;
        one.friction = Friction{*static_friction, *static_friction * ratio};
    }
    return one;
}

}  // namespace

BodySpec read_body(Table const& table, InputFiles& files) {
    bool const old = files.are_before_format_5();
    if (!table.has("file")) {
        auto spec = read_stated(table, table.text(body_keys["name"], "body"), old);
        settle(table, spec);
        return spec;
    }
    auto const file = table.text(bodies_keys["file"]);
    auto const name = table.text(body_keys["name"]);
    auto const inner =
        table.named_document(table.located("file", [&]() -> std::string const& { return files.read(file); }), file);
    table.located("file", [&] {
        validate(!inner.has("waves") || inner.has("base_width"),
                 "'{}' (a campaign: it states waves, and no base_width). Name a body's file", file);
    });
    auto spec = config::with_all_faults(inner, [&] {
        auto stated = read_stated(inner, inner.text(body_keys["name"], "body"), old);
        if (!table.has("restitution") && !table.has("base") && !table.has("pad")) {
            settle(inner, stated);  // faults of the file alone are reported there
        }
        return stated;
    });
    if (!name.empty()) {
        spec.name = name;
    }
    read_uncertain(table, spec, old);
    settle(table, spec);
    return spec;
}

std::vector<std::string> BodySpec::scattering() const {
    std::vector<std::string> keys;
    for (auto const& [key, quantity] : quantities) {
        if (scatters(scatter.*quantity)) {
            keys.emplace_back(key);
        }
    }
    return keys;
}

std::vector<double> BodySpec::scores(DrawnBody const& drawn) const {
    // As stated, that is before the similarity law, which multiplies; in the order of `quantities`.
    std::array const values{stated.mass_kg * (drawn.body.mass_kg() / body.mass_kg()),
                            stated.centre_height_m * (drawn.body.centre_height_m() / body.centre_height_m()),
                            drawn.body.restitution(), drawn.friction ? drawn.friction->static_coefficient : 0};
    std::vector<double> scores;
    for (std::size_t k = 0; k < quantities.size(); ++k) {
        if (auto const& quantity = scatter.*quantities[k].second; scatters(quantity)) {
            scores.push_back(quantity->score(values[k]));
        }
    }
    return scores;
}

DrawnBody BodySpec::for_wave(DrawnFor const& wave, std::uint64_t index) const {
    std::array const streams{
        std::pair{Purpose::body_scatter, 2 * index}, std::pair{Purpose::body_scatter, 2 * index + 1},
        std::pair{Purpose::restitution_scatter, index}, std::pair{Purpose::friction_scatter, index}};
    Values values;
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (auto const& quantity = scatter.*quantities[k].second) {
            values[k] = drawn(quantity, wave, streams[k].first, streams[k].second);
        }
    }
    return with(*this, values);
}

DrawnBody BodySpec::at_scores(std::span<double const> scores) const {
    constexpr double least = 0x1p-53;
    Values values;
    std::size_t taken = 0;
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (auto const& quantity = scatter.*quantities[k].second) {
            values[k] = scatters(quantity)
                            ? quantity->quantile(std::clamp(gsl_cdf_ugaussian_P(scores[taken++]), least, 1 - least))
                            : quantity->centre();
        }
    }
    return with(*this, values);
}

bool BodySpec::draws_alpha() const {
    auto const count = scattering().size();
    auto const alpha_rad = [&](double score) { return at_scores(std::vector<double>(count, score)).body.alpha_rad(); };
    return count > 0 && alpha_rad(-1) != alpha_rad(1);
}

std::vector<std::string> names_of(std::span<BodySpec const> bodies) {
    std::vector<std::string> names;
    std::ranges::transform(bodies, std::back_inserter(names), &BodySpec::name);
    return names;
}

}  // namespace overturn
