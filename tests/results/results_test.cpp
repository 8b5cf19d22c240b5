// Requirement R-1003: every field of a row is stored in exactly one column, and statistics count exactly what the rows
// say.
#include <set>

#include <gtest/gtest.h>

#include "output/stripe_text.hpp"
#include "response/registry.hpp"
#include "results/schema.hpp"
#include "results/statistics.hpp"
#include "support/campaigns.hpp"
#include "support/describe_all.hpp"

namespace overturn {
namespace {

template <class Row> void expect_each_field_once(Fields const& fields = fields_of<Row>()) {
    static_assert(std::is_trivially_copyable_v<Row> && alignof(Row) == 8);
    EXPECT_TRUE(testing::describe_all(fields, sizeof(Row)));
    for (auto const& field : fields) {
        EXPECT_FALSE(field.units.empty()) << field.name;
        EXPECT_FALSE(field.description.empty()) << field.name;
        EXPECT_EQ(field.type == FieldType::category, !field.categories.empty()) << field.name;
    }
}

TEST(Columns, CoverEveryFieldOnce) {
    expect_each_field_once<Outcome>();
    expect_each_field_once<Response>();
    expect_each_field_once<TrialRow>();
    expect_each_field_once<WaveRow>();
    expect_each_field_once<MeasureRow>();
    auto const bodies = testing::type_a + testing::type_b + "[[bodies]]\nname='third'\n"
                        + testing::type_b.substr(testing::type_b.find("mass"));
    auto const both = testing::campaign_from(testing::quick_waves + bodies + testing::levels("values=[3,6]\n")
                                             + "[measures]\nboth_radius_units=true\n");
    EXPECT_EQ(measure_table(both, 0).columns.size(), fields_of<MeasureRow>().size());
    auto const one = testing::campaign_from(testing::quick_waves + bodies + testing::levels("values=[3,6]\n"));
    EXPECT_EQ(measure_table(one, 0).columns.size() + 2, measure_table(both, 0).columns.size());
}

// R-1003: What a campaign does not want measured leaves no column behind, and nothing else is missing.
TEST(Columns, WhatIsNotWantedIsNotThere) {
    auto const spec_with = [](std::string const& keys) {
        return testing::campaign_from(testing::quick_waves + testing::type_a + testing::levels("values=[3,6]\n")
                                      + "[measures]\n" + keys);
    };
    auto const names_of = [](CampaignSpec const& spec) {
        std::set<std::string> names;
        for (auto const& table : {wave_table(spec), measure_table(spec, 0), trial_table(spec)}) {
            for (auto const& column : table.columns) {
                names.insert(table.group + "/" + std::string(column.name));
            }
        }
        return names;
    };
    auto const missing = [&](std::string const& keys) {
        auto all = names_of(spec_with(""));
        for (auto const& name : names_of(spec_with(keys))) {
            all.erase(name);
        }
        return all;
    };
    EXPECT_EQ(missing("energy=false\n"),
              (std::set<std::string>{"waves/type-a/ou_v_e", "waves/type-a/v_wes", "waves/type-a/v_wes_time",
                                     "trials/v_wes", "trials/ou_v_e", "trials/v_wes_safe", "trials/ou_v_e_safe"}));
    auto const quality = missing("wave_quality=false\n");
    for (auto const* name : {"waves/match_mean_misfit", "waves/psd_lowest_ratio", "waves/vertical_match_mean_misfit",
                             "waves/duration_5_95", "waves/residual_velocity", "waves/correlation", "waves/accepted",
                             "waves/acceptance_failures", "waves/type-a/band_mean_misfit"}) {
        EXPECT_TRUE(quality.contains(name)) << name;
    }
    for (auto const* name : {"waves/matched", "waves/match_iterations", "waves/pga", "waves/pgd", "waves/arias",
                             "waves/turned", "waves/type-a/v_wes"}) {
        EXPECT_FALSE(quality.contains(name)) << name;
    }
    EXPECT_TRUE(measure_table(spec_with("energy=false\nwave_quality=false\n"), 0).columns.empty());
}

TEST(Columns, MeasuresOfSeveralBodiesLieSideBySide) {
    auto const spec = testing::campaign_from(testing::quick_waves + testing::type_a + testing::type_b
                                             + testing::levels("values=[3,6]\n"));
    auto const second = measure_table(spec, 1);

    EXPECT_EQ(second.group, "waves/type-b");
    EXPECT_EQ(second.row_bytes, 2 * sizeof(MeasureRow));
    for (auto const& column : second.columns) {
        EXPECT_GE(column.offset, sizeof(MeasureRow));
        EXPECT_LT(column.offset, 2 * sizeof(MeasureRow));
    }
}

TEST(Columns, EveryVerdictReasonAndModelHasAName) {
    std::set<Verdict> values;
    std::set<std::string_view> names;
    for (auto const& entry : verdicts()) {
        values.insert(entry.value);
        names.insert(entry.name);
    }
    EXPECT_EQ(values.size(), verdicts().size());
    EXPECT_EQ(names.size(), verdicts().size());
    EXPECT_EQ(entry_of(Verdict::overturned).name, "overturned");
    EXPECT_FALSE(entry_of(Verdict::contact_lost).decided);
    EXPECT_FALSE(entry_of(Verdict::failed).decided);
    for (std::size_t i = 0; i < failures().size(); ++i) {
        EXPECT_EQ(static_cast<std::size_t>(failures()[i].value), i) << failures()[i].name;
    }
    for (std::size_t i = 0; i < model_categories().size(); ++i) {
        EXPECT_EQ(model_place(model_categories()[i].value), i);
    }
}

TEST(Columns, ADifferenceIsNamed) {
    TrialRow a;
    auto b = a;
    EXPECT_TRUE(same_bits(a, b)) << "what never came is as equal as any number";
    b.impacts = 1;
    b.friction_demand = -0.0;
    EXPECT_EQ(differing(a, b), (std::vector<std::string>{"impacts", "friction_demand"}));
}

TrialRow row_of(std::int64_t body, std::int64_t level, Verdict verdict, bool wes_safe, bool ou_safe) {
    TrialRow row;
    row.model = verdict == Verdict::at_rest ? 0 : verdict == Verdict::slid ? 2 : 1;
    row.body = body;
    row.level = level;
    row.verdict = verdict;
    row.v_wes_safe = wes_safe ? 1 : 0;
    row.ou_v_e_safe = ou_safe ? 1 : 0;
    return row;
}

// R-1003: a name that the results file needs for itself is refused before any work.
TEST(BodyNames, MayNotBeColumnsOfTheWaves) {
    for (std::string const name : {"pga", "id", "failed", "arias", ".", ".."}) {
        auto const body = "[[bodies]]\nname='" + name
                          + "'\nmass=1\nbase_width=1\ncentre_height=1\ninertia='uniform-block'\nrestitution=0.8\n";
        EXPECT_THROW((void)testing::campaign_from(testing::quick_waves + body + testing::levels("values=[3,6]\n")),
                     InputError)
            << name;
    }
}

//
TEST(Statistics, CountWhatTheRowsSay) {
    auto const spec = testing::campaign_from(testing::quick_waves + testing::type_a + testing::type_b
                                             + testing::levels("values=[3,6]\n"));
    Statistics statistics(spec);

    statistics.add(row_of(1, 0, Verdict::overturned, true, false));
    statistics.add(row_of(1, 0, Verdict::overturned, false, false));
    statistics.add(row_of(1, 0, Verdict::rocked, true, false));
    statistics.add(row_of(1, 0, Verdict::at_rest, false, true));
    statistics.add(row_of(1, 0, Verdict::failed, true, false));
    statistics.add(row_of(1, 1, Verdict::contact_lost, false, true));
    statistics.add(row_of(1, 1, Verdict::slid, true, true));
    auto slipping = row_of(0, 1, Verdict::rocked, true, true);
    slipping.required = mask_of(Effect::sliding) | mask_of(Effect::vertical);
    statistics.add(slipping);

    auto const& b = statistics.bodies()[1];
    EXPECT_EQ(b.stripes[0].trials, 5);
    EXPECT_EQ(b.stripes[0].overturned, 2);
    EXPECT_EQ(b.stripes[0].failed, 1);
    EXPECT_EQ(b.v_wes[0].undecided_safe, 1) << "said safe, and nobody knows";
    EXPECT_EQ(b.ou_v_e[0].undecided_safe, 0) << "each measure by its own word";
    EXPECT_EQ(b.ou_v_e[0].undecided_unsafe, 1);
    EXPECT_EQ(b.stripes[0].probability(), 0.5);
    EXPECT_EQ(b.stripes[1].trials, 2);
    EXPECT_EQ(b.stripes[1].undecided, 1);
    EXPECT_EQ(b.v_wes[1].undecided_unsafe, 1);
    EXPECT_EQ(b.v_wes[1].true_safe, 1);
    auto const ended = [&](Verdict verdict) {
        return b.ends[static_cast<std::size_t>(&entry_of(verdict) - verdicts().data())];
    };
    using Counts = std::vector<std::int64_t>;
    EXPECT_EQ(ended(Verdict::at_rest), (Counts{1, 0}));
    EXPECT_EQ(ended(Verdict::slid), (Counts{0, 1}));
    EXPECT_EQ(ended(Verdict::rocked), (Counts{1, 0}));
    EXPECT_EQ(ended(Verdict::overturned), (Counts{2, 0}));
    EXPECT_EQ(ended(Verdict::contact_lost), (Counts{0, 1}));
    EXPECT_EQ(ended(Verdict::failed), (Counts{1, 0}));
    EXPECT_EQ(b.models, (Counts{1, 4, 1, 0, 0})) << "the failed one needed none";
    EXPECT_EQ(b.v_wes[0].false_safe, 1);
    EXPECT_EQ(b.v_wes[0].true_overturn, 1);
    EXPECT_EQ(b.v_wes[0].true_safe, 1);
    EXPECT_EQ(b.v_wes[0].false_alarm, 1);
    EXPECT_EQ(b.ou_v_e[0].false_safe, 0);
    EXPECT_EQ(b.ou_v_e[0].false_alarm, 1);
    auto const& a = statistics.bodies()[0];
    EXPECT_EQ(a.stripes[0].trials, 0);
    EXPECT_EQ(a.stripes[1].amplitude, 6);
    EXPECT_EQ(a.required, (std::vector<Counts>{{0, 1}, {0, 1}, {0, 0}, {0, 0}}))
        << "vertical, sliding, contact, spatial";
    EXPECT_EQ(b.required, (std::vector<Counts>{{0, 0}, {0, 0}, {0, 0}, {0, 0}}));
}

// a body that still rocked when the record ended is reported, as far as rows know it.
TEST(Statistics, CountWhoFellOrPeakedOnlyAfterTheRecord) {
    auto const spec = testing::campaign_from(testing::quick_waves + testing::type_a + testing::type_b
                                             + testing::levels("values=[3,6]\n"));
    Statistics statistics(spec);
    std::vector<MeasureRow> const measures(2);
    for (std::int64_t wave = 0; wave < 2; ++wave) {
        WaveRow row;
        row.id = wave;
        row.duration_s = wave == 0 ? 20 : 40;
        statistics.add(row, measures);
    }
    auto const add = [&](std::int64_t wave, Verdict verdict, double peak_s, double fall_s) {
        auto row = row_of(0, 1, verdict, true, true);
        row.wave = wave;
        row.time_of_peak_s = peak_s;
        row.overturn_time_s = fall_s;
        statistics.add(row);
    };
    add(0, Verdict::overturned, 20.5, 20.5);
    add(0, Verdict::overturned, 20, 20);
    add(0, Verdict::rocked, 20.1, never);
    add(0, Verdict::rocked, 19.9, never);
    add(0, Verdict::failed, 30, never);
    add(1, Verdict::rocked, 30, never);
    add(1, Verdict::overturned, 40.2, 40.2);

    auto const& body = statistics.bodies()[0];
    using Counts = std::vector<std::int64_t>;
    EXPECT_EQ(body.fell_after_record, (Counts{0, 2}));
    EXPECT_EQ(body.peaked_after_record, (Counts{0, 1}));
    auto const told = output::stripes_text(spec, statistics);
    EXPECT_NE(
        told.find("note: 3 trials were still rocking at the end of the record (2 overturned and 1 reached their peak"),
        std::string::npos)
        << told;
    EXPECT_EQ(output::stripes_text(spec, Statistics(spec)).find("still rocking"), std::string::npos);
}

}  // namespace
}  // namespace overturn
