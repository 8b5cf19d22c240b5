#include "output/campaign_tables.hpp"

#include <algorithm>
#include <iterator>

#include "output/curve_tables.hpp"
#include "output/detail/acceptance_tables.hpp"
#include "output/detail/body_table.hpp"
#include "output/stripe_tables.hpp"
#include "output/summary_tables.hpp"
#include "results/few_waves.hpp"

namespace overturn::output {
namespace {

void append(std::vector<Table>& all, std::vector<Table> more) { std::ranges::move(more, std::back_inserter(all)); }

void add_body(std::vector<Table>& all, CampaignSpec const& spec, std::size_t b, BodyAnalysis const& analysis,
              double confidence) {
    all.push_back({.name = "grid"});
    all.push_back({.name = "quantiles"});
    if (analysis.grid) {
        all.push_back(grid_table(spec, spec.bodies[b], *analysis.grid));
        all.push_back(grid_level_table(spec, spec.bodies[b], *analysis.grid));
    }
    auto const levels = spec.levels.levels.size();
    for (std::size_t first = 0; first < analysis.quantiles.size(); first += levels) {
        all.push_back(
            quantile_table(spec, analysis.body, std::span(analysis.quantiles).subspan(first, levels), confidence));
    }
    all.push_back(criterion_table(analysis.body, analysis.criterion, confidence));
    all.push_back(response_table(analysis.body, analysis.response));
}

}  // namespace

std::vector<Table> campaign_tables(CampaignSpec const& spec, Statistics const& statistics,
                                   std::span<BodyAnalysis const> analysis, double confidence) {
    std::vector<Table> all;
    for (std::size_t b = 0; b < spec.bodies.size(); ++b) {
        all.push_back(body_table(spec, b));
    }
    append(all, {limit_table(spec), sigma_table(statistics.achieved_sigma())});
    append(all, acceptance_tables(spec, statistics, confidence));
    auto const& counted = statistics.bodies();
    bool const sample = !no_sample(spec, statistics.waves().waves);
    for (std::size_t limit = 0; limit < spec.limits.size(); ++limit) {
        for (auto const& body : counted) {
            all.push_back(stripe_table(spec, body, limit, confidence, sample));
        }
        for (auto const& body : analysis) {
            append(all, curve_tables({body.body, spec.limits[limit].name, confidence}, body.curves_of(limit)));
        }
    }
    all.push_back({.name = "together"});
    all.push_back({.name = "pairs"});
    append(all, together_tables(spec, bodies_together(spec, statistics), confidence));
    for (std::size_t b = 0; b < analysis.size(); ++b) {
        all.push_back(model_table(counted[b]));
        if (spec.measures.energy) {
            all.push_back(criterion_level_table(spec, counted[b], "v_wes", counted[b].v_wes));
            all.push_back(criterion_level_table(spec, counted[b], "ou_v_e", counted[b].ou_v_e));
        }
        add_body(all, spec, b, analysis[b], confidence);
    }
    return all;
}

std::vector<Table> rare_tables(CampaignSpec const& spec, std::span<RareBody const> bodies) {
    std::vector<Table> all;
    for (auto const& body : bodies) {
        append(all, rare_tables(spec, body));
    }
    return all;
}

}  // namespace overturn::output
