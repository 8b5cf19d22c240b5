#include "results/detail/level_quantiles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/units.hpp"
#include "stats/quantile.hpp"

namespace overturn {
namespace {

constexpr std::array quantile_shares{0.5, 0.84,
                                     0.95};  // median, one standard deviation above it, and what is rarely passed

// A fall lies beyond every value; `fallen` is what the columns hold of it.
SampleQuantile with_falls(SampleQuantile quantile, double fallen) {
    auto const tell = [&](double value) { return std::isinf(value) ? fallen : value; };
    quantile.value = tell(quantile.value);
    quantile.lower = quantile.lower ? std::optional(tell(*quantile.lower)) : std::nullopt;
    quantile.upper = quantile.upper ? std::optional(tell(*quantile.upper)) : std::nullopt;
    return quantile;
}

}  // namespace

std::vector<LevelQuantiles> level_quantiles(CampaignSpec const& spec, MeasuredTrials const& trials, std::size_t body,
                                            double confidence) {
    std::vector<LevelQuantiles> list;
    double const group_size = spec.source->about().shared.effect();
    auto const add = [&](LevelResponse response, char const* quantity, char const* units, double fallen) {
        auto const& levels = spec.levels.levels;
        auto by_level = trials.by_level(body, response);
        for (std::size_t l = 0; l < levels.size(); ++l) {
            auto& values = by_level[levels[l].value];
            auto const known =
                std::partition(values.begin(), values.end(), [](double value) { return !std::isnan(value); });
            auto const fell = std::count_if(values.begin(), known, [](double value) { return std::isinf(value); });
            LevelQuantiles at;
            at.quantity = quantity;
            at.units = units;
            at.level = l;
            at.amplitude = levels[l].value;
            at.trials = known - values.begin();
            at.unknown = values.end() - known;
            at.overturned = fell;
            at.fallen = fallen;
            values.erase(known, values.end());
            std::sort(values.begin(), values.end());
            if (!values.empty()) {
                at.least = std::min(values.front(), fallen);
                at.most = std::min(values.back(), fallen);
            }
            auto const independent = SharedDraws::whole(static_cast<double>(at.trials + at.unknown) / group_size);
            std::ranges::transform(quantile_shares, at.quantiles.begin(), [&](double share) {
                auto found = sample_quantile(values, at.unknown, share, confidence, group_size);
                if (independent < fewest_for_quantile(share)) {
                    found.value = std::numeric_limits<double>::quiet_NaN();
                }
                return with_falls(found, fallen);
            });
            list.push_back(at);
        }
    };
    if (spec.bodies[body].friction) {
        add(LevelResponse::peak_slip, "peak_slip", "m", std::numeric_limits<double>::infinity());
    }
    add(LevelResponse::peak_rotation_ratio, "peak_rotation_ratio", "1", pi / 2 / spec.bodies[body].body.alpha_rad());
    return list;
}

}  // namespace overturn
