#include "campaign/detail/stated_waves.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "generators/wave_source.hpp"

namespace overturn {
namespace {

enum class Of : std::uint8_t { any, all };

struct Component {
    std::string_view key;
    bool MeasuredWave::*of_measured;
};
constexpr Component transverse{"waves.transverse", &MeasuredWave::transverse};
constexpr Component vertical{"waves.vertical", &MeasuredWave::vertical};

// Keys state it of generated waves.
bool has_component(CampaignSpec const& spec, Component const& component, Of of) {
    auto const& measured = spec.source->about().measured;
    return measured.empty() ? states(spec, component.key)
           : of == Of::any  ? std::ranges::any_of(measured, component.of_measured)
                            : std::ranges::all_of(measured, component.of_measured);
}

}  // namespace

bool states(CampaignSpec const& spec, std::string_view begin) {
    return std::ranges::any_of(spec.inputs, [&](config::InputValue const& input) {
        return input.key.starts_with(begin) && input.basis != config::Basis::by_default;
    });
}

bool may_shake_across(CampaignSpec const& spec) { return has_component(spec, transverse, Of::any); }
bool always_shakes_across(CampaignSpec const& spec) { return has_component(spec, transverse, Of::all); }
bool always_shakes_vertically(CampaignSpec const& spec) { return has_component(spec, vertical, Of::all); }

}  // namespace overturn
