#include "output/response_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "campaign/typed_units.hpp"
#include "campaign/verdict_text.hpp"
#include "core/wrapped.hpp"
#include "output/record_text.hpp"
#include "output/row_json.hpp"
#include "response/registry.hpp"

namespace overturn::output {
namespace {

// Quantities that models share are those of the one that ran: the others know nothing of theirs.
void add_extra_json(Json& json, ModelSelector const& selector, std::span<std::byte const> extra) {
    static constexpr std::array of_matching{"restitution", "corner_share", "normal_restitution"};
    for (auto const& [traits, offset] : selector.extra_parts()) {
        for (auto const& field : traits->fields) {
            auto& place =
                std::ranges::count(of_matching, field.name) > 0 ? json["matching"][field.key()] : json[field.key()];
            if (place.is_null()) {
                place = value_json(extra.subspan(offset), field);
            }
        }
    }
}

std::string_view summary_of_reason(std::int64_t number) {
    return std::ranges::find(reasons(), number, &ReasonEntry::number)->summary;
}

std::string time_text(double time_s) { return std::isnan(time_s) ? "never" : fmt::format("at {:.3f} s", time_s); }

// A column of the model that answered, in the units of the body.
std::string column_text(Field const& field, std::span<std::byte const> values, TypedUnits const& units) {
    double const value = field.type == FieldType::real ? real_at(values, field) : 0;
    auto const number =
        field.type == FieldType::real ? shown_unit(units, field.units).text(value) : value_json(values, field).dump();
    return std::isnan(value) ? std::string()
                             : wrapped(fmt::format("{:<25}{}: {}", field.name, number, field.description), 25);
}

// "slip             12 mm at most, ...", in lines that fit a terminal.
std::string entry(std::string_view label, std::string_view text) {
    constexpr std::size_t columns = 17;
    return labelled(label, text, columns);
}

// Of the model that answered: a base on points, a rim or a disc has a restitution of its own.
double restitution_of(OneResponse const& of) {
    double const found = of.selector.extra_value(of.response, "restitution", of.extra);
    return std::isnan(found) ? of.spec.body.restitution() : found;
}

std::string body_text(OneResponse const& of, ShownVelocity const& unit) {
    auto const& b = of.spec.body;
    auto const& acceleration = of.spec.units.acceleration;
    return entry("body", fmt::format("{}: alpha {:.2f} deg, p {:.4f} rad/s, e {:.4f}, uplift at {:.4g} {}, V_Ereq {}",
                                     of.spec.name, b.alpha_rad() * 180 / pi, b.p_radps(), restitution_of(of),
                                     b.uplift_acceleration_mps2() / acceleration.si, acceleration.symbol,
                                     unit.text(b.limit_velocity_mps())));
}

// How it moved, what most concerns its safety first.
std::string moved_text(OneResponse const& of, ShownVelocity const& unit) {
    auto const& r = of.response;
    auto const& slip = of.spec.units.slip;
    auto text =
        entry("peak rotation", fmt::format("{:.4g} deg = {:.6g} rad = {:.4f} alpha, {}", r.peak_rotation_rad * 180 / pi,
                                           r.peak_rotation_rad, r.peak_rotation_ratio, time_text(r.time_of_peak_s)));
    text += entry("slip", fmt::format("{:.6g} {} at most, {:.6g} {} at the end", r.peak_slip_m / slip.si, slip.symbol,
                                      r.residual_slip_m / slip.si, slip.symbol));
    if (entry_of(r.verdict).fell) {
        text += entry("overturned",
                      fmt::format("{}, lies with {:.4g} rad/s, its centre of gravity with {}, its top with {}, "
                                  "{:.4g} kJ per t",
                                  time_text(r.overturn_time_s), r.landing_spin_radps, unit.text(r.landing_velocity_mps),
                                  unit.text(r.landing_top_mps), r.landing_energy_jpkg));
    }
    text += entry("uplift", std::isnan(r.first_uplift_s)
                                ? std::string("never")
                                : fmt::format("first {}, {} impacts, off the ground {}", time_text(r.first_uplift_s),
                                              r.impacts, time_text(r.contact_lost_s)));
    text += entry("V_resp", fmt::format("{} (V_Ereq, which overturns: {})", unit.text(r.response_velocity_mps),
                                        unit.text(of.spec.body.limit_velocity_mps())));
    text += entry("peak energy", fmt::format("{:.4f} of m g (R - h), the least that overturns", r.peak_energy_ratio));
    text += entry("friction demand",
                  fmt::format("{}, least contact force {:.4f} m g",
                              std::isnan(r.friction_demand) ? "unknown" : fmt::format("{:.4f}", r.friction_demand),
                              r.min_contact_force_ratio));
    return text
           + entry("effects",
                   fmt::format("{} (required: {}); {}", names_of_effects(static_cast<EffectMask>(r.effects)),
                               names_of_effects(static_cast<EffectMask>(r.required)), summary_of_reason(r.reason)));
}

// What the model that answered knows besides.
std::string columns_text(OneResponse const& of) {
    std::string text;
    for (auto const& [traits, offset] : of.selector.extra_parts()) {
        if (traits->number == of.response.model) {
            for (auto const& field : traits->fields) {
                text += column_text(field, of.extra.subspan(offset), of.spec.units);
            }
        }
    }
    return text;
}

}  // namespace

Json json_of(OneResponse const& of) {
    auto const& [spec, record, drift, response, selector, extra] = of;
    Json json;
    for (auto const& field : fields_of<Response>()) {
        json[field.key()] = value_json(bytes_of(response), field);
    }
    json["effects"] = effect_names(response.effects);
    json["effects_called"] = effect_names(response.required);
    json["overturned"] = entry_of(response.verdict).fell;
    auto stated = stated_of(fields_of<Response>(), bytes_of(response), spec.units);
    stated["v_ereq"] = stated_json(spec.body.limit_velocity_mps(), spec.units.velocity);
    json["v_ereq_mps"] = spec.body.limit_velocity_mps();
    json["restitution"] = spec.body.restitution();
    json["record"] = record_json(record);
    json["residual_velocity_mps"] = drift.end_velocity_mps;
    json["residual_displacement_m"] = drift.end_displacement_m;
    add_extra_json(json, selector, extra);
    for (auto const& [traits, offset] : selector.extra_parts()) {
        auto const of_model = stated_of(traits->fields, extra.subspan(offset), spec.units);
        for (auto const& [name, value] : of_model.items()) {
            auto& place = stated[name];
            if (place.is_null() || place["value"].is_null()) {
                place = value;
            }
        }
    }
    json["stated"] = std::move(stated);
    return json;
}

std::string text_of(OneResponse const& of, ShownVelocity const& unit) {
    auto const& [spec, record, drift, r, selector, extra] = of;
    auto text =
        entry("verdict", std::string(entry_of(r.verdict).name) + at_rest_text(r, MovementSpec{}, spec.units.slip));
    if (!std::isnan(r.peak_rotation_rad)) {  // else no model ran it: the error says why
        text += moved_text(of, unit);
    }
    text += body_text(of, unit);
    text += entry("read as", record.read_as());
    for (auto const& statement : record.statements) {
        if (statement.starts_with("left out: ")) {
            text += entry("left out", statement.substr(statement.find(' ', statement.find(':')) + 1));
        }
    }
    for (auto const& line : record.unread) {
        text += entry("not understood", line);
    }
    auto units = motion_units(spec.units);
    units.velocity = unit.symbol;
    text += entry(
        "wave", drift.text(units) + (drift.any_excessive() ? ": its baseline drifts, correct it with --baseline" : ""));
    return text + columns_text(of);
}

}  // namespace overturn::output
