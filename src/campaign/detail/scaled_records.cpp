#include "campaign/detail/scaled_records.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "campaign/detail/wave_rows.hpp"
#include "core/outward.hpp"
#include "motion/intensity.hpp"

namespace overturn {
namespace {

constexpr std::int64_t looked_at = 1000;

/// By which the highest level scales a wave; 0 where nothing of it can be scaled.
double factor_of(CampaignSpec const& spec, GroundMotion motion) {
    PreparedWave wave;
    wave.motion = std::move(motion);
    describe_motion(wave.row, wave.motion, intensity_of(wave.motion));
    measure_sa(spec.measures, wave);
    return spec.levels.scale(spec.levels.levels.back(), wave.row).value_or(0);
}

}  // namespace

ScaledRecords scaled_records(CampaignSpec const& spec) {
    ScaledRecords found;
    if (!spec.source->about().available || spec.levels.levels.empty()) {
        return found;
    }
    for (std::int64_t wave = 0; wave < std::min(spec.wave_count, looked_at); ++wave) {
        std::uint64_t const number = wave;
        auto const drift = spec.source->drift(number);  // of records only
        if (!drift) {
            return found;
        }
        double const factor = factor_of(spec, spec.source->make(spec.seed, number).motion) * drift->factor;
        found.count += factor > most_scaled ? 1 : 0;
        found.which = factor > found.most ? wave : found.which;
        found.most = std::max(found.most, factor);
    }
    return found;
}

std::string warning_of_scaled_records(CampaignSpec const& spec) {
    auto const [most, which, count] = scaled_records(spec);
    if (count == 0) {
        return {};
    }
    return fmt::format(
        "{} is scaled by up to {:.3g}{}: beyond {:g} a record's duration and long periods are "
        "hardly those of so strong a motion. Choose stronger records, or lower levels",
        spec.source->called(which), rounded_up(most),
        count > 1 ? fmt::format(", and {} more by above {:g}", count - 1, most_scaled) : "", most_scaled);
}

}  // namespace overturn
