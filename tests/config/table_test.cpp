// Requirement R-901: a campaign file is read whole: every key is used or refused with file, line and column.
#include "config/table.hpp"

#include "support/expect_input_error.hpp"

namespace overturn::config {
namespace {

using overturn::testing::expect_input_error;

TEST(Table, ReadsQuantitiesWithUnits) {
    auto const table = Table::parse("mass = \"12.6 t\"\nwidth = 1.36", "x.toml");

    EXPECT_DOUBLE_EQ(table.number("mass", Dimension::mass, Range::positive()), 12600);
    EXPECT_DOUBLE_EQ(table.number("width", Dimension::length, Range::positive()), 1.36);
    EXPECT_NO_THROW(table.finish());
}

TEST(Table, MisspeltKeyIsRefusedWithASuggestion) {
    auto const table = Table::parse("mass = 1\n  [body]\nbase_widht = 2", "x.toml");
    (void)table.number("mass", Dimension::mass, Range::positive());
    auto const body = table.child("body");
    EXPECT_EQ(body.number("base_width", Dimension::length, Range::positive(), 1.0), 1.0);

    expect_input_error([&] { body.finish(); }, "x.toml:3:", "unknown key 'body.base_widht'",
                       "Did you mean 'base_width'?");
}

TEST(Table, OutOfRangeNamesPlaceValueAndRange) {
    auto const table = Table::parse("a = 1\nmass = \"-3 t\"", "x.toml");

    expect_input_error([&] { (void)table.number("mass", Dimension::mass, Range::positive()); },
                       "x.toml:2:", "mass: -3 t, that is -3000 kg (must be above 0 kg)");
}

TEST(Table, MisspeltKeyThatMustBeThereIsSuggested) {
    auto const table = Table::parse("a = 1\nsede = 4", "x.toml");

    (void)table.integer("a", 0, 9);
    expect_input_error([&] { (void)table.integer("seed", 0, 9); }, "x.toml:2:", "sede: unknown key",
                       "Did you mean 'seed'?");
}

TEST(Table, MissingKeyIsNamed) {
    auto const table = Table::parse("[waves]\n", "x.toml").child("waves");

    expect_input_error([&] { (void)table.integer("count", 1, 10); }, "x.toml:1:", "waves.count: missing");
}

TEST(Table, SyntaxErrorNamesTheLine) {
    expect_input_error([] { (void)Table::parse("a = 1\nb = = 2\n", "x.toml"); }, "x.toml:2:", "not valid TOML");
}

TEST(Table, SettingsReachIntoTablesAndLists) {
    std::vector<std::string> const settings{"waves.count=7", "bodies.1.name=slim", "bodies[0].name=wide",
                                            "new.key=\"2 s\""};

    auto const table =
        Table::parse("[waves]\ncount = 3\n[[bodies]]\nname='a'\n[[bodies]]\nname='b'", "x.toml", settings);

    EXPECT_EQ(table.child("waves").integer("count", 0, 10), 7);
    EXPECT_EQ(table.children("bodies")[1].text("name"), "slim");
    EXPECT_EQ(table.children("bodies")[0].text("name"), "wide") << "as messages name places";
    EXPECT_EQ(table.child("new").number("key", Dimension::time, Range::any()), 2);
}

TEST(Table, BadSettingIsRefused) {
    std::vector<std::string> const no_value{"waves.count"};
    std::vector<std::string> const no_place{"bodies.5.name=x"};
    expect_input_error([&] { (void)Table::parse("", "x.toml", no_value); }, "--set waves.count");
    expect_input_error([&] { (void)Table::parse("[[bodies]]\n", "x.toml", no_place); }, "no place in a list of 1");
}

// A whole number beyond what is held is no text, though TOML knows no such number.
TEST(Table, AHugeIntegerIsNamedWithTheRange) {
    std::vector<std::string> const huge{"seed=9223372036854775808"};
    std::vector<std::string> const quoted{"seed=\"5\""};
    expect_input_error([&] { (void)Table::parse("", "x.toml", huge).integer("seed", 0, 9); },
                       "9223372036854775808 (must be 0 to 9)");
    expect_input_error([&] { (void)Table::parse("", "x.toml", quoted).integer("seed", 0, 9); }, "without quotes");
}

TEST(Table, ChoiceRefusesUnknownNamesWithASuggestion) {
    static constexpr std::array<Entry<int>, 2> entries{Entry<int>{"shared", "", 1}, Entry<int>{"independent", "", 2}};
    auto const table = Table::parse("waves = 'sahred'", "x.toml");

    expect_input_error([&] { (void)table.choice<int>("waves", entries); }, "x.toml:1:", "'sahred'",
                       "Did you mean 'shared'?");
}

TEST(Table, PairsMustBePairs) {
    auto const table = Table::parse("points = [[0.1, 2], [3]]", "x.toml");

    expect_input_error([&] { (void)table.pairs("points", Dimension::time, Dimension::none); }, "entry 2");
}

}  // namespace
}  // namespace overturn::config
