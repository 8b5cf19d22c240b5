// Requirement R-1001: two runs of one campaign give byte-identical files, on any number of ranks; a row can be rerun
// from the file alone.
#include <nlohmann/json.hpp>

#include "cli/campaign_files.hpp"
#include "cli/python.hpp"
#include "support/command.hpp"
#include "support/line_width.hpp"

namespace overturn::testing {
namespace {

class Run : public ::testing::Test {
  protected:
    Run() { folder.write("target.csv", target_csv); }

    std::string bytes(std::vector<std::string> const& command, std::string const& output) {
        auto const ended = execute(folder, command);
        EXPECT_EQ(ended.code, 0) << ended.err;
        EXPECT_TRUE(folder.has(output)) << ended.err;
        EXPECT_FALSE(folder.has(output + ".parts"));
        return folder.read(output);
    }

    Folder folder;
};

void expect_same(std::string const& a, std::string const& b, char const* what) {
    EXPECT_GT(a.size(), 10'000U) << what;
    EXPECT_TRUE(a == b) << what << " differs";
}

// R-1001: nothing in the file depends on ranks.
TEST_F(Run, RanksDoNotMatter) {
    for (std::string const waves : {"shared", "independent"}) {
        folder.write("c.toml", small_campaign(waves, 6));
        auto const alone = bytes({OVERTURN_PROGRAM, "run", "c.toml", "-o", waves + "0.h5"}, waves + "0.h5");
        for (int const ranks : {1, 2, 3}) {
            auto const name = waves + std::to_string(ranks) + ".h5";
            auto const many = bytes(mpirun(ranks, {"run", "c.toml", "-o", name}), name);
            expect_same(alone, many, name.c_str());
        }
    }
    EXPECT_TRUE(folder.has("shared3.runtime.json"));
}

// R-1001: nor on who fits which curve, where rank 0 alone puts the rows together too: of a packed file, and of waves
// whose targets are drawn.
TEST_F(Run, RanksShareTheCurves) {
    std::string const levels = "levels.values=['300 gal','600 gal','900 gal','1200 gal','1600 gal']";
    auto drawn = small_campaign("shared", 40);
    drawn.insert(drawn.find("[waves.vertical]"), "[waves.variability]\ncorrelation='baker-jayaram-2008'\nsigma=0.4\n");
    folder.write("plain.toml", small_campaign("shared", 40));
    folder.write("drawn.toml", drawn);
    auto const expect_same_on = [&](std::string const& campaign, std::vector<int> const& ranks, bool packed) {
        auto const run = [&](std::string const& output) {
            std::vector<std::string> const args{"run", campaign + ".toml", "--set", levels, "-o", output};
            return packed ? joined(args, {"--packed"}) : args;
        };
        auto const name = campaign + (packed ? "-packed" : "");
        auto const alone = bytes(joined({OVERTURN_PROGRAM}, run(name + ".h5")), name + ".h5");
        for (int const of : ranks) {
            auto const output = name + std::to_string(of) + ".h5";
            expect_same(alone, bytes(mpirun(of, run(output)), output), output.c_str());
        }
        auto const fit = overturn(folder, {"fit", name + ".h5"}).out;
        EXPECT_NE(fit.find("median"), std::string::npos) << "there are curves: " << fit;
    };
    expect_same_on("plain", {1, 2, 3}, false);
    expect_same_on("plain", {2}, true);
    expect_same_on("drawn", {3}, false);
    auto const other =
        bytes({OVERTURN_PROGRAM, "run", "plain.toml", "--set", levels, "seed=2014", "-o", "o.h5"}, "o.h5");
    EXPECT_FALSE(other == folder.read("plain.h5"));
}

// R-1001: a packed file of 16 800 trials is a fifth of the size, the same bytes on any ranks and merged, and every verb
// reads it as the plain one.
TEST_F(Run, PackedIsSmallerAndTheSame) {
    folder.write("c.toml",
                 "title='many'\nseed=1\n[waves]\nsource='harmonic'\namplitude='1 m/s2'\n"
                 "frequencies=['0.5 Hz','1 Hz','2 Hz','4 Hz','6 Hz','8 Hz']\ncycles=5\n[[bodies]]\nname='b'\n"
                 "mass='12.6 t'\nbase_width='0.9 m'\ncentre_height='1.045 m'\ninertia='uniform-block'\n[levels]\n"
                 "measure='pga'\nvalues={from='1 gal', to='500 gal', count=2800}\n");
    auto const plain = bytes({OVERTURN_PROGRAM, "run", "c.toml", "-o", "plain.h5"}, "plain.h5");
    auto const packed = bytes({OVERTURN_PROGRAM, "run", "c.toml", "-o", "packed.h5", "--packed"}, "packed.h5");
    EXPECT_LT(packed.size(), plain.size() / 5);
    auto const sizes = nlohmann::json::parse(overturn(folder, {"plan", "c.toml", "--json"}).out);
    EXPECT_NEAR(sizes["file_bytes"].get<double>() / static_cast<double>(plain.size()), 1, 0.15) << "R-904";
    EXPECT_NEAR(sizes["file_bytes_packed"].get<double>() / static_cast<double>(packed.size()), 1, 0.5);
    folder.write("large.toml", small_campaign("shared", 400'000));
    for (auto const& [name, text] :
         {std::pair("c.toml", " MB (with --packed "), {"large.toml", " GB (with --packed "}}) {
        auto const plan = planned(folder, {name}).out;
        EXPECT_NE(plan.find(text), std::string::npos) << plan;
    }
    std::vector<std::string> const fewer{"--set", "levels.values={from='1 gal', to='500 gal', count=2700}"};
    auto const plain_of_fewer =
        bytes(joined({OVERTURN_PROGRAM, "run", "c.toml", "-o", "fewer.h5"}, fewer), "fewer.h5").size();
    EXPECT_NEAR(
        static_cast<double>(
            bytes(joined({OVERTURN_PROGRAM, "run", "c.toml", "-o", "few.h5", "--packed"}, fewer), "few.h5").size()),
        static_cast<double>(plain_of_fewer), 0.01 * static_cast<double>(plain_of_fewer))
        << "up to 16 384 trials it is no smaller, as the help says";
    auto const no_smaller = nlohmann::json::parse(overturn(folder, joined({"plan", "c.toml", "--json"}, fewer)).out);
    EXPECT_TRUE(no_smaller["file_bytes_packed"].is_null());
    expect_same(packed, bytes(mpirun(2, {"run", "c.toml", "-o", "two.h5", "--packed"}), "two.h5"), "two.h5");
    for (auto const* part : {"1/2", "2/2"}) {
        EXPECT_EQ(overturn(folder, {"run", "c.toml", "-o", "parts.h5", "--part", part}).code, 0);
    }
    expect_same(packed, bytes({OVERTURN_PROGRAM, "merge", "parts.h5", "--packed"}, "parts.h5"), "parts.h5");

    // A finished file is packed on request, and what extends a packed one is packed.
    std::vector<std::string> const finished{"run", "c.toml", "-o", "plain.h5", "--packed"};
    auto const named = overturn(folder, joined(finished, {"--resume"}));
    EXPECT_NE(named.out.find("complete already, and not packed. To pack it: --extend --packed"), std::string::npos)
        << named.out;
    folder.write("again.h5", plain);
    expect_same(packed, bytes(mpirun(2, {"run", "c.toml", "-o", "again.h5", "--extend", "--packed"}), "again.h5"),
                "again.h5");
    auto const nothing = overturn(folder, {"run", "c.toml", "-o", "again.h5", "--extend", "--packed"});
    EXPECT_NE(nothing.out.find("complete already, nothing to do"), std::string::npos) << nothing.out;
    std::vector<std::string> const more{"--set", "levels.values={from='1 gal', to='500 gal', count=2801}"};
    auto const at_once =
        bytes(joined({OVERTURN_PROGRAM, "run", "c.toml", "-o", "more.h5", "--packed"}, more), "more.h5");
    auto const grown =
        bytes(joined({OVERTURN_PROGRAM, "run", "c.toml", "-o", "again.h5", "--extend", "--shrink"}, more), "again.h5");
    expect_same(at_once, grown, "a packed file, extended");
    std::vector<std::string> const little_more{"--set", "levels.values={from='1 gal', to='500 gal', count=2701}"};
    expect_same(bytes(joined({OVERTURN_PROGRAM, "run", "c.toml", "-o", "some.h5", "--packed"}, little_more), "some.h5"),
                bytes(joined({OVERTURN_PROGRAM, "run", "c.toml", "-o", "few.h5", "--extend", "--shrink"}, little_more),
                      "few.h5"),
                "a packed file too short for chunks, extended");

    auto const fitted = overturn(folder, {"fit", "plain.h5", "--json"});
    EXPECT_EQ(fitted.code, 0) << fitted.err;
    EXPECT_EQ(overturn(folder, {"fit", "packed.h5", "--json"}).out, fitted.out);
    for (auto const& asked : {std::vector<std::string>{"verify", "packed.h5", "--sample", "40"},
                              {"status", "packed.h5"},
                              {"replay", "packed.h5", "--trial", "16700"}}) {
        EXPECT_EQ(overturn(folder, asked).code, 0) << asked.front();
    }
}

// R-1001, R-713: that holds on compliant points, in the plane and in space, and beside another cask that moves too;
// every model answers some trial.
TEST_F(Run, RanksDoNotMatterOnPoints) {
    folder.write("c.toml", campaign_on_points(4) + "[site]\ncask='2 m'\ncask_body='round'\nedge='1 m'\n");
    auto const alone = bytes({OVERTURN_PROGRAM, "run", "c.toml", "-o", "0.h5"}, "0.h5");
    for (int const ranks : {1, 2, 3}) {
        auto const name = std::to_string(ranks) + ".h5";
        expect_same(alone, bytes(mpirun(ranks, {"run", "c.toml", "-o", name}), name), name.c_str());
    }
    auto const other = bytes({OVERTURN_PROGRAM, "run", "c.toml", "-o", "o.h5", "--set", "seed=7"}, "o.h5");
    EXPECT_FALSE(alone == other);
    auto const told = execute(folder, {OVERTURN_PROGRAM, "fit", "0.h5", "--full"});
    EXPECT_EQ(told.code, 0) << told.err;
    EXPECT_NE(told.out.find(" contact"), std::string::npos) << told.out;
    EXPECT_NE(told.out.find(" spatial"), std::string::npos) << told.out;
    EXPECT_EQ(too_wide(told.out), "");
    for (auto const* trial : {"7", "25", "38", "57"}) {
        auto const replayed = overturn(folder, {"replay", "0.h5", "--trial", trial, "--history", "h.csv"});
        EXPECT_EQ(replayed.code, 0) << replayed.out << replayed.err;
        auto const history = folder.read("h.csv");
        EXPECT_TRUE(history.substr(0, history.find('\n')).ends_with(",reach_minus_y_m,clearance_m,edge_margin_m"));
    }
}

// R-1001, R-103: nor on who shares the calibration of waves that are matched in the median.
TEST_F(Run, RanksShareACalibration) {
    auto campaign = small_campaign("shared", 3);
    std::string const each = "match='each'\nmatch_iterations=3\n";
    campaign.replace(campaign.find(each), each.size(), "match='ensemble'\n");
    folder.write("c.toml", campaign);
    auto const command = [](std::string const& output) {
        return std::vector<std::string>{"run", "c.toml", "-o", output};
    };
    auto const alone = bytes(mpirun(1, command("1.h5")), "1.h5");
    for (int const ranks : {2, 3}) {
        auto const name = std::to_string(ranks) + ".h5";
        expect_same(alone, bytes(mpirun(ranks, command(name)), name), name.c_str());
    }
    EXPECT_EQ(execute(folder, mpirun(2, {"verify", "3.h5"})).code, 0);
    auto const left = overturn(folder, joined(command("merged.h5"), {"--leave-blocks"}));
    EXPECT_EQ(left.code, 0) << left.err;
    expect_same(alone, bytes(mpirun(3, {"merge", "merged.h5"}), "merged.h5"), "merged.h5");
}

// R-1303: nor on there being far more ranks than cores, or than blocks.
TEST_F(Run, SixteenRanksDoNotMatter) {
    folder.write("c.toml", small_campaign("shared", 20));
    auto const alone = bytes({OVERTURN_PROGRAM, "run", "c.toml", "-o", "alone.h5"}, "alone.h5");
    auto const many = bytes(mpirun(16, {"run", "c.toml", "-o", "many.h5"}), "many.h5");
    expect_same(alone, many, "the file of 16 ranks");
}

//
TEST_F(Run, TheSeedMatters) {
    folder.write("c.toml", small_campaign("shared", 2));
    auto const one = bytes({OVERTURN_PROGRAM, "run", "c.toml"}, "c.h5");
    auto const again = bytes({OVERTURN_PROGRAM, "run", "c.toml", "-o", "again.h5"}, "again.h5");
    auto const other = bytes({OVERTURN_PROGRAM, "run", "c.toml", "-o", "o.h5", "--set", "seed=2014"}, "o.h5");

    expect_same(one, again, "a second run");
    EXPECT_FALSE(one == other);
}

// R-1005: replay needs the results file only and is bit-equal.
TEST_F(Run, ReplayFromTheFileAlone) {
    for (std::string const waves : {"shared", "independent"}) {
        folder.write("target.csv", target_csv);
        folder.write("c.toml", small_campaign(waves, 3));
        (void)bytes({OVERTURN_PROGRAM, "run", "c.toml", "-o", waves + ".h5", "--set", "seed=5"}, waves + ".h5");
        std::filesystem::remove(folder / "target.csv");
        std::filesystem::remove(folder / "c.toml");
        for (auto const* trial : {"0", "4", "11", "17"}) {
            auto const ended = overturn(folder, {"replay", waves + ".h5", "--trial", trial});
            EXPECT_EQ(ended.code, 0) << ended.err;
            EXPECT_NE(ended.out.find("bit-equal to the stored row"), std::string::npos) << ended.out;
        }
    }
    auto const beyond = overturn(folder, {"replay", "shared.h5", "--trial", "18"});
    EXPECT_EQ(beyond.code, 2);
    EXPECT_NE(beyond.err.find("0 to 17"), std::string::npos) << beyond.err;

    auto const ended = overturn(folder, {"replay", "shared.h5", "--trial", "5", "--history", "h.csv"});
    EXPECT_EQ(ended.code, 0);
    EXPECT_TRUE(folder.read("h.csv").starts_with("time_s,rotation_rad,"));
}

// R-107, R-1005: components of a station are used when asked for, named by the run, carried in the file and replayed
// from it alone.
TEST_F(Run, ListsTheFilesOfAStation) {
    auto const at2 = [](std::string const& component, std::string const& peak) {
        std::string text = "PEER\nSomewhere, 1/16/1995, A-B, " + component
                           + "\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 200, DT= .02 SEC\n";
        for (int i = 0; i < 200; ++i) {
            text += i % 50 < 25 ? " " + peak : " -" + peak;
        }
        return text + "\n";
    };
    folder.write("a000.AT2", at2("0", ".5"));
    folder.write("a-UP.AT2", at2("UP", ".2"));
    folder.write("other.AT2", "PEER\nElsewhere, 1/16/1995, A-B, UP\nACCELERATION IN UNITS OF G\nNPTS= 1, DT= .1\n 1\n");
    folder.write("c.toml",
                 "seed=1\n[waves]\nsource='records'\nfiles=['a000.AT2']\ncomponents='station'\n[[bodies]]\nname='b'\n"
                 "mass='12.6 t'\nbase_width='0.9 m'\ncentre_height='1.045 m'\ninertia='uniform-block'\n"
                 "[levels]\nmeasure='factor'\nvalues=[1]\n");

    auto const ended = overturn(folder, {"run", "c.toml"});

    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.err.find("waves: 1 record: a000.AT2, vertical a-UP.AT2\n"), std::string::npos) << ended.err;
    for (char const* file : {"a000.AT2", "a-UP.AT2", "other.AT2"}) {
        std::filesystem::remove(folder / file);
    }
    auto const replayed = overturn(folder, {"replay", "c.h5", "--trial", "0"});
    EXPECT_EQ(replayed.code, 0) << replayed.err;
    EXPECT_NE(replayed.out.find("bit-equal"), std::string::npos) << replayed.out;
}

// R-1005: a row that is not what the program computes is reported, with exit code 1.
TEST_F(Run, ATamperedRowIsFound) {
    if (!has_python(folder, "h5py")) {
        GTEST_SKIP() << "no h5py to tamper with (install python3-h5py)";
    }
    folder.write("c.toml", small_campaign("shared", 2));
    (void)bytes({OVERTURN_PROGRAM, "run", "c.toml"}, "c.h5");
    auto const tampered = edit_results(folder, "c.h5", "f['trials/impacts'][4] += 1");
    ASSERT_EQ(tampered.code, 0) << tampered.err;

    auto const bad = overturn(folder, {"replay", "c.h5", "--trial", "4", "--unverified"});
    auto const good = overturn(folder, {"replay", "c.h5", "--trial", "5", "--unverified"});

    EXPECT_EQ(bad.code, 1);
    EXPECT_NE(bad.out.find("NOT bit-equal to the stored row: impacts"), std::string::npos) << bad.out;
    EXPECT_TRUE(is_one_error_line(bad.err));
    EXPECT_EQ(good.code, 0);
}

}  // namespace
}  // namespace overturn::testing
