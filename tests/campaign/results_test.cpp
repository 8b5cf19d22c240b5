// Requirement: every field of a row is stored in exactly one column, and statistics count exactly what the rows say.
#include "campaign/results.hpp"

#include <set>

#include <gtest/gtest.h>

#include "support/campaigns.hpp"

namespace overturn {
namespace {

// Rows are 8-byte fields without padding, so a row of n columns is covered if they start at 0, 8, ..., 8 (n - 1).
template <class Row> void expect_each_field_once(store::TableSpec const& table) {
    static_assert(std::is_trivially_copyable_v<Row> && std::is_standard_layout_v<Row>);
    static_assert(sizeof(Row) % 8 == 0 && alignof(Row) == 8);
    std::set<std::size_t> offsets;
    std::set<std::string> names;
    for (auto const& column : table.columns) {
        EXPECT_EQ(column.offset % 8, 0U) << column.name;
        EXPECT_TRUE(offsets.insert(column.offset % sizeof(Row)).second) << column.name << " shares a field";
        EXPECT_TRUE(names.insert(column.name).second) << column.name << " twice";
        EXPECT_FALSE(column.units.empty()) << column.name;
        EXPECT_FALSE(column.description.empty()) << column.name;
        EXPECT_EQ(column.type == store::ColumnType::category, !column.categories.empty()) << column.name;
    }
    EXPECT_EQ(offsets.size(), sizeof(Row) / 8) << table.group << " leaves fields out";
}

TEST(Columns, CoverEveryFieldOnce) {
    expect_each_field_once<TrialRow>(trial_table());
    expect_each_field_once<WaveRow>(wave_table());
    auto const bodies = testing::type_a + testing::type_b + "[[bodies]]\nname='third'\n"
                        + testing::type_b.substr(testing::type_b.find("mass"));
    auto const both = testing::campaign_from(testing::quick_waves + bodies + testing::levels("values=[3,6]\n")
                                             + "[measures]\nboth_radius_units=true\n");
    expect_each_field_once<MeasureRow>(measure_table(both, 0));
    auto const one = testing::campaign_from(testing::quick_waves + bodies + testing::levels("values=[3,6]\n"));
    EXPECT_EQ(measure_table(one, 0).columns.size() + 2, measure_table(both, 0).columns.size());
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

TEST(Columns, EveryVerdictAndReasonHasAName) {
    EXPECT_EQ(verdict_names().size(), static_cast<std::size_t>(Verdict::failed) + 1);
    EXPECT_EQ(verdict_names()[static_cast<std::size_t>(Verdict::overturned)], "overturned");
    EXPECT_EQ(failure_names().size(), static_cast<std::size_t>(FailureReason::wave_not_accepted) + 1);
}

TEST(Columns, ADifferenceIsNamed) {
    TrialRow a;
    auto b = a;
    EXPECT_TRUE(differing_columns(a, b).empty());
    b.impacts = 1;
    b.friction_demand = -0.0;
    EXPECT_EQ(differing_columns(a, b), (std::vector<std::string>{"impacts", "friction_demand"}));
}

TrialRow row_of(std::int64_t body, std::int64_t level, Verdict verdict, bool wes_safe, bool ou_safe) {
    TrialRow row;
    row.body = body;
    row.level = level;
    row.verdict = static_cast<std::int64_t>(verdict);
    row.v_wes_safe = wes_safe ? 1 : 0;
    row.ou_v_e_safe = ou_safe ? 1 : 0;
    return row;
}

// Requirement: a name that the results file needs for itself is refused before any work.
TEST(BodyNames, MayNotBeColumnsOfTheWaves) {
    for (std::string const name : {"pga", "id", "failed", "arias", ".", ".."}) {
        auto const body = "[[bodies]]\nname='" + name
                          + "'\nmass=1\nbase_width=1\ncentre_height=1\ninertia='uniform-block'\nrestitution=0.8\n";
        EXPECT_THROW((void)testing::campaign_from(testing::quick_waves + body + testing::levels("values=[3,6]\n")),
                     InputError)
            << name;
    }
}

TEST(Statistics, CountWhatTheRowsSay) {
    auto const spec = testing::campaign_from(testing::quick_waves + testing::type_a + testing::type_b
                                             + testing::levels("values=[3,6]\n"));
    Statistics statistics(spec);

    statistics.add(row_of(1, 0, Verdict::overturned, true, false));
    statistics.add(row_of(1, 0, Verdict::overturned, false, false));
    statistics.add(row_of(1, 0, Verdict::rocked, true, false));
    statistics.add(row_of(1, 0, Verdict::at_rest, false, true));
    statistics.add(row_of(1, 0, Verdict::failed, true, true));
    auto slipping = row_of(0, 1, Verdict::rocked, true, true);
    slipping.effects_called = mask_of(Effect::sliding) | mask_of(Effect::vertical);
    statistics.add(slipping);

    auto const& b = statistics.bodies()[1];
    EXPECT_EQ(b.stripes[0].trials, 5);
    EXPECT_EQ(b.stripes[0].overturned, 2);
    EXPECT_EQ(b.stripes[0].failed, 1);
    EXPECT_EQ(b.v_wes[0].undecided_safe, 1) << "said safe, and nobody knows";
    EXPECT_EQ(b.stripes[0].probability(), 0.5);
    EXPECT_EQ(b.stripes[1].trials, 0);
    EXPECT_EQ(b.v_wes[0].false_safe, 1);
    EXPECT_EQ(b.v_wes[0].true_overturn, 1);
    EXPECT_EQ(b.v_wes[0].true_safe, 1);
    EXPECT_EQ(b.v_wes[0].false_alarm, 1);
    EXPECT_EQ(b.ou_v_e[0].false_safe, 0);
    EXPECT_EQ(b.ou_v_e[0].false_alarm, 1);
    auto const& a = statistics.bodies()[0];
    EXPECT_EQ(a.stripes[0].trials, 0);
    EXPECT_EQ(a.stripes[1].amplitude, 6);
    EXPECT_EQ(a.sliding_called[1], 1);
}

}  // namespace
}  // namespace overturn
