#include "output/response_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "output/record_text.hpp"
#include "response/registry.hpp"

namespace overturn::output {
namespace {

Json names_json(std::int64_t mask) {
    auto names = Json::array();
    for (auto const& entry : effects()) {
        if (has(static_cast<EffectMask>(mask), entry.value)) {
            names.push_back(entry.name);
        }
    }
    return names;
}

// What never came is null.
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

// Quantities that models share are those of the one that ran: the others know nothing of theirs.
void add_own_json(Json& json, ModelSelector const& selector, std::span<std::byte const> own) {
    static constexpr std::array matched{"restitution", "corner_share", "normal_restitution"};
    for (auto const& [traits, offset] : selector.extra_parts()) {
        for (auto const& field : traits->fields) {
            auto& place =
                std::ranges::count(matched, field.name) > 0 ? json["matched"][field.key()] : json[field.key()];
            if (place.is_null()) {
                place = value_json(own.subspan(offset), field);
            }
        }
    }
}

std::string_view summary_of_reason(std::int64_t number) {
    return std::ranges::find(reasons(), number, &ReasonEntry::number)->summary;
}

std::string time_text(double time_s) { return std::isnan(time_s) ? "never" : fmt::format("at {:.3f} s", time_s); }

}  // namespace

Json json_of(OneResponse const& of) {
    auto const& [spec, record, drift, response, selector, own] = of;
    Json json;
    for (auto const& field : fields_of<Response>()) {
        json[field.key()] = value_json(bytes_of(response), field);
    }
    json["effects"] = names_json(response.effects);
    json["effects_called"] = names_json(response.called);
    json["overturned"] = entry_of(response.verdict).fell;
    json["response_velocity_mps"] = json["v_resp_mps"];
    json["limit_velocity_mps"] = spec.body.limit_velocity_mps();
    json["restitution"] = spec.body.restitution();
    json["record"] = record_json(record);
    json["residual_velocity_mps"] = drift.end_velocity_mps;
    json["residual_displacement_m"] = drift.end_displacement_m;
    add_own_json(json, selector, own);
    return json;
}

std::string text_of(OneResponse const& of, ShownVelocity const& unit) {
    auto const& [spec, record, drift, r, selector, own] = of;
    auto const& b = spec.body;
    auto text = fmt::format("{}: alpha {:.2f} deg, p {:.4f} rad/s, e {:.4f}, uplift at {:.4g} {}, V_Ereq {}\n",
                            spec.name, b.alpha_rad() * 180 / pi, b.p_radps(), b.restitution(),
                            b.uplift_acceleration_mps2() / spec.units.acceleration.si, spec.units.acceleration.symbol,
                            unit.text(b.limit_velocity_mps()));
    text += fmt::format("read as          {}\n", record.read_as());
    for (auto const& claim : record.claims) {
        if (claim.starts_with("left out: ")) {
            text += fmt::format("left out         {}\n", claim.substr(claim.find(' ', claim.find(':')) + 1));
        }
    }
    for (auto const& line : record.unread) {
        text += fmt::format("not understood   {}\n", line);
    }
    text += fmt::format("wave             {}{}\n", drift.text(),
                        drift.any_excessive() ? ": its baseline drifts, correct it with --baseline" : "");
    text += fmt::format("verdict          {}\n", entry_of(r.verdict).name);
    if (std::isnan(r.peak_rotation_rad)) {
        return text;  // no model ran it: the error says why
    }
    text += fmt::format("peak rotation    {:.6g} rad = {:.4g} deg = {:.4f} alpha, {}\n", r.peak_rotation_rad,
                        r.peak_rotation_rad * 180 / pi, r.peak_rotation_ratio, time_text(r.time_of_peak_s));
    text += fmt::format("peak energy      {:.4f} of that of critical uplift\n", r.peak_energy_ratio);
    text += fmt::format("V_resp           {}\n", unit.text(r.response_velocity_mps));
    text += fmt::format("first uplift     {}, {} impacts\n", time_text(r.first_uplift_s), r.impacts);
    text += fmt::format("overturned       {}, off the ground {}\n", time_text(r.overturn_time_s),
                        time_text(r.contact_lost_s));
    auto const& slip = spec.units.slip;
    text += fmt::format("slip             {:.6g} {} at most, {:.6g} {} at the end\n", r.peak_slip_m / slip.si,
                        slip.symbol, r.residual_slip_m / slip.si, slip.symbol);
    text += fmt::format("friction demand  {}, least contact force {:.4f} m g\n",
                        std::isnan(r.friction_demand) ? "unknown" : fmt::format("{:.4f}", r.friction_demand),
                        r.min_contact_force_ratio);
    text +=
        fmt::format("effects          {} (required: {}); {}\n", names_of_effects(static_cast<EffectMask>(r.effects)),
                    names_of_effects(static_cast<EffectMask>(r.called)), summary_of_reason(r.reason));
    for (auto const& [traits, offset] : selector.extra_parts()) {
        if (traits->number != r.model) {
            continue;
        }
        for (auto const& field : traits->fields) {
            auto const values = own.subspan(offset);
            auto const degrees = field.units == "rad" && std::isfinite(real_at(values, field))
                                     ? fmt::format(" = {:.4g} deg", real_at(values, field) * 180 / pi)
                                     : std::string();
            text += fmt::format("{:<25}{} {}{}: {}\n", field.name, value_json(values, field).dump(),
                                field.units == "1" ? "" : field.units, degrees, field.description);
        }
    }
    return text;
}

}  // namespace overturn::output
