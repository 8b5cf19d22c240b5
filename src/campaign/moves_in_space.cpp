#include "campaign/moves_in_space.hpp"

#include "campaign/detail/stated_waves.hpp"

namespace overturn {

bool may_move_in_space(CampaignSpec const& spec, BodySpec const& body) {
    return body.axes > 1 && may_shake_across(spec) && has(spec.effects.wanted(), Effect::spatial);
}

}  // namespace overturn
