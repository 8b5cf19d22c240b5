/// Parts of the answer.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "output/answer.hpp"

namespace overturn::output {

/// Percentiles of a response of a body at a level; null where it was not simulated.
[[nodiscard]] inline LevelQuantiles const* quantiles_at(BodyAnalysis const& body, std::string_view quantity,
                                                        std::size_t level) {
    auto const found = std::ranges::find_if(
        body.quantiles, [&](LevelQuantiles const& at) { return at.quantity == quantity && at.level == level; });
    return found == body.quantiles.end() ? nullptr : &*found;
}

/// Do more than half of the trials leave the response open? What the others have is then no percentile of all.
[[nodiscard]] inline bool mostly_unknown(LevelQuantiles const& at) { return at.trials == 0 || at.unknown > at.trials; }

/// Null without a hazard curve.
[[nodiscard]] inline BodyFrequency const* frequency_at(Answered const& of, std::string const& body,
                                                       std::string const& limit) {
    auto const found = std::ranges::find_if(of.frequencies,
                                            [&](BodyFrequency const& f) { return f.body == body && f.limit == limit; });
    return found == of.frequencies.end() ? nullptr : &*found;
}

/// The estimate of [rare] that stands in place of these counted trials; null where there is none, or where it is but a
/// bound and the trials show a lower one.
[[nodiscard]] inline rare::Estimate const* rare_estimate_at(Answered const& of, std::size_t body, std::size_t limit,
                                                            std::size_t level) {
    auto const found = std::ranges::find_if(of.rare, [&](RareBody const& one) {
        return one.body == body && one.limit == limit && one.estimates.size() == of.spec.levels.levels.size();
    });
    if (found == of.rare.end()) {
        return nullptr;
    }
    auto const& estimate = found->estimates[level];
    auto const& plain = of.statistics.bodies()[body].stripes_of(limit)[level];
    bool const trials_show_more = !estimate.probability && plain.decided() > 0
                                  && plain.interval(of.confidence).upper <= estimate.interval_95.upper;
    return trials_show_more ? nullptr : &estimate;
}

}  // namespace overturn::output
