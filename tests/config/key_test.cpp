// Requirement R-909: a key is described once, with its unit, range and default, and nothing else is read of it.
#include "config/key.hpp"

#include "config/key_reference.hpp"
#include "config/table.hpp"
#include "core/error.hpp"
#include "support/expect_input_error.hpp"

namespace overturn::config {
namespace {

using overturn::testing::expect_input_error;

constexpr std::array shapes{Entry<int>{"square", "as wide as long", 1}, Entry<int>{"round", "a disc", 2}};
constexpr Keys inner_keys{
    number_key("length", Dimension::length, Range::positive(), "how long"),
    word_key<shapes>("shape", "its outline").otherwise("square"),
    integer_key("count", 1, 9, "how many").otherwise(3),
    boolean_key("flat", "without bumps").otherwise(true),
    number_key("step", Dimension::time, Range::between(0, 1), "time step").otherwise(0.25),
    text_key("note", "free words").optional(),
    number_key("end", Dimension::time, Range::positive(), "end").otherwise_in_words("half of it")};
constexpr KeyTable inner_table{.meaning = "a base", .keys = inner_keys.all};
constexpr Keys outer_keys{table_key<inner_table>("base", "what it stands on").optional(),
                          tables_key<inner_table>("bases", "more of them").optional()};
constexpr KeyTable outer_table{.meaning = "the file", .keys = outer_keys.all};

Table described(std::string_view text) {
    auto const root = Table::parse(text, "x.toml");
    root.described_by(outer_table);
    return root;
}

TEST(Key, ReadersTakeUnitRangeAndDefaultFromIt) {
    auto const table = described("[base]\nlength = '20 cm'\n").child(outer_keys["base"]);

    EXPECT_DOUBLE_EQ(table.number(inner_keys["length"]), 0.2);
    EXPECT_EQ(table.choice<int>(inner_keys["shape"], shapes), 1);
    EXPECT_EQ(table.integer(inner_keys["count"]), 3);
    EXPECT_TRUE(table.boolean(inner_keys["flat"]));
    EXPECT_DOUBLE_EQ(table.number(inner_keys["step"]), 0.25);
    EXPECT_EQ(table.text(inner_keys["note"]), "");
    EXPECT_DOUBLE_EQ(table.number(inner_keys["end"], {.otherwise = 7, .range = Range::between(1, 9)}), 7);
    table.finish();
    expect_input_error([] { (void)described("[base]\nlength=-1\n").child("base").number(inner_keys["length"]); },
                       "x.toml:2:", "must be above 0 m");
    expect_input_error([] { (void)described("[base]\n").child("base").number(inner_keys["length"]); },
                       "base.length: missing");
}

// Requirement: where a table is described, reading a key that is not, or as something else, is a mistake of ours.
TEST(Key, WhatIsReadOtherwiseThanDescribedIsRefused) {
#if OVERTURN_CHECKED
    auto const root =
        described("[base]\nlength = 1\nstep = 1\nwidth = 1\ncount = 1\nflat = true\n[[bases]]\nwidth=1\n");
    auto const table = root.child("base");

    EXPECT_NO_THROW((void)table.number("length", Dimension::length, Range::positive()));
    EXPECT_THROW((void)table.number("width", Dimension::length, Range::positive()), ContractError);
    EXPECT_THROW((void)table.number("length", Dimension::time, Range::positive()), ContractError);
    EXPECT_THROW((void)table.number("length", Dimension::length, Range::not_negative()), ContractError);
    EXPECT_THROW((void)table.integer("length", 0, 9), ContractError);
    EXPECT_THROW((void)table.number("step", Dimension::time, Range::between(0, 1), 0.5), ContractError);
    EXPECT_THROW((void)table.integer("count", 1, 9, 4), ContractError);
    EXPECT_THROW((void)table.boolean("flat", false), ContractError);
    EXPECT_THROW((void)table.choice<int>("shape", shapes, 2), ContractError);
    EXPECT_THROW((void)table.number("length", Dimension::length, Range::positive(), 1.0), ContractError);
    EXPECT_THROW((void)root.child("pad"), ContractError);
    EXPECT_THROW((void)root.children("bases")[0].number("width", Dimension::length, Range::any()), ContractError);
    EXPECT_THROW((void)root.named_document("base={}", "y.toml").child("pad"), ContractError);
#else
    GTEST_SKIP() << "developers' promises are not checked in this build";
#endif
}

TEST(Key, ReferenceListsPlacesOfTablesAndTypesOfKeys) {
    auto const tables = tables_within(outer_table);

    ASSERT_EQ(tables.size(), 2U);
    EXPECT_EQ(heading_of(tables[0]), "");
    EXPECT_EQ(heading_of(tables[1]), "[base], [[bases]]");
    EXPECT_EQ(takes_text(inner_keys["length"]), "length [m] above 0");
    EXPECT_EQ(default_text(inner_keys["length"]), "required");
    EXPECT_EQ(takes_text(inner_keys["shape"]), "square, round");
    EXPECT_EQ(takes_text(inner_keys["count"]), "whole number from 1 to 9");
    EXPECT_EQ(takes_text(inner_keys["step"]), "time [s] from 0 to 1");
    EXPECT_EQ(default_text(inner_keys["step"]), "0.25 s");
    EXPECT_EQ(default_text(inner_keys["note"]), "optional");
    EXPECT_EQ(default_text(inner_keys["end"]), "half of it");
    EXPECT_EQ(meaning_text(inner_keys["end"].only("shape = round")), "if shape = round: end");
}

}  // namespace
}  // namespace overturn::config
