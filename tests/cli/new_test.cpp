// Requirement R-918: whatever is answered, the campaign that `new` writes is one that `plan` takes as it stands:
// answers as they were typed, all else said to be assumed and why; what cannot be is refused, and no file is written
// over unasked.
#include <algorithm>
#include <cmath>
#include <regex>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/python.hpp"
#include "support/command.hpp"
#include "support/line_width.hpp"

namespace overturn::testing {
namespace {

using nlohmann::json;
using Arguments = std::vector<std::string>;

class New : public ::testing::Test {
  protected:
    New() {
        folder.write("record.csv", "time,a_horizontal\n0.00,0\n0.02,120\n0.04,-80\n0.06,0\n");
        std::string shaking = "time,a [gal]\n";
        for (int i = 0; i < 2000; ++i) {
            shaking += fmt::format("{:.2f},{:.3f}\n", 0.01 * i, 100 * std::sin(0.03 * i));
        }
        folder.write("shaking.csv", shaking);
        folder.write("target.csv", "period,sa [gal]\n0.02,250\n0.1,620\n1,800\n10,32\n");
        folder.write("hazard.csv", "pga [gal], annual_exceedance\n100, 2e-2\n600, 1e-4\n2000, 1e-6\n");
        std::filesystem::create_directory(folder / "records");
        std::filesystem::copy_file(folder / "record.csv", folder / "records" / "b.csv");
        folder.write("records/a.csv", "time,a_horizontal\n0.00,0\n0.02,-90\n0.04,110\n0.06,0\n");
    }

    Ended written(Arguments const& more) const {
        return overturn(folder, joined(joined({"new", "s.toml", "--force"}, cask), more));
    }
    void expect_planned(Arguments const& more) const {
        auto const ended = written(more);
        ASSERT_EQ(ended.code, 0) << ended.err;
        auto const plan = overturn(folder, {"plan", "s.toml", "--json"});
        ASSERT_EQ(plan.code, 0) << plan.err << folder.read("s.toml");
        expect_assumptions_listed(json::parse(plan.out)["assumptions"]);
    }
    /// Every mark of an assumption says why, and is one of the inputs that plan counts as assumed, with that reason.
    void expect_assumptions_listed(json const& assumptions) const {
        std::multiset<std::string> marked, counted;
        std::istringstream lines(folder.read("s.toml"));
        std::regex const assumption("# assumed: .+?, because (.+)");
        for (std::string line; std::getline(lines, line);) {
            std::smatch reason;
            if (std::regex_match(line, reason, assumption)) {
                marked.insert(reason[1]);
            }
            EXPECT_TRUE(!line.starts_with("# assumed") || !reason.empty()) << line;
        }
        for (auto const& input : assumptions["inputs"]) {
            if (input["basis"] == "assumed") {
                counted.insert(input["source"].get<std::string>());
            }
        }
        EXPECT_FALSE(marked.empty()) << "inertia, for one";
        EXPECT_EQ(counted, marked);
        EXPECT_EQ(assumptions["counts"]["assumed"], marked.size());
    }
    void expect_refused(Arguments const& arguments, std::string const& why) const {
        auto const ended = overturn(folder, joined({"new", "refused.toml"}, arguments));
        EXPECT_EQ(ended.code, 2) << ended.err;
        EXPECT_TRUE(is_one_error_line(ended.err));
        EXPECT_NE(ended.err.find(why), std::string::npos) << ended.err;
        EXPECT_FALSE(folder.has("refused.toml"));
    }

    Folder folder;
    Arguments const cask{"--mass", "258 kip", "--centre-height", "8.5 ft", "--base-width", "134 in"};
};

// of a campaign that `new` wrote, also of one with two bodies and all components, the plan fits a screen.
TEST_F(New, PlanFitsAScreen) {
    for (auto const& more : {Arguments{"--components", "3", "--base-shape", "round", "--gap", "80 cm"},
                             Arguments{"--friction", "0.5", "--pad-strength", "30 MPa"}}) {
        ASSERT_EQ(written(joined({"--spectrum", "mlit-ch1", "--design-basis", "600 gal", "--count", "2"}, more)).code,
                  0);
        auto const plan = overturn(folder, {"plan", "s.toml"}).out;
        EXPECT_LE(std::ranges::count(plan, '\n'), 24) << plan;
        EXPECT_EQ(too_wide(plan), "");
    }
}

// over all of it that decides which keys are written.
TEST_F(New, WhatItWritesIsPlanned) {
    Arguments const short_one{"--duration", "20 s", "--count", "2"};
    for (auto const& body : {Arguments{},
                             {"--base-shape", "round", "--friction", "0.4"},
                             {"--base-shape", "square", "--restitution", "housner", "--pad-strength", "30 MPa"}}) {
        for (auto const& site :
             {Arguments{}, {"--gap", "80 cm"}, {"--wall", "5 ft", "--edge", "2 m", "--height", "17 ft"}}) {
            auto const placed = joined(body, site);
            for (auto const& waves : {Arguments{"--spectrum", "mlit-sz1", "--design-basis", "100 kine"},
                                      {"--spectrum", "rg-1.60", "--design-basis", "0.3 g", "--components", "3"},
                                      {"--spectrum", "mlit-ch1", "--design-basis", "600 gal", "--components", "1"}}) {
                expect_planned(joined(placed, joined(waves, short_one)));
            }
            expect_planned(joined(placed, {"--records", "records", "--record-unit", "gal", "--design-basis", "0.3 g"}));
        }
    }
}

TEST_F(New, OtherSpectraRulesAndFiles) {
    for (auto const& waves :
         {Arguments{"--spectrum", "mlit-os2", "--components", "2", "--design-basis", "600 gal"},
          {"--spectrum", "rg-1.60", "--acceptance", "srp-3.7.1", "--design-basis", "3 m/s2"},
          {"--spectrum", "mlit-ka1", "--acceptance", "japan", "--design-basis", "1 m/s"},
          {"--spectrum", "target.csv", "--spectrum-kind", "acceleration", "--design-basis", "600 gal"},
          {"--records", "shaking.csv", "--baseline", "high-pass 0.2 Hz", "--design-basis", "40 kine"},
          {"--spectrum", "mlit-ch1", "--friction", "+.5D0", "--restitution", ".9", "--count", "007", "--design-basis",
           "1 g"},
          {"--spectrum", "mlit-ch1", "--hazard", "hazard.csv", "--design-basis", "600 gal", "--beta-u", "0.3"}}) {
        expect_planned(waves);
    }
    EXPECT_NE(folder.read("s.toml").find("hazard = \"hazard.csv\"\n"), std::string::npos) << folder.read("s.toml");
    EXPECT_NE(folder.read("s.toml").find("[statistics]\nbeta_u = 0.3\n"), std::string::npos) << folder.read("s.toml");
    auto const other =
        written({"--spectrum", "target.csv", "--spectrum-kind", "acceleration", "--design-basis", "0.7 g"});
    EXPECT_NE(other.err.find("warning: design basis 0.7 g, but the target spectrum has 0.254929 g"), std::string::npos)
        << other.err;
}

TEST_F(New, AnswersStandAsTheyWereTyped) {
    ASSERT_EQ(written({"--spectrum", "rg-1.60", "--design-basis", "0.3 g", "--gap", "2.5 ft"}).code, 0);
    auto const text = folder.read("s.toml");
    for (auto const* line :
         {"mass = \"258 kip\"\n", "centre_height = \"8.5 ft\"\n", "base_width = \"134 in\"\n", "cask = \"2.5 ft\"\n",
          "pga = \"0.3 g\"\n", "design_basis = \"0.3 g\"\n", "beyond_design = [\"0.45 g\", \"0.6 g\"]\n",
          "# Written by: overturn new s.toml --mass '258 kip' --centre-height '8.5 ft' --base-width '134 in' --gap "
          "'2.5 ft' "
          "--spectrum rg-1.60 --design-basis '0.3 g'\n"}) {
        EXPECT_NE(text.find(line), std::string::npos) << line << text;
    }
    EXPECT_NE(text.find("friction = 0.2\n"), std::string::npos) << "unstated friction is taken on both sides";
    EXPECT_NE(text.find("friction = 0.8\n"), std::string::npos);
}

// the question asks about what was given near the cask, and about nothing else. What a stated mass is taken as
// is the first assumption, and in the list.
TEST_F(New, TheQuestionIsOfWhatWasGiven) {
    auto const asked = [&](Arguments const& site) {
        EXPECT_EQ(written(joined({"--spectrum", "mlit-ch1", "--design-basis", "600 gal"}, site)).code, 0);
        auto const text = folder.read("s.toml");
        auto const begin = text.find("question = ");
        return text.substr(begin, text.find('\n', begin) - begin);
    };
    auto const question = [](std::string const& beside) {
        return "question = \"How likely is a cask of 258 kip on a base of 134 in to overturn" + beside
               + " at 600 gal and beyond?\"";
    };
    EXPECT_EQ(asked({}), question(""));
    EXPECT_EQ(asked({"--gap", "1 m"}), question(" or to touch"));
    EXPECT_EQ(asked({"--wall", "1 m"}), question(" or to touch"));
    EXPECT_EQ(asked({"--edge", "1 m"}), question(" or to leave its pad"));
    EXPECT_EQ(asked({"--wall", "1 m", "--edge", "1 m"}), question(", to touch or to leave its pad"));
    auto const text = folder.read("s.toml");
    EXPECT_NE(text.find("# assumed: all of this mass is one rigid body"), std::string::npos);
    EXPECT_NE(text.find("inertia = \"assumed: neither inertia nor parts were given: a cask on a pallet is taken as "
                        "fastened to it\""),
              std::string::npos)
        << text;
}

// a pallet under the cask is a part of its own: plan then says whether the cask leaves it first.
TEST_F(New, CaskAndPalletAreParts) {
    auto const pallet = [&](Arguments const& more) {
        return joined({"--mass",          "117 t",    "--pallet-mass",  "21 t",    "--pallet-height", "35 cm",
                       "--cask-diameter", "2.5 m",    "--cask-height",  "5.4 m",   "--base-width",    "3.4 m",
                       "--spectrum",      "mlit-ch1", "--design-basis", "600 gal", "--count",         "2",
                       "--friction",      "0.8"},
                      more);
    };
    auto const planned = [&](Arguments const& more) {
        EXPECT_EQ(overturn(folder, joined({"new", "s.toml", "--force"}, pallet(more))).code, 0);
        auto const plan = overturn(folder, {"plan", "s.toml", "--json"});
        EXPECT_EQ(plan.code, 0) << plan.err << folder.read("s.toml");
        auto const read = json::parse(plan.out);
        expect_assumptions_listed(read["assumptions"]);
        return read;
    };
    auto const warns = [](json const& plan) {
        return plan["warnings"].dump().find("part 1 tips") != std::string::npos;
    };
    auto const loose = planned({"--gap", "0.8 m"});
    EXPECT_TRUE(warns(loose)) << loose["warnings"];
    auto const text = folder.read("s.toml");
    EXPECT_NE(text.find("cask of 117 t on a pallet of 21 t and 3.4 m to overturn"), std::string::npos) << text;
    EXPECT_NE(text.find("because --pallet-friction was not given\n# friction = 0.3\n"), std::string::npos) << text;
    auto const& body = loose["bodies"][0];
    EXPECT_NEAR(body["mass_kg"].get<double>(), 138e3, 1e-6);
    EXPECT_NEAR(std::tan(body["alpha_rad"].get<double>()), 1.7 * 138 / (117 * (0.35 + 2.7) + 21 * 0.175),
                1e-12);  // of the common centre of gravity
    EXPECT_FALSE(warns(planned({"--pallet-friction", "fastened", "--base-shape", "round"})));
    EXPECT_NE(folder.read("s.toml").find("kind = \"cylinder\"\nmass = \"21 t\"\ndiameter = \"3.4 m\"\n"),
              std::string::npos);
    EXPECT_TRUE(warns(planned({"--pallet-friction", "0.9"})));
    EXPECT_NE(folder.read("s.toml").find("\nfriction = 0.9\n\n[[bodies.parts]]"), std::string::npos);

    expect_refused(pallet({"--centre-height", "2.6 m"}), "--centre-height '2.6 m' (it follows from cask and pallet");
    expect_refused(pallet({"--pallet-friction", "loose"}),
                   "--pallet-friction 'loose' (must be a number from 0, or fastened)");
    expect_refused(joined(cask, {"--spectrum", "mlit-ch1", "--design-basis", "600 gal", "--components", "4"}),
                   "--components '4' (no such number). Choose 1, 2 or 3");
    expect_refused({"--mass", "117 t", "--pallet-height", "35 cm"},
                   "--pallet-height '35 cm' (used only with --pallet-mass)");
    expect_refused({"--pallet-mass", "21 t", "--mass", "1 t"},
                   "--pallet-height, --cask-diameter, --cask-height, --base-width,");
}

// Names that would end a text, a comment or a shell's word; files beside another folder.
TEST_F(New, FilesAreNamedFromTheCampaign) {
    std::string const hostile = "it's \"mine\" \\ $(x).csv";
    std::filesystem::copy_file(folder / "record.csv", folder / hostile);
    expect_planned({"--records", hostile, "--record-unit", "gal", "--design-basis", "0.3 g"});
    std::filesystem::create_directory(folder / "studies");
    auto const arguments = joined({"new", "studies/s.toml", "--records", "records", "--record-unit", "gal",
                                   "--design-basis", "0.3 g", "--hazard", "hazard.csv"},
                                  cask);
    ASSERT_EQ(overturn(folder, arguments).code, 0);
    auto const text = folder.read("studies/s.toml");
    EXPECT_NE(text.find("folder = \"../records\"\nfiles = [\"a.csv\", \"b.csv\"]\n"), std::string::npos) << text;
    EXPECT_NE(text.find("\nhazard = \"../hazard.csv\"\n"), std::string::npos) << text;
    EXPECT_EQ(overturn(folder, {"plan", "studies/s.toml"}).code, 0);
}

// a folder of single components is a record for each station and event, the vertical component with it.
TEST_F(New, ComponentsOfAStationAreOneRecord) {
    std::filesystem::create_directory(folder / "peer");
    auto const write = [&](char const* name, char const* station, char const* component, int value) {
        folder.write(std::string("peer/") + name,
                     fmt::format("PEER NGA STRONG MOTION DATABASE RECORD\nHole 01, 5/19/1940, {}, {}\n"
                                 "ACCELERATION TIME SERIES IN UNITS OF G\nNPTS=   4, DT=   .0100 SEC,\n"
                                 " .0{} -.02 .01 0.0\n",
                                 station, component, value));
    };
    write("a-up.at2", "El Centro", "UP", 1);
    write("b.at2", "El Centro", "180", 2);
    write("c.at2", "El Centro", "270", 3);
    write("d.at2", "Taft", "090", 4);
    write("e.at2", "Taft", "UP", 5);
    Arguments const study{"--records", "peer", "--design-basis", "0.3 g"};
    expect_planned(study);
    auto const text = folder.read("s.toml");
    EXPECT_NE(text.find("files = [\"b.at2\", \"d.at2\"]\n"), std::string::npos) << text;
    EXPECT_NE(text.find("\ncomponents = \"station\"  # "), std::string::npos) << text;

    write("f.at2", "Hachinohe", "090", 6);  // alone: no other component would be found
    std::filesystem::remove(folder / "peer/a-up.at2");
    std::filesystem::remove(folder / "peer/e.at2");
    expect_planned(study);
    EXPECT_NE(folder.read("s.toml").find("files = [\"b.at2\", \"c.at2\", \"d.at2\", \"f.at2\"]\n"), std::string::npos);
}

// what stands in the way of a folder of stations is named, and none is left out.
TEST_F(New, AStationWithoutAHorizontalComponentIsNamed) {
    std::filesystem::create_directory(folder / "peer");
    auto const write = [&](char const* name, char const* station, char const* component) {
        folder.write(std::string("peer/") + name,
                     fmt::format("PEER NGA STRONG MOTION DATABASE RECORD\nHole 01, 5/19/1940, {}, {}\n"
                                 "ACCELERATION TIME SERIES IN UNITS OF G\nNPTS=   4, DT=   .0100 SEC,\n"
                                 " .01 -.02 .01 0.0\n",
                                 station, component));
    };
    write("a.at2", "El Centro", "UP");
    write("b.at2", "El Centro", "180");
    write("c.at2", "El Centro", "270");
    write("d.at2", "Taft", "UP");
    expect_refused(joined(cask, {"--records", "peer", "--design-basis", "0.3 g"}),
                   "--records 'peer' (d.at2: no horizontal component of its station; ");
    std::filesystem::remove(folder / "peer/d.at2");
    folder.write("peer/notes.txt", "time_s,acc (gal)\n0,1\n0.01,2\n0.02,-3\n");
    expect_refused(joined(cask, {"--records", "peer", "--design-basis", "0.3 g"}), "(notes.txt: no station stated; ");
}

// KiK-net's NS1, EW1 and UD1 are of the borehole: no motion that a cask stands on.
TEST_F(New, RecordsOfABoreholeAreRefused) {
    std::filesystem::create_directory(folder / "kik");
    std::filesystem::create_directory(folder / "surface");
    auto const write = [&](std::string const& name, char direction) {
        std::string text;
        for (auto const& [key, value] :
             std::vector<std::pair<std::string, std::string>>{{"Origin Time", "2011/03/11 14:46:00"},
                                                              {"Lat.", "38"},
                                                              {"Long.", "142"},
                                                              {"Depth. (km)", "24"},
                                                              {"Mag.", "9"},
                                                              {"Station Code", "XXXH08"},
                                                              {"Station Lat.", "38"},
                                                              {"Station Long.", "142"},
                                                              {"Station Height(m)", "1"},
                                                              {"Record Time", "2011/03/11 14:46:36"},
                                                              {"Sampling Freq(Hz)", "100Hz"},
                                                              {"Duration Time(s)", "1"},
                                                              {"Dir.", std::string(1, direction)},
                                                              {"Scale Factor", "100(gal)/10000"},
                                                              {"Max. Acc. (gal)", "9.900"},
                                                              {"Last Correction", "2011/03/11 14:46:36"},
                                                              {"Memo.", ""}}) {
            text += fmt::format("{:<18}{}\n", key, value);
        }
        for (int i = 0; i < 100; ++i) {
            text += fmt::format("{:>8} {}", i == 40 ? 1000 : 0, i % 8 == 7 || i == 99 ? "\n" : "");
        }
        folder.write(name, text);
    };
    char direction = '1';
    for (std::string const name : {"x.NS1", "x.EW1", "x.UD1", "x.NS2", "x.EW2", "x.UD2"}) {
        write("kik/" + name, direction);
        if (direction > '3') {
            write("surface/" + name, direction);
        }
        ++direction;
    }
    expect_refused(joined(cask, {"--records", "kik", "--design-basis", "0.3 g"}),
                   "(x.EW1, x.NS1, x.UD1: recorded in a borehole, not at the surface)");
    expect_planned({"--records", "surface", "--design-basis", "0.3 g"});
    auto text = folder.read("s.toml");
    EXPECT_NE(text.find("components = \"station\""), std::string::npos) << text;
    // A campaign that states one is told so.
    EXPECT_EQ(overturn(folder, {"plan", "s.toml"}).out.find("borehole"), std::string::npos);
    text.replace(text.find("\"surface\""), 9, "\"kik\"");
    text.replace(text.find("x.EW2"), 5, "x.EW1");
    folder.write("down.toml", text);
    auto const plan = overturn(folder, {"plan", "down.toml"});
    EXPECT_NE((plan.out + plan.err).find("recorded in a borehole"), std::string::npos) << plan.out << plan.err;
}

TEST_F(New, RefusesWhatCannotBe) {
    Arguments const waves{"--spectrum", "mlit-ch1", "--design-basis", "600 gal"};
    expect_refused({"--mass", "117 stone"}, "--mass unit 'stone' (not a unit of mass). Use one of: ");
    expect_refused({"--mass", "117"},
                   "--mass '117' (a number without its unit). Write \"117 t\" or \"117 kg\", or with your own");
    expect_refused({"--pad-strength", "30"}, "Write \"30 MPa\" or \"30 Pa\", or with your own");
    expect_refused({"--base-width", "3"}, "Write \"3 m\", or with your own");
    expect_refused({"--mass", "-117 t"}, "--mass '-117 t' (not above 0)");
    expect_refused({"--mass", ""}, "--mass '' (empty");
    expect_refused({"--mass", "117 t\nseed = 2"}, "--mass (holds a control character)");
    expect_refused({"--mass", "nan t"}, "--mass 'nan t'");
    expect_refused({"--friction", "0.5 m"},
                   "--friction '0.5 m' (must be a number from 0, or a band such as 0.3 to 0.6)");
    expect_refused({"--friction", "0.3 to x"}, "--friction 'x' (must be a number from 0, or a band");
    expect_refused({"--friction", "0.6 to 0.6"}, "--friction '0.6 to 0.6' (the second number must be above the first)");
    expect_refused({"--count", "1.5"}, "--count '1.5' (must be a whole number)");
    expect_refused({"--base-shape", "rond"}, "--base-shape 'rond' (unknown). Did you mean 'round'?");
    expect_refused({"--spectrum", "rg-1.61"},
                   "--spectrum 'rg-1.61' (neither a published spectrum nor a file). Did you mean 'rg-1.60'?");
    expect_refused({"--spectrum", "rg-1.60-vertical"}, "(of the vertical component)");
    expect_refused({"--records", "none.csv"}, "--records 'none.csv' (no such file)");
    expect_refused({"--hazard", "none.csv"}, "--hazard 'none.csv' (no such file)");
    expect_refused({"--design-basis", "2 m"}, "--design-basis '2 m' (must be a number above 0, a blank and a unit");
    expect_refused({"--design-basis", "0.35g"},
                   "--design-basis '0.35g' (no blank between number and unit). Write \"0.35 g\"");
    expect_refused({"--mass", "117t"}, "--mass '117t' (no blank between number and unit). Write \"117 t\"");
    expect_refused({"--height", "5 m"}, "--height '5 m' (used only with --gap, --wall or --edge");
    expect_refused({"--duration", "5 s"}, "--duration '5 s' (used only with --spectrum");
    expect_refused({"--spectrum", "mlit-ch1", "--records", "record.csv"},
                   "--records 'record.csv' (--spectrum is given: waves come from one of the two");
    expect_refused({"--spectrum", "rg-1.60", "--design-basis", "30 kine"},
                   "rg-1.60 is scaled by a peak acceleration). Give one such as '0.3 g'");
    // What only plan knows.
    expect_refused(joined(cask, {"--records", "record.csv", "--design-basis", "600 gal"}),
                   "overturn plan refuses the campaign: refused.toml:");
    expect_refused(joined(joined(cask, waves), {"--gap", "1 m", "--height", "1 m"}),
                   "--height '1 m' (not above the centre of gravity, 8.5 ft)");
    expect_refused(joined(cask, {"--spectrum", "mlit-ch1", "--design-basis", "30 kine", "--hazard", "hazard.csv"}),
                   "State it over pgv");
}

// What stands between the commas of levels is a level each, of the measure of the design basis and beyond it.
TEST_F(New, RefusesLevelsThatCannotBe) {
    auto const refused = [&](char const* option, char const* levels, std::string const& why) {
        expect_refused(joined(cask, {"--spectrum", "mlit-ch1", "--design-basis", "600 gal", option, levels}), why);
    };
    refused("--levels", "300 gal, 600", "--levels '600' (a number without its unit). Write for example \"600 gal\"");
    refused("--levels", "300 gal,", "--levels '300 gal,' (nothing between two commas)");
    refused("--levels", "300 gal, 30 kine", "--levels '30 kine' (--design-basis '600 gal' is another measure: accel");
    refused("--beyond-design", "90 kine", "--beyond-design '90 kine' (--design-basis '600 gal' is another measure");
    refused("--beyond-design", "500 gal", "levels.beyond_design: 500 gal (not above design_basis 600 gal)");
}

// stated levels and a stated band of friction are the campaign's own, and no assumption.
TEST_F(New, LevelsAndABandAreStated) {
    Arguments const study{"--spectrum", "mlit-ch1", "--design-basis", "600 gal", "--count", "2"};
    expect_planned(joined(study, {"--beyond-design", "900 gal", "--friction", "0.3 to .6"}));
    auto const plan = [&] { return json::parse(overturn(folder, {"plan", "s.toml", "--json"}).out); };
    auto const levels_of = [](json const& planned, std::string const& purpose) {
        std::vector<double> gal;
        for (auto const& level : planned["levels"]["levels"]) {
            if (purpose.empty() || level["purpose"] == purpose) {
                gal.push_back(std::round(level["stated"].get<double>()));
            }
        }
        return gal;
    };
    EXPECT_EQ(levels_of(plan(), "beyond-design"), (std::vector<double>{900}));
    auto text = folder.read("s.toml");
    EXPECT_NE(text.find("\nfriction = {distribution = \"uniform\", low = 0.3, high = 0.6}\n"), std::string::npos)
        << text;
    EXPECT_EQ(text.find("because no other beyond-design motion"), std::string::npos) << text;
    EXPECT_NE(text.find("levels from 0.5 to 5 times the design basis, because"), std::string::npos) << text;
    EXPECT_EQ(plan()["bodies"].size(), 1U) << "a band is of one body";

    expect_planned(joined(study, {"--beyond-design", "1 g, 1200 gal", "--levels", "300 gal,  600 gal, 1500 gal"}));
    EXPECT_EQ(levels_of(plan(), ""), (std::vector<double>{300, 600, 981, 1200, 1500}));
    EXPECT_EQ(levels_of(plan(), "beyond-design"), (std::vector<double>{981, 1200}));
    text = folder.read("s.toml");
    EXPECT_NE(text.find("\nvalues = [\"300 gal\", \"600 gal\", \"1500 gal\"]\n\n"), std::string::npos)
        << "no basis of an assumption follows" << text;
}

// The cover of the page has its keys: the question stated, the names and the revision to be filled in.
TEST_F(New, TheCoverIsPrepared) {
    ASSERT_EQ(written({"--spectrum", "mlit-ch1", "--design-basis", "600 gal"}).code, 0);
    auto text = folder.read("s.toml");
    for (auto const* key : {"prepared", "checked", "approved", "revision"}) {
        auto const at = text.find(std::string("\n# ") + key + " = \"");
        ASSERT_NE(at, std::string::npos) << key << text;
        text.erase(at + 1, 2);
    }
    folder.write("filled.toml", text);
    EXPECT_EQ(overturn(folder, {"plan", "filled.toml"}).code, 0);
}

// A record without its unit is refused by the option that states it, not by a key of a file that was not written.
TEST_F(New, AsksForTheUnitOfRecordsByItsOption) {
    expect_refused(joined(cask, {"--records", "record.csv", "--design-basis", "0.3 g"}), "State --record-unit \"gal\"");
}

// Without a terminal nothing is asked.
TEST_F(New, ListsAllThatIsMissing) {
    expect_refused(
        {}, "new: --mass, --centre-height, --base-width, --spectrum or --records, --design-basis missing (required");
    expect_refused(joined(cask, {"--spectrum", "target.csv", "--design-basis", "600 gal"}),
                   "new: --spectrum-kind missing (required");
}

TEST_F(New, LosesNoFile) {
    Arguments const study = joined(cask, {"--spectrum", "mlit-ch1", "--design-basis", "600 gal"});
    folder.write("mine.toml", "mine");
    auto const ended = overturn(folder, joined({"new", "mine.toml"}, study));
    EXPECT_EQ(ended.code, 2);
    EXPECT_NE(ended.err.find("mine.toml: exists already (it would be lost)"), std::string::npos) << ended.err;
    EXPECT_EQ(folder.read("mine.toml"), "mine");
    std::filesystem::create_directory(folder / "d.toml");
    for (auto const* name : {"study", "nowhere/s.toml", "a\nb.toml", "d.toml", ""}) {
        auto const refused = overturn(folder, joined({"new", name, "--force"}, study));
        EXPECT_EQ(refused.code, 2) << name;
        EXPECT_TRUE(is_one_error_line(refused.err));
    }
    EXPECT_EQ(overturn(folder, joined({"new", "mine.toml", "--force"}, study)).code, 0);
    EXPECT_NE(folder.read("mine.toml"), "mine");
}

// At a terminal it asks for what is not stated, again after a wrong answer, and gives up where input ends.
TEST_F(New, AsksAtATerminal) {
    folder.write("answers",
                 "117 stone\n'117 t'\n\n2.6 m\n\n3.4 m\nround\n\n\n\n0.8 m\n\n\n\nmlit-ch1\n1\n\n\n\n0.6 g\n\n");
    auto const shell = [&](std::string const& input, std::string const& name) {
        return execute(folder, {"/bin/sh", "-c",
                                std::string(OVERTURN_PYTHON " " OVERTURN_AT_TERMINAL " " OVERTURN_PROGRAM " new ")
                                    + name + " --count 5 < " + input});
    };
    auto const ended = shell("answers", "asked.toml");
    ASSERT_EQ(ended.code, 0) << ended.out << ended.err;
    EXPECT_NE(ended.out.find("--mass unit 'stone' (not a unit of mass)"), std::string::npos) << ended.out;
    EXPECT_EQ(ended.out.find("number of waves"), std::string::npos) << "what an option states is not asked";
    EXPECT_EQ(ended.out.find("that file holds"), std::string::npos) << "nor what does not apply";
    auto const stated = overturn(
        folder,
        {"new",          "stated.toml", "--count",        "5",     "--mass", "117 t", "--centre-height", "2.6 m",
         "--base-width", "3.4 m",       "--base-shape",   "round", "--gap",  "0.8 m", "--spectrum",      "mlit-ch1",
         "--components", "1",           "--design-basis", "0.6 g"});
    ASSERT_EQ(stated.code, 0) << stated.err;
    auto const as_asked =
        std::regex_replace(folder.read("stated.toml"), std::regex("stated\\.(toml|h5|html)"), "asked.$1");
    EXPECT_EQ(folder.read("asked.toml"), as_asked);

    // Neither a spectrum nor records: the question about the spectrum comes again.
    folder.write("back", "117 t\n\n2.6 m\n3.4 m\nround\n\n\n\n0.8 m\n\n\n\n\n\nmlit-ch1\n1\n\n\n0.6 g\n\n\n");
    auto const led_back = shell("back", "back.toml");
    ASSERT_EQ(led_back.code, 0) << led_back.out << led_back.err;
    EXPECT_NE(led_back.out.find("or Enter to state a target spectrum"), std::string::npos) << led_back.out;
    EXPECT_NE(led_back.out.find("one of the two is required. Published spectra: mlit-"), std::string::npos)
        << led_back.out;
    EXPECT_NE(folder.read("back.toml").find("spectrum = \"mlit-ch1\""), std::string::npos);

    folder.write("few", "117 t\n");
    auto const broken_off = shell("few", "few.toml");
    EXPECT_EQ(broken_off.code, 2) << broken_off.out;
    EXPECT_NE(broken_off.out.find("new: --centre-height, --base-width,"), std::string::npos) << broken_off.out;
    EXPECT_NE(broken_off.out.find("). Add them to: overturn new few.toml --mass '117 t' --count 5\n"),
              std::string::npos)
        << broken_off.out;
    EXPECT_FALSE(folder.has("few.toml"));
}

// It ends with what was given, where nothing that can be used comes: Enter again and again, or a word.
TEST_F(New, GivesUpAtATerminal) {
    auto const asked = [&](std::string const& answers, std::string const& arguments) {
        folder.write("answers", answers);
        return execute(folder, {"/bin/sh", "-c",
                                OVERTURN_PYTHON " " OVERTURN_AT_TERMINAL " " OVERTURN_PROGRAM " new s.toml " + arguments
                                    + " < answers"});
    };
    auto const count_in = [](std::string const& text, std::string const& part) {
        int count = 0;
        for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
            ++count;
        }
        return count;
    };
    std::string const enter(60, '\n');
    auto const round = asked("117 t\n\n2.6 m\n3.4 m\n" + enter, "--force");
    EXPECT_EQ(round.code, 2) << round.out;
    EXPECT_EQ(count_in(round.out, "one of the two is required. Published spectra: "), 5) << round.out;
    EXPECT_NE(
        round.out.find("new: --spectrum or --records, --design-basis missing (required: no value can be assumed). "
                       "Add them to: overturn new s.toml --mass '117 t' --centre-height '2.6 m' --base-width "
                       "'3.4 m' --force\n"),
        std::string::npos)
        << round.out;

    auto const required = asked(enter, "");
    EXPECT_EQ(required.code, 2) << required.out;
    EXPECT_EQ(count_in(required.out, "a value is required: none can be assumed"), 5) << required.out;

    auto const word =
        asked("oval\noval\noval\noval\noval\noval\n",
              "--mass '1 t' --pallet-mass '1 t' --pallet-height '1 m' --cask-diameter '1 m' --cask-height "
              "'2 m' --pallet-friction 1 --base-width '3 m' --spectrum mlit-ch1 --design-basis '600 gal'");
    EXPECT_EQ(word.code, 2) << word.out;
    EXPECT_EQ(count_in(word.out, "'oval' (unknown)"), 5) << word.out;
    EXPECT_NE(word.out.find("new: no answer that can be used (asked too often). Add the rest to: overturn new s.toml "),
              std::string::npos)
        << word.out;
    EXPECT_FALSE(folder.has("s.toml"));

    // A usable answer between wrong ones: these are counted anew.
    auto const slow = asked("1\n1\n1\n117 t\n\n1\n1\n1\n2.6 m\n", "--base-width '3 m'");
    EXPECT_EQ(count_in(slow.out, "(a number without its unit)"), 6) << slow.out;
    EXPECT_NE(slow.out.find("--centre-height '2.6 m'"), std::string::npos) << slow.out;
}

// at a terminal warnings go on below with an indent, an error stays a line; into a pipe each is a line.
TEST_F(New, WrapsWarningsAtATerminal) {
    auto const piped = written({"--spectrum", "mlit-ch1", "--design-basis", "600 gal", "--friction", "1.25"});
    auto const warning = piped.err.substr(0, piped.err.find('\n'));
    ASSERT_TRUE(warning.starts_with("warning: ")) << piped.err;
    ASSERT_GT(warning.size(), 100U) << "else nothing is shown";

    auto const shown = [&](Arguments const& arguments) {
        return execute(folder, joined({OVERTURN_PYTHON, OVERTURN_AT_TERMINAL, OVERTURN_PROGRAM}, arguments)).out;
    };
    auto const wave = shown({"wave", "s.toml", "--wave", "0", "-o", "wave.csv"});
    EXPECT_EQ(wave.find(warning), std::string::npos) << wave;
    EXPECT_NE(unwrapped(wave).find(warning), std::string::npos) << wave;
    std::istringstream lines(wave);
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(line.size(), 100U) << line;
    }

    auto const error = shown({"plan", std::string(120, 'n') + ".toml"});
    EXPECT_TRUE(is_one_error_line(error)) << error;
    EXPECT_GT(error.size(), 101U) << "else nothing is shown";
}

// the studies that come with the program are what the command in each writes, and plan takes them.
TEST_F(New, LicenceStudiesAreItsOwn) {
    for (auto const* beside : {"examples", "hazard"}) {
        std::filesystem::create_directory_symlink(std::filesystem::path(OVERTURN_CAMPAIGNS) / beside, folder / beside);
    }
    std::filesystem::remove_all(folder / "licence");
    std::filesystem::create_directory(folder / "licence");
    int count = 0;
    for (auto const& file : std::filesystem::directory_iterator(OVERTURN_CAMPAIGNS "/licence")) {
        auto const text = read_text(file.path());
        std::smatch command;
        ASSERT_TRUE(std::regex_search(text, command, std::regex("# Written by: overturn (new [^\n]*)"))) << file.path();
        auto const again = execute(folder, {"/bin/sh", "-c", "cd licence && " OVERTURN_PROGRAM " " + command[1].str()});
        EXPECT_EQ(again.code, 0) << again.err;
        EXPECT_EQ(folder.read("licence/" + file.path().filename().string()), text)
            << "write it anew: that command, with --force, in campaigns/licence";
        EXPECT_EQ(overturn(folder, {"plan", file.path(), "--json"}).code, 0);
        ++count;
    }
    EXPECT_GE(count, 3);
}

}  // namespace
}  // namespace overturn::testing
