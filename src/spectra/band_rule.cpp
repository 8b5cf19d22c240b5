#include "spectra/band_rule.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <gsl/gsl_integration.h>

#include "core/error.hpp"
#include "core/units.hpp"
#include "simd/lane_values.hpp"

namespace overturn {

PeriodBand rocking_period_band(double radius_m, RadiusUnit unit, double gravity_mps2) {
    validate(radius_m > 0 && std::isfinite(radius_m), "radius {} m (must be positive). Mend the body", radius_m);
    validate(gravity_mps2 > 0 && std::isfinite(gravity_mps2), "gravity {} m/s2 (must be positive). Mend the body",
             gravity_mps2);
    double const root =
        std::sqrt(unit == RadiusUnit::centimetre ? 100 * radius_m : radius_m) * std::sqrt(g0 / gravity_mps2);
    return {0.05 * root, 0.5 * root};
}

void validate_band(PeriodBand const& band, double panel_phase_rad) {
    validate(band.t0_s > 0 && band.t1_s > band.t0_s && std::isfinite(band.t1_s),
             "period band {} s to {} s (needs 0 < T0 < T1). Mend it", band.t0_s, band.t1_s);
    validate(panel_phase_rad > 0, "panel phase {} rad (must be positive). Use 20", panel_phase_rad);
}

BandRule band_rule(PeriodBand const& band, double length_s, double panel_phase_rad) {
    validate_band(band, panel_phase_rad);
    double const low = 2 * pi / band.t1_s;
    double const high = 2 * pi / band.t0_s;
    constexpr double fewest = 4;  // for f(T) dT/dw itself, which falls like 1/w^2
    auto const panels = static_cast<int>(std::max(fewest, std::ceil((high - low) * length_s / panel_phase_rad)));
    double const width = (high - low) / panels;
    double const peak = 2 / ((band.t1_s - band.t0_s) * (band.t1_s - band.t0_s));
    std::unique_ptr<gsl_integration_glfixed_table, decltype(&gsl_integration_glfixed_table_free)> const gauss(
        gsl_integration_glfixed_table_alloc(simd::sweep_lanes), &gsl_integration_glfixed_table_free);
    BandRule rule;
    for (int panel = 0; panel < panels; ++panel) {
        for (std::size_t i = 0; i < simd::sweep_lanes; ++i) {
            double w = 0;
            double share = 0;
            gsl_integration_glfixed_point(low + width * panel, low + width * (panel + 1), i, &w, &share, gauss.get());
            double const period = 2 * pi / w;
            rule.frequency_radps.push_back(w);
            rule.weight.push_back(share * peak * (band.t1_s - period) * period / w);
        }
    }
    return rule;
}

}  // namespace overturn
