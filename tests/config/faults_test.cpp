// Requirement R-901: all that is wrong with a file is reported at once, each with its place.
#include "config/faults.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace overturn::config {
namespace {

constexpr std::array shapes{Entry<int>{"box", "", 0}, Entry<int>{"ball", "", 1}};
constexpr Keys part_keys{word_key<shapes>("shape", "what it is"),
                         number_key("width", Dimension::length, Range::positive(), "of a box").only("shape = box"),
                         number_key("radius", Dimension::length, Range::positive(), "of a ball").only("shape = ball")};
constexpr KeyTable part_table{.meaning = "a part", .keys = part_keys.all};
constexpr Keys whole_keys{integer_key("seed", 0, 9, "of all"),
                          number_key("mass", Dimension::mass, Range::positive(), "of it").only("there is no file"),
                          text_key("file", "that says the rest").optional(),
                          number_key("hot", Dimension::none, Range::any(), "this").only("there is no cold"),
                          number_key("cold", Dimension::none, Range::any(), "or this").only("there is no hot"),
                          boolean_key("bold", "or not").otherwise(false),
                          numbers_key("levels", Dimension::acceleration, Range::positive(), "of shaking").optional(),
                          tables_key<part_table>("parts", "of it").optional()};
constexpr KeyTable whole_table{.meaning = "all", .keys = whole_keys.all};

std::vector<std::string> faults_in(std::string const& text) {
    auto const table = Table::parse(text, "x.toml");
    table.described_by(whole_table);
    std::vector<std::string> told;
    for (auto const& fault : table.faults()) {
        told.push_back(fault.text);
    }
    return told;
}

void expect_reported(std::string const& text, std::vector<std::string> const& parts) {
    auto const told = faults_in(text);
    ASSERT_EQ(told.size(), parts.size()) << joined_faults(told);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        EXPECT_NE(told[i].find(parts[i]), std::string::npos) << told[i];
    }
}

TEST(Faults, NoneOfWhatIsAsDescribed) {
    EXPECT_EQ(faults_in("seed = 1\nmass = '3 t'\nlevels = ['100 gal']\n[[parts]]\nshape = 'ball'\nradius = 1\n"),
              std::vector<std::string>());
    EXPECT_EQ(faults_in("seed = 1\nfile = 'a'\nbold = true\n"), std::vector<std::string>());
}

TEST(Faults, AllOfThemAreReported) {
    expect_reported(
        "mass = '-3 t'\nbold = 1\ncolour = 2\nlevels = ['3 kg']\n[[parts]]\nshape = 'box'\n[[parts]]\n"
        "shape = 'bal'\nradius = [1]\n",
        {"x.toml:1:1: seed: missing", "x.toml:1:8: mass: -3 t, that is -3000 kg (must be above 0 kg)",
         "x.toml:2:8: bold: a number (must be true or false)", "x.toml:3:10: unknown key 'colour'",
         "x.toml:4:10: levels: ", "x.toml:5:1: parts[0].width: missing",
         "x.toml:8:9: parts[1].shape: shape 'bal' (unknown). Did you mean 'ball'?",
         "x.toml:9:10: parts[1].radius: a list"});
}

// a misspelt key that must be there is one fault, not two.
TEST(Faults, AMisspeltKeyIsOne) {
    expect_reported("sede = 1\nfile = 'a'\n",
                    {"x.toml:1:8: sede: unknown key (nothing reads it, and 'seed' is missing)"});
}

TEST(Faults, WhatStoppedAReaderStandsFirstAndOnce) {
    auto const table = Table::parse("seed = 10\nbold = 1\n", "x.toml");
    table.described_by(whole_table);
    std::string message;
    try {
        with_all_faults(table, [&] { return table.integer(whole_keys["seed"]); });
    } catch (InputError const& error) {
        message = error.what();
    }
    auto const told = faults_of(message);
    ASSERT_EQ(told.size(), 3U);
    EXPECT_TRUE(told[0].starts_with("x.toml:1:8: seed: 10 (must be 0 to 9)"));
    EXPECT_TRUE(told[1].starts_with("x.toml:1:1: mass: missing"));
    EXPECT_TRUE(told[2].starts_with("x.toml:2:8: bold"));
}

TEST(Faults, IndependentReadersAllReport) {
    FaultGatherer faults;
    faults.run([] { throw InputError("one\nline"); });
    faults.run([] {});
    faults.run([] { throw InputError(joined_faults({"two", "three", "two"})); });
    try {
        faults.tell();
        FAIL();
    } catch (InputError const& error) {
        EXPECT_EQ(faults_of(error.what()), (std::vector<std::string>{"one line", "two", "three"}));
    }
}

}  // namespace
}  // namespace overturn::config
