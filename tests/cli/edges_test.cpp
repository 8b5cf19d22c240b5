// Requirement R-1106, R-902: at the edges of what a shell, a disk and a batch system do there is one line that says
// what to do, never a wrong place, a stack or a hang.
#include <algorithm>

#include <sys/stat.h>
#include <unistd.h>

#include "cli/campaign_files.hpp"
#include "cli/python.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

namespace fs = std::filesystem;

class Edges : public ::testing::Test {
  protected:
    Edges() {
        folder.write("target.csv", target_csv);
        folder.write("c.toml", small_campaign("shared", 2));
    }

    [[nodiscard]] Ended shell(std::string const& line) const { return execute(folder, {"/bin/sh", "-c", line}); }
    void make() const { ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0); }
    static void expect_refused(Ended const& ended, std::string const& why) {
        EXPECT_EQ(ended.code, 2) << ended.err;
        EXPECT_TRUE(is_one_error_line(ended.err)) << ended.err;
        EXPECT_NE(ended.err.find(why), std::string::npos) << ended.err;
    }

    Folder folder;
};

/// A script's unset variable is no wish for a file in the current folder.
TEST_F(Edges, AnEmptyOutputIsAnError) {
    expect_refused(overturn(folder, {"run", "c.toml", "-o", ""}), "-o '' (empty");
    expect_refused(overturn(folder, {"cost", "c.toml", "-o", ""}), "-o '' (empty");
    EXPECT_FALSE(folder.has("c.h5"));
}

TEST_F(Edges, LinksAreFollowedToWhatIsNotThereYet) {
    fs::create_directory(folder / "scratch");
    fs::create_symlink("second.h5", folder / "first.h5");
    fs::create_symlink("scratch/real.h5", folder / "second.h5");
    EXPECT_EQ(overturn(folder, {"run", "c.toml", "-o", "first.h5"}).code, 0);

    EXPECT_TRUE(fs::is_symlink(folder / "first.h5"));
    EXPECT_TRUE(fs::is_symlink(folder / "second.h5"));
    EXPECT_TRUE(fs::is_regular_file(folder / "scratch/real.h5"));
    EXPECT_EQ(overturn(folder, {"status", "first.h5"}).code, 0);
}

TEST_F(Edges, CirclesOfLinksAreRefused) {
    fs::create_symlink("b", folder / "a");
    fs::create_symlink("a", folder / "b");
    for (std::string const place : {"a", "a/c.h5"}) {
        expect_refused(overturn(folder, {"run", "c.toml", "-o", place}), place);
        expect_refused(overturn(folder, {"status", place}), "Too many levels of symbolic links");
        expect_refused(overturn(folder, {"fit", place}), "Too many levels of symbolic links");
    }
}

TEST_F(Edges, APipeIsNoResultsFile) {
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    for (std::string const verb : {"status", "fit"}) {
        expect_refused(overturn(folder, {verb, "pipe"}), "pipe: not an HDF5 file");
    }
}

// Parts and files of another user, who does not share them.
TEST_F(Edges, WhatBelongsToOthersIsOneLineAndStays) {
    std::string const other = ::geteuid() == 0
                                  ? "exec setpriv --reuid=65534 --regid=65534 --clear-groups " OVERTURN_PROGRAM " "
                                  : "exec " OVERTURN_PROGRAM " ";
    for (auto const* open_to_all : {"", "theirs.h5.parts", "closed.h5.parts"}) {
        fs::create_directories(folder / open_to_all);
        fs::permissions(folder / open_to_all, fs::perms::all);
    }
    if (shell(other + "list").code != 0) {
        GTEST_SKIP() << "no other user may run the program where it lies";
    }
    folder.write("theirs.h5.parts/lock", "");
    fs::permissions(folder / "theirs.h5.parts/lock", fs::perms::owner_read);
    fs::permissions(folder / "closed.h5.parts", ::geteuid() == 0 ? fs::perms::owner_all : fs::perms::none);
    for (std::string const name : {"theirs", "closed"}) {
        for (auto const* resume : {"", " --resume"}) {
            auto const run = shell(other + "run c.toml -o " + name + ".h5" + resume);
            EXPECT_EQ(run.code, 1) << name << run.err;
            EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
            EXPECT_NE(run.err.find(name + ".h5.parts/lock (Permission denied)"), std::string::npos) << run.err;
        }
    }
    expect_refused(shell(other + "status closed.h5"), "Permission denied");
    fs::permissions(folder / "closed.h5.parts", fs::perms::owner_all);
    EXPECT_TRUE(folder.has("theirs.h5.parts/lock"));
    EXPECT_FALSE(folder.has("theirs.h5"));
}

TEST_F(Edges, PathsNeedNotBeText) {
    if (!has_python(folder, "h5py, matplotlib")) {
        GTEST_SKIP() << "no h5py and matplotlib to draw with";
    }
    std::string const place = "not \xFF text";
    fs::create_directory(folder / place);
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "-o", place + "/c.h5"}).code, 0);
    auto const page =
        overturn(folder, {"report", place + "/c.h5", "-o", place + "/page.html", "--figures", place + "/figures"});
    EXPECT_EQ(page.code, 0) << page.err;
    EXPECT_TRUE(folder.has(place + "/page.html"));
    EXPECT_FALSE(fs::is_empty(folder / (place + "/figures")));
}

TEST_F(Edges, NoMemoryIsOneLine) {
    int told = 0;
    for (int const limit_mb : {120, 150, 170, 180, 190, 200, 205, 210, 220, 240}) {
        auto const ended = shell("ulimit -v " + std::to_string(limit_mb)
                                 + "000 && exec " OVERTURN_PROGRAM " run c.toml -o limited.h5 --resume");
        // HDF5 1.10 frees twice where it gets no memory, as amid the copy of a property list: nobody's line to print.
        bool const in_hdf5 = ended.err.find("libhdf5") < ended.err.find("/overturn(+");
        EXPECT_TRUE(ended.code != 128 + SIGABRT || in_hdf5) << limit_mb << ended.err;
        EXPECT_EQ(ended.err.find("fftw:"), std::string::npos) << limit_mb << ended.err;
        auto const ours = ended.err.find("overturn: ");
        if (ended.code == 1 && ours != std::string::npos && ended.err.find("out of memory") != std::string::npos) {
            ++told;
            EXPECT_NE(ended.err.find("go on with --resume", ours), std::string::npos) << ended.err;
        }
    }
    EXPECT_GT(told, 0) << "else nothing was shown";
}

// R-1102: Sent by a library that is set up before main, as by a batch system that is in a hurry.
TEST_F(Edges, SignalsCountFromTheFirstInstant) {
    for (int const signal : {SIGUSR1, SIGTERM}) {
        auto const early = "OVERTURN_EARLY_SIGNAL=" + std::to_string(signal)
                           + " LD_PRELOAD=" OVERTURN_EARLY_SIGNAL " exec " OVERTURN_PROGRAM " ";
        auto const run = shell(early + "run c.toml");
        EXPECT_EQ(run.code, 3) << run.err;
        EXPECT_NE(run.err.find("0 of 2 blocks"), std::string::npos) << run.err;
        EXPECT_EQ(shell(early + "list").code, 128 + signal) << "who has nothing to save ends at once";
        EXPECT_EQ(overturn(folder, {"run", "c.toml", "--resume"}).code, 0);
        fs::remove(folder / "c.h5");
    }
}

TEST_F(Edges, AKilledReportLeavesNothing) {
    if (!has_python(folder, "h5py, matplotlib")) {
        GTEST_SKIP() << "no h5py and matplotlib to draw with";
    }
    make();
    fs::create_directory(folder / "tmp");
    Running report(folder, {"/usr/bin/env", "TMPDIR=" + (folder / "tmp").string(), OVERTURN_PROGRAM, "report", "c.h5",
                            "-o", "page.html"});
    ASSERT_TRUE(comes_true([&] {
        std::error_code error;
        auto const files = fs::directory_iterator(folder / "tmp", error);
        return std::any_of(begin(files), end(files),
                           [](auto const& each) { return fs::exists(each.path() / "errors"); });
    }));
    std::this_thread::sleep_for(std::chrono::milliseconds(50));  // waits for Python now
    report.signal(SIGTERM);
    auto const ended = report.wait();

    EXPECT_EQ(ended.code, 1) << ended.err;
    EXPECT_NE(ended.err.find("stopped by signal"), std::string::npos) << ended.err;
    EXPECT_TRUE(fs::is_empty(folder / "tmp"));
    EXPECT_FALSE(folder.has("page.html"));
}

/// Nothing can be done against KILL but by the next, which leaves alone what others use.
TEST_F(Edges, TheNextFigureRemovesWhatAKilledOneLeft) {
    if (!has_python(folder, "h5py, matplotlib")) {
        GTEST_SKIP() << "no h5py and matplotlib to draw with";
    }
    make();
    fs::create_directory(folder / "tmp");
    auto const folders = [&] {
        std::error_code error;
        std::vector<fs::path> found;
        for (auto const& each : fs::directory_iterator(folder / "tmp", error)) {
            found.push_back(each.path());
        }
        return found;
    };
    auto const in_there = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"/usr/bin/env", "TMPDIR=" + (folder / "tmp").string(), OVERTURN_PROGRAM});
        return arguments;
    };
    auto const figure = in_there({"wave", "c.toml", "--wave", "0", "--plot", "wave.svg"});
    Running killed(folder, figure);
    ASSERT_TRUE(comes_true([&] { return !folders().empty() && fs::exists(folders().front() / "errors"); }));
    killed.signal(SIGKILL);
    (void)killed.wait();
    ASSERT_EQ(folders().size(), 1U);
    auto const left = folders().front();
    fs::create_directory(folder / "tmp/overturn-figure-fresh");  // as just made, not locked yet
    fs::create_directory(folder / "tmp/others");
    Running alive(folder, in_there({"report", "c.h5", "-o", "page.html"}));
    ASSERT_TRUE(comes_true([&] {
        auto const all = folders();
        return std::ranges::any_of(all, [&](auto const& each) { return each != left && fs::exists(each / "errors"); });
    }));

    EXPECT_EQ(execute(folder, figure).code, 0);

    EXPECT_EQ(alive.wait().code, 0) << "nobody took its folder";
    EXPECT_FALSE(fs::exists(left));
    EXPECT_EQ(folders().size(), 2U);
}

TEST_F(Edges, MessagesQuoteNoKilobytes) {
    std::string const key(10'000, 'k');
    folder.write("long.toml", key + " = 1\n" + small_campaign());
    folder.write("unit.toml", small_campaign() + "[statistics]\nconfidence='0.9 " + key + "'\n");
    for (std::string const campaign : {"long.toml", "unit.toml"}) {
        auto const ended = planned(folder, {campaign});
        expect_refused(ended, campaign + ":");
        EXPECT_LT(ended.err.size(), 1100U);
    }
}

TEST_F(Edges, OfManyLevelsSomeAreShown) {
    auto campaign = small_campaign("shared", 1);
    auto const at = campaign.find("values=[");
    campaign.replace(at, campaign.find("]\n", at) + 1 - at, "values={from='10 gal',to='1000 gal',count=2000}");
    folder.write("c.toml", campaign + "[[limits]]\nname='touches'\nquantity='peak_slip'\nabove='0.1 m'\n");
    auto const lines = [](std::string const& text) { return std::count(text.begin(), text.end(), '\n'); };

    auto const plan = planned(folder, {"c.toml"});
    EXPECT_EQ(plan.code, 0) << plan.err;
    EXPECT_LT(lines(plan.out), 30);
    EXPECT_NE(plan.out.find("levels    pga [gal]: 10, "), std::string::npos) << plan.out;
    EXPECT_NE(plan.out.find(", 600 (design-basis), "), std::string::npos) << plan.out;
    EXPECT_NE(plan.out.find(", 1000 ("), std::string::npos) << plan.out;
    EXPECT_NE(plan.out.find("levels; all are in the file)\n"), std::string::npos) << plan.out;
    auto const run = overturn(folder, {"run", "c.toml", "--full"});
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_LT(lines(run.out), 500) << "stripes, a limit state and percentiles of two bodies, alone and together";
    EXPECT_NE(run.out.find("levels; all are in the file)\n"), std::string::npos);
}

TEST_F(Edges, DamagedInputsAreBadInput) {
    if (!has_python(folder, "h5py")) {
        GTEST_SKIP() << "no h5py to look for them with (install python3-h5py)";
    }
    make();
    auto const script =
        "import h5py\nat = h5py.File('c.h5')['inputs/0000'].id.get_chunk_info(0).byte_offset\n"
        "b = bytearray(open('c.h5', 'rb').read()); b[at + 12] ^= 255; open('c.h5', 'wb').write(b)";
    ASSERT_EQ(execute(folder, {OVERTURN_PYTHON, "-c", script}).code, 0);

    expect_refused(overturn(folder, {"status", "c.h5"}), "/inputs/0000 changed");
    expect_refused(overturn(folder, {"status", "c.h5", "--unverified"}), "inputs/0000 cannot be read");
}

TEST_F(Edges, FilesFollowTheUmask) {
    for (auto const& [mask, expected] : {std::pair{"027", 0640U}, std::pair{"002", 0664U}}) {
        ASSERT_EQ(shell(std::string("umask ") + mask + " && " OVERTURN_PROGRAM " run c.toml --part 1/2").code, 0);
        for (auto const& entry : fs::directory_iterator(folder / "c.h5.parts")) {
            EXPECT_EQ(static_cast<unsigned>(entry.status().permissions()), expected) << entry.path();
        }
        ASSERT_EQ(shell(std::string("umask ") + mask + " && " OVERTURN_PROGRAM " run c.toml --resume").code, 0);
        for (std::string const file : {"c.h5", "c.runtime.json"}) {
            EXPECT_EQ(static_cast<unsigned>(fs::status(folder / file).permissions()), expected) << file;
        }
        fs::remove(folder / "c.h5");
    }
}

// R-1202: Ranks that do not find each other would each run the whole campaign into one file.
TEST_F(Edges, ARankThatIsAloneAmongOthersIsReported) {
    auto const ended = shell("PMI_SIZE=4 PMI_RANK=0 " OVERTURN_PROGRAM " run c.toml");
    expect_refused(ended, "PMI_SIZE states 4 ranks");
    EXPECT_NE(ended.err.find("Start it with the mpirun of Open MPI"), std::string::npos) << ended.err;
    EXPECT_EQ(shell("PMI_SIZE=4 PMI_RANK=3 " OVERTURN_PROGRAM " run c.toml").err, "");
    // Slurm's step of three, of which MPI is not informed.
    auto const step = shell("SLURM_STEP_NUM_TASKS=3 SLURM_PROCID=0 " OVERTURN_PROGRAM " run c.toml");
    expect_refused(step, "SLURM_STEP_NUM_TASKS states 3 ranks");
    EXPECT_NE(step.err.find("Start it with mpirun"), std::string::npos) << step.err;
    EXPECT_EQ(shell("SLURM_STEP_NUM_TASKS=3 SLURM_PROCID=2 " OVERTURN_PROGRAM " run c.toml").err, "");
    EXPECT_FALSE(folder.has("c.h5.parts"));
}

// R-1202: Processes of one user that start and end at once need no folder for all of them, where one's end may take
// what another one makes.
TEST_F(Edges, AProcessAloneNeedsNoFolderForAllOfAUser) {
    folder.write("no-folder", "");
    auto const ended = shell("TMPDIR=no-folder " OVERTURN_PROGRAM " run c.toml");
    EXPECT_EQ(ended.code, 0) << ended.err;
}

}  // namespace
}  // namespace overturn::testing
