#include "output/detail/together_text.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "output/interval_text.hpp"
#include "output/shown_levels.hpp"

namespace overturn::output {
namespace {

std::string phi_text(std::optional<double> const& phi) { return phi ? fmt::format("{:+.2f}", *phi) : "-"; }

std::string slope_text(Estimate const& estimate) {
    return fmt::format("{:.3g} {}", estimate.value, interval_text(estimate.interval));
}

std::string said_of(std::string const& name, CampaignSpec const& spec) {
    auto const limit = std::ranges::find(spec.limits, name, &LimitState::name);
    return limit == spec.limits.end() ? name : said_name(*limit, spec.limits);
}

}  // namespace

std::string together_text(CampaignSpec const& spec, std::span<BodiesTogether const> together, double confidence) {
    constexpr std::size_t most_pairs = 6;  // columns that a terminal holds
    std::string text;
    for (auto const& of : together) {
        auto const shown = std::min(of.joint.pairs.size(), most_pairs);
        std::vector<std::string> heads;
        for (std::size_t p = 0; p < shown; ++p) {
            auto const& pair = of.joint.pairs[p];
            heads.push_back(fmt::format("{}/{}", spec.bodies[pair.first].name, spec.bodies[pair.second].name));
        }
        auto const did =
            of.passing == Passing::exceeded ? "exceeds " + said_of(of.limit, spec) : std::string("overturns");
        auto const left = shown < of.joint.pairs.size()
                              ? fmt::format(" (the first {} of {} pairs; all in --json)", shown, of.joint.pairs.size())
                              : std::string();
        text += fmt::format("\nany of {} bodies {} under one wave; phi: correlation of two bodies' ends under it{}\n",
                            spec.bodies.size(), did, left);
        text += fmt::format("{:>12} {:>7} {:>7} {:>9} {:>8} {:>20} {:>14}  {}\n",
                            fmt::format("{} {}", spec.levels.measure_name(), spec.levels.shown_units()), "waves", "any",
                            "undecided", "P", fmt::format("{:g} % interval", 100 * confidence), "if independent",
                            fmt::join(heads, "  "));
        for (auto const l : shown_levels(spec.levels)) {
            auto const& any = of.joint.any[l];
            std::vector<std::string> phis;
            for (std::size_t p = 0; p < shown; ++p) {
                phis.push_back(fmt::format("{:>{}}", phi_text(of.joint.pairs[p].phi[l]), heads[p].size()));
            }
            text += fmt::format("{:>12.4g} {:>7} {:>7} {:>9} {:>8.4f} {:>20} {:>14.4f}  {}\n",
                                spec.levels.shown(any.amplitude), any.trials, any.overturned, any.undecided,
                                any.probability(), interval_text(any.interval(confidence)), of.joint.if_independent[l],
                                fmt::join(phis, "  "));
        }
        text += left_out_levels(spec.levels);
        std::vector<std::string> pooled;
        for (std::size_t p = 0; p < shown; ++p) {
            pooled.push_back(fmt::format("{} {}", heads[p], phi_text(of.joint.pairs[p].pooled)));
        }
        text += fmt::format("  phi pooled over levels: {}\n", fmt::join(pooled, ", "));
    }
    return text;
}

std::string two_measures_text(CampaignSpec const& spec, std::span<TwoMeasures const> fits, double confidence) {
    std::string text =
        fmt::format("\nP over two measures (SI), {:g} % intervals by resampling waves\n", 100 * confidence);
    for (auto const& of : fits) {
        auto const who =
            of.limit == overturning_limit ? of.body : fmt::format("{}, {}", of.body, said_of(of.limit, spec));
        if (!of.fit) {
            text += fmt::format(
                "  {}: no curve over {} and {} (all ended alike, are separated, or one measure is the "
                "other's multiple)\n",
                who, of.names[0], of.names[1]);
            continue;
        }
        auto const& fit = *of.fit;
        text += fmt::format(
            "  {}: P = Phi({:.4g} {:+.4g} ln {} {:+.4g} ln {}); ln {} {}, ln {} {}, beta where both scale {}; deviance "
            "{:.4g} below that of {} alone, the better one\n",
            who, fit.constant.value, fit.slopes[0].value, of.names[0], fit.slopes[1].value, of.names[1], of.names[0],
            slope_text(fit.slopes[0]), of.names[1], slope_text(fit.slopes[1]), slope_text(fit.beta), fit.deviance_gain,
            of.names.at(fit.better));
    }
    return text;
}

}  // namespace overturn::output
