#include "report/wave_figure.hpp"

#include <utility>

#include <nlohmann/json.hpp>

#include "motion/intensity.hpp"
#include "report/figure.hpp"
#include "spectra/input_energy.hpp"
#include "spectra/response_spectrum.hpp"

namespace overturn::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr double shortest_s = 0.02;
constexpr double longest_s = 20;
constexpr std::size_t period_count = 300;
constexpr double default_energy_damping = 0.10;  // what the criterion's source plots

// The target where it is defined, of these periods. \param key of its values, as `value` gives them
Json target_json(TargetSpectrum const& target, std::vector<double> const& periods, char const* key,
                 double (TargetSpectrum::*value)(double) const) {
    std::vector<double> within;
    std::vector<double> values;
    for (double const period : periods) {
        if (target.defined_at(period)) {
            within.push_back(period);
            values.push_back((target.*value)(period));
        }
    }
    return {{"name", target.name()}, {"period_s", within}, {key, values}};
}

Json bands_json(std::vector<AcceptanceBand> const& bands) {
    auto list = Json::array();
    for (auto const& band : bands) {
        list.push_back({{"name", band.name},
                        {"lower", band.lower},
                        {"upper", band.upper},
                        {"from_s", band.from_s},
                        {"to_s", band.to_s}});
    }
    return list;
}

Json bodies_json(WaveFigure const& figure) {
    auto bodies = Json::array();
    for (auto const& body : figure.bodies) {
        bodies.push_back({{"name", body.name},
                          {"v_ereq_mps", body.limit_velocity_mps},
                          {"t0_s", body.band.t0_s},
                          {"t1_s", body.band.t1_s},
                          {"v_wes_mps", body.v_wes_mps}});
    }
    return bodies;
}

}  // namespace

AcceptanceBand srp_acceptance_band() { return {"SRP 3.7.1: \u221210 % to +30 %", 0.9, 1.3, 0.02, 10}; }

Json unit_json(WaveFigure::Unit const& unit) { return {{"symbol", unit.symbol}, {"si", unit.si}}; }

Json wave_data(WaveFigure const& figure) {
    auto const& motion = figure.motion;
    double const step = motion.time_step_s;
    auto const periods = log_periods(shortest_s, longest_s, period_count);
    auto const intensity = intensity_of(motion.horizontal_mps2, step);
    bool const energy_target = figure.target && figure.target->is_energy();
    double const energy_damping = energy_target ? figure.target->damping() : default_energy_damping;
    Json data{{"title", figure.title},
              {"subtitle", figure.subtitle},
              {"units",
               {{"velocity", unit_json(figure.velocities)},
                {"acceleration", unit_json(figure.accelerations)},
                {"length", unit_json(figure.lengths)}}},
              {"pga_mps2", intensity.pga_mps2},
              {"pgv_mps", intensity.pgv_mps},
              {"pgd_m", intensity.pgd_m},
              {"time_step_s", step},
              {"acceleration_mps2", motion.horizontal_mps2},
              {"velocity_mps", velocity_of(motion.horizontal_mps2, step)},
              {"displacement_m", displacement_of(motion.horizontal_mps2, step)},
              {"period_s", periods},
              {"damping", figure.damping},
              {"psa_mps2", response_spectrum(motion.horizontal_mps2, step, periods, figure.damping).psa_mps2},
              {"energy_damping", energy_damping},
              {"v_e_mps", input_energy_velocities(motion.horizontal_mps2, step, periods, energy_damping)},
              {"v_e0_mps", undamped_energy_velocities(motion.horizontal_mps2, step, periods)},
              {"bodies", bodies_json(figure)}};
    data["further"] = Json::array();
    for (auto const& [name, values] :
         {std::pair{"transverse", &motion.transverse_mps2}, std::pair{"vertical", &motion.vertical_mps2}}) {
        if (!values->empty()) {
            data["further"].push_back(
                {{"name", name},
                 {"acceleration_mps2", *values},
                 {"psa_mps2", response_spectrum(*values, step, periods, figure.damping).psa_mps2}});
        }
    }
    if (energy_target) {  // stands beside V_E, not beside the response
        data["energy_target"] = target_json(*figure.target, periods, "v_e_mps", &TargetSpectrum::psv_mps);
    } else if (figure.target) {
        data["target"] = target_json(*figure.target, periods, "psa_mps2", &TargetSpectrum::psa_mps2);
        data["target"]["bands"] = bands_json(figure.bands);
    }
    return data;
}

void draw_wave(WaveFigure const& figure, std::filesystem::path const& output) {
    draw_figure("wave_figure.py", wave_data(figure), output);
}

}  // namespace overturn::report
