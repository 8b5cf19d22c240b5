#include "output/stated_curve.hpp"

#include <optional>
#include <span>

#include <fmt/format.h>

#include "campaign/intensity_measure.hpp"
#include "output/curve_spread.hpp"
#include "output/table.hpp"

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

Table stated_curve_table(StatedCurve const& curve) {
    using Row = StatedCurve;
    auto const unit = stated_unit(curve.unit.symbol);
    TableOf<Row> table({.name = "stated_curve", .constants = {{"units", curve.unit.symbol}}}, std::span(&curve, 1));
    table.add("median", unit, "intensity of P = 0.5, as stated", [](Row const& c) { return c.unit.of(c.median); })
        .add("beta", "1", "lognormal standard deviation: of waves alone with beta_u, else of all",
             [](Row const& c) { return c.beta; })
        .add("beta_u", "1", "epistemic uncertainty beta_U; null: not stated",
             [](Row const& c) { return c.hclpf() ? std::optional(c.beta_u) : std::nullopt; })
        .add("five_percent_point", unit, "median exp(-1.645 beta)",
             [](Row const& c) { return c.unit.of(c.five_percent_point()); })
        .add("one_percent_point", unit, "median exp(-2.326 sqrt(beta^2 + beta_u^2))",
             [](Row const& c) { return c.unit.of(c.one_percent_point()); })
        .add("hclpf", unit, "median exp(-1.645 (beta + beta_u)); null: beta_u is not stated", [](Row const& c) {
            auto const hclpf = c.hclpf();
            return hclpf ? std::optional(c.unit.of(*hclpf)) : std::nullopt;
        });
    return table.take();
}

Json json_of(StatedCurve const& curve) {
    auto json = json_of(stated_curve_table(curve)).front();
    json["warnings"] = warnings_of(curve);
    return json;
}

}  // namespace overturn::output
