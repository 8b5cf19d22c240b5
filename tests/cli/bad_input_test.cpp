// Requirement R-902: bad input is refused with exit code 2 and one line on stderr for each fault, `file:line:col:
// problem (why) what to do`, reported by one rank, before any work.
#include <algorithm>
#include <string>

#include "cli/campaign_files.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

void expect_refused(Ended const& ended, std::string const& part) {
    EXPECT_EQ(ended.code, 2) << part;
    EXPECT_TRUE(is_one_error_line(ended.err)) << part;
    EXPECT_NE(ended.err.find(part), std::string::npos) << "no '" << part << "' in: " << ended.err;
    EXPECT_EQ(ended.out, "");
}

std::string changed(std::string const& from, std::string const& to) {
    auto text = small_campaign();
    auto const at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

class BadInput : public ::testing::Test {
  protected:
    BadInput() { folder.write("target.csv", target_csv); }

    /// Changes one thing in a campaign that is fine otherwise.
    void refuse(std::string const& from, std::string const& to, std::string const& part) {
        folder.write("c.toml", changed(from, to));
        expect_refused(planned(folder, {"c.toml"}), part);
    }

    Folder folder;
};

// unknown keys are errors with a suggestion and their place.
TEST_F(BadInput, MisspeltKey) {
    refuse("friction=", "fricton=", "c.toml:27:9: unknown key 'bodies[0].fricton'");
    refuse("friction=", "fricton=", "Did you mean 'friction'?");
    refuse("seed  =", "sede  =", "Did you mean 'seed'?");
    refuse("[waves.vertical]", "[waves.vertcal]", "Did you mean 'vertical'?");
    refuse("[levels]", "[level]", "Did you mean 'levels'?");
    refuse("match_iterations=3", "longest='10 s'",
           "unknown key 'waves.longest' (nothing reads it). Did you mean 'waves.target.longest'?");
    refuse("match_iterations=3", "ratio=0.5", "unknown key 'waves.ratio' (nothing reads it here). Remove it");
    refuse("seed  = 2013", "", "seed: missing (there is no default). Add this key");
}

// what is not measured can neither be asked for nor judged.
TEST_F(BadInput, WhatIsNotMeasuredIsNotAskedFor) {
    refuse("seed  = 2013", "seed  = 2013\nmeasures={energy=false,both_radius_units=true}",
           "measures.both_radius_units: beside energy = false");
    folder.write("c.toml", small_campaign());
    expect_refused(planned(folder, {"c.toml", "--set", "measures.wave_quality=false", "--set", "waves.match='each'",
                                    "--set", "waves.acceptance='srp-3.7.1'"}),
                   "measures.wave_quality: false beside waves.acceptance");
}

// a value outside its range or of another dimension is refused where it stands.
TEST_F(BadInput, ImpossibleValues) {
    refuse("'20.48 s'", "'20.48 m'", "c.toml:6:10: waves.duration: ");
    refuse("mass='12.6 t'", "mass='-12.6 t'", "bodies[0].mass: -12.6 t, that is -12600 kg");
    refuse("mass='12.6 t'", "mass=nan", "bodies[0].mass");
    refuse("base_width='1.36 m'", "base_width=0", "bodies[0].base_width: 0 m");
    refuse("base_width='1.36 m'", "base_width='8 m'", "so squat");
    refuse("friction=0.5", "restitution=1.01", "bodies[0].restitution: 1.01");
    refuse("friction=0.5", "restitution=-0.1", "bodies[0].restitution: -0.1");
    refuse("count=12", "count=0", "waves.count: 0");
    refuse("count=12", "count=1.5", "waves.count");
    refuse("seed  = 2013", "seed  = -1", "seed: -1");
    refuse("'300 gal'", "'300 kine'", "levels.values");
    refuse("name='type-b'", "name='type-a'", "twice");
    refuse("title = 'small'", "title = small", "not valid TOML");
}

// all that is missing, unknown or of another type is reported in one run, a line each.
TEST_F(BadInput, AllFaultsAreReportedAtOnce) {
    folder.write("b.toml", "name='c'\nmass='5 t'\ncolour='red'\n");
    folder.write("c.toml",
                 "[waves]\nsource='harmonic'\namplitude='lots'\nfrequency='1 Hz'\ncycles=5\n[[bodies]]\nname='a'\n"
                 "mass=true\nbase_width='1 m'\n[[bodies]]\nfile='b.toml'\n[levels]\nmeasure='factor'\nvalus=[1]\n"
                 "design_basis=2\n");
    auto const ended = overturn(folder, {"plan", "c.toml"});
    EXPECT_EQ(ended.code, 2);
    for (auto const* part :
         {"c.toml:1:1: seed: missing", "c.toml:3:11: waves.amplitude: ", "c.toml:6:1: bodies[0].centre_height: missing",
          "c.toml:6:1: bodies[0].inertia: missing",
          "c.toml:8:6: bodies[0].mass: ", "c.toml:14:7: unknown key 'levels.valus'", "b.toml:1:1: base_width: missing",
          "b.toml:1:1: centre_height: missing", "b.toml:1:1: inertia: missing", "b.toml:3:8: unknown key 'colour'"}) {
        auto const at = ended.err.find(std::string("overturn: ") + part);
        EXPECT_NE(at, std::string::npos) << "no '" << part << "' in: " << ended.err;
        EXPECT_EQ(ended.err.find(part, at + 20), std::string::npos) << "twice '" << part << "' in: " << ended.err;
    }
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 10) << ended.err;
}

// unknown names are refused with a suggestion.
TEST_F(BadInput, UnknownNames) {
    refuse("source='spectrum-compatible'", "source='spectrum-compatibel'", "Did you mean 'spectrum-compatible'?");
    refuse("file='target.csv'\nkind='acceleration'", "spectrum='mlit-ch3'", "Did you mean 'mlit-ch1'?");
    refuse("[levels]", "[effects]\ninclude=['verticle']\n[levels]", "Did you mean 'vertical'?");
    refuse("[levels]", "[effects]\nmode='atuo'\n[levels]", "Did you mean 'auto'?");
    refuse("measure='pga'", "measure='pgw'", "Did you mean 'pga'?");
}

// R-1106: missing or odd files are named, with the key that asked for them.
TEST_F(BadInput, Files) {
    expect_refused(planned(folder, {"nope.toml"}), "nope.toml: cannot be read");
    expect_refused(overturn(folder, {"run", "nope.toml"}), "nope.toml: cannot be read");
    expect_refused(overturn(folder, {"run", "."}), "cannot be read");
    refuse("target.csv", "nowhere.csv", "nowhere.csv");
    folder.write("target.csv", "# period_s,sa_mps2\n0.02,2.5\n0.1,-6.2\n10,1\n");
    folder.write("c.toml", small_campaign());
    expect_refused(planned(folder, {"c.toml"}), "target.csv:3");
}

// a vertical record shakes no body sideways; its own spectrum may be asked for.
TEST_F(BadInput, VerticalRecordUnderABody) {
    std::string text =
        "PEER\nSomewhere, 1/16/1995, A-B, UP\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 50, DT= .02 SEC\n";
    for (int i = 0; i < 10; ++i) {
        text += " .1 .2 -.1 -.2 .0\n";
    }
    folder.write("a-UP.AT2", text);
    folder.write("body.toml", "mass=1\nbase_width=1\ncentre_height=2\ninertia='uniform-block'\n");
    expect_refused(overturn(folder, {"rock", "--body", "body.toml", "--wave", "a-UP.AT2"}),
                   "a-UP.AT2: recorded vertically");
    expect_refused(overturn(folder, {"spectrum", "--body", "body.toml", "--wave", "a-UP.AT2"}),
                   "a-UP.AT2: recorded vertically");
    EXPECT_EQ(overturn(folder, {"spectrum", "--wave", "a-UP.AT2"}).code, 0);
}

// a record that is not numbers is refused with its line.
TEST_F(BadInput, NotANumberInARecord) {
    folder.write("r.csv", "0,0.1\n0.01,0.2\n0.02,nan\n0.03,0\n");
    folder.write("body.toml", "mass=1\nbase_width=1\ncentre_height=2\ninertia='uniform-block'\n");
    expect_refused(overturn(folder, {"rock", "--body", "body.toml", "--wave", "r.csv", "--unit", "g"}), "r.csv:3");
    expect_refused(overturn(folder, {"spectrum", "--wave", "r.csv", "--unit", "g"}), "r.csv:3");
    expect_refused(overturn(folder, {"spectrum", "--wave", "r.csv", "--unit", "gall"}), "gall");
    folder.write("whole.csv", "0,0.1\n0.01,0.2\n0.02,0.1\n0.03,0\n");
    expect_refused(overturn(folder, {"spectrum", "--wave", "whole.csv"}), "unit");
    folder.write("c.toml",
                 "seed=1\n[waves]\nsource='records'\nfiles=['r.csv']\nunit='g'\n[[bodies]]\nfile='body.toml'\n"
                 "[levels]\nmeasure='factor'\nvalues=[1]\n");
    expect_refused(overturn(folder, {"run", "c.toml"}), "r.csv:3");
    EXPECT_FALSE(folder.has("c.h5"));
}

// R-1105: an output that cannot be had is refused before any work.
TEST_F(BadInput, Output) {
    folder.write("c.toml", small_campaign("shared", 1));
    folder.write("file", "");
    expect_refused(overturn(folder, {"run", "c.toml", "-o", "no/such/folder/o.h5"}), "no/such/folder/o.h5");
    expect_refused(overturn(folder, {"run", "c.toml", "-o", "file/o.h5"}), "cannot write there");
    expect_refused(overturn(folder, {"run", "c.toml", "-o", "/proc/o.h5"}), "cannot write there");
    expect_refused(overturn(folder, {"run", "c.toml", "-o", "."}), "is a folder");
    folder.write("taken.h5", "precious");
    expect_refused(overturn(folder, {"run", "c.toml", "-o", "taken.h5"}), "exists already");
    expect_refused(overturn(folder, {"run", "c.toml", "-o", "taken.h5", "--resume"}), "taken.h5");
    EXPECT_EQ(folder.read("taken.h5"), "precious");
    expect_refused(overturn(folder, {"status", "none.h5"}), "none.h5");
    expect_refused(overturn(folder, {"replay", "taken.h5", "--trial", "0"}), "taken.h5");
    expect_refused(overturn(folder, {"fit", "none.h5"}), "none.h5");
}

// a command line that is not understood says what was probably meant.
TEST_F(BadInput, CommandLine) {
    expect_refused(overturn(folder, {"rnu", "c.toml"}), "verb 'rnu' (unknown). Did you mean 'run'?");
    expect_refused(overturn(folder, {"frobnicate"}), "Known: new, run, plan");
    expect_refused(overturn(folder, {}), "no verb");
    expect_refused(overturn(folder, {"run", "c.toml", "--reusme"}), "Did you mean '--resume'?");
    expect_refused(overturn(folder, {"run", "c.toml", "--reusme=1"}), "option '--reusme' (unknown)");
    expect_refused(overturn(folder, {"list", "all"}), "list 'all' (unknown)");
    expect_refused(overturn(folder, {"list", "assumptions", "all"}), "'all' (one argument too many)");
    expect_refused(overturn(folder, {"replay", "c.h5", "--trial", "x"}), "--trial");
    expect_refused(overturn(folder, {"run"}), "campaign is required");
}

//
TEST_F(BadInput, Settings) {
    folder.write("c.toml", small_campaign());
    auto const refused = [&](std::string const& setting, std::string const& part) {
        expect_refused(planned(folder, {"c.toml", "--set", setting}), part);
    };
    refused("waves.cuont=3", "Did you mean 'count'?");
    refused("waves.count", "no '='");
    refused("bodies.7.friction=1", "no place in a list of 2");
    refused("waves.count=0", "waves.count: 0");
    expect_refused(overturn(folder, {"run", "c.toml", "--max-walltime", "5 parsec"}), "parsec");
    expect_refused(overturn(folder, {"run", "c.toml", "--max-walltime", "-5"}), "--max-walltime");
    EXPECT_FALSE(folder.has("c.h5.parts"));
}

// under MPI one rank speaks. Without --quiet mpirun adds its own words on exit codes, which no program can
// keep it from.
TEST_F(BadInput, UnderMpiOneRankSpeaks) {
    folder.write("c.toml", changed("friction=", "fricton="));
    folder.write("good.toml", small_campaign("shared", 1));
    folder.write("taken.h5", "precious");
    expect_refused(execute(folder, mpirun(2, {"run", "c.toml"})), "c.toml:27:9: ");
    expect_refused(execute(folder, mpirun(2, {"run", "good.toml", "-o", "taken.h5"})), "exists already");
    expect_refused(execute(folder, mpirun(2, {"run", "good.toml", "-o", "no/folder.h5"})), "no/folder.h5");
    expect_refused(execute(folder, mpirun(2, {"run", "good.toml", "--max-walltime", "x"})), "x");
    expect_refused(execute(folder, mpirun(2, {"rnu", "c.toml"})), "Did you mean 'run'?");
    expect_refused(execute(folder, mpirun(2, {"run", "c.toml", "--reusme"})), "Did you mean '--resume'?");
}

}  // namespace
}  // namespace overturn::testing
