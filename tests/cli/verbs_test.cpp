// Requirement R-903: what the verbs print keeps its keys and columns; scripts depend on them.
#include <cmath>
#include <cstdio>
#include <sstream>

#include <nlohmann/json.hpp>

#include "cli/campaign_files.hpp"
#include "core/wrapped.hpp"
#include "support/command.hpp"
#include "support/line_width.hpp"

namespace overturn::testing {
namespace {

using nlohmann::json;

std::string const body = "mass='12.6 t'\nbase_width='0.9 m'\ncentre_height='1.045 m'\ninertia='uniform-block'\n";

class Verbs : public ::testing::Test {
  protected:
    Verbs() {
        folder.write("target.csv", target_csv);
        folder.write("body.toml", body);
        folder.write("c.toml", small_campaign("shared", 2));
    }

    Ended done(std::vector<std::string> const& arguments) {
        auto ended = overturn(folder, arguments);
        EXPECT_EQ(ended.code, 0) << ended.err;
        return ended;
    }

    Folder folder;
};

std::vector<std::string> keys_of(json const& object) {
    std::vector<std::string> keys;
    for (auto const& [key, value] : object.items()) {
        keys.push_back(key);
    }
    return keys;
}

void expect_keys(json const& object, std::vector<std::string> const& keys) {
    for (auto const& key : keys) {
        EXPECT_TRUE(object.contains(key)) << key;
    }
}

// One full sine of 0.5 g and 1 s: the body of type B rocks and stands, by --scale 3 it falls.
std::string sine_csv() {
    std::ostringstream text;
    text << "time_s,ax\n";
    for (int i = 0; i <= 400; ++i) {
        text << i * 0.01 << ',' << (i <= 100 ? 0.5 * std::sin(2 * 3.14159265358979 * i * 0.01) : 0.0) << '\n';
    }
    return text.str();
}

// An angle has its degrees beside it, those of models in space too.
TEST_F(Verbs, RockPrintsAnglesInDegrees) {
    folder.write("sine.csv", sine_csv());
    folder.write("round.toml",
                 "mass='12.6 t'\nbase_width='0.9 m'\ncentre_height='1.045 m'\ninertia='uniform-block'\n"
                 "friction=0.5\nbase={shape='round'}\n");
    auto const told = done({"rock", "--body", "round.toml", "--wave", "sine.csv", "--unit", "g"}).out;
    EXPECT_TRUE(told.starts_with("verdict ")) << "the answer first: " << told;
    double rotation = 0, degrees = 0;
    ASSERT_EQ(
        std::sscanf(told.c_str() + told.find("peak rotation"), "peak rotation %lf deg = %lf rad", &degrees, &rotation),
        2)
        << told;
    EXPECT_NEAR(degrees, rotation * 180 / 3.14159265358979, 1e-3 * degrees);
    auto const yaw = told.find("peak_yaw");
    ASSERT_NE(yaw, std::string::npos) << told;
    EXPECT_NE(told.substr(yaw, told.find(':', yaw) - yaw).find(" deg"), std::string::npos) << told;
    EXPECT_EQ(told.find("landing_azimuth"), std::string::npos) << "it stands: " << told;
    EXPECT_EQ(told.find("e 0.7648"), std::string::npos) << "Housner's is not its restitution: " << told;
}

TEST_F(Verbs, RockJson) {
    folder.write("sine.csv", sine_csv());
    std::vector<std::string> const command{"rock",     "--body", "body.toml", "--wave",
                                           "sine.csv", "--unit", "g",         "--json"};
    auto const stands = json::parse(done(command).out);
    auto const falls = json::parse(done(joined(command, {"--scale", "3", "--history", "h.csv"})).out);

    EXPECT_EQ(keys_of(stands).size(), 51U);  // the contract's, what else a row of /trials says, and what was typed
    expect_keys(stands, {"contact_lost_time_s", "verdict", "overturned", "peak_rotation_rad", "peak_rotation_ratio",
                         "peak_energy_ratio", "peak_impact_velocity_mps", "time_of_peak_s", "overturn_time_s",
                         "first_uplift_s", "impacts", "peak_slip_m", "residual_slip_m", "friction_demand",
                         "min_contact_force_ratio", "v_resp_mps", "v_ereq_mps", "effects", "restitution"});
    EXPECT_EQ(stands["verdict"], "rocked");
    EXPECT_EQ(stands["record"]["format"], "columns");
    EXPECT_EQ(stands["record"]["samples"], 401);
    EXPECT_NEAR(stands["residual_velocity_mps"].get<double>(), 0, 1e-12);
    EXPECT_EQ(stands["overturned"], false);
    EXPECT_TRUE(stands["overturn_time_s"].is_null());
    EXPECT_GT(stands["impacts"], 0);
    EXPECT_EQ(stands["effects"], json::array());
    EXPECT_EQ(falls["verdict"], "overturned");
    EXPECT_NEAR(falls["peak_rotation_rad"].get<double>(), 1.5707963, 1e-7);
    EXPECT_EQ(falls["v_resp_mps"], falls["v_ereq_mps"]);
    EXPECT_TRUE(folder.read("h.csv").starts_with("time_s,"));
}

// Effects that leave sliding out say so of a body with friction, and no friction then limits what holds it: 0.1 would
// let it slip for metres under 0.5 g. What is left is the spring of its points.
TEST_F(Verbs, RockSaysWhetherABodyWithFrictionSlips) {
    folder.write("sine.csv", sine_csv());
    folder.write("slippery.toml", folder.read("body.toml") + "friction=0.1\n");
    auto const slip_under = [&](std::string const& effects, bool told) {
        auto const ended = done(
            {"rock", "--body", "slippery.toml", "--wave", "sine.csv", "--unit", "g", "--effects", effects, "--json"});
        EXPECT_EQ(ended.err.find("it does not slip") != std::string::npos, told) << effects << ended.err;
        return json::parse(ended.out).at("peak_slip_m").get<double>();
    };
    EXPECT_GT(slip_under("auto", false), 0.1);
    EXPECT_GT(slip_under("sliding,contact", false), 0.1);
    EXPECT_LT(slip_under("contact", true), 0.01);
    EXPECT_EQ(slip_under("none", true), 0);
}

TEST_F(Verbs, SpectrumJson) {
    folder.write("sine.csv", sine_csv());
    auto const spectrum =
        json::parse(done({"spectrum", "--wave", "sine.csv", "--unit", "g", "--body", "body.toml", "--json"}).out);
    auto const without = json::parse(done({"spectrum", "--wave", "sine.csv", "--unit", "g", "--json"}).out);

    expect_keys(spectrum, {"pga_mps2", "pgv_mps", "pgd_m", "cav_mps", "standardised_cav_mps", "period_s", "sa_mps2",
                           "psv_mps", "v_e_mps", "energy"});
    expect_keys(spectrum["energy"], {"t0_s", "t1_s", "ou_v_e_mps", "v_wes_mps", "v_wes_time_s", "v_ereq_mps"});
    EXPECT_EQ(spectrum["period_s"].size(), spectrum["sa_mps2"].size());
    EXPECT_NEAR(spectrum["pga_mps2"].get<double>(), 0.5 * 9.80665, 1e-6);
    // b sqrt(2 g / (R + h)) by hand
    double const radius = std::hypot(0.45, 1.045);
    EXPECT_NEAR(spectrum["energy"]["v_ereq_mps"].get<double>(), std::sqrt(2 * 9.80665 * (radius - 1.045)), 1e-9);
    EXPECT_FALSE(without.contains("energy"));
    // A prediction is called one; whether the body falls is for its history to tell.
    auto const text = done({"spectrum", "--wave", "sine.csv", "--unit", "g", "--body", "body.toml"}).out;
    EXPECT_EQ(text.find("overturn\n"), std::string::npos) << text;
    EXPECT_NE(text.find(": predicted "), std::string::npos) << text;
    EXPECT_GT(spectrum["cav_mps"].get<double>(), spectrum["pgv_mps"].get<double>()) << "of a wave that swings";
}

// A wave that is written and read back is the same wave to the last bit.
TEST_F(Verbs, WaveIsReadableByTheOtherVerbs) {
    auto const ended = done({"wave", "c.toml", "--wave", "1", "-o", "w.csv"});
    auto const text = folder.read("w.csv");
    EXPECT_TRUE(text.starts_with("time_s,ax_mps2,az_mps2\n0,"));
    EXPECT_EQ(done({"wave", "c.toml", "--wave", "1"}).out, text);
    double peak = 0;
    std::istringstream lines(text);
    std::string line;
    std::getline(lines, line);
    int count = 0;
    while (std::getline(lines, line)) {
        peak = std::max(peak, std::abs(std::stod(line.substr(line.find(',') + 1))));
        ++count;
    }
    EXPECT_EQ(count, 1025);

    auto const spectrum = json::parse(done({"spectrum", "--wave", "w.csv", "--unit", "m/s2", "--json"}).out);
    EXPECT_EQ(spectrum["pga_mps2"].get<double>(), peak);
    auto const rock =
        json::parse(done({"rock", "--body", "body.toml", "--wave", "w.csv", "--unit", "m/s2", "--json"}).out);
    EXPECT_EQ(rock["effects"], json::array({"vertical"}));
}

//
TEST_F(Verbs, PlanCountsAndEstimates) {
    auto const ended = done({"plan", "c.toml", "--set", "waves.count=40"});

    EXPECT_NE(ended.out.find("\n40 waves x 2 bodies x 3 levels = 240 trials\n"), std::string::npos) << ended.out;
    EXPECT_NE(ended.out.find("design-basis"), std::string::npos);
    for (auto const* heading :
         {"\nwaves ", "\nbodies ", "\nlevels ", "\ntested ", "\ninputs ", "\nmodel ", "\ntime "}) {
        EXPECT_NE(ended.out.find(heading), std::string::npos) << heading;
    }
    EXPECT_EQ(ended.out.find("\nscratch "), std::string::npos);
    auto const full = done({"plan", "c.toml", "--set", "waves.count=40", "--full"}).out;
    EXPECT_NE(full.find("\nscratch   40 block files of 1 waves"), std::string::npos) << full;
    for (auto const* heading : {"\nmodels ", "\nper wave "}) {
        EXPECT_NE(full.find(heading), std::string::npos) << heading << full;
    }
}

//
TEST_F(Verbs, ListNamesEverythingThatCanBeAskedFor) {
    auto const ended = done({"list"});
    for (auto const* name : {"spectrum-compatible", "harmonic", "pulse", "records", "mlit-ch1", "vertical", "pgv",
                             "peak_rotation_ratio"}) {
        EXPECT_NE(ended.out.find(std::string("  ") + name + " "), std::string::npos) << name;
    }
    auto const measures = done({"list", "measures"}).out;
    EXPECT_EQ(measures.rfind("level measures (levels.measure)\n", 0), 0U) << measures;
    EXPECT_NE(measures.find("  pgv "), std::string::npos) << measures;
    EXPECT_NE(measures.find("  standardised_cav ", measures.find("further curve measures (measures.curves)")),
              std::string::npos);
    EXPECT_EQ(measures.find("mlit-ch1"), std::string::npos) << "one list alone";
    auto const verdicts = done({"list", "verdicts"}).out;
    EXPECT_NE(verdicts.find("at-rest                slid less than 1 mm, and no edge of its base rose 1 mm\n"),
              std::string::npos)
        << verdicts;
    EXPECT_NE(ended.out.find(measures), std::string::npos) << "and it is part of the whole";
}

//
TEST_F(Verbs, FitRecountsAndStatusKnowsTheEnd) {
    auto const run = done({"run", "c.toml"});
    auto const fit = json::parse(done({"fit", "c.h5", "--json"}).out);

    EXPECT_EQ(fit["stripes"].size(), 6U);
    expect_keys(fit["stripes"][0],
                {"body", "amplitude", "trials", "overturned", "failed", "probability", "lower", "upper"});
    EXPECT_EQ(fit["stripes"][5]["trials"], 2);
    expect_keys(fit["criterion"][0], {"false_safe", "false_alarm", "true_safe", "true_overturn"});
    // The run's own table, recomputed from the file.
    EXPECT_EQ(run.out, done({"fit", "c.h5"}).out + "results: c.h5\n");
    auto const told = done({"fit", "c.h5", "--section", "together"}).out;
    EXPECT_NE(told.find("\nany of 2 bodies"), std::string::npos) << told;
    EXPECT_NE(done({"status", "c.h5"}).out.find("complete, 12 trials of 'small'"), std::string::npos);
}

TEST_F(Verbs, VersionAndHelp) {
    EXPECT_TRUE(done({"--version"}).out.starts_with("overturn "));
    EXPECT_NE(done({"run", "--help"}).out.find("--max-walltime"), std::string::npos);
}

void expect_narrow(std::string const& text, std::string const& name) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(line.size(), line_width) << name << ": " << line;
    }
}

// The help of every verb and every list fits 100 columns; the verbs stand one to a line.
TEST_F(Verbs, HelpAndListsFitATerminal) {
    auto const help = done({"--help"}).out;
    expect_narrow(help, "--help");
    std::istringstream lines(help.substr(help.find("\nSubcommands:\n") + 14));
    int verbs = 0;
    for (std::string line; std::getline(lines, line);) {
        if (auto const name = line.substr(0, line.find(' ', 2)); !name.empty()) {
            expect_narrow(done({name.substr(2), "--help"}).out, name);
            ++verbs;
        }
    }
    EXPECT_EQ(verbs, 17);
    done({"run", "c.toml"});
    for (std::vector<std::string> const& list :
         {std::vector<std::string>{"list"}, {"list", "keys"}, {"list", "assumptions"}, {"list", "columns", "c.h5"}}) {
        expect_narrow(done(list).out, list.back());
    }
}

// notes fit 100 columns in a log too, and so do rock, replay and status; a command to go on with stays whole,
// and an error is one line.
TEST_F(Verbs, NotesAndResultsFitATerminal) {
    std::string const setting = "title=" + std::string(90, 'x');
    auto const stopped =
        overturn(folder, {"run", "c.toml", "--set", "waves.count=4000", setting, "--max-walltime", "0.05 s"});
    EXPECT_EQ(stopped.code, 3) << stopped.err;
    auto const command = "\n    overturn run c.toml -o c.h5 --resume --set waves.count=4000 --set " + setting + "\n";
    auto lines = stopped.err_lines;
    auto const at = lines.find(command);
    ASSERT_NE(at, std::string::npos) << lines;
    lines.erase(at, command.size() - 1);
    EXPECT_EQ(too_wide(lines), "");
    auto status = overturn(folder, {"status", "c.h5"}).out;
    auto const again = status.find(command);
    ASSERT_NE(again, std::string::npos) << status;
    EXPECT_EQ(too_wide(status.erase(again, command.size() - 1)), "");
    std::filesystem::remove_all(folder / "c.h5.parts");

    auto const run = done({"run", "c.toml"});
    EXPECT_NE(run.err.find("validated range: outside the range of 245 shaking-table tests of two granite blocks: "),
              std::string::npos)
        << run.err;
    EXPECT_EQ(too_wide(run.err_lines), "");
    done({"wave", "c.toml", "--wave", "1", "-o", "w.csv"});
    folder.write("body.toml",
                 "name='a body with a name that is rather long'\nmass='12.6 t'\nbase_width='0.9 m'\n"
                 "centre_height='1.045 m'\ninertia='uniform-block'\nfriction=0.5\n");
    for (std::vector<std::string> const& verb : {std::vector<std::string>{"status", "c.h5"},
                                                 {"replay", "c.h5", "--trial", "9"},
                                                 {"replay", "c.h5", "--trial", "3"},
                                                 {"rock", "--body", "body.toml", "--wave", "w.csv", "--scale", "3"}}) {
        auto const ended = done(verb);
        EXPECT_EQ(too_wide(ended.out + ended.err_lines), "") << verb.front();
    }
    auto const refused = overturn(folder, {"run", "c.toml", "-o", std::string(120, 'x') + "/c.h5"});
    EXPECT_TRUE(is_one_error_line(refused.err_lines));
}

// a number that is none is refused with one that would be; a section with the one that was probably meant.
TEST_F(Verbs, NumbersAndSectionsAreRefusedWithWhatToWrite) {
    auto const refused = [&](std::vector<std::string> const& arguments, std::string const& why) {
        auto const ended = overturn(folder, arguments);
        EXPECT_EQ(ended.code, 2) << ended.err;
        EXPECT_TRUE(is_one_error_line(ended.err));
        EXPECT_NE(ended.err.find(why), std::string::npos) << ended.err;
    };
    refused({"fit", "c.h5", "--beta-u", "30%"}, "--beta-u '30%' (must be a number). Write 0.3");
    refused({"fit", "c.h5", "--beta-u", "30 %"}, "--beta-u '30 %' (must be a number). Write 0.3");
    refused({"fit", "c.h5", "--beta-u", "much"}, "--beta-u 'much' (must be a number). Write one, for example 0.3");
    refused({"plan", "c.toml", "--ranks", "2.5"}, "--ranks '2.5' (must be a whole number). Write one, for example 10");
    refused({"fit", "c.h5", "--section", "curve"}, "--section 'curve' (no such section). Did you mean 'curves'?");
    refused({"fit", "c.h5", "--section", "zzz"}, "--section 'zzz' (no such section). There are records, stripes");
    done({"plan", "c.toml", "--ranks", "2"});
}

}  // namespace
}  // namespace overturn::testing
