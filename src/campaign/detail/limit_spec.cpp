#include "campaign/detail/limit_spec.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "config/suggestion.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "response/registry.hpp"

namespace overturn {
namespace {

using config::Table;

std::vector<config::Word> quantity_words() {
    std::vector<config::Word> words;
    for (auto const& quantity : limit_quantities()) {
        words.push_back({quantity.name, quantity.description});
    }
    return words;
}

enum class Falls { pass, excluded };

constexpr std::array fall_kinds{
    config::Entry<Falls>{"passes", "a trial that overturned exceeds the limit", Falls::pass},
    config::Entry<Falls>{"excluded", "its response up to overturning is compared", Falls::excluded}};

constexpr config::Range half_widths{.low = 0, .high = 0.5, .low_open = true};
constexpr config::Keys precision_keys{
    config::number_key("target_half_width", Dimension::none, half_widths,
                       "half width of the interval of every P at which the run stops")
        .optional(),
    config::number_key("target_median_half_width", Dimension::none, half_widths,
                       "half width of the interval of the median, over the median, at which the run stops")
        .optional()};
constexpr config::Keys limit_keys{
    config::text_key("name", "name of the limit state"),
    config::word_key("quantity", &quantity_words, "stored response that is compared with the limit")
        .only("there is no any and no all"),
    config::number_key("above", Dimension::none, config::Range::not_negative(), "limit: exceeded by larger values")
        .in_unit_of("quantity")
        .only("quantity is stated, and no below"),
    config::number_key("below", Dimension::none, config::Range::positive(), "limit: exceeded by smaller values")
        .in_unit_of("quantity")
        .only("quantity is stated, and no above"),
    config::word_key<fall_kinds>("overturned", "how a trial that overturned is counted")
        .otherwise("passes")
        .only("quantity is stated"),
    config::texts_key("any", "earlier limit states: exceeded if any of them is exceeded")
        .only("there is no quantity and no all"),
    config::texts_key("all", "earlier limit states: exceeded if all of them are exceeded")
        .only("there is no quantity and no any")};

PrecisionTarget read_target(Table const& table, WavesOfLevels waves, PrecisionTarget target) {
    for (auto const& [described, value] :
         {std::pair{precision_keys["target_half_width"], &target.half_width},
          std::pair{precision_keys["target_median_half_width"], &target.median_half_width}}) {
        auto const key = described.name;
        if (!table.has(key)) {
            continue;
        }
        *value = table.number(described);
        if (waves == WavesOfLevels::grid) {
            table.fail(key,
                       "of a grid of frequencies (it is no sample, so that no probability gets more precise). "
                       "Leave it out");
        }
        if (waves == WavesOfLevels::independent) {
            table.fail(key,
                       "beside independent waves (they come level by level, so that the first ones are of the "
                       "lowest level only). Use levels.waves = 'shared'");
        }
    }
    return target;
}

std::string read_name(Table const& table, std::span<LimitState const> before) {
    auto name = table.text(limit_keys["name"]);
    if (name.empty() || name == "." || name == ".." || name.find('/') != std::string::npos) {
        table.fail("name", fmt::format("'{}' (names a group of the results file). Choose another, without '/'", name));
    }
    if (auto const found = std::ranges::find(before, name, &LimitState::name); found != before.end()) {
        bool const of_the_site = found->quantity.is_signed && found->threshold == 0;  // others are below more than 0
        table.fail("name", fmt::format("'{}' {} (names of limit states must differ). Rename it", name,
                                       found->is_overturning() ? "is always there"
                                       : of_the_site           ? "comes with [site]"
                                                               : "twice"));
    }
    return name;
}

LimitQuantity read_quantity(Table const& table) {
    auto const name = table.text(limit_keys["quantity"]);
    auto const all = limit_quantities();
    auto const found = std::ranges::find(all, name, &LimitQuantity::name);
    if (found == all.end()) {
        std::vector<std::string> names;
        std::ranges::transform(all, std::back_inserter(names), &LimitQuantity::name);
        table.fail("quantity", fmt::format("'{}' (no stored response that a limit can be set to). {}", name,
                                           config::suggestion(name, names)));
    }
    return *found;
}

Dimension dimension_of(LimitQuantity const& quantity) {
    static constexpr std::array dimensions{Dimension::length, Dimension::angle, Dimension::velocity};
    auto const* const found =
        std::ranges::find_if(dimensions, [&](Dimension dimension) { return si_symbol(dimension) == quantity.units; });
    return found == dimensions.end() ? Dimension::none : *found;
}

bool may_run(ModelTraits const& model, EffectRequest const& effects) {
    return (model.brings() & effects.wanted()) != 0;
}

// Will some model that may run know the quantity?
bool is_computed(LimitQuantity const& quantity, EffectRequest const& effects) {
    if (quantity.of_every_model) {
        return holds_all(effects.wanted(), quantity.needs);
    }
    return std::ranges::any_of(models(), [&](ModelEntry const& model) {
        auto const& fields = model.traits().fields;
        return may_run(model.traits(), effects)
               && std::ranges::find(fields, quantity.name, &Field::name) != fields.end();
    });
}

// A quantity that only some effects give: they are simulated in every trial, or the limit is refused.
void call_for(Table const& table, LimitQuantity const& quantity, EffectRequest& effects) {
    if (is_computed(quantity, effects)) {
        if (effects.mode == EffectMode::automatic && !quantity.of_every_model) {
            effects.include |= quantity.needs | mask_of(Effect::sliding);  // points slip one by one
        }
        return;
    }
    table.fail("quantity", fmt::format("'{}' needs the effect {} (no selected model computes it). Add it to "
                                       "effects.include, or remove [effects]: auto includes what a limit needs",
                                       quantity.name, names_of_effects(quantity.needs)));
}

// Units of what is stated nowhere else: angular velocities, energies over the mass.
struct OwnUnit {
    std::string_view symbol;
    double si;
};
constexpr std::array spin_units{OwnUnit{"rad/s", 1}, OwnUnit{"deg/s", pi / 180}};
constexpr std::array energy_units{OwnUnit{"J/kg", 1}, OwnUnit{"kJ/t", 1}};

// Empty: its unit is one of the others.
std::span<OwnUnit const> own_units_of(LimitQuantity const& quantity) {
    using Units = std::span<OwnUnit const>;
    return quantity.units == "rad/s" ? Units(spin_units) : quantity.units == "J/kg" ? Units(energy_units) : Units();
}

double read_of_own_unit(Table const& table, config::Key const& key, std::span<OwnUnit const> units,
                        IntensityUnit& shown) {
    if (table.kind(key.name) != config::Kind::text) {
        return table.number(key);
    }
    auto const text = table.text(key.name);
    auto const blank = std::min(trimmed(text).find(' '), trimmed(text).size());
    auto const unit = trimmed(trimmed(text).substr(blank));
    auto const found = std::ranges::find(units, unit, &OwnUnit::symbol);
    double value = 0;
    if (!parse_number(trimmed(text).substr(0, blank), value) || found == units.end() || !key.range.holds(value)) {
        table.fail(key.name, fmt::format("'{}' (must be a number above 0 of {} or {}). Write for example \"1.5 {}\"",
                                         text, units[0].symbol, units[1].symbol, units[0].symbol));
    }
    shown = {std::string(unit), found->si};
    return value * shown.si;
}

void read_threshold(Table const& table, LimitState& limit, bool falls_pass, EffectRequest& effects) {
    limit.quantity = read_quantity(table);
    if (limit.quantity.is_of_the_fall() && table.has("overturned")) {
        table.fail("overturned", fmt::format("beside '{}' (which only bodies that overturned have). Leave it out",
                                             limit.quantity.name));
    }
    limit.falls_pass = limit.quantity.is_of_the_fall() ? false
                       : table.has("overturned")
                           ? table.choice<Falls>(limit_keys["overturned"], fall_kinds) == Falls::pass
                           : falls_pass;
    if (limit.quantity.is_signed && !table.has("below")) {
        table.fail("quantity",
                   fmt::format("'{}' above a value (it is a distance that is left). State below", limit.quantity.name));
    }
    auto const& key = table.has("below") ? limit_keys["below"] : limit_keys["above"];
    limit.rule = table.has("below") ? LimitState::Rule::below : LimitState::Rule::above;
    if (table.has("above") && table.has("below")) {
        table.fail("below", "stated beside above (one side fails). Keep one, or join two limits with any or all");
    }
    auto const dimension = dimension_of(limit.quantity);
    if (auto const units = own_units_of(limit.quantity); !units.empty()) {
        limit.threshold = read_of_own_unit(table, key, units, limit.shown);
        call_for(table, limit.quantity, effects);
        return;
    }
    limit.threshold = table.number(key, {.dimension = dimension});
    if (auto const unit = table.unit_at(key.name); !unit.empty()) {
        limit.shown = {unit, unit_factor(unit, dimension)};
    }
    call_for(table, limit.quantity, effects);
}

void read_parts(Table const& table, config::Key const& joined, LimitState& limit, std::span<LimitState const> before) {
    auto const key = joined.name;
    limit.rule = key == "any" ? LimitState::Rule::any : LimitState::Rule::all;
    for (auto const& name : table.texts(joined)) {
        auto const found = std::ranges::find(before, name, &LimitState::name);
        if (found == before.end()) {
            std::vector<std::string> names;
            std::ranges::transform(before, std::back_inserter(names), &LimitState::name);
            table.fail(key, fmt::format("'{}' (no limit state stated before this one). {}", name,
                                        config::suggestion(name, names)));
        }
        limit.of.push_back(found - before.begin());
    }
    if (limit.of.empty()) {
        table.fail(key, "empty (nothing to join). Name other limit states");
    }
}

LimitState read_limit(Table const& table, std::span<LimitState const> before, bool falls_pass, EffectRequest& effects) {
    LimitState limit;
    limit.name = read_name(table, before);
    std::vector<char const*> stated;
    std::ranges::copy_if(std::array{"quantity", "any", "all"}, std::back_inserter(stated),
                         [&](char const* key) { return table.has(key); });
    if (stated.size() != 1) {
        auto const what = stated.empty() ? std::string("none") : fmt::format("{}", fmt::join(stated, " and "));
        table.fail(stated.empty() ? "name" : stated.back(),
                   fmt::format("{} of quantity, any and all in '{}' (exactly one defines the limit). Write quantity = "
                               "\"peak_slip\", above = \"0.3 m\", or any = [...] of others",
                               what, limit.name));
    }
    if (table.has("quantity")) {
        read_threshold(table, limit, falls_pass, effects);
    } else {
        read_parts(table, table.has("any") ? limit_keys["any"] : limit_keys["all"], limit, before);
    }
    return limit;
}

}  // namespace

constinit config::KeyTable const precision_table{.meaning = "precision at which a run may stop",
                                                 .keys = precision_keys.all};
constinit config::KeyTable const limit_table{
    .meaning = "limit state besides overturning", .keys = limit_keys.all, .also = {&precision_table}};

std::vector<LimitState> read_limits(config::Table const& root, config::Table const& statistics, WavesOfLevels waves,
                                    bool falls_pass, Site const& site, EffectRequest& effects) {
    auto const common = read_target(statistics, waves, {});
    std::vector<LimitState> limits(1);
    limits.front().name = overturning_limit;
    limits.front().target = common;
    for (auto const& [name, quantity, there] : {std::tuple{touching_limit, "least_clearance", site.has_gaps()},
                                                std::tuple{leaving_limit, "edge_margin", site.has_edges()}}) {
        if (there) {
            auto& limit = limits.emplace_back();
            limit.name = name;
            limit.rule = LimitState::Rule::below;
            limit.quantity = *std::ranges::find(limit_quantities(), quantity, &LimitQuantity::name);
            limit.target = common;
        }
    }
    if (!root.has("limits")) {
        return limits;
    }
    for (auto const& table : root.children("limits")) {
        if (limits.size() == most_limits) {
            table.fail("name", fmt::format("more than {} limit states in one campaign. Split it", most_limits - 1));
        }
        auto limit = read_limit(table, limits, falls_pass, effects);
        bool const gap = limit.quantity.name == "least_clearance";
        if (limit.quantity.is_signed && !(gap ? site.has_gaps() : site.has_edges())) {
            table.fail("quantity", fmt::format("'{}' without {} in [site] (a distance to nothing). State one",
                                               limit.quantity.name, gap ? "cask or wall" : "edge"));
        }
        limit.target = read_target(table, waves, common);
        table.finish();
        limits.push_back(std::move(limit));
    }
    return limits;
}

std::string unreachable(LimitState const& limit, BodySpec const& body) {
    auto const& quantity = limit.quantity;
    if (has(quantity.needs, Effect::sliding) && quantity.of_every_model && !body.friction) {
        return fmt::format(
            "'{}' of body '{}', which has no friction (it cannot slip, so it cannot exceed the limit). State its "
            "friction",
            quantity.name, body.name);
    }
    if (quantity.name == "peak_crush" && !body.footing.pad.strength_pa) {
        return fmt::format(
            "'{}' of body '{}', whose pad has no strength (it stays elastic, so it cannot exceed the limit). State "
            "pad.strength",
            quantity.name, body.name);
    }
    return {};
}

void check_reachable(config::Table const& root, std::span<LimitState const> limits, std::span<BodySpec const> bodies) {
    auto const of_the_site = limits.size() - (root.has("limits") ? root.children("limits").size() : 0);
    for (auto i = of_the_site; i < limits.size(); ++i) {
        if (std::ranges::none_of(bodies, [&](BodySpec const& body) { return unreachable(limits[i], body).empty(); })) {
            root.children("limits")[i - of_the_site].fail("quantity", unreachable(limits[i], bodies.front()));
        }
    }
}

}  // namespace overturn
