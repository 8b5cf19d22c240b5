#include "campaign/assumptions.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "campaign/detail/unused_inputs.hpp"
#include "core/texts_of.hpp"

namespace overturn {
namespace {

// How much is computed, how finely, what things are called, and the motions that are read, which are listed on their
// own.
bool is_choice(std::string_view key) {
    static constexpr std::array whole{"waves.count",    "waves.time_step", "waves.match",  "waves.seed",
                                      "waves.folder",   "waves.files",     "waves.format", "waves.resample",
                                      "levels.measure", "levels.period",   "levels.waves"};
    static constexpr std::array within{"waves.match_", "waves.records", "waves.target.longest"};
    static constexpr std::array last{"name", "file", "kind", "distribution", "points", "match_restitution"};
    auto const dot = key.rfind('.');
    auto const leaf = dot == std::string_view::npos ? key : key.substr(dot + 1);
    bool const of_list = key.starts_with("bodies") || key.starts_with("limits");
    return std::ranges::find(whole, key) != whole.end()
           || std::ranges::any_of(within, [&](char const* begin) { return key.starts_with(begin); })
           || (of_list && std::ranges::find(last, leaf) != last.end());
}

bool is_physical(std::string_view key) {
    static constexpr std::array whole{"site", "hazard"};  // the first stated as one assumption: nothing stands near
    static constexpr std::array within{"waves.", "bodies", "levels.", "site.", "limits"};
    return key == beta_u_key || std::ranges::find(whole, key) != whole.end()
           || (std::ranges::any_of(within, [&](char const* begin) { return key.starts_with(begin); })
               && !is_choice(key));
}

// "friction" holds "friction.static".
bool holds(std::string_view key, std::string_view part) {
    return part.starts_with(key) && (part.size() == key.size() || part[key.size()] == '.');
}

// A key beside a file outranks the file's own, and any outranks a default: what is outranked decides nothing.
bool is_outranked(config::InputValue const& value, std::span<config::InputValue const> inputs) {
    return std::ranges::any_of(inputs, [&](config::InputValue const& other) {
        return other.basis != config::Basis::by_default
               && (other.depth < value.depth || value.basis == config::Basis::by_default)
               && (holds(other.key, value.key) || holds(value.key, other.key));
    });
}

}  // namespace

std::vector<config::InputValue> physical_inputs(CampaignSpec const& spec) {
    std::vector<config::InputValue> inputs;
    std::ranges::copy_if(spec.inputs, std::back_inserter(inputs), [&](config::InputValue const& value) {
        return is_physical(value.key) && !is_outranked(value, spec.inputs) && !is_unused(value, spec);
    });
    return inputs;
}

InputTally tally_of(std::span<config::InputValue const> inputs) {
    InputTally tally;
    for (auto const& input : inputs) {
        switch (input.basis) {
            case config::Basis::assumed:
                ++tally.assumed;
                break;
            case config::Basis::published:
                ++tally.published;
                break;
            case config::Basis::measured:
                ++tally.measured;
                break;
            case config::Basis::not_stated:
                ++tally.not_stated;
                break;
            case config::Basis::by_default:
                ++tally.by_default;
                break;
        }
    }
    return tally;
}

bool is_beta_u_assumed(CampaignSpec const& spec) {
    return std::ranges::any_of(spec.inputs, [](config::InputValue const& value) {
        return value.key == beta_u_key && value.number && value.basis == config::Basis::assumed;
    });
}

std::string text_of(InputTally const& tally) {
    return fmt::format(
        "{} of {} inputs are assumed, {} published, {} measured, {} without a source, {} of this program",
        tally.assumed, tally.all(), tally.published, tally.measured, tally.not_stated,
        count_text(tally.by_default, "default"));
}

namespace {

// "bodies[0].friction": "bodies.friction".
std::string without_places(std::string key) {
    for (auto at = key.find('['); at != std::string::npos; at = key.find('[')) {
        auto const end = key.find(']', at);
        key.erase(at, end == std::string::npos ? end : end + 1 - at);
    }
    return key;
}

}  // namespace

std::string assumed_text(std::span<config::InputValue const> inputs) {
    constexpr std::size_t room = 100;
    auto const tally = tally_of(inputs);
    std::vector<std::string> keys;
    for (auto const& input : inputs) {
        auto const key = without_places(input.key);
        if (input.basis == config::Basis::assumed && std::ranges::find(keys, key) == keys.end()) {
            keys.push_back(key);
        }
    }
    std::string named;
    std::size_t shown = 0;
    for (; shown < keys.size() && (shown == 0 || named.size() + keys[shown].size() <= room); ++shown) {
        named += (shown == 0 ? "" : ", ") + keys[shown];
    }
    if (shown < keys.size()) {
        auto const left = keys.size() - shown;
        named += fmt::format(", {} more key{}", left, left == 1 ? "" : "s");
    }
    return fmt::format("{} of {} inputs are assumed{}, {} without a source", tally.assumed, tally.all(),
                       named.empty() ? "" : " (" + named + ")", tally.not_stated);
}

}  // namespace overturn
