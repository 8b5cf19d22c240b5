#include "output/target_text.hpp"

#include <string>

#include <fmt/format.h>

#include "stats/proportion.hpp"

namespace overturn::output {

// More waves do not decide trials: the interval counts those without a verdict as either.
std::string half_width_obstacle(std::span<Stripe const> stripes, double half_width, double confidence) {
    for (auto const& stripe : stripes) {
        auto const open = stripe.trials - stripe.decided();
        if (clopper_pearson_of_groups(open, open, stripe.trials, stripe.group_size, confidence).lower
            > 2 * half_width) {
            return fmt::format("cannot meet target_half_width = {:g} ({} of {} trials at one level have no verdict)",
                               half_width, open, stripe.trials);
        }
    }
    return {};
}

std::string median_obstacle(FragilityFit const& fit, double half_width) {
    bool const by_limit = fit.passing == Passing::exceeded;
    std::string why;
    if (fit.state == FragilityState::none_overturned) {
        why = by_limit ? "no trial exceeded the limit" : "no trial overturned";
    } else if (fit.state == FragilityState::all_overturned) {
        why = by_limit ? "every trial exceeded the limit" : "every trial overturned";
    } else if (fit.state == FragilityState::undecided) {
        why = fmt::format("{:g} trials have no verdict", fit.undecided);
    }
    return why.empty() ? why : fmt::format("cannot meet target_median_half_width = {:g} ({})", half_width, why);
}

}  // namespace overturn::output
