#include "output/rocking_text.hpp"

#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "core/outward.hpp"
#include "core/units.hpp"
#include "core/wrapped.hpp"
#include "output/detail/left_out.hpp"

namespace overturn::output {
namespace {

bool tilt_is_known(Verdict verdict) { return verdict == Verdict::at_rest || verdict == Verdict::rocked; }

char const* fate_of(Verdict verdict) {
    return verdict == Verdict::overturned ? "overturns" : tilt_is_known(verdict) ? "stands" : "undecided";
}

std::string cell_of(RockingCurve const& curve, RockingCurve::Point const& point) {
    return tilt_is_known(point.verdict) ? fmt::format("{:g}", rounded_up(point.peak_rotation_rad / curve.alpha_rad))
                                        : fate_of(point.verdict);
}

Json if_known(RockingCurve::Point const& point, double value) {
    return tilt_is_known(point.verdict) ? Json(value) : Json(nullptr);
}

}  // namespace

Json json_of(RockingSpectrum const& spectrum) {
    auto curves = Json::array();
    for (auto const& curve : spectrum.curves) {
        auto points = Json::array();
        for (auto const& point : curve.points) {
            points.push_back({{"rocking_period_s", point.period_s},
                              {"p_radps", 2 * pi / point.period_s},
                              {"fate", fate_of(point.verdict)},
                              {"peak_rotation_rad", if_known(point, point.peak_rotation_rad)},
                              {"peak_rotation_ratio", if_known(point, point.peak_rotation_rad / curve.alpha_rad)}});
        }
        curves.push_back(
            {{"alpha_rad", curve.alpha_rad}, {"restitution", curve.restitution}, {"points", std::move(points)}});
    }
    Json json{{"record", spectrum.record},
              {"pga_mps2", spectrum.pga_mps2},
              {"stated", {{"pga", stated_json(spectrum.pga_mps2, spectrum.units.acceleration)}}}};
    if (spectrum.body_period_s) {
        json["body"] = spectrum.body;
        json["body_rocking_period_s"] = *spectrum.body_period_s;
        json["left_out"] = spectrum.left_out;
    }
    json["curves"] = std::move(curves);
    return json;
}

std::string csv_of(RockingSpectrum const& spectrum) {
    std::string csv = "alpha_rad,restitution,rocking_period_s,p_radps,fate,peak_rotation_rad,peak_rotation_ratio\n";
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
    auto text = wrapped(fmt::format(
        "largest rotation over alpha under {} (PGA {:.5g} {}): rigid blocks on two corners, in one plane, without "
        "slip",
        spectrum.record, spectrum.units.acceleration.of(spectrum.pga_mps2), spectrum.units.acceleration.symbol));
    auto const out = std::back_inserter(text);
    if (spectrum.body_period_s) {
        fmt::format_to(out, "{}: 2 pi / p = {:.5g} s\n", spectrum.body, *spectrum.body_period_s);
        text += left_out_text(spectrum.left_out);
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

}  // namespace overturn::output
