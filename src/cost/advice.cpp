#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cost/study.hpp"

namespace overturn::cost {
namespace {

std::string quality(Measured const& row) {
    auto text = std::isnan(row.error.p95) ? std::string("no error to compare")
                                          : fmt::format("95 % error {:.1e}", row.error.p95);
    if (row.trials > 0) {
        text += fmt::format(", {} of {} verdicts change", row.flips, row.trials);
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

// The value of a knob that changes most verdicts, of equal ones the one of the largest error.
bool is_larger(Measured const& row, Measured const& other) {
    auto const share = [](Measured const& of) {
        return static_cast<double>(of.flips) / static_cast<double>(std::max<std::int64_t>(1, of.trials));
    };
    auto const error = [](Measured const& of) { return std::isnan(of.error.p95) ? 0 : of.error.p95; };
    return std::pair(share(row), error(row)) > std::pair(share(other), error(other));
}

}  // namespace

std::string largest_effect(std::vector<KnobResult> const& knobs) {
    KnobResult const* knob = nullptr;
    Measured const* largest = nullptr;
    for (auto const& result : knobs) {
        for (auto const& row : result.rows) {
            if (result.knob.here && row.trials > 0 && (largest == nullptr || is_larger(row, *largest))) {
                knob = &result;
                largest = &row;
            }
        }
    }
    if (largest == nullptr) {
        return "";
    }
    if (largest->flips == 0) {
        return fmt::format("No value of any setting changes a verdict ({} trials). Largest error: {} = {}, {}.",
                           largest->trials, knob->knob.name, largest->setting.label, quality(*largest));
    }
    auto const& here = knob->rows[*knob->knob.here];
    auto text = fmt::format("Largest effect of a setting: {} = {} changes {} of {} verdicts", knob->knob.name,
                            largest->setting.label, largest->flips, largest->trials);
    return text
           + (&here == largest ? "; it is the campaign's value."
                               : fmt::format("; the campaign's {} changes {}.", here.setting.label, here.flips));
}

std::string advice_of(KnobResult const& result) {
    if (!result.knob.here) {
        return "No key of the campaign sets it.";
    }
    auto const& here = result.rows[*result.knob.here];
    auto text = fmt::format("Setting of the campaign: {} ({}).", here.setting.label, quality(here));
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
        text += " No other value is faster or more accurate by more than 15 %.";
    } else if (faster == nullptr) {
        text += " No value on the Pareto front is faster.";
    } else if (finer == nullptr) {
        text += " No value on the Pareto front is more accurate.";
    }
    return text;
}

}  // namespace overturn::cost
