#include "campaign/limit_state.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/units.hpp"
#include "response/registry.hpp"

namespace overturn {
namespace {

constexpr std::array slip_quantities{std::string_view("peak_slip"), std::string_view("residual_slip"),
                                     std::string_view("friction_work")};
// Of the base as it was matched, whatever the trial does.
constexpr std::array base_properties{std::string_view("restitution"), std::string_view("corner_share"),
                                     std::string_view("normal_restitution")};

// Unknown where what decides where a body goes was called for and left out.
constexpr std::array places{
    std::string_view("residual_x"),   std::string_view("residual_y"),    std::string_view("edge_x_most"),
    std::string_view("edge_x_least"), std::string_view("edge_y_most"),   std::string_view("edge_y_least"),
    std::string_view("peak_top"),     std::string_view("rotation_most"), std::string_view("rotation_least")};

template <std::size_t Count> bool is_among(std::array<std::string_view, Count> const& names, std::string_view name) {
    return std::ranges::find(names, name) != names.end();
}

bool is_a_response(Field const& field) {
    return (field.type == FieldType::real && field.units != "s") || field.name == "impacts";
}

double value_at(std::span<std::byte const> row, Field const& field) {
    return field.type == FieldType::real ? real_at(row, field) : static_cast<double>(integer_at(row, field));
}

bool exceeds(LimitState const& limit, double value) {
    double const size = limit.quantity.is_signed ? value : std::abs(value);
    return limit.rule == LimitState::Rule::above ? size > limit.threshold : size < limit.threshold;
}

constexpr std::uint32_t bit_of(std::size_t limit) { return std::uint32_t{1} << limit; }

}  // namespace

std::span<LimitQuantity const> limit_quantities() {
    static auto const quantities = [] {
        std::vector<LimitQuantity> all;
        for (auto const& field : fields_of<Outcome>()) {
            if (is_a_response(field)) {
                auto const needs = is_among(slip_quantities, field.name) ? mask_of(Effect::sliding) : 0;
                all.push_back({field.name, field.units, field.description, needs, true});
            }
        }
        for (std::string_view const name : {"least_clearance", "edge_margin"}) {
            auto const& field = field_named(fields_of<TrialRow>(), name);
            constexpr auto decided_by = mask_of(Effect::sliding) | mask_of(Effect::spatial);
            all.push_back({field.name, field.units, field.description, decided_by, true, true});
        }
        for (auto const& model : models()) {
            for (auto const& field : model.traits().fields) {
                bool const known = std::ranges::find(all, field.name, &LimitQuantity::name) != all.end();
                if (is_a_response(field) && !known && !is_among(base_properties, field.name)) {
                    // A rigid body has places too, of which slip decides; vertical motion it has where the wave does.
                    auto const brings = model.traits().brings() & ~mask_of(Effect::vertical);
                    auto const needs = brings != 0 ? brings : mask_of(Effect::sliding);
                    all.push_back({field.name, field.units, field.description, needs, false});
                }
            }
        }
        return all;
    }();
    return quantities;
}

std::string LimitState::threshold_text() const {
    if (threshold == 0) {
        return "0";  // in every unit
    }
    auto const symbol = !shown.symbol.empty() ? shown.symbol : quantity.units == "1" ? std::string() : quantity.units;
    auto text = fmt::format("{:.6g}{}{}", shown.of(threshold), symbol.empty() ? "" : " ", symbol);
    if (symbol == "rad") {
        text += fmt::format(" = {:.4g} deg", threshold * 180 / pi);
    }
    return text;
}

namespace {

// Of how a body lands only those speak that fell.
bool is_passed_by_falling(LimitState const& limit, std::span<LimitState const> limits) {
    auto const is = [&](std::size_t part) { return is_passed_by_falling(limits[part], limits); };
    switch (limit.rule) {
        case LimitState::Rule::above:
        case LimitState::Rule::below:
            return limit.falls_pass || limit.quantity.is_of_the_fall();
        case LimitState::Rule::any:
            return std::ranges::any_of(limit.of, is);
        case LimitState::Rule::all:
            return std::ranges::all_of(limit.of, is);
        case LimitState::Rule::overturning:
            break;
    }
    return true;
}

std::string_view words_of_falls(LimitState const& limit, std::span<LimitState const> limits) {
    return is_passed_by_falling(limit, limits) ? std::string_view() : without_overturning;
}

}  // namespace

std::string full_name(LimitState const& limit, std::span<LimitState const> limits) {
    return limit.name + std::string(words_of_falls(limit, limits));
}

std::string definition_of(LimitState const& limit, std::span<LimitState const> limits) {
    auto const without = words_of_falls(limit, limits);
    auto const names = [&] {
        std::string text;
        for (auto const place : limit.of) {
            text += (text.empty() ? "" : ", ") + full_name(limits[place], limits);
        }
        return text;
    };
    switch (limit.rule) {
        case LimitState::Rule::above:
            return fmt::format("{} > {}{}", limit.quantity.name, limit.threshold_text(), without);
        case LimitState::Rule::below:
            return fmt::format("{} < {}{}", limit.quantity.name, limit.threshold_text(), without);
        case LimitState::Rule::any:
            return "any of " + names();
        case LimitState::Rule::all:
            return "all of " + names();
        case LimitState::Rule::overturning:
            break;
    }
    return "the body fell over";
}

LimitJudge::LimitJudge(std::span<LimitState const> limits, ModelSelector const& selector) : limits_(limits) {
    OVERTURN_EXPECT(limits.size() <= most_limits);
    for (std::size_t l = 0; l < limits.size(); ++l) {
        auto const& quantity = limits[l].quantity;
        bool const column = !quantity.name.empty() && quantity.of_every_model;
        columns_.push_back(column ? &field_named(fields_of<TrialRow>(), quantity.name) : nullptr);
        if (quantity.name.empty() || column) {
            continue;
        }
        for (auto const& [traits, offset] : selector.extra_parts()) {
            auto const found = std::ranges::find(traits->fields, quantity.name, &Field::name);
            if (found != traits->fields.end()) {
                extra_.push_back({l, traits->number, *found});
                extra_.back().field.offset += offset;
            }
        }
    }
}

bool LimitJudge::reads_extra() const { return !extra_.empty(); }

// NaN where it is unknown.
double LimitJudge::value_of(std::size_t limit, TrialRow const& row, std::span<std::byte const> extra) const {
    auto const missed = static_cast<EffectMask>(row.required) & ~static_cast<EffectMask>(row.effects);
    if (columns_[limit] != nullptr) {
        bool const answered = (missed & limits_[limit].quantity.needs) == 0;
        return answered ? value_at(bytes_of(row), *columns_[limit]) : never;
    }
    constexpr auto decide_places = mask_of(Effect::sliding) | mask_of(Effect::spatial);
    if (is_among(places, limits_[limit].quantity.name) && (missed & decide_places) != 0) {
        return never;
    }
    auto const part = std::ranges::find_if(
        extra_, [&](Own const& candidate) { return candidate.limit == limit && candidate.model == row.model; });
    return part == extra_.end() || extra.empty() ? never : value_at(extra, part->field);
}

double LimitJudge::nearness(std::size_t limit, TrialRow const& row, std::span<std::byte const> extra) const {
    auto const& state = limits_[limit];
    constexpr double beyond = 1.0000001;
    bool const fell = entry_of(row.verdict).fell;
    double const value = value_of(limit, row, extra);
    double const size = std::abs(value);
    // fmax: what is not known of a trial that fell decides nothing.
    double const least = fell && state.falls_pass ? std::max(row.peak_rotation_ratio, beyond) : never;
    if (state.quantity.is_signed) {  // a length over which it may grow: no more than its order matters
        constexpr double usual_m = 1;
        double const beyond_m =
            state.rule == LimitState::Rule::below ? state.threshold - value : value - state.threshold;
        return std::fmax(least, std::exp(beyond_m / usual_m));
    }
    switch (state.rule) {
        case LimitState::Rule::overturning:
            return fell ? std::max(row.peak_rotation_ratio, beyond) : std::min(row.peak_rotation_ratio, 1.0);
        case LimitState::Rule::above:
            return std::fmax(least, state.threshold > 0 ? size / state.threshold
                                    : size > 0          ? std::numeric_limits<double>::max()
                                                        : size);
        case LimitState::Rule::below:
            return std::fmax(least, size > 0 ? state.threshold / size : std::numeric_limits<double>::max());
        case LimitState::Rule::any:
        case LimitState::Rule::all:
            break;
    }
    bool const nearest = state.rule == LimitState::Rule::any;
    double combined = nearness(state.of.front(), row, extra);
    for (auto const part : state.of) {
        double const near = nearness(part, row, extra);
        combined = std::isnan(near) ? near : nearest ? std::max(combined, near) : std::min(combined, near);
    }
    return combined;
}

LimitOutcomes LimitJudge::judge(TrialRow const& row, std::span<std::byte const> extra) const {
    auto const& end = entry_of(row.verdict);
    LimitOutcomes outcomes;
    if (!end.decided) {
        return outcomes;
    }
    auto const set = [&](std::size_t limit, bool passed) {
        outcomes.decided |= bit_of(limit);
        outcomes.passed |= passed ? bit_of(limit) : 0;
    };
    for (std::size_t l = 0; l < limits_.size(); ++l) {
        auto const& limit = limits_[l];
        switch (limit.rule) {
            case LimitState::Rule::overturning:
                set(l, end.fell);
                break;
            case LimitState::Rule::above:
            case LimitState::Rule::below:
                if (end.fell && limit.falls_pass) {
                    set(l, true);
                } else if (double const value = value_of(l, row, extra); !std::isnan(value)) {
                    set(l, exceeds(limit, value));
                }
                break;
            case LimitState::Rule::any:
            case LimitState::Rule::all: {
                bool const settles = limit.rule == LimitState::Rule::any;  // what one alone decides
                auto const is = [&](std::size_t part) {
                    return outcomes.is_decided(part) && outcomes.has_passed(part) == settles;
                };
                auto const open = [&](std::size_t part) { return !outcomes.is_decided(part); };
                if (std::ranges::any_of(limit.of, is)) {
                    set(l, settles);
                } else if (std::ranges::none_of(limit.of, open)) {
                    set(l, !settles);
                }
                break;
            }
        }
    }
    return outcomes;
}

}  // namespace overturn
