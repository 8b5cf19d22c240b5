// Requirement R-1107: a campaign takes more waves, levels and bodies, other limits and other statistics: rows that are
// there are kept, the rest is computed, and the file is that of the larger campaign run at once.
#include <charconv>
#include <cmath>
#include <functional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/campaign_files.hpp"
#include "core/units.hpp"
#include "store/results_file.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

constexpr char const* three_levels = "'300 gal','600 gal','1200 gal'";
constexpr char const* five_levels = "'150 gal','300 gal','600 gal','900 gal','1200 gal'";
constexpr char const* third_body =
    "[[bodies]]\nname='type-c'\nmass='12.6 t'\nbase_width='1.1 m'\ncentre_height='1.045 m'\n"
    "inertia='uniform-block'\nfriction={distribution='lognormal',median=0.5,beta=0.1}\n";

std::string with(std::string text, std::string const& from, std::string const& to) {
    return text.replace(text.find(from), from.size(), to);
}

std::string with_levels(std::string const& text) { return with(text, three_levels, five_levels); }
std::string with_body_last(std::string const& text) {
    return with(text, "[levels]", third_body + std::string("[levels]"));
}
std::string with_body_first(std::string const& text) {
    return with(text, "[[bodies]]", third_body + std::string("[[bodies]]"));
}

/// Trials that a run answered: "cost: at-rest 12 trials, 1.5 us each; rocking 6 trials, ..."
int trials_answered(std::string const& told) {
    int sum = 0;
    for (auto at = told.find("cost: "); (at = told.find(" trials, ", at)) != std::string::npos; ++at) {
        int trials = 0;
        auto const begin = told.rfind(' ', at - 1) + 1;
        std::from_chars(told.data() + begin, told.data() + at, trials);
        sum += trials;
    }
    return sum;
}

class Extend : public ::testing::Test {
  protected:
    Extend() { folder.write("target.csv", target_csv); }

    void write(std::string const& text) { folder.write("c.toml", text); }
    [[nodiscard]] Ended extend(int ranks) { return execute(folder, mpirun(ranks, {"run", "c.toml", "--extend"})); }
    void expect_as_at_once() {
        ASSERT_EQ(execute(folder, mpirun(2, {"run", "c.toml", "-o", "once.h5"})).code, 0);
        EXPECT_TRUE(folder.read("c.h5") == folder.read("once.h5"));
        EXPECT_FALSE(folder.has("c.h5.parts"));
        std::filesystem::remove(folder / "once.h5");
    }
    Folder folder;
};

// R-1107: on one, two and three ranks, with waves that levels share and with waves of their own, and a second time.
TEST_F(Extend, WavesAreAddedToTheSameBytes) {
    int ranks = 1;
    for (char const* waves : {"shared", "independent"}) {
        write(small_campaign(waves, 6));
        ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
        for (int const count : {9, 14}) {
            write(small_campaign(waves, count));
            auto const ended = extend(ranks);
            ASSERT_EQ(ended.code, 0) << ended.err;
            EXPECT_EQ(ended.err.find(": 0 of"), std::string::npos) << ended.err;
            EXPECT_NE(ended.err.find("extending c.h5: "), std::string::npos) << ended.err;
            expect_as_at_once();
            ranks = ranks % 3 + 1;
        }
        std::filesystem::remove(folder / "c.h5");
    }
}

// R-1303: a column's 64 KiB are not read anew for each block of few trials, which made this 130 times the file.
TEST_F(Extend, ReadsWhatItKeepsAFewTimes) {
    auto const grown = [](int waves) {
        auto text = small_campaign("shared", waves);
        text = with(text, "duration='20.48 s'\ntime_step='0.02 s'\nmatch='each'\nmatch_iterations=3",
                    "duration='2.56 s'\ntime_step='0.02 s'\nmatch='none'");
        text = with(text, "rise='2 s'\nlevel_end='10 s'\nend='18 s'", "rise='0.5 s'\nlevel_end='1.5 s'\nend='2.4 s'");
        return with(text, "longest=6", "longest=2");
    };
    write(grown(2600));
    ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
    double const file = std::filesystem::file_size(folder / "c.h5");
    write(grown(2610));
    auto const ended = execute(
        folder, {"/bin/sh", "-c", "\"$0\" run c.toml --extend >told && grep rchar /proc/$$/io", OVERTURN_PROGRAM});
    ASSERT_EQ(ended.code, 0) << ended.err;
    constexpr std::string_view label = "rchar: ";
    double const bytes = std::stod(ended.out.substr(ended.out.find(label) + label.size()));
    EXPECT_GT(bytes, 2 * file);  // it was counted: the file is hashed on opening, and again when it is made
    EXPECT_LT(bytes, 25 * file);
    expect_as_at_once();
}

// R-1107: levels and bodies, and both beside waves, wherever they stand in their lists: of what is there no trial is
// answered again, but for a body that scatters and is drawn by another place.
TEST_F(Extend, LevelsAndBodiesAreAddedToTheSameBytes) {
    struct Growth {
        char const* what;
        std::function<std::string(std::string const&)> grown;
        int waves, answered;
    };
    std::vector<Growth> const growths{
        {"levels", with_levels, 6, 6 * 2 * 2},
        {"a body behind the others", with_body_last, 6, 6 * 3},
        {"a body before them", with_body_first, 6, 6 * 3 * 2},
        {"all", [](auto const& text) { return with_levels(with_body_last(text)); }, 9, 9 * 15 - 6 * 6},
    };
    int ranks = 1;
    for (char const* waves : {"shared", "independent"}) {
        for (auto const& growth : growths) {
            SCOPED_TRACE(std::string(waves) + " waves, " + growth.what);
            write(small_campaign(waves, 6));
            ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
            write(growth.grown(small_campaign(waves, growth.waves)));
            auto const ended = extend(ranks);
            ASSERT_EQ(ended.code, 0) << ended.err;
            EXPECT_EQ(trials_answered(ended.err), growth.answered) << ended.err;
            auto const of_all = fmt::format("{} of ", growth.answered);
            EXPECT_NE(ended.err.find(" waves are kept, " + of_all), std::string::npos) << ended.err;
            expect_as_at_once();
            std::filesystem::remove(folder / "c.h5");
            ranks = ranks % 3 + 1;
        }
    }
}

// R-1107: what is left out of a campaign is left out of its file, and nothing is computed.
TEST_F(Extend, LevelsAndBodiesAreTakenAway) {
    for (char const* waves : {"shared", "independent"}) {
        write(with_levels(with_body_last(small_campaign(waves, 6))));
        ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
        write(small_campaign(waves, 4));
        auto const bytes = folder.read("c.h5");
        auto const refused = extend(2);
        EXPECT_EQ(refused.code, 2);
        EXPECT_NE(refused.err.find("finished rows would be lost (waves.count is 4, 6 waves are there; level "),
                  std::string::npos)
            << refused.err;
        EXPECT_NE(refused.err.find("; body type-c). Undo that, or run with --shrink"), std::string::npos)
            << refused.err;
        EXPECT_TRUE(folder.read("c.h5") == bytes);
        auto const ended = execute(folder, mpirun(2, {"run", "c.toml", "--extend", "--shrink"}));
        ASSERT_EQ(ended.code, 0) << ended.err;
        EXPECT_EQ(trials_answered(ended.err), 0) << ended.err;
        expect_as_at_once();
        std::filesystem::remove(folder / "c.h5");
    }
}

// R-1107: a count that was forgotten, or a level that was replaced, deletes nothing.
TEST_F(Extend, WhatWasForgottenIsNotLost) {
    write(small_campaign("shared", 6));
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "--set", "waves.count=20"}).code, 0);
    auto const bytes = folder.read("c.h5");
    for (auto const& settings : {std::vector<std::string>{"--set", "title=other"},
                                 {"--set", "waves.count=30", "--set", "bodies.0.name=renamed"},
                                 {"--set", "waves.count=20", "--set", "levels.values=['300 gal','600 gal']"}}) {
        std::vector<std::string> command{"run", "c.toml", "--extend"};
        command.insert(command.end(), settings.begin(), settings.end());
        auto const refused = overturn(folder, command);
        EXPECT_EQ(refused.code, 2) << refused.err;
        EXPECT_NE(refused.err.find("finished rows would be lost ("), std::string::npos) << refused.err;
        EXPECT_TRUE(folder.read("c.h5") == bytes);
    }
    EXPECT_EQ(overturn(folder, {"run", "c.toml", "--shrink"}).code, 2);
}

// R-1107: a body that a file describes comes with its file.
TEST_F(Extend, ABodyFromAFile) {
    write(small_campaign("shared", 4));
    ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
    folder.write("c-body.toml", with(third_body, "[[bodies]]\nname='type-c'\n", ""));
    write(with(small_campaign("shared", 4), "[levels]", "[[bodies]]\nname='type-c'\nfile='c-body.toml'\n[levels]"));
    auto const ended = extend(1);
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(trials_answered(ended.err), 4 * 3) << ended.err;
    expect_as_at_once();
}

// R-1107, R-1103: of a body's file the values count, not its name, comments or units; a change is named by key and
// value.
TEST_F(Extend, OfABodysFileTheValuesCount) {
    std::string const body = with(third_body, "[[bodies]]\nname='type-c'\n", "");
    auto const named = [&](std::string const& file) {
        return with(small_campaign("shared", 4), "[levels]",
                    "[[bodies]]\nname='type-c'\nfile='" + file + "'\n[levels]");
    };
    folder.write("c-body.toml", body);
    write(named("c-body.toml"));
    ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
    folder.write("other.toml", "# other\n" + with(with(body, "1.1 m", "110 cm"), "12.6 t", "12600 kg"));
    write(named("other.toml"));
    auto const same = extend(1);
    ASSERT_EQ(same.code, 0) << same.err;
    EXPECT_EQ(trials_answered(same.err), 0) << same.err;
    expect_as_at_once();
    folder.write("other.toml", with(body, "1.1 m", "1.2 m"));
    auto const changed = extend(1);
    EXPECT_EQ(changed.code, 2);
    EXPECT_NE(changed.err.find("(base_width in other.toml (bodies[2], type-c) was '110 cm', is '1.2 m')"),
              std::string::npos)
        << changed.err;
    auto const resumed = overturn(folder, {"run", "c.toml", "--resume"});
    EXPECT_EQ(resumed.code, 2);
    EXPECT_NE(resumed.err.find("was '110 cm', is '1.2 m'"), std::string::npos) << resumed.err;
}

// R-1107: a body that states no name is known by that of its file, wherever it stands.
TEST_F(Extend, ABodyWithoutANameStandsAnywhere) {
    auto const begin = third_body;
    folder.write("one.toml", with(begin, "[[bodies]]\nname='type-c'\n", "name='one'\n"));
    folder.write("two.toml", with(with(begin, "[[bodies]]\nname='type-c'\n", "name='two'\n"), "1.1 m", "1.2 m"));
    auto const of = [](std::string const& bodies) {
        auto text = small_campaign("shared", 4);
        auto const first = text.find("[[bodies]]");
        return text.replace(first, text.find("[levels]") - first, bodies);
    };
    for (auto const* bodies : {"[[bodies]]\nfile='two.toml'\n[[bodies]]\nfile='one.toml'\n",
                               "[[bodies]]\nfile='one.toml'\n[[bodies]]\nfile='two.toml'\n"}) {
        write(of("[[bodies]]\nfile='one.toml'\n"));
        ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
        write(of(bodies));
        auto const ended = extend(2);
        ASSERT_EQ(ended.code, 0) << ended.err;
        expect_as_at_once();
        std::filesystem::remove(folder / "c.h5");
    }
}

std::string wiggle(double amplitude_mps2, double radps) {
    std::string text = "time_s,a_mps2\n";
    for (int i = 0; i <= 800; ++i) {
        double const t = 0.01 * i;
        text += fmt::format("{:.2f},{:.6f}\n", t, amplitude_mps2 * std::sin(radps * t) * std::sin(pi * t / 8));
    }
    return text;
}

std::string campaign_of_records(std::string const& records, bool scatter) {
    auto const body = [](char const* name, char const* more) {
        return fmt::format(
            "[[bodies]]\nname='{}'\nmass='12.6 t'\nbase_width='0.9 m'\ncentre_height='1.045 m'\n"
            "inertia='uniform-block'\n{}\n",
            name, more);
    };
    return "seed=1\n[waves]\nsource='records'\n" + records + body("a", "friction=0.6")
           + body("b", scatter ? "restitution={distribution='lognormal',median=0.85,beta=0.1}" : "restitution=0.85")
           + "[levels]\nmeasure='pga'\nvalues=['300 gal','600 gal']\n";
}

// R-1107: records are known by what is stated of them: added at the end, before or between the others, as files or as
// tables, no trial is answered again but those of a body that scatters and whose wave has another number.
TEST_F(Extend, RecordsAreAddedAnywhere) {
    for (int i = 1; i <= 4; ++i) {
        folder.write(fmt::format("{}.csv", i), wiggle(3 + 0.3 * i, 4 + 0.7 * i));
    }
    auto const list = [](std::vector<int> const& numbers, bool tables) {
        std::string text;
        for (auto const i : numbers) {
            text += fmt::format(fmt::runtime(tables ? "{{horizontal='{}.csv',scale=1.5}}," : "'{}.csv',"), i);
        }
        return fmt::format("{}=[{}]\n", tables ? "records" : "files", text);
    };
    struct Added {
        std::vector<int> records;
        int moved;  ///< of the first two
    };
    int ranks = 1;
    for (bool const tables : {false, true}) {
        for (bool const scatter : {false, true}) {
            for (auto const& [records, moved] :
                 {Added{{1, 2, 3, 4}, 0}, Added{{3, 1, 2}, 2}, Added{{1, 3, 2}, 1}, Added{{2, 1}, 2}}) {
                SCOPED_TRACE(fmt::format("{} {} {}", tables, scatter, records.size()));
                write(campaign_of_records(list({1, 2}, tables), scatter));
                auto const begun = overturn(folder, {"run", "c.toml"});
                ASSERT_EQ(begun.code, 0) << begun.err;
                write(campaign_of_records(list(records, tables), scatter));
                auto const ended = extend(ranks);
                ASSERT_EQ(ended.code, 0) << ended.err;
                int const fresh = static_cast<int>(records.size()) - 2;
                EXPECT_EQ(trials_answered(ended.err), 4 * fresh + (scatter ? 2 * moved : 0)) << ended.err;
                expect_as_at_once();
                std::filesystem::remove(folder / "c.h5");
                ranks = ranks % 3 + 1;
            }
        }
    }
    auto const refuse = [&](std::string const& records, std::string const& said) {
        write(campaign_of_records(records, true));
        auto const refused = extend(1);
        EXPECT_EQ(refused.code, 2);
        EXPECT_NE(refused.err.find(said), std::string::npos) << refused.err;
    };
    write(campaign_of_records(list({1, 2}, true), true));
    ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
    refuse(list({2}, true), "finished rows would be lost (record 1.csv)");
    refuse(with(list({3, 1, 2}, true), "'2.csv',scale=1.5", "'2.csv',scale=1.6"),
           "of record 2.csv, waves.records[2].scale was 1.5, is 1.6");
    folder.write("1.csv", wiggle(5, 5));
    refuse(list({3, 1, 2}, true), "file 1.csv changed");
}

// R-1107: of a run that was not finished the blocks that fit are kept, whatever campaign comes next, and back again.
TEST_F(Extend, UnfinishedRuns) {
    auto const begun = small_campaign("independent", 100);
    std::vector<std::string> const others{small_campaign("independent", 140), small_campaign("independent", 60),
                                          with_levels(with_body_last(small_campaign("independent", 100)))};
    int ranks = 1;
    for (auto const& other : others) {
        write(begun);
        ASSERT_EQ(overturn(folder, {"run", "c.toml", "--max-walltime", "0.3 s"}).code, 3);
        auto const blocks = blocks_done(folder, "c.h5");
        write(other);
        ASSERT_EQ(overturn(folder, {"run", "c.toml", "--resume", "--shrink", "--max-walltime", "0.05 s"}).code, 3);
        write(begun);
        auto const back = overturn(folder, {"run", "c.toml", "--resume", "--shrink", "--max-walltime", "0.05 s"});
        ASSERT_EQ(back.code, 3);
        EXPECT_GE(blocks_done(folder, "c.h5"), blocks) << back.err;
        write(other);
        auto const ended = execute(folder, mpirun(ranks, {"run", "c.toml", "--resume", "--shrink"}));
        ASSERT_EQ(ended.code, 0) << ended.err;
        EXPECT_EQ(ended.err.find(": 0 of 140"), std::string::npos) << ended.err;
        expect_as_at_once();
        std::filesystem::remove(folder / "c.h5");
        ranks = ranks % 3 + 1;
    }
}

// R-1107: rows of an unfinished run that a campaign does not ask for are given up on request only, at once or, where a
// target is met before them, at the end.
TEST_F(Extend, UnfinishedRunsLoseNothing) {
    auto const begun = with_body_last(small_campaign("shared", 300));
    write(begun);
    Running running(folder, {OVERTURN_PROGRAM, "run", "c.toml"});
    ASSERT_TRUE(comes_true([&] { return blocks_done(folder, "c.h5") > 100; }));
    running.signal(SIGUSR1);
    ASSERT_EQ(running.wait().code, 3);
    auto const blocks = blocks_done(folder, "c.h5");
    auto const refuse = [&](std::string const& text, std::string const& said) {
        write(text);
        auto const refused = overturn(folder, {"run", "c.toml", "--resume"});
        EXPECT_EQ(refused.code, 2) << refused.err;
        EXPECT_NE(refused.err.find("finished rows would be lost (" + said), std::string::npos) << refused.err;
        EXPECT_NE(refused.err.find("or run with --shrink"), std::string::npos) << refused.err;
    };
    refuse(with_body_last(small_campaign("shared", 40)), fmt::format("waves.count is 40, {} waves are there)", blocks));
    refuse(small_campaign("shared", 300), "body type-c)");
    refuse(with(begun, "'1200 gal'", "'1201 gal'"), "level 1200 gal)");
    EXPECT_EQ(blocks_done(folder, "c.h5"), blocks);
    auto const early = begun + "[statistics]\ntarget_half_width=0.4\n";
    refuse(early, fmt::format("the target is met by 32 waves, {} waves are there)", blocks));
    EXPECT_FALSE(folder.has("c.h5"));
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "--resume", "--shrink", "--leave-blocks"}).code, 0);
    EXPECT_EQ(overturn(folder, {"merge", "c.h5"}).code, 2);
    EXPECT_FALSE(folder.has("c.h5"));
    write(begun);
    auto const back = overturn(folder, {"run", "c.toml", "--resume", "--max-walltime", "0.05 s"});
    EXPECT_EQ(back.code, 3) << back.err;
    EXPECT_GE(blocks_done(folder, "c.h5"), blocks) << back.err;
    write(early);
    auto const ended = overturn(folder, {"run", "c.toml", "--resume", "--shrink"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    expect_as_at_once();
    write(with_body_last(small_campaign("shared", 40)));
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "-o", "more.h5"}).code, 0);
    write(early);
    auto const fewer = overturn(folder, {"run", "c.toml", "-o", "more.h5", "--extend"});
    EXPECT_EQ(fewer.code, 2);
    EXPECT_NE(fewer.err.find("the target is met by 32 waves, 40 waves are there)"), std::string::npos) << fewer.err;
    EXPECT_FALSE(folder.has("more.h5.parts")) << "a refused extension leaves nothing";
    EXPECT_EQ(overturn(folder, {"status", "more.h5"}).code, 0);
}

// R-1107: an extension without a block is none to be lost, nor is it complete.
TEST_F(Extend, StoppedBeforeItsFirstBlock) {
    write(small_campaign("shared", 20));
    ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
    auto const larger = with_body_last(small_campaign("shared", 40));
    write(larger);
    auto const stopped = overturn(folder, {"run", "c.toml", "--extend", "--max-walltime", "0.001 s"});
    EXPECT_EQ(stopped.code, 3) << stopped.err;
    EXPECT_NE(stopped.err.find("no block was done in this run: a limit must be longer"), std::string::npos)
        << stopped.err;
    ASSERT_EQ(blocks_done(folder, "c.h5"), 0);
    auto const status = overturn(folder, {"status", "c.h5"});
    EXPECT_EQ(status.code, 3);
    EXPECT_NE(status.out.find("an extension to 40 waves, 3 bodies"), std::string::npos) << status.out;
    write(with(larger, "median=0.5", "median=0.4"));
    auto const other = extend(2);
    ASSERT_EQ(other.code, 0) << other.err;
    EXPECT_NE(other.err.find("extending c.h5: 120 trials of 20 waves are kept, 240 of 360 are new\n"),
              std::string::npos)
        << other.err;
    expect_as_at_once();
}

// R-1107: rows that are there are copied by all ranks, and a signal is heeded while they are.
TEST_F(Extend, CopiesAreWorkLikeAnyOther) {
    write(small_campaign("shared", 60));
    ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
    write(small_campaign("shared", 61));
    auto const stopped = overturn(folder, {"run", "c.toml", "--extend", "--max-walltime", "0.001 s"});
    EXPECT_EQ(stopped.code, 3) << stopped.err;
    EXPECT_NE(stopped.err.find("extending c.h5: 360 trials of 60 waves are kept, 6 of 366 are new\n"),
              std::string::npos)
        << stopped.err;
    EXPECT_LT(blocks_done(folder, "c.h5"), 60) << "of which none is copied once time is up";
    auto const ended = extend(3);
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(trials_answered(ended.err), 6) << "of the wave that is new";
    expect_as_at_once();
}

// R-1107: a workflow extends from its first run on; at a misspelt place that is said.
TEST_F(Extend, NothingThere) {
    write(small_campaign("shared", 3));
    auto const said = [&] {
        auto const ended = extend(2);
        EXPECT_EQ(ended.code, 0) << ended.err;
        return ended.err.find("c.h5: nothing is there that could be extended: the campaign begins anew\n")
               != std::string::npos;
    };
    EXPECT_TRUE(said());
    expect_as_at_once();
    EXPECT_FALSE(said()) << "complete already";
    write(small_campaign("shared", 4));
    EXPECT_FALSE(said());
    std::filesystem::remove(folder / "c.h5");
    write(small_campaign("shared", 1000));
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "--max-walltime", "0.3 s"}).code, 3);
    EXPECT_FALSE(said()) << "of an unfinished run";
}

// R-1107: a campaign that ends when it is precise enough takes what was computed without an end in sight.
TEST_F(Extend, UnfinishedRunsWithATarget) {
    write(small_campaign("shared", 300));
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "--max-walltime", "0.5 s"}).code, 3);
    write(small_campaign("shared", 1000) + "[statistics]\ntarget_half_width=0.2\n");
    auto const ended = execute(folder, mpirun(3, {"run", "c.toml", "--extend", "--shrink"}));
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.err.find("precise enough after"), std::string::npos) << ended.err;
    EXPECT_NE(ended.err.find(" waves are kept, at most "), std::string::npos) << ended.err;
    expect_as_at_once();
}

// R-1103: an unfinished run names what bars it, and of that alone.
TEST_F(Extend, UnfinishedRunsOfAnotherCampaign) {
    write(small_campaign("shared", 1000));
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "--max-walltime", "0.3 s"}).code, 3);
    auto const blocks = blocks_done(folder, "c.h5");
    write(with(with_levels(small_campaign("shared", 2000)), "friction=0.5", "friction=0.6"));
    auto const ended = overturn(folder, {"run", "c.toml", "--resume"});
    EXPECT_EQ(ended.code, 2);
    EXPECT_TRUE(is_one_error_line(ended.err)) << ended.err;
    EXPECT_NE(ended.err.find("(bodies[0].friction (type-a) was 0.5, is 0.6)"), std::string::npos) << ended.err;
    EXPECT_EQ(blocks_done(folder, "c.h5"), blocks);
}

// R-1107: bodies on points have columns of their own models.
TEST_F(Extend, OfModelsWithColumnsOfTheirOwn) {
    write(campaign_on_points(2));
    ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
    write(campaign_on_points(3));
    auto const ended = extend(2);
    ASSERT_EQ(ended.code, 0) << ended.err;
    expect_as_at_once();
}

// R-1107, R-921: title, cover, confidence, limits and comments compute nothing anew; fewer waves are kept as well.
TEST_F(Extend, WhatMovesNoRowTakesAll) {
    write(small_campaign("shared", 6));
    ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
    auto text = small_campaign("shared", 6);
    text.replace(text.find("small"), 5, "other");
    text = "question='q?'\nprepared='p'\nchecked='c'\napproved='a'\nrevision='1'\n" + text;
    for (auto const& added : {std::string("# a comment\n"), std::string("[statistics]\nconfidence=0.9\n"),
                              std::string("[[limits]]\nname='slips'\nquantity='peak_slip'\nabove='1 mm'\n")}) {
        text += added;
        write(text);
        auto const refused = overturn(folder, {"run", "c.toml", "--resume"});
        EXPECT_EQ(refused.code, 2);
        EXPECT_NE(refused.err.find("Use --extend"), std::string::npos) << refused.err;
        auto const ended = extend(1);
        ASSERT_EQ(ended.code, 0) << ended.err;
        EXPECT_NE(ended.err.find("extending c.h5: 36 trials of 6 waves are kept, 0 of 36 are new\n"), std::string::npos)
            << ended.err;
        expect_as_at_once();
    }
    auto const again = extend(1);
    EXPECT_NE(again.out.find("complete already"), std::string::npos) << again.out;
    text.replace(text.find("count=6"), 7, "count=4");
    write(text);
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "--extend", "--shrink"}).code, 0);
    expect_as_at_once();
}

// R-1107: waves that are held to a rule are drawn on from where the file ends.
TEST_F(Extend, WavesThatMustBeAccepted) {
    auto const ruled = [](int count) {
        auto text = small_campaign("shared", count);
        text.replace(text.find("match_iterations=3"), 18, "acceptance='japan'");
        text.replace(text.find("longest=6"), 9, "longest=10");
        return text;
    };
    write(ruled(3));
    auto const first = overturn(folder, {"run", "c.toml"});
    ASSERT_EQ(first.code, 0) << first.err;
    write(ruled(5));
    auto const ended = extend(2);
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.err.find("18 trials of 3 waves are kept, 12 of 30 are new\n"), std::string::npos) << ended.err;
    expect_as_at_once();
}

// R-1107: killed at any time the finished file is there still, and the next run goes on.
TEST_F(Extend, AKillLosesNothing) {
    write(small_campaign("shared", 20));
    ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
    auto const before = folder.read("c.h5");
    write(small_campaign("shared", 120));
    Running running(folder, {OVERTURN_PROGRAM, "run", "c.toml", "--extend"});
    ASSERT_TRUE(comes_true([&] { return blocks_done(folder, "c.h5") > 30; }));
    running.signal(SIGKILL);
    EXPECT_EQ(running.wait().code, 128 + SIGKILL);
    EXPECT_TRUE(folder.read("c.h5") == before);
    auto const status = overturn(folder, {"status", "c.h5"});
    EXPECT_EQ(status.code, 3);
    EXPECT_TRUE(status.out.starts_with("c.h5: an extension to 120 waves, 2 bodies and 3 levels is not complete, "))
        << status.out;
    EXPECT_NE(status.out.find("-o c.h5 --extend\nthe file until then: complete, 120 trials"), std::string::npos)
        << status.out;
    auto const told = overturn(folder, {"status", "c.h5", "--json"});
    EXPECT_EQ(told.code, 3);
    auto const facts = nlohmann::json::parse(told.out);
    EXPECT_EQ(facts["complete"], true);
    EXPECT_EQ(facts["trials"]["done"], 120);
    auto const& extension = facts["extension"];
    EXPECT_EQ(extension["complete"], false);
    EXPECT_EQ(extension["waves"]["planned"], 120);
    EXPECT_EQ(extension["blocks"]["done"], blocks_done(folder, "c.h5"));
    EXPECT_EQ(extension["blocks"]["done"].get<int>() + extension["blocks"]["left"].get<int>(), 120);
    EXPECT_EQ(extension["waves_left"], extension["blocks"]["left"]) << "a block is a wave here";
    EXPECT_TRUE(extension["waves_left_numbers"].is_string());
    auto const merged = overturn(folder, {"merge", "c.h5"});
    EXPECT_EQ(merged.code, 3);
    EXPECT_NE(merged.err.find("an extension of c.h5 is not complete"), std::string::npos) << merged.err;
    write(small_campaign("shared", 20));
    auto const smaller = overturn(folder, {"run", "c.toml", "--resume"});
    EXPECT_EQ(smaller.code, 0);
    EXPECT_NE(smaller.err.find("Go on with: overturn run c.toml -o c.h5 --extend"), std::string::npos) << smaller.err;
    write(small_campaign("shared", 120));
    auto const early = overturn(folder, {"run", "c.toml", "--extend", "--max-walltime", "0.05 s"});
    EXPECT_EQ(early.code, 3);
    EXPECT_NE(early.err.find("-o c.h5 --extend"), std::string::npos) << early.err;
    auto const ended = extend(3);
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(overturn(folder, {"status", "c.h5"}).code, 0);
    expect_as_at_once();
}

// R-1103: what decides rows is named by key and value; the file stays as it was.
TEST_F(Extend, AnotherCampaignIsNamedByKeyAndValue) {
    write(small_campaign("shared", 4));
    ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
    auto const before = folder.read("c.h5");
    auto const refuse = [&](std::string const& from, std::string const& to, std::string const& said) {
        auto text = small_campaign("shared", 8);
        text.replace(text.find(from), from.size(), to);
        write(text);
        auto const ended = extend(1);
        EXPECT_EQ(ended.code, 2) << ended.err;
        EXPECT_TRUE(is_one_error_line(ended.err)) << ended.err;
        EXPECT_NE(ended.err.find(said), std::string::npos) << ended.err;
        EXPECT_TRUE(folder.read("c.h5") == before);
    };
    refuse("friction=0.5", "friction=0.6", "(bodies[0].friction (type-a) was 0.5, is 0.6)");
    refuse("seed  = 2013", "seed  = 2014", "seed was 2013, is 2014");
    refuse("waves='shared'", "waves='independent'", "levels.waves was 'shared', is 'independent'");
    write(small_campaign("shared", 8));
    folder.write("target.csv", target_csv + "12,0.3\n");
    auto const file = extend(1);
    EXPECT_EQ(file.code, 2);
    EXPECT_NE(file.err.find("file target.csv changed"), std::string::npos) << file.err;
}

// R-1103: of another program's file is named by what the program differs.
TEST_F(Extend, AnotherProgramIsNamedByWhatDiffers) {
    for (char const* golden : {"results-4", "results-5"}) {
        ASSERT_EQ(
            execute(folder, {"/bin/sh", "-c", fmt::format("gzip -dc '{}/{}.h5.gz' > c.h5", OVERTURN_GOLDEN, golden)})
                .code,
            0);
        auto const of_file = store::ResultsReader(folder / "c.h5").text("sources_sha256");
        write(small_campaign("shared", 4));
        auto const ended = extend(1);
        EXPECT_EQ(ended.code, 2);
        EXPECT_TRUE(is_one_error_line(ended.err)) << ended.err;
        EXPECT_NE(
            ended.err.find(fmt::format("sources {}, this is ", of_file.empty() ? "not named" : of_file.substr(0, 12))),
            std::string::npos)
            << ended.err;
        EXPECT_EQ(ended.err.find("GSL"), std::string::npos) << ended.err;
    }
}

// R-1107: bodies drawn in slices of all waves change with their number, the others do not.
TEST_F(Extend, SlicedBodiesAreDrawnAnew) {
    auto const sliced = [](int count) {
        return small_campaign("shared", count) + "[scatter]\nsampling='latin-hypercube'\n";
    };
    write(sliced(4));
    auto const first = overturn(folder, {"run", "c.toml"});
    ASSERT_EQ(first.code, 0) << first.err;
    write(sliced(8));
    auto const ended = extend(1);
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(trials_answered(ended.err), 8 * 6 - 4 * 3) << ended.err;
    expect_as_at_once();
}

// R-1103: a limit on what only points tell has them run in every trial, and is named.
TEST_F(Extend, ALimitThatCallsForEffects) {
    write(small_campaign("shared", 4));
    ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
    write(small_campaign("shared", 4) + "[[limits]]\nname='bounces'\nquantity='peak_rise'\nabove='1 mm'\n");
    auto const ended = extend(1);
    EXPECT_EQ(ended.code, 2);
    EXPECT_NE(ended.err.find(
                  "limits.bounces calls for sliding, contact in every trial, which its rows were computed without"),
              std::string::npos)
        << ended.err;
}

}  // namespace
}  // namespace overturn::testing
