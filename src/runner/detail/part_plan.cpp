#include "runner/detail/part_plan.hpp"

#include <algorithm>
#include <cmath>

#include "campaign/trial.hpp"
#include "core/error.hpp"

namespace overturn {

Plan plan_of_part(CampaignSpec const& spec, Part part) {
    Plan plan(spec);
    if (part.is_whole() || !spec.source->about().acceptance.refuses()) {
        return plan;
    }
    validate(
        plan.groups() == 1,
        "--part {}/{} of waves that are held to a rule level by level (how many each level needs no part can know). "
        "Run it whole, under mpirun",
        part.number, part.of);
    constexpr std::int64_t looked_at = 32;
    std::int64_t accepted = 0;
    PhaseSeconds seconds;
    auto const looks = std::min(looked_at, plan.waves());
    for (std::int64_t wave = 0; wave < looks; ++wave) {
        accepted += prepare_wave(spec, plan, wave, seconds).row.accepted == Accepted::yes ? 1 : 0;
    }
    double const share = std::max(0.1, static_cast<double>(accepted) / static_cast<double>(looks));
    auto const count = static_cast<double>(plan.count());
    double const needed = (count + 2 * std::sqrt(count * (1 - share))) / share;
    auto const blocks = std::ceil(needed / static_cast<double>(plan.block_size()));
    return plan.first(std::min(plan.blocks(), static_cast<std::int64_t>(blocks)));
}

}  // namespace overturn
