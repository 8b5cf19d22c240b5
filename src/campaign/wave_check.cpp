#include "campaign/wave_check.hpp"

#include <cmath>

#include "campaign/rocking_band.hpp"

namespace overturn {

WaveCheck check_wave(GeneratedWave const& wave, std::vector<BodySpec> const& bodies, RadiusUnit radius_unit) {
    WaveCheck check;
    check.quality = wave_quality(wave.motion);
    check.clauses = wave.clauses;
    bool const asked = wave.rule.enabled();
    if (asked) {
        for (auto& clause : wave_clauses(wave.rule, {.time_step_s = wave.motion.time_step_s,
                                                    .duration_s = wave.motion.duration_s(),
                                                    .end_velocity_ratio = check.quality.end_velocity_ratio,
                                                    .correlation = std::abs(check.quality.correlation)})) {
            check.clauses.push_back(std::move(clause));
        }
    }
    for (auto const& body : bodies) {
        auto const band = rocking_band(body.body, radius_unit);
        check.bands.push_back(match_figures(wave.judged_periods_s, wave.ratios, band.t0_s, band.t1_s));
        if (asked) {
            check.clauses.push_back(band_clause(body.name, check.bands.back().mean_misfit));
        }
    }
    return check;
}

void validate_bands(WaveSource const& source, std::vector<BodySpec> const& bodies, RadiusUnit radius_unit) {
    auto const judged = source.about().compared_periods;
    if (!source.about().acceptance.asked() || !judged) {
        return;
    }
    for (auto const& body : bodies) {
        auto const band = rocking_band(body.body, radius_unit);
        validate(band.t1_s <= judged->to_s,
                 "'{}' beside a body '{}' with T1 = {:.3g} s (waves are compared with their target to {:.3g} s only). "
                 "Use a target that extends to T1, and a waves.target.longest of at least T1",
                 source.about().acceptance.rule, body.name, band.t1_s, judged->to_s);
    }
}

}  // namespace overturn
