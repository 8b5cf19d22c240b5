#include "output/row_json.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "campaign/typed_units.hpp"
#include "response/model_selector.hpp"
#include "response/registry.hpp"

namespace overturn::output {

Json value_json(std::span<std::byte const> row, Field const& field) {
    if (field.type == FieldType::category) {
        return category_at(row, field);
    }
    if (field.type == FieldType::integer) {
        return integer_at(row, field);
    }
    double const value = real_at(row, field);
    return std::isnan(value) ? Json(nullptr) : Json(value);
}

Json effect_names(std::int64_t mask) {
    auto names = Json::array();
    for (auto const& entry : effects()) {
        if (has(static_cast<EffectMask>(mask), entry.value)) {
            names.push_back(entry.name);
        }
    }
    return names;
}

Json stated_of(Fields const& fields, std::span<std::byte const> row, TypedUnits const& units) {
    static constexpr std::array with_units{"m", "m/s", "m/s2", "rad"};
    auto stated = Json::object();
    for (auto const& field : fields) {
        if (field.type == FieldType::real && std::ranges::count(with_units, field.units) > 0) {
            stated[field.name] = stated_json(real_at(row, field), shown_unit(units, field.units));
        }
    }
    return stated;
}

Json replay_json(ReplayedTrial const& of) {
    auto const& row = of.trial.rows.front();
    auto const units = typed_units(of.spec);
    Json columns;
    auto stated = stated_of(fields_of<TrialRow>(), bytes_of(row), units);
    auto const& levels = of.spec.levels;
    stated["amplitude"] = stated_json(row.amplitude, {levels.shown_units(), levels.stated_unit_si});
    for (auto const& field : fields_of<TrialRow>()) {
        columns[field.key()] = value_json(bytes_of(row), field);
    }
    columns["effects"] = effect_names(row.effects);
    columns["effects_called"] = effect_names(row.required);
    ModelSelector const selector(of.spec.effects, of.spec.accuracy);
    std::span<std::byte const> const own(of.trial.extra);
    for (auto const& [traits, offset] : selector.extra_parts()) {
        auto& part = columns[std::string(traits->name)];
        for (auto const& field : traits->fields) {
            part[field.key()] = value_json(own.subspan(offset), field);
        }
        part["stated"] = stated_of(traits->fields, own.subspan(offset), units);
    }
    columns["stated"] = std::move(stated);
    return {{"trial", of.number},
            {"wave_number", of.wave_number},
            {"record", of.spec.source->name(row.wave)},
            {"body_name", of.spec.bodies[row.body].name},
            {"bit_equal", of.different.empty()},
            {"different", of.different},
            {"row", std::move(columns)}};
}

}  // namespace overturn::output
