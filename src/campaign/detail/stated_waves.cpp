#include "campaign/detail/stated_waves.hpp"

#include <algorithm>

namespace overturn {
namespace {

bool has_records(CampaignSpec const& spec) {
    return std::ranges::any_of(spec.inputs, [](config::InputValue const& input) {
        return input.key == "waves.source" && input.text == "records";
    });
}

}  // namespace

bool states(CampaignSpec const& spec, std::string_view begin) {
    return std::ranges::any_of(spec.inputs, [&](config::InputValue const& input) {
        return input.key.starts_with(begin) && input.basis != config::Basis::by_default;
    });
}

bool may_shake_across(CampaignSpec const& spec) { return states(spec, "waves.transverse") || has_records(spec); }

bool may_shake_vertically(CampaignSpec const& spec) { return states(spec, "waves.vertical") || has_records(spec); }

}  // namespace overturn
