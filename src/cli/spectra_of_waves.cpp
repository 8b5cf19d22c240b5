#include "cli/spectra_of_waves.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "campaign/plan.hpp"
#include "campaign/rocking_band.hpp"
#include "campaign/wave_check.hpp"
#include "cli/figures.hpp"
#include "cli/json_values.hpp"
#include "core/error.hpp"
#include "spectra/band_rule.hpp"
#include "spectra/input_energy.hpp"
#include "spectra/response_spectrum.hpp"
#include "stats/quantile.hpp"

namespace overturn::cli {
namespace {

using Rows = std::vector<std::vector<double>>;  // by wave, by period

SpectrumBand band_of(Rows const& rows, std::int64_t independent) {
    constexpr double low = 0.15865525393145707;  // of a normal's one standard deviation
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    SpectrumBand band;
    band.few = independent < fewest_for_quantile(low);
    std::vector<double> column(rows.size());
    for (std::size_t period = 0; period < rows.front().size(); ++period) {
        std::ranges::transform(rows, column.begin(), [&](auto const& row) { return row[period]; });
        std::ranges::sort(column);
        bool const known = !std::isnan(column.front()) && !std::isnan(column.back());
        auto const at = [&](double q) { return known ? quantile(column, q) : unknown; };
        auto const percentile = [&](double q) { return independent < fewest_for_quantile(q) ? unknown : at(q); };
        band.lowest.push_back(known ? column.front() : unknown);
        band.p16.push_back(percentile(low));
        band.p50.push_back(percentile(0.5));
        band.p84.push_back(percentile(1 - low));
        band.highest.push_back(known ? column.back() : unknown);
    }
    return band;
}

std::vector<double> psa_of(TargetSpectrum const& target, std::vector<double> const& periods) {
    std::vector<double> psa;
    std::ranges::transform(periods, std::back_inserter(psa), [&](double period_s) {
        return target.defined_at(period_s) ? target.psa_mps2(period_s) : std::numeric_limits<double>::quiet_NaN();
    });
    return psa;
}

Json band_json(SpectrumBand const& band) {
    return {
        {"lowest", band.lowest}, {"p16", band.p16}, {"p50", band.p50}, {"p84", band.p84}, {"highest", band.highest}};
}

}  // namespace

SpectraOfWaves spectra_of_waves(CampaignInput const& input, CampaignSpec const& spec, std::int64_t count,
                                double energy_damping) {
    constexpr double shortest_s = 0.02;
    constexpr double longest_s = 20;
    constexpr std::size_t periods = 121;
    SpectraOfWaves all;
    all.energy_damping = energy_damping;
    all.period_s = log_periods(shortest_s, longest_s, periods);
    auto target = target_of(input);
    if (target) {
        all.damping = target->damping();
    }
    if (target && target->is_energy()) {
        target.reset();
    }
    if (target) {
        all.target = target->name();
        all.stated_psa_mps2 = psa_of(*target, all.period_s);
    }
    Plan const plan(spec);
    Rows psa, v_e, targets;
    auto const most = static_cast<std::size_t>(std::min(count, plan.asked()));
    bool const refuses = spec.source->about().acceptance.refuses();
    for (std::int64_t number = 0; number < plan.waves() && all.waves.size() + all.left_out < most; ++number) {
        try {
            auto const made = spec.source->make(spec.seed, plan.wave_id(number));
            if (refuses && !all_passed(check_wave(made, spec.bodies, spec.measures.radius_unit).clauses)) {
                continue;  // no trial, so no part of what trials see
            }
            auto const& a = made.motion.horizontal_mps2;
            double const step = made.motion.time_step_s;
            psa.push_back(response_spectrum(a, step, all.period_s, all.damping).psa_mps2);
            v_e.push_back(input_energy_velocities(a, step, all.period_s, energy_damping));
            all.waves.push_back({number, made.label, psa.back(), v_e.back()});
            if (made.drawn && target) {
                targets.push_back(psa_of(target->shaped(made.drawn->shape), all.period_s));
            }
        } catch (InputError const&) {
            ++all.left_out;
        }
    }
    validate(!all.waves.empty(), "none of the first {} waves can be made. See overturn wave CAMPAIGN --wave 0", count);
    auto const shared = spec.source->about().shared.effect();
    auto const independent = SharedDraws::whole(static_cast<double>(psa.size()) / shared);
    all.psa_mps2 = band_of(psa, independent);
    all.v_e_mps = band_of(v_e, independent);
    if (!targets.empty()) {
        all.targets = band_of(targets, independent);
    }
    return all;
}

Json spectra_json(CampaignSpec const& spec, SpectraOfWaves const& spectra) {
    Json json{{"title", spec.title},
              {"waves", spectra.waves.size()},
              {"left_out", spectra.left_out},
              {"remarks", spec.source->about().remarks},
              {"variability", spec.source->about().variability},
              {"damping", spectra.damping},
              {"energy_damping", spectra.energy_damping},
              {"period_s", spectra.period_s},
              {"psa_mps2", band_json(spectra.psa_mps2)},
              {"v_e_mps", band_json(spectra.v_e_mps)},
              {"target", nullptr},
              {"bodies", Json::array()},
              {"each", Json::array()}};
    if (!spectra.target.empty()) {
        json["target"] = {{"name", spectra.target}, {"psa_mps2", spectra.stated_psa_mps2}, {"drawn_psa_mps2", nullptr}};
        if (spectra.targets) {
            json["target"]["drawn_psa_mps2"] = band_json(*spectra.targets);
        }
    }
    for (auto const& body : spec.bodies) {
        auto const band = rocking_band(body.body, spec.measures.radius_unit);
        json["bodies"].push_back({{"name", body.name},
                                  {"t0_s", band.t0_s},
                                  {"t1_s", band.t1_s},
                                  {"v_ereq_mps", body.body.limit_velocity_mps()}});
    }
    for (auto const& wave : spectra.waves) {
        json["each"].push_back(
            {{"wave", wave.number}, {"label", wave.label}, {"psa_mps2", wave.psa_mps2}, {"v_e_mps", wave.v_e_mps}});
    }
    return json;
}

}  // namespace overturn::cli
