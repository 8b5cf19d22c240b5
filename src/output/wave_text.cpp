#include "output/wave_text.hpp"

#include <utility>

#include <fmt/format.h>

#include "campaign/intensity_measure.hpp"
#include "campaign/rocking_band.hpp"
#include "campaign/warnings.hpp"
#include "motion/ground_motion.hpp"
#include "motion/intensity.hpp"
#include "output/json.hpp"
#include "output/record_text.hpp"

namespace overturn::output {
namespace {

std::string match_text(char const* name, MatchReport const& match) {
    if (match.all.mean_ratio == 0) {
        return "";
    }
    return fmt::format(
        "{}: mean misfit {:.2f} %, largest {:.2f} % at {:.3f} s, worst decade {:.2f} %, SI ratio {}, {} "
        "iterations\n",
        name, 100 * match.all.mean_misfit, 100 * match.all.max_misfit, match.all.max_misfit_period_s,
        100 * match.worst_decade,
        match.intensity_ratio > 0 ? fmt::format("{:.3f}", match.intensity_ratio) : "not covered (0.1 s to 2.5 s)",
        match.iterations);
}

// What of a body's band no target says anything about.
std::string uncovered_text(CampaignSpec const& spec, PeriodBand const& band) {
    auto const judged = spec.source->about().compared_periods;
    return judged && ends_inside(*judged, band)
               ? fmt::format(" (compared from {:.2f} s to {:.2f} s only)", judged->from_s, judged->to_s)
               : "";
}

Json figures_json(MatchFigures const& f) {
    return {{"mean_misfit", f.mean_misfit},
            {"max_misfit", f.max_misfit},
            {"max_misfit_period_s", f.max_misfit_period_s},
            {"mean_ratio", f.mean_ratio},
            {"ratio_cov", f.cov},
            {"lowest_ratio", f.lowest_ratio},
            {"highest_ratio", f.highest_ratio},
            {"longest_below", f.longest_below}};
}

Json match_json(MatchReport const& match) {
    auto json = figures_json(match.all);
    json["matched"] = match.matched;
    json["iterations"] = match.iterations;
    json["worst_decade"] = match.worst_decade;
    json["si_ratio"] = match.intensity_ratio > 0 ? Json(match.intensity_ratio) : Json();  // null: not covered
    json["psd_lowest_ratio"] = match.psd_lowest_ratio;
    json["psd_lowest_frequency_hz"] = match.psd_lowest_hz;
    return json;
}

}  // namespace

std::string wave_text(CampaignSpec const& spec, GeneratedWave const& wave, WaveCheck const& check) {
    auto text = match_text("match", wave.match) + match_text("transverse match", wave.transverse_match)
                + match_text("vertical match", wave.vertical_match);
    for (std::size_t b = 0; b < spec.bodies.size() && !wave.ratios.empty(); ++b) {
        auto const band = rocking_band(spec.bodies[b].body, spec.measures.radius_unit);
        text += fmt::format(
            "{} rocks at {:.2f} s to {:.2f} s: mean misfit {:.2f} %, largest {:.2f} %, mean ratio {:.3f}{}\n",
            spec.bodies[b].name, band.t0_s, band.t1_s, 100 * check.bands[b].mean_misfit,
            100 * check.bands[b].max_misfit, check.bands[b].mean_ratio, uncovered_text(spec, band));
    }
    if (auto const drift = spec.source->pgd_drift(); !drift.empty()) {
        text += fmt::format("its peak displacement is no ground's: {}\n", drift);
    }
    text += fmt::format("strong motion: {:.1f} s (5 to 75 %), {:.1f} s (5 to 95 %)\n", check.quality.duration_5_75_s,
                        check.quality.duration_5_95_s);
    for (auto const& clause : check.clauses) {
        text += fmt::format("{}: {}\n", spec.source->about().acceptance.rule, clause.text());
    }
    if (!check.clauses.empty()) {
        text += fmt::format("{}: {}\n", spec.source->about().acceptance.rule,
                            all_passed(check.clauses) ? "accepted" : "NOT accepted");
    }
    return text;
}

std::string wave_json(CampaignSpec const& spec, GeneratedWave const& wave, WaveCheck const& check) {
    auto const& q = check.quality;
    auto const intensity = intensity_of(wave.motion.horizontal_mps2, wave.motion.time_step_s);
    Json json{{"label", wave.label},
              {"time_step_s", wave.motion.time_step_s},
              {"duration_s", wave.motion.duration_s()},
              {"pga_mps2", intensity.pga_mps2},
              {"pgv_mps", intensity.pgv_mps},
              {"pgd_m", intensity.pgd_m},
              {"pgd_drift", spec.source->pgd_drift()},
              {"arias_mps", intensity.arias_mps},
              {"duration_5_75_s", q.duration_5_75_s},
              {"duration_5_95_s", q.duration_5_95_s},
              {"residual_velocity_mps", q.residual_velocity_mps},
              {"residual_displacement_m", q.residual_displacement_m},
              {"correlation", q.correlation}};
    for (auto const& [name, values] : {std::pair{"transverse_pga_mps2", &wave.motion.transverse_mps2},
                                       std::pair{"vertical_pga_mps2", &wave.motion.vertical_mps2}}) {
        if (!values->empty()) {
            json[name] = peak_of(*values);
        }
    }
    for (auto const& [measure, value] : measures_of(wave.motion)) {
        json[key_of(*measure)] = value;
    }
    if (!wave.ratios.empty()) {
        json["match"] = match_json(wave.match);
        json["bands"] = Json::array();
        for (std::size_t b = 0; b < spec.bodies.size(); ++b) {
            auto const band = rocking_band(spec.bodies[b].body, spec.measures.radius_unit);
            auto entry = figures_json(check.bands[b]);
            entry["body"] = spec.bodies[b].name;
            entry["t0_s"] = band.t0_s;
            entry["t1_s"] = band.t1_s;
            json["bands"].push_back(std::move(entry));
        }
    }
    for (auto const& [name, match] :
         {std::pair{"transverse_match", &wave.transverse_match}, std::pair{"vertical_match", &wave.vertical_match}}) {
        if (match->all.mean_ratio > 0) {
            json[name] = match_json(*match);
        }
    }
    Json acceptance{{"rule", spec.source->about().acceptance.rule}};
    acceptance["accepted"] = check.clauses.empty() ? Json() : Json(all_passed(check.clauses));
    acceptance["clauses"] = Json::array();
    for (auto const& clause : check.clauses) {
        acceptance["clauses"].push_back({{"name", clause.name},
                                         {"figure", clause.figure},
                                         {"limit", clause.limit},
                                         {"at_least", clause.at_least},
                                         {"passed", clause.passed()}});
    }
    json["acceptance"] = std::move(acceptance);
    return json.dump(2) + "\n";
}

}  // namespace overturn::output
