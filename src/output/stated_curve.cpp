#include "output/stated_curve.hpp"

#include <fmt/format.h>

#include "campaign/intensity_measure.hpp"
#include "output/curve_spread.hpp"

namespace overturn::output {

std::vector<std::string> warnings_of(StatedCurve const& curve) {
    auto lines = unusual_spread({curve.beta, curve.beta_u, true, curve.beta_u > 0});
    // A median that no motion reaches, or under which nothing stands, is in another unit.
    auto const* const like = measure_named(curve.dimension == Dimension::acceleration ? "pga"
                                           : curve.dimension == Dimension::velocity   ? "pgv"
                                                                                      : "pgd");
    auto const& usual = like->plausible;
    if (curve.median > usual.most || curve.median < usual.least) {
        lines.push_back(fmt::format("median {} ({}, casks stand below {:g} {}). Check its unit",
                                    curve.unit.text(curve.median), usual.known, usual.least / usual.unit_si,
                                    usual.unit));
    }
    return lines;
}

std::string text_of(StatedCurve const& curve) {
    auto const& unit = curve.unit;
    auto const hclpf = curve.hclpf();
    auto text = fmt::format(
        "stated curve (no trials): median {}, {} {:g}{}\n  5 % point {}, HCLPF {}, 1 % point {}\n",
        unit.text(curve.median), hclpf ? "beta_R" : "beta", curve.beta,
        hclpf ? fmt::format(", beta_U {:g}", curve.beta_u) : std::string(), unit.text(curve.five_percent_point()),
        hclpf ? unit.text(*hclpf) : std::string("not known without --beta-u"), unit.text(curve.one_percent_point()));
    for (auto const& line : warnings_of(curve)) {
        text += fmt::format("  note: {}\n", line);
    }
    return text;
}

Json json_of(StatedCurve const& curve) {
    auto const& unit = curve.unit;
    Json json{{"units", unit.symbol},
              {"median", unit.of(curve.median)},
              {"beta", curve.beta},
              {"beta_u", nullptr},
              {"five_percent_point", unit.of(curve.five_percent_point())},
              {"one_percent_point", unit.of(curve.one_percent_point())},
              {"hclpf", nullptr},
              {"warnings", warnings_of(curve)}};
    if (auto const hclpf = curve.hclpf()) {
        json["beta_u"] = curve.beta_u;
        json["hclpf"] = unit.of(*hclpf);
    }
    return json;
}

}  // namespace overturn::output
