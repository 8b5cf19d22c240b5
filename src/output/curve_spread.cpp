#include "output/curve_spread.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/usual_range.hpp"
#include "stats/scores.hpp"

namespace overturn::output {
namespace {

constexpr double widest = 5;
constexpr double not_asked = std::numeric_limits<double>::quiet_NaN();

double found_r(CurveSpread const& of) { return of.beta_r > 0 && !of.beta_r_stated ? of.beta_r : not_asked; }
double stated_r(CurveSpread const& of) { return of.beta_r_stated ? of.beta_r : not_asked; }
double drawn_u(CurveSpread const& of) { return of.beta_u > 0 && !of.beta_u_stated ? of.beta_u : not_asked; }
double stated_u(CurveSpread const& of) { return of.beta_u_stated ? of.beta_u : not_asked; }

std::string waves_text(CurveSpread const& spread, double value) {
    return fmt::format("{} {:.3g} divides the 5 % point and HCLPF by {:.3g}", spread.beta_u > 0 ? "beta_R" : "beta",
                       value, std::exp(hclpf_score * value));
}
std::string unknown_text(CurveSpread const& /*spread*/, double value) {
    return fmt::format("beta_U {:.3g} divides HCLPF by {:.3g}", value, std::exp(hclpf_score * value));
}

constexpr std::string_view usual = "usual: 0.2 to 0.6";
constexpr std::string_view as_share = "Check it: 0.4 for 40 %";
constexpr std::array spread_ranges{
    UsualRange<CurveSpread>{&found_r, 0, 1, &waves_text, usual,
                            "Check that the levels' measure is one that overturning hangs on"},
    UsualRange<CurveSpread>{&stated_r, 0.1, 1, &waves_text, usual, as_share},
    UsualRange<CurveSpread>{&drawn_u, 0, 1, &unknown_text, usual, "Check the distributions of the body"},
    UsualRange<CurveSpread>{&stated_u, 0.1, 1, &unknown_text, usual, as_share}};

}  // namespace

std::vector<std::string> unusual_spread(CurveSpread const& spread) {
    return unusual(spread, std::span<UsualRange<CurveSpread> const>(spread_ranges));
}

void check_spread(std::string_view option, double beta) {
    validate(beta <= widest,
             "{}: {} (more than {}, which no curve has: it would divide HCLPF by {:.2g}). Write 0.4 for 40 %", option,
             beta, widest, std::exp(hclpf_score * beta));
}

}  // namespace overturn::output
