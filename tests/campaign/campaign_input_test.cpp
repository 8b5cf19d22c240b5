// Requirement R-1103, R-1005: a campaign travels and is stored whole, and a change is reported by the key it is in.
#include "campaign/campaign_input.hpp"

#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "campaign/campaign_spec.hpp"
#include "support/campaigns.hpp"
#include "support/expect_input_error.hpp"

namespace overturn {
namespace {

CampaignInput example() {
    return {"some/c.toml",
            "seed = 1\n# \xe5\x9c\xb0\nx = 2\n",
            {"seed=3", "a.b='=c'"},
            {{"t.csv", std::string("1,2\n\0\xff", 6)}, {"u/empty", ""}}};
}

TEST(CampaignInput, RoundTrip) {
    auto const before = example();
    auto const after = CampaignInput::deserialise(before.serialise());

    EXPECT_EQ(after.name, before.name);
    EXPECT_EQ(after.text, before.text);
    EXPECT_EQ(after.settings, before.settings);
    EXPECT_EQ(after.files, before.files);
    EXPECT_EQ(after.sha256(), before.sha256());
    EXPECT_TRUE(before.differences(after).empty());
}

TEST(CampaignInput, HashSeesEverythingButTheName) {
    auto const base = example();
    auto renamed = base;
    renamed.name = "elsewhere.toml";
    EXPECT_EQ(renamed.sha256(), base.sha256());

    auto text = base;
    text.text += " ";
    auto setting = base;
    setting.settings.pop_back();
    auto file = base;
    file.files["t.csv"] += "3";
    for (auto const& other : {text, setting, file}) {
        EXPECT_NE(other.sha256(), base.sha256());
    }
    EXPECT_EQ(base.differences(setting).size(), 1U);
    EXPECT_EQ(base.differences(file).size(), 1U);
    EXPECT_TRUE(base.differences(text).empty()) << "a blank decides no row";
}

/// Each alone moves last bits, so that blocks of two of either must not be mixed.
TEST(CampaignInput, BlocksBelongToCampaignProgramAndMachine) {
    auto const base = example();
    auto text = base;
    text.text.replace(text.text.find("x = 2"), 5, "x = 3");
    auto blank = base;
    blank.text += "# ";
    blank.text +=
        "\ntitle = 'another'\nquestion = 'why?'\nprepared = 'a'\nchecked = 'b'\napproved = 'c'\nrevision = '1'\n";
    EXPECT_EQ(blank.block_key(), base.block_key());
    EXPECT_NE(blank.sha256(), base.sha256());
    auto program = base;
    program.program += "+";
    auto machine = base;
    machine.machine = "another";
    auto other_compiler = base;
    auto const place = other_compiler.libraries.find(compiler());
    ASSERT_NE(place, std::string::npos) << base.libraries;
    other_compiler.libraries.replace(place, compiler().size(), "GCC 99");
    for (auto const& other : {text, program, machine, other_compiler}) {
        EXPECT_NE(other.block_key(), base.block_key());
    }
    EXPECT_EQ(program.sha256(), base.sha256());
    EXPECT_EQ(machine.sha256(), base.sha256());
}

// Where a value comes from decides no row: whoever states it later keeps what was computed. A key `source` of the waves
// is what they are made of.
TEST(CampaignInput, StatementsOfOriginAreNoDifferences) {
    auto const input = [](std::string const& text, std::string const& body = "mass = '12 t'\n") {
        return CampaignInput{"c.toml", text, {}, {{"b.toml", body}}};
    };
    std::string const waves = "seed = 11\n[waves]\nsource = 'spectrum-compatible'\n";
    std::string const bodies = "[[bodies]]\nfile = 'b.toml'\nfriction = 0.5\n";
    auto const base = input(waves + bodies);
    for (auto const& same :
         {input(waves + "basis = 'assumed'\n" + bodies),
          input(waves + bodies + "basis = 'measured'\nsource = 'page 3'\n"),
          input(waves
                + "[[bodies]]\nfile = 'b.toml'\nfriction = {value = 0.5, basis = 'assumed', range = [0.4, 0.6]}\n"),
          input(waves + bodies, "mass = '12 t'\n[basis]\nmass = 'published: plate'\n"),
          input("seed = 0x0B\n" + waves.substr(waves.find('[')) + bodies)}) {
        EXPECT_EQ(base.differences(same), std::vector<std::string>()) << same.text;
        EXPECT_EQ(base.differences_of_rows(same), std::vector<std::string>()) << same.text;
        EXPECT_EQ(base.block_key(), same.block_key()) << same.text;
    }
    auto const other = input("seed = 11\n[waves]\nbasis = 'assumed'\nsource = 'records'\n" + bodies);
    EXPECT_EQ(base.differences_of_rows(other),
              std::vector<std::string>{"waves.source was 'spectrum-compatible', is 'records'"});
    auto const friction = input(waves + "[[bodies]]\nfile = 'b.toml'\nfriction = {value = 0.6, basis = 'assumed'}\n");
    EXPECT_EQ(base.differences_of_rows(friction).size(), 1U);
}

TEST(CampaignInput, DifferencesNameTheKey) {
    auto const base = example();
    auto other = base;
    other.text = "seed = 1\n# \xe5\x9c\xb0\nx = 5\n";
    other.settings = {"seed=4"};
    other.files["t.csv"] = "";

    auto const told = base.differences(other);

    EXPECT_EQ(told, (std::vector<std::string>{"a.b was '=c', is not stated", "seed was 3, is 4", "x was 2, is 5",
                                              "file t.csv changed"}));
}

TEST(CampaignInput, AMissingAndAnAddedFileAreDifferences) {
    auto const base = example();
    auto fewer = base;
    fewer.files.erase("u/empty");

    EXPECT_EQ(base.differences(fewer).size(), 1U);
    EXPECT_EQ(fewer.differences(base).size(), 1U);
}

// A body's file in a campaign's place is one fault, not one a key.
TEST(CampaignInput, ABodysFileIsNoCampaign) {
    testing::expect_input_error(
        [] {
            (void)parse_campaign(CampaignInput{"b.toml", "mass=1\nbase_width=2\n", {}, {}});
        },
        "b.toml: a body's file", "Name it in a campaign");
}

// Beyond this a results file's header could not hold it, which a run must not find out at its end.
TEST(CampaignInput, ACampaignTooLongForTheResultsFileIsRefusedAtOnce) {
    auto const path = std::filesystem::temp_directory_path() / fmt::format("overturn-long-{}.toml", ::getpid());
    std::ofstream(path) << "seed=7\n"
                        << std::string(70'000, '#') << '\n'
                        << testing::quick_waves << testing::type_a << testing::levels("values=[3]\n");

    testing::expect_input_error([&] { (void)load_campaign(path, {}); }, "70", "file");
    std::filesystem::remove(path);
}

// R-1003: A results file of format 4 or before means what it meant then: a target without a unit is in SI, unnamed
// columns behind the time are horizontal, transverse, vertical.
TEST(CampaignInput, OfAnEarlierFormatIsReadAsThen) {
    auto const rest = testing::type_b + testing::levels("values=[3]\n");
    auto target = testing::input_from(
        "[waves]\nsource='spectrum-compatible'\ncount=1\nduration='20.48 s'\n"
        "time_step='0.02 s'\n[waves.target]\nfile='t.csv'\nkind='acceleration'\n"
            + rest,
        {{"t.csv", "0.02 2\n0.5 6\n10 0.2\n"}});
    std::string rows;
    for (int i = 0; i < 64; ++i) {
        double const wiggle = i % 2 == 0 ? 1 : -1;
        rows += fmt::format("{:.2f} {} {} {}\n", 0.02 * i, wiggle, 2 * wiggle, 3 * wiggle);
    }
    auto record =
        testing::input_from("[waves]\nsource='records'\nfiles=['r.txt']\nunit='m/s2'\n" + rest, {{"r.txt", rows}});
    testing::expect_input_error([&] { (void)parse_campaign(target); }, "t.csv", "unit of the ordinates missing");
    testing::expect_input_error([&] { (void)parse_campaign(record); }, "r.txt", "its component is ambiguous");

    target.before_format_5 = record.before_format_5 = true;
    auto const in_si = parse_campaign(target).source->make(1, 0);
    EXPECT_LT(in_si.match.all.mean_misfit, 0.05) << "of the table's numbers as m/s2";
    EXPECT_NE(parse_campaign(target).source->about().text.find("t.csv"), std::string::npos);
    auto const motion = parse_campaign(record).source->make(1, 0).motion;
    EXPECT_NEAR(motion.horizontal_mps2[2], 1, 1e-12);
    EXPECT_NEAR(motion.transverse_mps2[2], 2, 1e-12);
    EXPECT_NEAR(motion.vertical_mps2[2], 3, 1e-12);
}

}  // namespace
}  // namespace overturn
