#include "campaign/detail/stated_waves.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "generators/wave_source.hpp"
#include "motion/ground_motion.hpp"

namespace overturn {
namespace {

bool has_records(CampaignSpec const& spec) {
    return std::ranges::any_of(spec.inputs, [](config::InputValue const& input) {
        return input.key == "waves.source" && input.text == "records";
    });
}

enum class Of : std::uint8_t { any, all };

struct Component {
    std::string_view key;
    std::vector<double> GroundMotion::*samples;
};
constexpr Component transverse{"waves.transverse", &GroundMotion::transverse_mps2};
constexpr Component vertical{"waves.vertical", &GroundMotion::vertical_mps2};

// Keys state it of generated waves. A recorded one that is withheld may have it.
bool has_component(CampaignSpec const& spec, Component const& component, Of of) {
    if (!has_records(spec)) {
        return states(spec, component.key);
    }
    auto const count = static_cast<std::uint64_t>(spec.source->about().available.value_or(0));
    for (std::uint64_t record = 0; record < count; ++record) {
        bool has = true;
        try {
            has = peak_of(spec.source->make(spec.seed, record).motion.*component.samples) > 0;
        } catch (InputError const&) {
            has = true;
        }
        if (has == (of == Of::any)) {
            return has;
        }
    }
    return of == Of::all;
}

}  // namespace

bool states(CampaignSpec const& spec, std::string_view begin) {
    return std::ranges::any_of(spec.inputs, [&](config::InputValue const& input) {
        return input.key.starts_with(begin) && input.basis != config::Basis::by_default;
    });
}

bool may_shake_across(CampaignSpec const& spec) { return has_component(spec, transverse, Of::any); }
bool may_shake_vertically(CampaignSpec const& spec) { return has_component(spec, vertical, Of::any); }
bool always_shakes_across(CampaignSpec const& spec) { return has_component(spec, transverse, Of::all); }
bool always_shakes_vertically(CampaignSpec const& spec) { return has_component(spec, vertical, Of::all); }

}  // namespace overturn
