// Requirement R-1405: real outcomes are held against a campaign on the report's page: false safe first, chosen by
// motions left out, each test that fell though it was called safe by name.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/campaign_files.hpp"
#include "cli/python.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

/// Strong noise as it is and twice as strong, two bodies of which the first falls under about half of the waves.
std::string noisy_campaign(std::string const& levels = "measure='factor'\nvalues=[1, 2]\n") {
    return "title='noisy'\nseed=3\n"
           "[waves]\nsource='filtered-noise'\nmodel='kanai-tajimi'\nrms='1 m/s2'\ncount=40\nduration='8 s'\n"
           "time_step='0.02 s'\n[waves.envelope]\nshape='constant'\n"
           "[[bodies]]\nname='block-1'\nmass='1 t'\nbase_width='0.3 m'\ncentre_height='0.8 "
           "m'\ninertia='uniform-block'\n"
           "[[bodies]]\nname='block-2'\nmass='1 t'\nbase_width='0.5 m'\ncentre_height='0.8 "
           "m'\ninertia='uniform-block'\n"
           "[levels]\n"
           + levels;
}

class Outcomes : public ::testing::Test {
  protected:
    static void SetUpTestSuite() {
        ::unsetenv("OVERTURN_PYTHON");
        folder = new Folder;
        folder->write("c.toml", noisy_campaign());
        ASSERT_EQ(overturn(*folder, {"run", "c.toml", "-o", "c.h5"}).code, 0);
        drawable = has_python(*folder, "matplotlib, h5py");
    }
    static void TearDownTestSuite() {
        delete folder;
        folder = nullptr;
    }
    void SetUp() override {
        if (!drawable) {
            GTEST_SKIP() << "nothing to draw with (install python3-matplotlib python3-h5py)";
        }
    }

    /// Writes outcomes.csv: of block-1 what its trials did, but for the first `flipped` waves that stood, which fell.
    /// \return the first of these
    static int write_outcomes(int flipped) {
        auto const ended = execute(*folder, {OVERTURN_PYTHON, "-c",
                                             fmt::format(R"(
import h5py
with h5py.File('c.h5') as f:
    names = h5py.check_enum_dtype(f['trials/verdict'].dtype)
    fell = f['trials/verdict'][()].reshape(40, 2, 2)[:, 0, 0] == names['overturned']
assert 5 < fell.sum() < 35, fell.sum()
turned = [w for w in range(40) if not fell[w]][:{0}]
with open('outcomes.csv', 'w') as o:
    o.write('wave,motion,block-1\n')
    o.writelines('%d,m%d,%d\n' % (w, w // 4, fell[w] or w in turned) for w in range(40))
print(turned[0] if turned else -1)
)",
                                                         flipped)});
        EXPECT_EQ(ended.code, 0) << ended.err;
        return std::stoi(ended.out);
    }
    static std::string page() {
        auto const ended =
            overturn(*folder, {"report", "c.h5", "-o", "c.html", "--figures", "figures", "--outcomes", "outcomes.csv"});
        EXPECT_EQ(ended.code, 0) << ended.err;
        return folder->read("c.html");
    }

    static inline Folder* folder = nullptr;
    static inline bool drawable = false;
};

TEST_F(Outcomes, FalseSafeTestsAreCountedNamedAndDrawn) {
    int const wave = write_outcomes(3);
    auto const text = page();
    EXPECT_NE(text.find("<section id=\"outcomes\""), std::string::npos);
    // predicted by, false safe, false alarm
    EXPECT_NE(text.find("<td class=short>time history</td><td class=short>3</td><td class=short>0</td>"),
              std::string::npos)
        << text.substr(text.find("<section id=\"outcomes\""), 4000);
    EXPECT_NE(text.find("3 of 3 tests that fell though their trial stood"), std::string::npos);
    EXPECT_NE(text.find(fmt::format("(fell in its test): wave {} at", wave)), std::string::npos);
    auto const told = folder->read("figures/outcomes.csv");
    EXPECT_NE(told.find(fmt::format("\nblock-1,{},,m{},1,0.0,", wave, wave / 4)), std::string::npos) << told;
    auto const wrong = folder->read("figures/false_safe-block-1.csv");
    EXPECT_NE(wrong.find(fmt::format("\n{},,m{},", wave, wave / 4)), std::string::npos) << wrong;
}

// The control of the test above: where nothing is wrong nothing is reported to be.
TEST_F(Outcomes, APerfectPredictionHasNoFalseSafe) {
    write_outcomes(0);
    auto const text = page();
    EXPECT_NE(text.find("<td class=short>time history</td><td class=short>0</td><td class=short>0</td>"),
              std::string::npos);
    EXPECT_NE(text.find("agrees with 1.00 of them"), std::string::npos);
    EXPECT_EQ(text.find("Fell, though predicted to stand"), std::string::npos);
    EXPECT_NE(text.find("No test fell that the time history or a criterion predicted to stand"), std::string::npos);
}

TEST_F(Outcomes, APageWithoutThemHasNoSuchSection) {
    ASSERT_EQ(overturn(*folder, {"report", "c.h5", "-o", "d.html"}).code, 0);
    auto const text = folder->read("d.html");
    EXPECT_EQ(text.find("id=\"outcomes\""), std::string::npos);

    int fell = 0, peaked = 0;  // R-406: after the record
    auto const fit = nlohmann::json::parse(overturn(*folder, {"fit", "c.h5", "--json"}).out);
    for (auto const& stripe : fit.at("stripes")) {
        if (stripe.at("body") == "block-1") {
            fell += stripe.at("fell_after_record").get<int>();
            peaked += stripe.at("peaked_after_record").get<int>();
        }
    }
    ASSERT_GT(fell + peaked, 0);
    EXPECT_NE(
        text.find(fmt::format(
            "block-1: {} trials were still rocking at the end of the record ({} overturned and {} reached their peak",
            fell + peaked, fell, peaked)),
        std::string::npos);
}

// Several bodies stand for a specimen; tests that nobody made, and waves without a row, do not count.
TEST_F(Outcomes, SeveralBodiesVoteAndUntestedWavesAreLeftOut) {
    folder->write("outcomes.csv",
                  "# two motions\nwave; motion; \"block-*\"\n0; a; 1\n1; a; 0\n2; b; 1\n3; b;\n4; b; 0\n");
    auto const text = page();
    EXPECT_NE(text.find("2 falls in 4 tests of 2 motions"), std::string::npos);
    EXPECT_NE(text.find("2 bodies represent it"), std::string::npos);
}

TEST_F(Outcomes, EachWrongTableIsOneLineWithWhatToDo) {
    struct Wrong {
        std::string table, said;
    };
    for (auto const& [table, said] : std::vector<Wrong>{
             {"", "outcomes.csv: empty (no header)"},
             {"wave,block-1\n", "a header alone"},
             {"motion,block-1\nm,1\n", "outcomes.csv:1:1: no column 'wave'"},
             {"wave,motion\n0,m\n", "outcomes.csv:1:6: no column of outcomes"},
             {"wave,blok-1\n0,1\n", "outcomes.csv:1:6: column 'blok-1' (no body is named so). Did you mean 'block-1'?"},
             {"wave,block-1,block-1\n0,1,1\n", "outcomes.csv:1:14: column 'block-1' twice"},
             {"wave,wave,block-1\n0,0,1\n", "outcomes.csv:1:6: column 'wave' twice"},
             {"wave,block-1\n40,1\n",
              "outcomes.csv:2:1: wave '40' (neither a record of the campaign nor a number from 0 to 39)"},
             {"wave,block-1\n1.5,1\n", "outcomes.csv:2:1: wave '1.5'"},
             {"wave,block-1\n1,1\n1,0\n", "outcomes.csv:3:1: wave '1' twice"},
             {"wave,block-1\n1,fell\n", "outcomes.csv:2:3: 'fell' (not an outcome)"},
             {"wave,block-1\n1\n", "outcomes.csv:2:1: 1 columns (the header has 2)"},
             {"wave,motion,block-1\n1,,0\n", "outcomes.csv:2:3: no motion"}}) {
        folder->write("outcomes.csv", table);
        auto const ended = overturn(*folder, {"report", "c.h5", "-o", "w.html", "--outcomes", "outcomes.csv"});
        EXPECT_EQ(ended.code, 2) << table;
        EXPECT_NE(ended.err.find(said), std::string::npos) << table << ended.err;
        EXPECT_TRUE(is_one_error_line(ended.err)) << ended.err;
    }
    EXPECT_EQ(overturn(*folder, {"report", "c.h5", "-o", "w.html", "--outcomes", "nowhere.csv"}).code, 2);
}

// A record goes by the name that the campaign gives it, by its file's alone, or by its number.
TEST_F(Outcomes, RecordsGoByTheirNames) {
    std::filesystem::create_directories(*folder / "far/away");
    for (auto const* letter : {"a", "b", "c"}) {
        auto const wave = std::to_string(*letter - 'a');
        auto const name = fmt::format("far/away/{}.csv", letter);
        ASSERT_EQ(overturn(*folder, {"wave", "c.toml", "--wave", wave, "-o", name}).code, 0);
    }
    auto campaign = noisy_campaign("measure='factor'\nvalues=[1]\n");
    auto const waves = campaign.find("[waves]");
    campaign.replace(waves, campaign.find("[[bodies]]") - waves,
                     "[waves]\nsource='records'\nfolder='far'\nfiles=['away/a.csv','away/b.csv','away/c.csv']\n");
    folder->write("r.toml", campaign);
    auto const ran = overturn(*folder, {"run", "r.toml", "-o", "r.h5"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    folder->write("outcomes.csv", "wave,block-1\naway/a.csv,1\nb.csv,1\n2,1\n");
    auto const ended =
        overturn(*folder, {"report", "r.h5", "-o", "r.html", "--figures", "r", "--outcomes", "outcomes.csv"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    auto const told = folder->read("r/outcomes.csv");
    for (auto const* row : {"\nblock-1,0,away/a.csv,", "\nblock-1,1,away/b.csv,", "\nblock-1,2,away/c.csv,"}) {
        EXPECT_NE(told.find(row), std::string::npos) << told;
    }
}

// Scaled waves are not the ones that were shaken.
TEST_F(Outcomes, NeedALevelWithTheMotionsAsMeasured) {
    folder->write("scaled.toml", noisy_campaign("measure='pga'\nvalues=['3 m/s2']\n"));
    ASSERT_EQ(overturn(*folder, {"run", "scaled.toml", "-o", "scaled.h5"}).code, 0);
    folder->write("outcomes.csv", "wave,block-1\n1,1\n");
    auto const ended = overturn(*folder, {"report", "scaled.h5", "-o", "w.html", "--outcomes", "outcomes.csv"});
    EXPECT_EQ(ended.code, 2);
    EXPECT_NE(ended.err.find("Run it with measure = \"factor\" and 1 among the values"), std::string::npos)
        << ended.err;
}

/// Closed forms of the page's statistics, in the script that carries them.
class OutcomeStatistics : public ::testing::Test {
  protected:
    void holds(std::string const& statements) {
        ::unsetenv("OVERTURN_PYTHON");
        if (!has_python(folder, "numpy")) {
            GTEST_SKIP() << "no numpy (install python3-numpy)";
        }
        auto const ended = execute(folder, {OVERTURN_PYTHON, "-B", "-c",
                                            "import sys\nsys.path.insert(0, '" OVERTURN_PACKAGE
                                            "')\nimport numpy as np\nfrom overturn.report import outcomes as o\n"
                                                + statements});
        EXPECT_EQ(ended.code, 0) << ended.err;
    }
    Folder folder;
};

TEST_F(OutcomeStatistics, IntervalsOfSharesAreExact) {
    holds(R"(
low, high = o.exact(0, 10)  # 1 - p to the tenth is 0.025
assert low == 0 and abs(high - (1 - 0.025 ** 0.1)) < 1e-12, (low, high)
low, high = o.exact(10, 10)
assert high == 1 and abs(low - 0.025 ** 0.1) < 1e-12, (low, high)
low, high = o.exact(5, 10)  # symmetric; Clopper and Pearson's table
assert abs(low + high - 1) < 1e-12 and abs(low - 0.187086) < 1e-6, (low, high)
low, high = o.exact(700, 2000)
assert abs(low - 0.329079) < 1e-6 and abs(high - 0.371362) < 1e-6, (low, high)  # as `overturn fit --stripes` has it
)");
}

TEST_F(OutcomeStatistics, AreasOfKnownOrders) {
    holds(R"(
fell = np.array([False, False, True, True])
area = lambda x: o.Area(np.array(x, float), fell)(np.arange(4))
assert area([1, 2, 3, 4]) == 1 and area([4, 3, 2, 1]) == 0 and area([1, 1, 1, 1]) == 0.5 and area([1, 3, 2, 4]) == 0.75
)");
}

// Each of two bodies is right of one motion alone: judged by the other motion's choice both are always wrong. Leaving
// out tests, or nothing, would call one of them right.
TEST_F(OutcomeStatistics, BodiesAreChosenByTheOtherMotions) {
    holds(R"(
fell = np.array([True, False] * 10)
motions = np.array(['a'] * 10 + ['b'] * 10)
said = np.stack([np.where(motions == 'a', fell, ~fell), np.where(motions == 'b', fell, ~fell)]).T
pgv = np.arange(20.0)
tests = {'fell': said, 'energy': None, 'pga': pgv, 'pgv': pgv, 'limit': np.ones(2), 'measured': {}}
told = o.judge(tests, motions, fell, np.random.default_rng(1))
assert told['by_time_history']['agreement'] == 0, told['by_time_history']
assert told['votes'] == {0: 1, 1: 1}, told['votes']
assert told['brier']['time_history'] == 1 and told['brier']['always_the_share'] == 0.25, told['brier']
)");
}

// Where every test fell the best threshold is none at all; of one motion nobody knows how others would scatter.
TEST_F(OutcomeStatistics, ExtremesGetNoFalseAnswer) {
    holds(R"(
x = np.array([1.0, 2, 3])
assert (x > o.best_threshold(x, np.array([True] * 3))).all()
assert not (x > o.best_threshold(x, np.array([False] * 3))).any()
assert o.interval(np.array(['a', 'a', 'a']), lambda i: 0.5, np.random.default_rng(1)) is None
fell = np.array([True, True, False])
tests = {'fell': fell[:, None], 'energy': None, 'pga': x, 'pgv': x, 'limit': np.ones(1), 'measured': {'v_wes': x[:, None] / 2}}
told = o.judge(tests, np.array(['a'] * 3), fell, np.random.default_rng(1))
assert told['agreement_interval'] is None and told['areas']['pgv'][1] is None
assert list(told['unsafe']['v_wes']) == [False, True, True] and told['criteria']['v_wes']['false_safe'] == 1
)");
}

TEST_F(OutcomeStatistics, FalseSafeIsAFallPredictedToStand) {
    holds(R"(
c = o.counted(np.array([False, False, True, True, True]), np.array([True, False, False, True, True]))
assert (c['false_safe'], c['safe'], c['false_alarm'], c['fell'], c['agreement']) == (1, 1, 1, 2, 0.6), c
)");
}

}  // namespace
}  // namespace overturn::testing
