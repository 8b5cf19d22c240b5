// Requirement R-906: any value of a campaign may say where it comes from, without its reader knowing; what is wrongly
// said is refused with file, line and column.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "config/table.hpp"
#include "support/expect_input_error.hpp"

namespace overturn::config {
namespace {

using overturn::testing::expect_input_error;

double read(Table const& table, char const* key, Dimension dimension = Dimension::none) {
    return table.number(key, dimension, Range::any());
}

InputValue input(Table const& table, std::string const& key) {
    for (auto const& value : table.inputs()) {
        if (value.key == key) {
            return value;
        }
    }
    ADD_FAILURE() << "no " << key;
    return {};
}

/// Reader and value are those of the plain form; only the ledger knows more.
TEST(Origin, AValueReadsAsItsPlainForm) {
    auto const table = Table::parse(R"(
friction = {value = 0.55, basis = "measured", source = "tilt test of 2019"}
mass = {value = "12.6 t", basis = "published", source = "PATRAM 2013", range = ["12 t", 13000]}
shape = {value = "round", basis = "assumed"}
periods = {value = [1, "2 s"], basis = "published: RG 1.60, table 1"}
both = {value = true, basis = "assumed"}
count = {value = 3, basis = "assumed", range = [2, 5]}
)",
                                    "x.toml");

    EXPECT_EQ(table.kind("friction"), Kind::number);
    EXPECT_EQ(read(table, "friction"), 0.55);
    EXPECT_EQ(read(table, "mass", Dimension::mass), 12600);
    EXPECT_EQ(table.text("shape"), "round");
    EXPECT_EQ(table.numbers("periods", Dimension::time, Range::any()), (std::vector<double>{1, 2}));
    EXPECT_TRUE(table.boolean("both", false));
    EXPECT_EQ(table.integer("count", 0, 9), 3);
    EXPECT_EQ(table.unit_at("mass"), "t");
    EXPECT_NO_THROW(table.finish());

    EXPECT_EQ(input(table, "friction").basis, Basis::measured);
    EXPECT_EQ(input(table, "friction").source, "tilt test of 2019");
    EXPECT_EQ(input(table, "friction").number, 0.55);
    EXPECT_EQ(input(table, "friction").text, "0.55");
    EXPECT_EQ(input(table, "mass").text, "12.6 t");
    EXPECT_EQ(input(table, "mass").range, (std::vector<std::string>{"12 t", "13000"}));
    EXPECT_EQ(input(table, "shape").basis, Basis::assumed);
    EXPECT_EQ(input(table, "periods").source, "RG 1.60, table 1");
    EXPECT_EQ(input(table, "periods").text, "[1, 2 s]");
}

/// A span is where the value stands, so that it can be replaced in the text.
TEST(Origin, KnowsWhereValuesStand) {
    auto const table = Table::parse("# é\n  mass = {value = \"12.6 t\", basis = \"assumed\"} # é\nh = 0.25", "x.toml");
    (void)read(table, "mass", Dimension::mass);
    (void)read(table, "h");

    auto const mass = input(table, "mass").span;
    EXPECT_EQ((std::array{mass.line, mass.column, mass.end_line, mass.end_column}), (std::array{2, 19, 2, 27}));
    auto const h = input(table, "h").span;
    EXPECT_EQ((std::array{h.line, h.column, h.end_line, h.end_column}), (std::array{3, 5, 3, 9}));
}

TEST(Origin, OfAWholeTableHoldsForWhatSaysNothingElse) {
    auto const root = Table::parse(R"(
[waves]
basis = "assumed"
source = "spectrum-compatible"
duration = 82
[waves.target]
damping = 0.05
basis = "published"
source = "MLIT 2016"
[waves.envelope]
rise = {value = 6, basis = "measured"}
end = 75
[[bodies]]
mass = 1
width = 2
height = 3
parts = [{m = 4}]
[bodies.basis]
mass = "published: PATRAM 2013"
width = {basis = "assumed", range = [1.5, 2.5]}
parts = "measured"
[[bodies]]
mass = 9
basis = {others = "assumed"}
)",
                                   "x.toml");
    auto const waves = root.child("waves");
    EXPECT_EQ(waves.text("source"), "spectrum-compatible");
    (void)read(waves, "duration");
    for (auto const& [table, keys] :
         {std::pair{waves.child("target"), std::vector{"damping"}}, {waves.child("envelope"), {"rise", "end"}}}) {
        for (auto const* key : keys) {
            (void)read(table, key);
        }
        EXPECT_NO_THROW(table.finish());
    }
    EXPECT_NO_THROW(waves.finish());
    auto const bodies = root.children("bodies");
    for (auto const* key : {"mass", "width", "height"}) {
        (void)read(bodies[0], key);
    }
    (void)read(bodies[0].children("parts")[0], "m");
    (void)read(bodies[1], "mass");
    EXPECT_NO_THROW(bodies[0].finish());
    EXPECT_NO_THROW(bodies[1].finish());
    EXPECT_NO_THROW(root.finish());

    EXPECT_EQ(input(root, "waves.duration").basis, Basis::assumed);
    EXPECT_EQ(input(root, "waves.duration").source, "");  // `source` is a value of this table
    EXPECT_EQ(input(root, "waves.target.damping").source, "MLIT 2016");
    EXPECT_EQ(input(root, "waves.envelope.rise").basis, Basis::measured);
    EXPECT_EQ(input(root, "waves.envelope.end").basis, Basis::assumed);
    EXPECT_EQ(input(root, "bodies[0].mass").source, "PATRAM 2013");
    EXPECT_EQ(input(root, "bodies[0].width").range, (std::vector<std::string>{"1.5", "2.5"}));
    EXPECT_EQ(input(root, "bodies[0].height").basis, Basis::not_stated);
    EXPECT_EQ(input(root, "bodies[0].parts[0].m").basis, Basis::measured);
    EXPECT_EQ(input(root, "bodies[1].mass").basis, Basis::assumed);
}

TEST(Origin, DefaultsAreListedWhereNothingIsStated) {
    static constexpr std::array shapes{Entry<int>{"square", "", 0}, Entry<int>{"round", "", 1}};
    auto const root = Table::parse("damping = 0.1", "x.toml");

    EXPECT_EQ(root.number("damping", Dimension::none, Range::any(), 0.05), 0.1);
    EXPECT_EQ(root.number("rise", Dimension::time, Range::any(), 6), 6);
    EXPECT_EQ(root.child_or_empty("base").choice<int>("shape", shapes, 1), 1);

    EXPECT_EQ(input(root, "damping").basis, Basis::not_stated);
    EXPECT_EQ(input(root, "rise").basis, Basis::by_default);
    EXPECT_EQ(input(root, "rise").text, "6 s");
    EXPECT_EQ(input(root, "base.shape").text, "round");
}

/// A table outranks the file it names, a statement any default.
TEST(Origin, OfNamedFilesCountBelowTheTableThatNamesThem) {
    auto const body = Table::parse("[[bodies]]\nfriction = 0.6\nheight = {value = 4, basis = 'measured'}\n", "x.toml")
                          .children("bodies")[0];
    auto const file =
        body.named_document("basis = 'assumed'\nmass = 2\nheight = 3\nfriction = {static = 0.4}\naxes = 1", "b.toml");
    (void)read(file, "mass");
    (void)read(file, "height");
    (void)read(file.child("friction"), "static");
    (void)file.integer("axes", 1, 3, 3);
    (void)read(body, "friction");
    (void)read(body, "height");
    (void)body.integer("axes", 1, 3, 1);

    EXPECT_EQ(input(body, "bodies[0].mass").basis, Basis::assumed);
    EXPECT_EQ(input(body, "bodies[0].mass").file, "b.toml");
    EXPECT_EQ(input(body, "bodies[0].friction").file, "x.toml");
    EXPECT_EQ(input(body, "bodies[0].axes").basis, Basis::assumed);
    EXPECT_EQ(input(body, "bodies[0].height").basis, Basis::measured);
    EXPECT_EQ(body.inputs().size(), 4U);
}

/// A distribution has a key `value` of its own; what is said beside it is of all its keys.
TEST(Origin, OfADistributionIsThatOfItsKeys) {
    auto const root = Table::parse(
        "mass = {distribution = 'fixed', value = 3, basis = 'measured', source = 'scales'}\n"
        "parts = {basis = 'assumed', value = {m = 1}}",
        "x.toml");
    EXPECT_EQ(root.kind("mass"), Kind::table);
    auto const mass = root.child("mass");
    EXPECT_EQ(mass.text("distribution"), "fixed");
    EXPECT_EQ(read(mass, "value"), 3);
    EXPECT_NO_THROW(mass.finish());
    EXPECT_EQ(read(root.child("parts"), "m"), 1);

    EXPECT_EQ(input(root, "mass.value").source, "scales");
    EXPECT_EQ(input(root, "parts.m").basis, Basis::assumed);
}

/// Where it comes from may begin with a number, too.
TEST(Origin, HasNoUnit) {
    auto const root =
        Table::parse("values = {basis = 'published', from = 1, source = '2013 PATRAM', to = '3 gal'}", "x.toml");

    EXPECT_EQ(root.unit_at("values"), "gal");
}

TEST(Origin, ATableHasNoRange) {
    auto const root = Table::parse("[a]\nb = 1\n[basis]\na = {basis = 'assumed', range = [1, 2]}", "x.toml");

    expect_input_error([&] { (void)root.child("a"); }, "x.toml:1:", "range of a table", "State it there");
}

/// What is set by hand is not what the file vouches for.
TEST(Origin, IsNotThatOfASetting) {
    std::vector<std::string> const settings{"a=2", "b={value=3, basis=\"measured\"}", "c.value=4"};
    auto const table =
        Table::parse("basis = 'published'\na = 1\nb = 1\nc = {value = 1, basis = 'assumed'}", "x.toml", settings);
    (void)read(table, "a");
    (void)read(table, "b");
    EXPECT_EQ(read(table, "c"), 4);

    EXPECT_EQ(input(table, "a").basis, Basis::not_stated);
    EXPECT_EQ(input(table, "b").basis, Basis::measured);
    EXPECT_EQ(input(table, "c").basis, Basis::not_stated);
    EXPECT_FALSE(input(table, "a").span.is_known());
}

struct Wrong {
    char const* name;
    char const* text;
    char const* place;
    char const* why;
    char const* advice;
};
class WrongOrigin : public ::testing::TestWithParam<Wrong> {};

constexpr Keys pad_keys{
    number_key("strength", Dimension::pressure, Range::positive(), "of the pad").optional(),
    number_key("damping", Dimension::none, Range::any(), "of the pad").otherwise(0.05),
    number_key("height", Dimension::length, Range::any(), "of the pad").otherwise_in_words("the width"),
    number_key("width", Dimension::length, Range::any(), "of the pad")};
constexpr KeyTable pad_table{.meaning = "a pad", .keys = pad_keys.all};

Table read_pad(std::string const& text) {
    auto const table = Table::parse(text, "x.toml");
    table.described_by(pad_table);
    table.may_have(pad_table);
    (void)table.number(pad_keys["width"]);
    (void)table.maybe_number(pad_keys["strength"]);
    (void)table.maybe_number(pad_keys["height"]);
    (void)table.number(pad_keys["damping"]);
    table.finish();
    return table;
}

/// A key that is left out may be assumed to be: it is then an input, of the text that stands in for it.
TEST(Origin, TheAbsenceOfAKeyMayBeAssumed) {
    auto const table = read_pad(
        "width=1\nbasis={strength='assumed: elastic', damping='assumed: usual', height='assumed', width='measured'}");

    EXPECT_EQ(input(table, "strength").basis, Basis::assumed);
    EXPECT_EQ(input(table, "strength").source, "elastic");
    EXPECT_EQ(input(table, "strength").text, "not stated");
    EXPECT_FALSE(input(table, "strength").number);
    EXPECT_EQ(input(table, "damping").basis, Basis::assumed) << "a default too";
    EXPECT_EQ(input(table, "damping").text, "0.05");
    EXPECT_EQ(input(table, "height").text, "the width");
    EXPECT_EQ(input(table, "width").basis, Basis::measured);
    EXPECT_EQ(table.inputs().size(), 4U);
    EXPECT_EQ(read_pad("width=1").inputs().size(), 2U) << "nothing is said of what is left out";
}

/// Only an assumption: nobody measures what is not there, and what must be there is missing.
TEST(Origin, TheAbsenceOfAKeyIsNotMeasured) {
    for (char const* basis : {"{strength='measured: here'}", "{strength='published: x'}", "{strenght='assumed'}",
                              "{strength={basis='assumed', range=[1, 2]}}"}) {
        expect_input_error([&] { (void)read_pad(std::string("width=1\nbasis=") + basis); }, "no value of this table");
    }
}

TEST_P(WrongOrigin, IsRefused) {
    auto const& wrong = GetParam();
    expect_input_error(
        [&] {
            auto const table = Table::parse(wrong.text, "x.toml");
            (void)read(table, "a");
            table.finish();
        },
        wrong.place, wrong.why, wrong.advice);
}

INSTANTIATE_TEST_SUITE_P(
    Origins, WrongOrigin,
    ::testing::Values(Wrong{"Unknown", "\na = {value = 1, basis = 'mesured'}",
                            "x.toml:2:25:", "a: basis 'mesured' (unknown)", "Did you mean 'measured'?"},
                      Wrong{"UnknownOfTable", "a = 1\nbasis = 'guessed'", "x.toml:2:9:", "basis 'guessed' (unknown)",
                            "Known: published, measured, assumed"},
                      Wrong{"NoText", "a = 1\nbasis = 3", "x.toml:2:9:", "basis is no text", "Put it in quotes"},
                      Wrong{"SourceAlone", "a = {value = 1, source = 'x'}", "x.toml:1:5:", "a: no basis", "Add basis"},
                      Wrong{"SourceTwice", "a = {value = 1, basis = 'measured: y', source = 'x'}",
                            "x.toml:1:49:", "source stated twice", "Keep one"},
                      Wrong{"SourceWithoutBasis", "a = 1\nsource = 'x'", "x.toml:2:10:", "unknown key 'source'",
                            "Remove it"},
                      Wrong{"Misspelt", "a = {value = 1, basis = 'assumed', sorce = 'x'}",
                            "x.toml:1:44:", "unknown key 'sorce'", "Did you mean 'source'?"},
                      Wrong{"OfAnotherKey", "a = 1\n[basis]\nfriction = 'assumed'",
                            "x.toml:3:12:", "basis: 'friction' (no value of this table)", "where the value stands"},
                      Wrong{"NoPair", "a = {value = 1, basis = 'assumed', range = 3}",
                            "x.toml:1:44:", "range is no pair", "Write [low, high]"},
                      Wrong{"AboveItsRange", "a = {value = 4, basis = 'assumed', range = [2, 3]}",
                            "x.toml:1:", "4 outside its range", "Mend one of them"},
                      Wrong{"OutsideItsRange", "a = {value = 1, basis = 'assumed', range = [2, 3]}",
                            "x.toml:1:", "1 outside its range", "Mend one of them"}),
    [](auto const& info) { return info.param.name; });

}  // namespace
}  // namespace overturn::config
