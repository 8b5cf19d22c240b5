#include "output/detail/acceptance_tables.hpp"

#include "generators/acceptance.hpp"
#include "stats/proportion.hpp"

namespace overturn::output {
namespace {

Table count_table(CampaignSpec const& spec, WaveCounts const& waves, double confidence) {
    std::vector<WaveCounts> rows;
    if (spec.source->about().acceptance.asked()) {
        rows.push_back(waves);
    }
    TableOf<WaveCounts> table({.name = "acceptance", .group = "acceptance", .constants = {{"confidence", confidence}}},
                              rows);
    table
        .add("rule", "1", "acceptance rule of the waves",
             [&](WaveCounts const&) { return spec.source->about().acceptance.rule; })
        .add("tried", "1", "waves with trials", [](WaveCounts const& row) { return row.waves; })
        .add("refused", "1", "waves that miss the rule; not used as trials",
             [](WaveCounts const& row) { return row.refused; })
        .add("used", "1", "of the waves with trials, those that miss the rule",
             [](WaveCounts const& row) { return row.not_accepted; })
        .add("refused_share", "1", "share of the drawn waves that was refused",
             [](WaveCounts const& row) {
                 return static_cast<double>(row.refused) / static_cast<double>(row.waves + row.refused);
             })
        .add("refused_share", "1", "its exact interval", [confidence](WaveCounts const& row) {
            return clopper_pearson(row.refused, row.waves + row.refused, confidence);
        });
    return table.take();
}

Table clause_table(MissedClauses const& missed) {
    std::vector<MissedClause> const rows = missed.rows();
    TableOf<MissedClause> table({.name = "missed_clauses", .group = "missed_clauses"}, rows);
    table
        .category("clause", "clause of the acceptance rule", clause_names(),
                  [](MissedClause const& row) { return row.clause; })
        .category("component", "component that misses it; whole-wave: the clause is about the whole wave",
                  {"horizontal", "transverse", "vertical", "whole-wave"},
                  [](MissedClause const& row) { return row.component.empty() ? "whole-wave" : row.component; })
        .add("waves", "1", "waves that miss it", [](MissedClause const& row) { return row.waves; })
        .add("worst", "1", "value of the wave that misses it most", [](MissedClause const& row) { return row.worst; })
        .add("period_lower", "s", "the middle nine tenths of them miss it at this period or above",
             [](MissedClause const& row) { return row.from_period_s; })
        .add("period_upper", "s", "the middle nine tenths of them miss it at this period or below",
             [](MissedClause const& row) { return row.to_period_s; });
    return table.take();
}

}  // namespace

std::vector<Table> acceptance_tables(CampaignSpec const& spec, Statistics const& statistics, double confidence) {
    return {count_table(spec, statistics.waves(), confidence), clause_table(statistics.missed_clauses())};
}

}  // namespace overturn::output
