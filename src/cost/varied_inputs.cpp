#include "cost/detail/varied_inputs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "campaign/assumptions.hpp"
#include "core/units.hpp"

namespace overturn::cost {
namespace {

// Columns count characters, of which UTF-8 has one to four bytes.
std::size_t offset_of(std::string const& text, int line, int column) {
    std::size_t at = 0;
    for (int l = 1; l < line; ++l) {
        at = text.find('\n', at) + 1;
    }
    constexpr unsigned continuation = 0x80;
    constexpr unsigned leading_bits = 0xC0;
    for (int c = 1; c < column && at < text.size(); ++c) {
        do {
            ++at;
        } while (at < text.size() && (static_cast<unsigned char>(text[at]) & leading_bits) == continuation);
    }
    return at;
}

// A tenth below and above, in the unit that the value is written in.
std::array<std::string, 2> ends_of(config::InputValue const& value) {
    if (!value.range.empty()) {
        return {value.range[0], value.range[1]};
    }
    auto const blank = value.text.find(' ');
    double number = 0;
    bool const has_unit = blank != std::string::npos && parse_number(value.text.substr(0, blank), number);
    number = has_unit ? number : *value.number;
    auto const unit = has_unit ? value.text.substr(blank) : std::string();
    return {fmt::format("{:.12g}{}", number * (1 - usual_share), unit),
            fmt::format("{:.12g}{}", number * (1 + usual_share), unit)};
}

// A number as it is, anything else as a text.
std::string toml_of(std::string const& written) {
    double number = 0;
    return parse_number(written, number) ? written : fmt::format("'{}'", written);
}

// Does the friction decide whether the body slides or rocks, wherever the number comes from? From tan(alpha) to
// about 1.15 of it a trial's outcome changes with it: the move may reach into that range.
bool is_deciding_friction(CampaignSpec const& spec, config::InputValue const& value) {
    constexpr double both_to = 1.15;
    for (std::size_t b = 0; value.number && b < spec.bodies.size(); ++b) {
        auto const key = fmt::format("bodies[{}].friction", b);
        if (value.key != key && value.key != key + ".static") {
            continue;
        }
        auto const& body = spec.bodies[b].body;
        double const share = *value.number / std::tan(body.corner(body.weaker_side()).base_angle_rad);
        return share * (1 + usual_share) >= 1 && share * (1 - usual_share) <= both_to;
    }
    return false;
}

// "bodies[0].pad.strength" -> "bodies.0.pad.strength"
std::string setting_of(std::string key) {
    std::erase(key, ']');
    std::ranges::replace(key, '[', '.');
    return key;
}

// The stiffness of the pad of each body that stands on a rim, bed or polygon, where it is the program's. Nobody
// measures it, and just below tan(alpha) it decides whether a sliding body begins to rock.
void add_default_pads(CampaignSpec const& spec, std::vector<config::InputValue>& inputs) {
    for (std::size_t b = 0; b < spec.bodies.size(); ++b) {
        auto const& footing = spec.bodies[b].stated_footing;
        auto const key = fmt::format("bodies[{}].pad.vertical_frequency", b);
        auto const there = std::ranges::find(inputs, key, &config::InputValue::key);
        bool const is_default = there == inputs.end() || there->basis == config::Basis::by_default;
        if (footing.base.on_corners() || !is_default) {
            continue;
        }
        double const hertz = footing.pad.vertical_frequency_hz;
        config::InputValue value{.key = key,
                                 .text = fmt::format("{:g} Hz", hertz),
                                 .basis = config::Basis::assumed,
                                 .source = "default of this program",
                                 .range = {fmt::format("{:g} Hz", hertz / 2), fmt::format("{:g} Hz", hertz * 2)},
                                 .number = hertz};
        if (there == inputs.end()) {
            inputs.push_back(std::move(value));
        } else {
            *there = std::move(value);
        }
    }
}

std::string why_unvaried(config::InputValue const& value) {
    if (!value.range.empty()) {
        return "";
    }
    return !value.number        ? "not a number: state a range of two values"
           : *value.number == 0 ? "a tenth of 0 is 0: state a range"
                                : "";
}

}  // namespace

CampaignInput with_value(CampaignInput const& input, config::InputValue const& value, std::string const& written) {
    auto varied = input;
    if (!value.span.is_known()) {  // of a setting or a default
        varied.settings.push_back(fmt::format("{}={}", setting_of(value.key), toml_of(written)));
        return varied;
    }
    auto& text = value.depth == 0 ? varied.text : varied.files.at(value.file);
    auto const begin = offset_of(text, value.span.line, value.span.column);
    auto const end = offset_of(text, value.span.end_line, value.span.end_column);
    text.replace(begin, end - begin, toml_of(written));
    return varied;
}

VariedInputs varied_inputs(CampaignSpec const& spec) {
    VariedInputs found;
    std::map<std::tuple<std::string, int, int>, std::size_t> places;
    auto inputs = physical_inputs(spec);
    add_default_pads(spec, inputs);
    for (auto const& value : inputs) {
        if (value.key == beta_u_key  // it moves no trial
            || (value.basis != config::Basis::assumed && !is_deciding_friction(spec, value))) {
            continue;
        }
        if (auto const why = why_unvaried(value); !why.empty()) {
            found.unvaried.push_back({value.key, value.text, why});
            continue;
        }
        auto const place_of = value.span.is_known() ? std::tuple(value.file, value.span.line, value.span.column)
                                                    : std::tuple(value.key, 0, 0);
        auto const [place, is_new] = places.try_emplace(place_of, found.values.size());
        if (is_new) {
            found.values.push_back(value);
            found.inputs.push_back({{}, value.text, value.source, ends_of(value), {}, !value.range.empty()});
        }
        found.inputs[place->second].keys.push_back(value.key);
    }
    return found;
}

}  // namespace overturn::cost
