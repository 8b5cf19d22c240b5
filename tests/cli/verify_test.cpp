// Requirement R-1005: verify recomputes any rows of a file, on any ranks, and says which differ; a difference is never
// blamed on another version that is the very one running.
#include <nlohmann/json.hpp>

#include "cli/campaign_files.hpp"
#include "cli/python.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

class Verify : public ::testing::Test {
  protected:
    void make(std::string const& campaign) {
        folder.write("target.csv", target_csv);
        folder.write("c.toml", campaign);
        auto const ended = overturn(folder, {"run", "c.toml"});
        ASSERT_EQ(ended.code, 0) << ended.err;
    }
    void edit(std::string const& statement) const {
        ASSERT_EQ(edit_results(folder, "c.h5", statement).code, 0) << statement;
    }

    Folder folder;
};

TEST_F(Verify, EveryRowIsBitEqualOnAnyRanks) {
    make(campaign_on_points(5));
    std::string const equal =
        "c.h5: 75 trials, 5 waves recomputed, all bit-equal to the stored rows\n";  // 5 bodies at 3 levels
    for (int const ranks : {1, 2, 3}) {
        auto const ended = execute(folder, mpirun(ranks, {"verify", "c.h5"}));
        EXPECT_EQ(ended.code, 0) << ended.err;
        EXPECT_EQ(ended.out, equal) << ranks;
    }
    EXPECT_EQ(overturn(folder, {"verify", "c.h5"}).out, equal);
}

// R-1005: what was verified is a record that can be filed: JSON and a page, the same on any ranks but for their number.
TEST_F(Verify, LeavesARecord) {
    make(small_campaign("shared", 4));
    auto const bytes = folder.read("c.h5");
    auto const seal = bytes.substr(bytes.rfind("sha256 ") + 7, 64);
    std::vector<std::string> const asked{"verify", "c.h5", "--json", "--html", "v.html", "--date", "<1 May>"};
    auto alone = nlohmann::json::parse(overturn(folder, asked).out);
    EXPECT_EQ(alone["passed"], true);
    EXPECT_EQ(alone["sha256"], seal);
    auto const status = nlohmann::json::parse(overturn(folder, {"status", "c.h5", "--json"}).out);
    EXPECT_EQ(alone["content_sha256"], status["content_sha256"]) << "the digest that is cited";
    EXPECT_EQ(alone["date"], "<1 May>");
    EXPECT_EQ(alone["trials"], 24);
    EXPECT_EQ(alone["differing_trials"], 0);
    EXPECT_EQ(alone["made_by"].get<std::string>().rfind("overturn ", 0), 0U);
    auto const page = folder.read("v.html");
    EXPECT_NE(page.find("all rows are bit-equal"), std::string::npos);
    EXPECT_NE(page.find(seal), std::string::npos);
    EXPECT_NE(page.find("content_sha256</dt><dd>" + status["content_sha256"].get<std::string>()), std::string::npos);
    EXPECT_NE(page.find("<dd>&lt;1 May&gt;</dd>"), std::string::npos);
    auto together = nlohmann::json::parse(execute(folder, mpirun(2, asked)).out);
    EXPECT_EQ(together["ranks"], 2);
    together["ranks"] = alone["ranks"];
    EXPECT_EQ(together, alone);

    edit("f['trials/v_wes'][3] *= 1.5");
    auto const edited = overturn(folder, {"verify", "c.h5", "--json", "--html", "v.html", "--unverified"});
    EXPECT_EQ(edited.code, 1);
    auto const record = nlohmann::json::parse(edited.out);
    EXPECT_EQ(record["passed"], false);
    EXPECT_EQ(record["differing_trials"], 1);
    EXPECT_NE(record["first"].get<std::string>().find("trial 3 "), std::string::npos);
    EXPECT_NE(folder.read("v.html").find("rows DIFFER"), std::string::npos);
    EXPECT_EQ(overturn(folder, {"verify", "c.h5", "--html", "v.pdf"}).code, 2);
    EXPECT_EQ(overturn(folder, {"verify", "c.h5", "--html", "no/v.html"}).code, 2);
}

TEST_F(Verify, ASampleIsAsLargeAsAskedFor) {
    make(small_campaign("shared", 6));
    for (std::string const size : {"1", "7", "36"}) {
        auto const ended = overturn(folder, {"verify", "c.h5", "--sample", size});
        EXPECT_EQ(ended.code, 0) << ended.err;
        auto const counted = size == "36" ? "36 trials, 6 waves recomputed" : size + " of 36 trials, ";
        EXPECT_EQ(ended.out.rfind("c.h5: " + counted, 0), 0U) << ended.out;
    }
    auto const asked = overturn(folder, {"verify", "c.h5", "--sample", "7", "--html", "v.html", "--json"});
    auto const record = nlohmann::json::parse(asked.out);
    EXPECT_EQ(record["stored_trials"], 36);
    EXPECT_EQ(record["stored_waves"], 6);
    auto const page = folder.read("v.html");
    EXPECT_NE(page.find("Verification: 7 of 36 trials, "), std::string::npos);
    EXPECT_EQ(page.find("all rows"), std::string::npos) << "of a sample";
    EXPECT_NE(page.find("<td>7 of 36</td>"), std::string::npos);
    EXPECT_EQ(page.find("<td>rare</td>"), std::string::npos) << "the file has none";
    for (std::string const size : {"0", "-1", "37"}) {
        auto const ended = overturn(folder, {"verify", "c.h5", "--sample", size});
        EXPECT_EQ(ended.code, 2) << size;
        EXPECT_TRUE(is_one_error_line(ended.err));
        EXPECT_NE(ended.err.find("36 rows of trials"), std::string::npos) << ended.err;
    }
}

TEST_F(Verify, RareEventsAreRowsToo) {
    make(
        "seed=7\n[waves]\nsource='filtered-noise'\nrms='1 m/s2'\nmodel='clough-penzien'\nground_frequency='0.5 Hz'\n"
        "ground_damping=0.5\nfilter_frequency='0.1 Hz'\ncount=3\nduration='20.47 s'\ntime_step='0.02 s'\n"
        "[[bodies]]\nname='block'\nmass='12.6 t'\nbase_width='0.9 m'\ncentre_height='1.045 m'\n"
        "inertia='uniform-block'\nrestitution=0.85\n[levels]\nmeasure='factor'\nvalues=[1.6]\n"
        "[rare]\nmethod='subset'\nreplicates=4\n");
    auto const ended = overturn(folder, {"verify", "c.h5"});

    EXPECT_EQ(ended.code, 0) << ended.err << ended.out;
    EXPECT_EQ(ended.out.rfind("c.h5: 3 trials, 3 waves, ", 0), 0U) << ended.out;
    EXPECT_NE(ended.out.find(" rows of rare events recomputed, all bit-equal"), std::string::npos) << ended.out;
    auto const some = execute(folder, mpirun(2, {"verify", "c.h5", "--sample", "100"}));
    EXPECT_EQ(some.code, 0) << some.err << some.out;
    EXPECT_NE(some.out.find(" rows of rare events recomputed, all bit-equal"), std::string::npos) << some.out;
}

TEST_F(Verify, WhatDiffersIsCountedAndTheFirstIsNamed) {
    make(small_campaign("shared", 4));
    if (!has_python(folder, "h5py")) {
        GTEST_SKIP() << "no h5py to write with (install python3-h5py)";
    }
    EXPECT_EQ(overturn(folder, {"verify", "c.h5"}).code, 0);
    edit(
        "f['trials/v_wes'][7] *= 2; f['trials/scale'][7] *= 2; f['trials/peak_rotation'][20] += 1; "
        "f['waves/pgv'][3] += 1e-9; f['waves/type-b/ou_v_e'][3] += 1e-9");

    EXPECT_EQ(overturn(folder, {"verify", "c.h5"}).code, 2) << "not without being asked to";
    for (int const ranks : {1, 2}) {
        auto const ended = execute(folder, mpirun(ranks, {"verify", "c.h5", "--unverified"}));
        EXPECT_EQ(ended.code, 1);
        EXPECT_NE(ended.out.find("c.h5: 24 trials, 4 waves recomputed, NOT all bit-equal: 2 trials, 1 waves differ; "
                                 "first trial 7 (wave 1, type-a, 600 gal): scale, v_wes\n"),
                  std::string::npos)
            << ended.out;
        EXPECT_TRUE(is_one_error_line(ended.err)) << ended.err;
        EXPECT_NE(ended.err.find("this very program made it"), std::string::npos) << ended.err;
        EXPECT_NE(ended.err.find("it was edited"), std::string::npos) << ended.err;
        EXPECT_EQ(ended.err.find("Replay it with that one"), std::string::npos) << ended.err;
    }
    edit("f.attrs['git_revision'] = 'abcdef012345'; f.attrs['sources_sha256'] = 'f' * 64");
    auto const other = overturn(folder, {"replay", "c.h5", "--trial", "7", "--unverified"});
    EXPECT_EQ(other.code, 1);
    EXPECT_NE(other.err.find("(abcdef012345, sources ffffffffffff); this is"), std::string::npos) << other.err;
}

/// What only one model knows of a trial lies in columns of its own.
TEST_F(Verify, AModelsOwnColumnsAreComparedToo) {
    make(campaign_on_points(1));
    if (!has_python(folder, "h5py")) {
        GTEST_SKIP() << "no h5py to write with (install python3-h5py)";
    }
    edit("f['trials/contact/peak_crush'][2] = 7");
    auto const ended = overturn(folder, {"verify", "c.h5", "--unverified"});

    EXPECT_EQ(ended.code, 1);
    EXPECT_NE(ended.out.find("1 trials, 0 waves differ; first trial 2 "), std::string::npos) << ended.out;
    EXPECT_NE(ended.out.find("peak_crush"), std::string::npos) << ended.out;
}

TEST_F(Verify, ASampleFindsWhatItMeets) {
    make(small_campaign("shared", 2));
    if (!has_python(folder, "h5py")) {
        GTEST_SKIP() << "no h5py to write with (install python3-h5py)";
    }
    edit("f['trials/peak_rotation'][...] = 1");
    auto const ended = overturn(folder, {"verify", "c.h5", "--sample", "3", "--unverified"});

    EXPECT_EQ(ended.code, 1);
    EXPECT_NE(ended.out.find("3 trials, 0 waves differ"), std::string::npos) << ended.out << ended.err;
    EXPECT_NE(overturn(folder, {"verify", "c.h5", "--sample", "3", "--seed", "2", "--unverified"}).out, ended.out)
        << "another seed meets other rows";
}

}  // namespace
}  // namespace overturn::testing
