#include "cli/rocking_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include "campaign/warnings.hpp"
#include "cli/json_values.hpp"
#include "cli/number_grid.hpp"
#include "core/error.hpp"
#include "core/outward.hpp"
#include "core/units.hpp"
#include "motion/intensity.hpp"
#include "rocking/rocking_models.hpp"

namespace overturn::cli {
namespace {

double housner_restitution(double alpha_rad) { return 1 - 1.5 * std::pow(std::sin(alpha_rad), 2); }

std::vector<RockingBlock> stated_blocks(std::string const& alphas, std::optional<double> restitution) {
    validate(!restitution || (*restitution >= 0 && *restitution <= 1),
             "--restitution {} (angular velocity behind an impact over that before it, 0 to 1). Mend it",
             restitution.value_or(0));
    std::string_view const stated = alphas.empty() ? "10 deg,15 deg,20 deg" : std::string_view(alphas);
    std::vector<RockingBlock> blocks;
    for (auto const part : parts_of(stated, ',')) {
        double const alpha = parse_quantity(std::string(trimmed(part)), Dimension::angle);
        validate(alpha > 0 && alpha < pi / 2, "--alpha {} (must lie between 0 and 90 deg). Mend it", part);
        double const e = restitution.value_or(housner_restitution(alpha));
        validate(e >= 0,
                 "--alpha {} (Housner's restitution is {:.3g}: such a block does not rock on). State --restitution",
                 part, e);
        blocks.push_back({.alpha_rad = alpha, .restitution = e});
    }
    return blocks;
}

RockingBlock block_of_file(RockingSpectrum& spectrum, std::string const& body) {
    auto const spec = load_body(body);
    validate(!spec.body.needs_planar_rocking(),
             "{}: slope, offset or initial tilt (a rocking spectrum is of symmetric bodies at rest). Leave it out",
             body);
    note_warnings(warnings_of(spec));
    spectrum.body = spec.name;
    auto const block = block_of(spec.body);
    spectrum.body_period_s = 2 * pi / block.p_radps;
    return block;
}

RockingCurve curve_of(RockingBlock block, Excitation const& shaking, std::vector<double> const& periods) {
    std::vector<RockingTrial> trials;
    for (double const period : periods) {
        block.p_radps = 2 * pi / period;
        trials.push_back({block, shaking});
    }
    std::vector<RockingOutcome> outcomes(trials.size());
    simulate_rocking(trials, {}, Slip::ignored, outcomes);
    RockingCurve curve{.alpha_rad = block.alpha_rad, .restitution = block.restitution, .points = {}};
    for (std::size_t i = 0; i < periods.size(); ++i) {
        curve.points.push_back({periods[i], outcomes[i].peak_rotation_rad, outcomes[i].verdict});
    }
    return curve;
}

bool tilt_is_known(Verdict verdict) { return verdict == Verdict::at_rest || verdict == Verdict::rocked; }

char const* fate_of(Verdict verdict) {
    return verdict == Verdict::overturned ? "overturns" : tilt_is_known(verdict) ? "stands" : "undecided";
}

std::string cell_of(RockingCurve const& curve, RockingCurve::Point const& point) {
    return tilt_is_known(point.verdict) ? fmt::format("{:g}", rounded_up(point.peak_rotation_rad / curve.alpha_rad))
                                        : fate_of(point.verdict);
}

}  // namespace

void RockingSpectrumOptions::offered_by(Verb& verb) {
    verb.takes("--rocking", asked, "how far blocks of many sizes tilt under the wave; with --alpha, --restitution");
    verb.takes("--rocking-periods", periods,
               "their 2 pi / p [s]: 1,2,5 or first:last:count; default 1:8:36 (uniform blocks of R = 0.19 to 12 m)");
}

RockingSpectrum rocking_spectrum(RockingSpectrumOptions const& options, RecordOptions const& record,
                                 std::string const& alphas, std::optional<double> restitution,
                                 std::string const& body) {
    validate(!record.wave.empty(), "--wave (missing). State the record of the rocking spectrum");
    validate(body.empty() || (alphas.empty() && !restitution),
             "--alpha and --restitution beside --body (it states them). Leave one of them out");
    RockingSpectrum spectrum;
    auto const blocks =
        body.empty() ? stated_blocks(alphas, restitution) : std::vector<RockingBlock>{block_of_file(spectrum, body)};
    auto periods = number_grid(options.periods.empty() ? "1:8:36" : options.periods, "--rocking-periods");
    if (spectrum.body_period_s) {
        periods.push_back(*spectrum.body_period_s);
    }
    std::ranges::sort(periods);
    auto const placed = load_motion(record);
    validate_rocking_plane(placed.direction, {record.wave});
    note_warnings(warnings_of(placed.motion));
    spectrum.record = std::filesystem::path(record.wave).filename().string();
    spectrum.pga_mps2 = peak_of(placed.motion.horizontal_mps2);
    Excitation const shaking{.horizontal_mps2 = placed.motion.horizontal_mps2,
                             .vertical_mps2 = placed.motion.vertical_mps2,
                             .time_step_s = placed.motion.time_step_s};
    for (auto const& block : blocks) {
        spectrum.curves.push_back(curve_of(block, shaking, periods));
    }
    return spectrum;
}

nlohmann::ordered_json json_of(RockingSpectrum const& spectrum) {
    auto curves = Json::array();
    for (auto const& curve : spectrum.curves) {
        auto points = Json::array();
        for (auto const& point : curve.points) {
            bool const known = tilt_is_known(point.verdict);
            points.push_back({{"rocking_period_s", point.period_s},
                              {"p_radps", 2 * pi / point.period_s},
                              {"fate", fate_of(point.verdict)},
                              {"peak_rotation_rad", or_null(known, point.peak_rotation_rad)},
                              {"peak_rotation_over_alpha", or_null(known, point.peak_rotation_rad / curve.alpha_rad)}});
        }
        curves.push_back(
            {{"alpha_rad", curve.alpha_rad}, {"restitution", curve.restitution}, {"points", std::move(points)}});
    }
    Json json{{"record", spectrum.record}, {"pga_mps2", spectrum.pga_mps2}};
    if (spectrum.body_period_s) {
        json["body"] = spectrum.body;
        json["body_rocking_period_s"] = *spectrum.body_period_s;
    }
    json["curves"] = std::move(curves);
    return json;
}

std::string csv_of(RockingSpectrum const& spectrum) {
    std::string csv =
        "alpha_rad,restitution,rocking_period_s,p_radps,fate,peak_rotation_rad,peak_rotation_over_alpha\n";
    auto const out = std::back_inserter(csv);
    for (auto const& curve : spectrum.curves) {
        for (auto const& point : curve.points) {
            fmt::format_to(out, "{},{},{},{},{},", curve.alpha_rad, curve.restitution, point.period_s,
                           2 * pi / point.period_s, fate_of(point.verdict));
            if (tilt_is_known(point.verdict)) {
                fmt::format_to(out, "{},{}\n", point.peak_rotation_rad, point.peak_rotation_rad / curve.alpha_rad);
            } else {
                csv += ",\n";
            }
        }
    }
    return csv;
}

std::string text_of(RockingSpectrum const& spectrum) {
    std::string text = fmt::format(
        "largest rotation over alpha under {} (PGA {:.5g} m/s2): rigid blocks on two corners, in one plane, without "
        "slip\n",
        spectrum.record, spectrum.pga_mps2);
    auto const out = std::back_inserter(text);
    if (spectrum.body_period_s) {
        fmt::format_to(out, "{}: 2 pi / p = {:.5g} s\n", spectrum.body, *spectrum.body_period_s);
    }
    auto const row = [&](char const* head, auto const& of_curve) {
        fmt::format_to(out, "{:>8} {:>8}", head, "");
        for (auto const& curve : spectrum.curves) {
            fmt::format_to(out, " {:>10}", of_curve(curve));
        }
        text += '\n';
    };
    row("alpha", [](RockingCurve const& curve) { return fmt::format("{:.4g} deg", curve.alpha_rad * 180 / pi); });
    row("e", [](RockingCurve const& curve) { return fmt::format("{:.4g}", curve.restitution); });
    fmt::format_to(out, "{:>8} {:>8}\n{:>8} {:>8}\n", "2 pi / p", "p", "s", "rad/s");
    for (std::size_t i = 0; i < spectrum.curves.front().points.size(); ++i) {
        double const period = spectrum.curves.front().points[i].period_s;
        fmt::format_to(out, "{:>8.4g} {:>8.4g}", period, 2 * pi / period);
        for (auto const& curve : spectrum.curves) {
            fmt::format_to(out, " {:>10}", cell_of(curve, curve.points[i]));
        }
        text += '\n';
    }
    return text;
}

}  // namespace overturn::cli
