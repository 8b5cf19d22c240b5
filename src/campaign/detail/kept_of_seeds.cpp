#include "campaign/detail/kept_of_seeds.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "campaign/rocking_band.hpp"
#include "core/units.hpp"
#include "motion/intensity.hpp"
#include "spectra/response_spectrum.hpp"

namespace overturn {
namespace {

constexpr double damping = 0.05;
constexpr double least_kept = 0.95;

/// Between periods on straight lines, beyond them the nearest.
double ratio_at(GeneratedWave const& made, double period_s) {
    auto const& periods = made.judged_periods_s;
    auto const right = static_cast<std::size_t>(std::ranges::lower_bound(periods, period_s) - periods.begin());
    if (right == 0 || right == periods.size()) {
        return right == 0 ? made.ratios.front() : made.ratios.back();
    }
    double const share = (period_s - periods[right - 1]) / (periods[right] - periods[right - 1]);
    return made.ratios[right - 1] + share * (made.ratios[right] - made.ratios[right - 1]);
}

struct Spectra {
    std::vector<double> period_s, seed_m, made_m;
    std::vector<double> factor;  ///< of the seed's, which the match was to have
};

Spectra spectra_of(GroundMotion const& seed, GeneratedWave const& made) {
    constexpr double from_s = 0.05;
    constexpr double to_s = 20;
    constexpr std::size_t count = 150;
    Spectra spectra{log_periods(from_s, to_s, count), {}, {}, {}};
    spectra.seed_m = displacement_spectrum(seed.horizontal_mps2, seed.time_step_s, spectra.period_s, damping);
    spectra.made_m =
        displacement_spectrum(made.motion.horizontal_mps2, made.motion.time_step_s, spectra.period_s, damping);
    double last = 1;
    for (std::size_t i = 0; i < count; ++i) {
        bool const matched = spectra.period_s[i] <= made.judged_periods_s.back();
        bool const known = matched && spectra.seed_m[i] > 0;
        last = known ? spectra.made_m[i] / ratio_at(made, spectra.period_s[i]) / spectra.seed_m[i] : last;
        spectra.factor.push_back(last);
    }
    return spectra;
}

double pgv_factor(Spectra const& spectra) {
    double sum = 0;
    double weights = 0;
    for (std::size_t i = 0; i < spectra.period_s.size(); ++i) {
        double const psv = 2 * pi / spectra.period_s[i] * spectra.seed_m[i];
        weights += psv * psv;
        sum += psv * psv * spectra.factor[i] * spectra.factor[i];
    }
    return weights > 0 ? std::sqrt(sum / weights) : 1;
}

double kept_over(Spectra const& spectra, PeriodBand const& band) {
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < spectra.period_s.size(); ++i) {
        double const wanted = spectra.seed_m[i] * spectra.factor[i];
        if (spectra.period_s[i] >= band.t0_s && spectra.period_s[i] <= band.t1_s && wanted > 0) {
            sum += std::log(spectra.made_m[i] / wanted);
            ++count;
        }
    }
    return count > 0 ? std::exp(sum / count) : 1;
}

}  // namespace

KeptOfSeed kept_of_seed(GroundMotion const& seed, GeneratedWave const& made, std::span<PeriodBand const> bands) {
    auto const spectra = spectra_of(seed, made);
    double const wanted = intensity_of(seed.horizontal_mps2, seed.time_step_s).pgv_mps * pgv_factor(spectra);
    double const pgv = intensity_of(made.motion.horizontal_mps2, made.motion.time_step_s).pgv_mps;
    KeptOfSeed kept{wanted > 0 ? pgv / wanted : 1, kept_over(spectra, bands.front()), bands.front()};
    for (auto const& band : bands.subspan(1)) {
        if (double const sa = kept_over(spectra, band); sa < kept.sa) {
            kept.sa = sa;
            kept.band = band;
        }
    }
    return kept;
}

std::string warning_of_lost_periods(CampaignSpec const& spec) {
    constexpr std::uint64_t most = 8;  // a match takes a while
    std::vector<PeriodBand> bands;
    for (auto const& body : spec.bodies) {
        bands.push_back(rocking_band(body.body));
    }
    auto const count = std::min(most, static_cast<std::uint64_t>(spec.wave_count));
    std::uint64_t lost = 0;
    KeptOfSeed worst;
    std::uint64_t worst_wave = 0;
    for (std::uint64_t wave = 0; wave < count; ++wave) {
        auto const* const seed = spec.source->began_with(wave);
        if (seed == nullptr || bands.empty()) {
            return {};
        }
        auto const made = spec.source->make(spec.seed, wave);
        if (made.ratios.empty()) {
            return {};
        }
        auto const kept = kept_of_seed(*seed, made, bands);
        lost += std::min(kept.pgv, kept.sa) < least_kept ? 1 : 0;
        if (std::min(kept.pgv, kept.sa) < std::min(worst.pgv, worst.sa)) {
            worst = kept;
            worst_wave = wave;
        }
    }
    if (lost == 0) {
        return {};
    }
    return fmt::format(
        "{} of the first {} seeds lose more than 5 % of PGV, or of Sa over a body's periods, to their match; most "
        "wave {}: PGV {:+.3g} %, Sa over {:.3g} to {:.3g} s {:+.3g} % (against the seed times the "
        "factor of its match). Lengthen waves.target.longest and waves.duration, or read P with that",
        lost, count, worst_wave, 100 * (worst.pgv - 1), worst.band.t0_s, worst.band.t1_s, 100 * (worst.sa - 1));
}

}  // namespace overturn
