/// One wave on one page: acceleration, velocity, displacement, V_WES(t) against V_Ereq, response and energy spectra.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "motion/ground_motion.hpp"
#include "spectra/band_rule.hpp"
#include "spectra/target_spectrum.hpp"
#include "spectra/window_energy.hpp"

namespace overturn::report {

/// Range in which a standard wants the ratio of wave to target, and its periods.
struct AcceptanceBand {
    std::string name;
    double lower = 0, upper = 0;  ///< ratio to the target [-]
    double from_s = 0, to_s = 0;  ///< [s]
};

/// NUREG-0800 SRP 3.7.1 (rev. 4, 2014), option 1, approach 2: nowhere more than 10 % below the target nor more than 30
/// % above it, from 0.1 Hz to 50 Hz.
[[nodiscard]] AcceptanceBand srp_acceptance_band();

/// A body as the energy criterion sees it.
struct FigureBody {
    std::string name;
    double limit_velocity_mps = 0;  ///< V_Ereq [m/s]
    PeriodBand band;
    std::vector<double> v_wes_mps;  ///< at every sample and on until the wave has left the window [m/s]
};

struct WaveFigure {
    std::string title;
    std::string subtitle;  ///< source of the wave
    GroundMotion motion;
    double damping = 0.05;  ///< of the response spectrum [-]
    std::optional<TargetSpectrum> target;
    std::vector<AcceptanceBand> bands;
    std::vector<FigureBody> bodies;
    struct Unit {
        std::string symbol = "m/s";
        double si = 1;  ///< SI value of one of it
    };
    Unit velocities;                   ///< unit of drawn velocities
    Unit accelerations = {"m/s2", 1};  ///< and of drawn accelerations
    Unit lengths = {"m", 1};           ///< and of drawn displacements
};

/// Data of the figure, for pages that hold it among others.
[[nodiscard]] nlohmann::ordered_json wave_data(WaveFigure const& figure);

/// \throws as draw_figure
void draw_wave(WaveFigure const& figure, std::filesystem::path const& output);

}  // namespace overturn::report
