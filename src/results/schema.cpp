#include "results/schema.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "core/error.hpp"
#include "response/registry.hpp"

namespace overturn {
namespace {

// "rocked, overturned": for readers that ask what an end means, not what it is called.
std::string verdicts_that(bool VerdictEntry::*holds) {
    std::string names;
    for (auto const& entry : verdicts()) {
        if (entry.*holds) {
            names += (names.empty() ? "" : ", ") + std::string(entry.name);
        }
    }
    return names;
}

bool is_energy(std::string_view column) { return column.starts_with("v_wes") || column.starts_with("ou_v_e"); }

// Of a wave's match, but whether and how fast it was matched: iteration knows that anyway.
bool is_quality(std::string_view column) {
    constexpr std::array kept{"matched", "match_iterations"};
    constexpr std::array prefixes{"match_",
                                  "si_ratio",
                                  "psd_",
                                  "transverse_match",
                                  "vertical_match",
                                  "duration_5_",
                                  "residual_",
                                  "correlation",
                                  "accept",
                                  "band_",
                                  "horizontal_failures",
                                  "transverse_failures",
                                  "vertical_failures"};
    auto const begins = [&](char const* name) { return column.starts_with(name); };
    return std::ranges::find(kept, column) == kept.end() && std::ranges::any_of(prefixes, begins);
}

// What a table of refused waves is made from: where a rule asks nothing, nobody needs it.
bool is_for_rules(std::string_view column) {
    constexpr std::array further{"transverse_match_", "vertical_match_"};
    constexpr std::array always{"_mean_misfit", "_worst_decade"};
    constexpr std::array own{"match_lowest_period", "match_highest_period", "match_longest_below_to",
                             "horizontal_failures", "transverse_failures",  "vertical_failures"};
    auto const begins = [&](char const* name) { return column.starts_with(name); };
    auto const ends = [&](char const* name) { return column.ends_with(name); };
    return std::ranges::find(own, column) != own.end()
           || (std::ranges::any_of(further, begins) && !std::ranges::any_of(always, ends));
}

Field& field_of(Fields& columns, std::string_view name) {
    auto const found = std::ranges::find(columns, name, &Field::name);
    OVERTURN_EXPECT(found != columns.end());
    return *found;
}

// Columns that say what targets were drawn and what Sa is at the campaign's periods: named by period, or not there.
void name_periods(CampaignSpec const& spec, Fields& columns) {
    auto const& periods_s = spec.measures.sa_periods_s;
    bool const varies = spec.source->about().draws_targets;
    bool const parted = spec.source->about().draws_events;
    std::erase_if(columns, [&](Field const& column) {
        bool const part = column.name.starts_with("epsilon_between_") || column.name.starts_with("epsilon_within_");
        bool const drawn = column.name == "target" || column.name == "event" || column.name.starts_with("epsilon_");
        return (drawn && !varies) || (part && !parted) || (column.name == "sa_average" && !spec.measures.sa_band);
    });
    for (std::string_view const name : {"epsilon", "epsilon_between", "epsilon_within"}) {
        for (std::size_t i = 0; i < epsilon_periods_s.size() && (name == "epsilon" ? varies : parted); ++i) {
            field_of(columns, fmt::format("{}_{}", name, i + 1)).name =
                fmt::format("{}_{:g}s", name, epsilon_periods_s[i]);
        }
    }
    for (std::size_t i = 0; i < most_sa_periods; ++i) {
        auto const slot = fmt::format("sa_{}", i + 1);
        if (i >= periods_s.size()) {
            std::erase_if(columns, [&](Field const& column) { return column.name == slot; });
            continue;
        }
        auto& column = field_of(columns, slot);
        column.name = fmt::format("sa_{:g}s", periods_s[i]);
        column.description =
            fmt::format("pseudo-acceleration of the horizontal component at {:g} s, 5 % damping", periods_s[i]);
    }
}

}  // namespace

std::string group_of(std::string const& table, std::string const& body, std::string const& limit) {
    return limit == overturning_limit ? fmt::format("{}/{}", table, body)
                                      : fmt::format("limits/{}/{}/{}", limit, table, body);
}

std::string column_of(std::string_view verdict) {
    std::string name(verdict);
    std::ranges::replace(name, '-', '_');
    return name;
}

store::TableSpec trial_table(CampaignSpec const& spec) {
    store::TableSpec table{"trials", sizeof(TrialRow), fields_of<TrialRow>(), "trial",
                           "number of the trial, for overturn replay --trial"};
    field_of(table.columns, "verdict").notes = {{"moved", verdicts_that(&VerdictEntry::moved)},
                                                {"decided", verdicts_that(&VerdictEntry::decided)},
                                                {"fell", verdicts_that(&VerdictEntry::fell)}};
    if (!spec.measures.energy) {
        std::erase_if(table.columns, [](Field const& column) { return is_energy(column.name); });
    }
    std::erase_if(table.columns, [&](Field const& column) {
        auto const* const own = std::ranges::find(intensity_measures, column.name, &IntensityMeasure::name);
        return own != intensity_measures.end() && own->has_trial_column()
               && std::ranges::find(spec.measures.curves, own) == spec.measures.curves.end();
    });
    std::erase_if(table.columns, [&](Field const& column) {
        return (column.name == "least_clearance" && !spec.site.has_gaps())
               || (column.name == "edge_margin" && !spec.site.has_edges());
    });
    for (auto& column : table.columns) {
        if (column.name == "amplitude") {
            column.units = spec.levels.units();
        } else if (column.name == "body") {
            column.type = FieldType::category;
            for (auto const& body : spec.bodies) {
                column.categories.push_back({std::ssize(column.categories), body.name});
            }
        }
    }
    return table;
}

store::TableSpec wave_table(CampaignSpec const& spec) {
    store::TableSpec table{"waves", sizeof(WaveRow), fields_of<WaveRow>(), "wave", "number of the wave's row"};
    if (!spec.measures.wave_quality) {
        std::erase_if(table.columns, [](Field const& column) { return is_quality(column.name); });
    }
    if (!spec.source->about().acceptance.asked()) {
        std::erase_if(table.columns, [](Field const& column) { return is_for_rules(column.name); });
    }
    name_periods(spec, table.columns);
    return table;
}

store::TableSpec refused_wave_table(CampaignSpec const& spec) {
    auto table = wave_table(spec);
    table.group = "refused_waves";
    return table;
}

store::TableSpec measure_table(CampaignSpec const& spec, std::size_t body) {
    store::TableSpec table{"waves/" + spec.bodies.at(body).name, spec.bodies.size() * sizeof(MeasureRow),
                           fields_of<MeasureRow>(), "waves/wave"};
    if (!spec.measures.both_radius_units) {
        std::erase_if(table.columns, [](Field const& column) { return column.name.ends_with("_other_unit"); });
    }
    std::erase_if(table.columns, [&](Field const& column) {
        return (!spec.measures.energy && is_energy(column.name))
               || (!spec.measures.wave_quality && is_quality(column.name));
    });
    for (auto& column : table.columns) {
        column.offset += body * sizeof(MeasureRow);
    }
    return table;
}

std::vector<store::TableSpec> measure_tables(CampaignSpec const& spec) {
    std::vector<store::TableSpec> tables;
    for (std::size_t body = 0; body < spec.bodies.size(); ++body) {
        tables.push_back(measure_table(spec, body));
    }
    return tables;
}

std::vector<store::TableSpec> extra_tables(ModelSelector const& selector) {
    std::vector<store::TableSpec> tables;
    for (auto const& [traits, offset] : selector.extra_parts()) {
        store::TableSpec table{"trials/" + std::string(traits->name), selector.extra_bytes(), traits->fields,
                               "trials/trial"};
        for (auto& column : table.columns) {
            column.offset += offset;
        }
        tables.push_back(std::move(table));
    }
    return tables;
}

}  // namespace overturn
