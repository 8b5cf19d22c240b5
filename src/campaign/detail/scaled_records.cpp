#include "campaign/detail/scaled_records.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include <fmt/format.h>

#include "core/error.hpp"
#include "motion/intensity.hpp"

namespace overturn {
namespace {

constexpr double most_scaled = 5;  // what guides on the choice of records mostly allow
constexpr std::int64_t looked_at = 1000;

/// 0 where the levels are by another measure.
double measured(Intensity const& intensity, std::string_view level) {
    return level == "pga"          ? intensity.pga_mps2
           : level == "vector-pga" ? intensity.vector_pga_mps2
           : level == "pgv"        ? intensity.pgv_mps
           : level == "pgd"        ? intensity.pgd_m
           : level == "factor"     ? 1
                                   : 0;
}

}  // namespace

std::string warning_of_scaled_records(CampaignSpec const& spec) {
    if (!spec.source->about().available || spec.levels.levels.empty()) {
        return {};
    }
    double const highest = spec.levels.levels.back().value;
    double most = 0;
    std::int64_t which = 0;
    std::int64_t count = 0;
    for (std::int64_t wave = 0; wave < std::min(spec.wave_count, looked_at); ++wave) {
        auto const number = static_cast<std::uint64_t>(wave);
        auto const drift = spec.source->drift(number);  // of records only
        if (!drift) {
            return {};
        }
        double const has =
            measured(intensity_of(spec.source->make(spec.seed, number).motion), spec.levels.measure->level);
        double const factor = has > 0 ? highest / has * drift->factor : 0;
        count += factor > most_scaled ? 1 : 0;
        which = factor > most ? wave : which;
        most = std::max(most, factor);
    }
    if (count == 0) {
        return {};
    }
    return fmt::format(
        "record {} is scaled by up to {:.3g}{}: beyond {:g} a record's duration and long periods are "
        "hardly those of so strong a motion. Choose stronger records, or lower levels",
        which, most, count > 1 ? fmt::format(", and {} more by above {:g}", count - 1, most_scaled) : "", most_scaled);
}

}  // namespace overturn
