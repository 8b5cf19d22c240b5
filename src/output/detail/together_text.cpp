#include "output/detail/together_text.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/wrapped.hpp"
#include "output/detail/interval_text.hpp"
#include "output/detail/level_columns.hpp"
#include "output/shown_levels.hpp"

namespace overturn::output {
namespace {

std::string phi_text(std::optional<double> const& phi) { return phi ? fmt::format("{:+.2f}", *phi) : "-"; }

std::string slope_text(Estimate const& estimate) {
    return fmt::format("{:.3g} {}", estimate.value, interval_text(estimate.interval));
}

std::string name_in_text(std::string const& name, CampaignSpec const& spec) {
    auto const limit = std::ranges::find(spec.limits, name, &LimitState::name);
    return limit == spec.limits.end() ? name : full_name(*limit, spec.limits);
}

// Does nothing distinguish them but what is often assumed of a cask: friction, restitution, pad?
bool may_be_one(BodySpec const& a, BodySpec const& b) {
    auto const shape = [](BodySpec const& body) {
        auto const& stated = body.stated;
        return std::array{stated.mass_kg, stated.half_width_m, stated.centre_height_m, stated.inertia_kgm2,
                          stated.gravity_mps2};
    };
    return shape(a) == shape(b) && a.footing.base.shape == b.footing.base.shape;
}

}  // namespace

std::string alternatives_text(CampaignSpec const& spec) {
    for (auto const& body : spec.bodies) {
        std::vector<std::string> alike;
        for (auto const& other : spec.bodies) {
            if (may_be_one(body, other)) {
                alike.push_back(other.name);
            }
        }
        if (alike.size() > 1) {
            return fmt::format(
                "{} have one mass and one shape. If they are one cask under several assumptions, P of any of them "
                "means nothing: quote the largest P of one.",
                fmt::join(alike, ", "));
        }
    }
    return {};
}

std::string together_text(CampaignSpec const& spec, std::span<BodiesTogether const> together, double confidence) {
    constexpr std::size_t most_pairs = 6;  // columns that a terminal holds
    std::string text;
    if (auto const note = alternatives_text(spec); !note.empty() && !together.empty()) {
        text += "\n" + wrapped("note: " + note, 6);
    }
    for (auto const& of : together) {
        auto const shown = std::min(of.joint.pairs.size(), most_pairs);
        std::vector<std::string> heads;
        for (std::size_t p = 0; p < shown; ++p) {
            auto const& pair = of.joint.pairs[p];
            heads.push_back(fmt::format("{}/{}", spec.bodies[pair.first].name, spec.bodies[pair.second].name));
        }
        auto const did =
            of.passing == Passing::exceeded ? "exceeds " + name_in_text(of.limit, spec) : std::string("overturns");
        auto const left = shown < of.joint.pairs.size()
                              ? fmt::format(" (the first {} of {} pairs; all in --json)", shown, of.joint.pairs.size())
                              : std::string();
        text += fmt::format("\nany of {} bodies {} under one wave; phi: correlation of the outcomes of two bodies{}\n",
                            spec.bodies.size(), did, left);
        auto const levels = shown_levels(spec.levels);
        TextGroup any_of{level_column(spec.levels, levels),
                         {"waves"},
                         {"any"},
                         {"undecided"},
                         {"P"},
                         {fmt::format("{:g} % interval", 100 * confidence)},
                         {"if independent"}};
        for (auto const l : levels) {
            auto const& any = of.joint.any[l];
            std::array const cells{std::to_string(any.trials),
                                   std::to_string(any.overturned),
                                   std::to_string(any.undecided),
                                   fmt::format("{:.4f}", any.probability()),
                                   interval_text(any.interval(confidence)),
                                   fmt::format("{:.4f}", of.joint.if_independent[l])};
            append_row(any_of, cells, 1);
        }
        std::vector<TextGroup> groups{any_of};
        for (std::size_t p = 0; p < shown; ++p) {
            TextColumn phis{heads[p]};
            for (auto const l : levels) {
                phis.cells.push_back(phi_text(of.joint.pairs[p].phi[l]));
            }
            groups.push_back({phis});
        }
        text += columns_text(groups);
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
            of.limit == overturning_limit ? of.body : fmt::format("{}, {}", of.body, name_in_text(of.limit, spec));
        if (!of.fit) {
            text += fmt::format(
                "  {}: no curve over {} and {} (all ended the same way, are separated, or one measure is the "
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
