#include <cmath>

#include <fmt/format.h>

#include "cost/study.hpp"

namespace overturn::cost {
namespace {

std::string quality(Measured const& row) {
    auto text = std::isnan(row.error.p95) ? std::string("no error to compare")
                                          : fmt::format("95 % error {:.1e}", row.error.p95);
    if (row.trials > 0) {
        text += fmt::format(", flips {} of {} verdicts", row.flips, row.trials);
    }
    return text;
}

// The neighbour on the front, beyond the noise: the slowest of the faster ones, or the fastest of the more accurate.
Measured const* neighbour(KnobResult const& result, Measured const& here, bool faster) {
    Measured const* best = nullptr;
    auto const own = point_of(here, result.floor);
    for (auto const& row : result.rows) {
        auto const point = point_of(row, result.floor);
        bool const wanted =
            row.on_front
            && (faster ? point.seconds * (1 + noise) < own.seconds : point.error * (1 + noise) < own.error);
        if (wanted && (best == nullptr || (faster ? row.seconds > best->seconds : row.seconds < best->seconds))) {
            best = &row;
        }
    }
    return best;
}

}  // namespace

std::string advice_of(KnobResult const& result) {
    if (!result.knob.here) {
        return "No key of the campaign sets it.";
    }
    auto const& here = result.rows[*result.knob.here];
    auto text = fmt::format("The campaign stands on {} ({}).", here.setting.label, quality(here));
    auto const* faster = neighbour(result, here, true);
    auto const* finer = neighbour(result, here, false);
    if (faster != nullptr) {
        text += fmt::format(" {}: {:.2g} times faster, {}.", faster->setting.label, here.seconds / faster->seconds,
                            quality(*faster));
    }
    if (finer != nullptr && finer != faster) {
        double const ratio = finer->seconds / here.seconds;
        auto const pace = ratio > 1 + noise         ? fmt::format("{:.2g} times slower", ratio)
                          : ratio * (1 + noise) < 1 ? fmt::format("{:.2g} times faster", 1 / ratio)
                                                    : std::string("as fast");
        text += fmt::format(" {}: {}, {}.", finer->setting.label, pace, quality(*finer));
    }
    if (faster == nullptr && finer == nullptr) {
        text += " Nothing else is faster or more accurate by more than the noise.";
    } else if (faster == nullptr) {
        text += " Nothing on the front is faster.";
    } else if (finer == nullptr) {
        text += " Nothing on the front is more accurate.";
    }
    return text;
}

}  // namespace overturn::cost
