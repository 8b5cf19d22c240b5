// Requirement R-1101: SIGKILL at any instant, of one rank, of all or of mpirun, and a resume on 1 to 3 ranks give the
// bytes of an unbroken run. A short version by default; the long one, with its figures: OVERTURN_KILLS=200 ctest
// --preset dev -R Kill -V
#include <array>
#include <cstdlib>
#include <random>

#include "cli/campaign_files.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

using Clock = std::chrono::steady_clock;

enum class Victim { one_rank, all, mpirun };
constexpr char const* victim_names[] = {"one rank", "all at once", "mpirun"};

/// When a kill came, by what lay on the disk right after it.
enum class Instant { before_the_first_block, among_blocks, while_merging, after_the_end };
constexpr char const* instant_names[] = {"before the first block", "among blocks", "while merging", "after the end"};

struct Figures {
    int rounds = 0, kills = 0, refused = 0;
    int victims[3] = {}, instants[4] = {};
};

std::string files_of(std::filesystem::path const& path) {
    std::string names;
    std::error_code error;
    for (auto const& file : std::filesystem::directory_iterator(path, error)) {
        names += file.path().filename().string() + "\n";
    }
    return names;
}

constexpr std::array places{"TMPDIR", "OMPI_MCA_btl_vader_backing_directory", "OMPI_MCA_osc_sm_backing_directory"};

class Kills : public ::testing::Test {
  protected:
    Kills() {
        folder.write("target.csv", target_csv);
        folder.write("c.toml", small_campaign("independent", 40));
    }

    ~Kills() override {
        for (auto const* name : places) {
            ::unsetenv(name);  // the folder goes, and other tests of this process look for it
        }
    }

    int draw(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }
    /// mpirun may speak for itself here, and gets a place of its own: what a killed one leaves behind can keep the next
    /// from starting, and goes with the folder.
    std::vector<std::string> command() {
        auto const place = folder / ("mpirun-" + std::to_string(++started_));
        std::filesystem::create_directory(place);
        for (auto const* name : places) {
            ::setenv(name, place.c_str(), 1);
        }
        auto line = mpirun(draw(1, 3), {"run", "c.toml", "--resume"});
        std::erase(line, "--quiet");
        return line;
    }

    /// One run, killed at some instant of its life. Not a kill if it ended before.
    void run_and_kill(double life_s) {
        auto const victim = static_cast<Victim>(draw(0, 2));
        Running running(folder, command());
        std::this_thread::sleep_for(std::chrono::duration<double>(life_s * draw(0, 1000) / 1000));
        auto const ranks = children_of(running.pid());
        bool hit = false;
        if (victim != Victim::one_rank) {
            hit = ::kill(running.pid(), 0) == 0 && !ranks.empty();
            running.signal(SIGKILL);
        }
        if (victim != Victim::mpirun && !ranks.empty()) {
            auto const first =
                victim == Victim::all ? 0 : static_cast<std::size_t>(draw(0, static_cast<int>(ranks.size()) - 1));
            auto const last = victim == Victim::all ? ranks.size() : first + 1;
            for (auto i = first; i < last; ++i) {
                hit = ::kill(ranks[i], SIGKILL) == 0 || hit;
            }
        }
        auto const instant = folder.has("c.h5")                ? Instant::after_the_end
                             : folder.has("c.h5.merging")      ? Instant::while_merging
                             : blocks_done(folder, "c.h5") > 0 ? Instant::among_blocks
                                                               : Instant::before_the_first_block;
        (void)running.wait();
        if (hit) {
            ++figures.kills;
            ++figures.victims[static_cast<int>(victim)];
            ++figures.instants[static_cast<int>(instant)];
        }
    }

    /// Ranks outlive a killed mpirun for up to three seconds and still hold their lock, which is reported.
    void resume_to_the_end(std::string const& unbroken) {
        Ended ended;
        ASSERT_TRUE(comes_true([&] {
            ended = execute(folder, command());
            bool const refused = ended.err.find("another run is writing there now") != std::string::npos;
            figures.refused += refused ? 1 : 0;
            return !refused;
        }));
        ASSERT_EQ(ended.code, 0) << ended.err << ended.out;
        ASSERT_TRUE(folder.read("c.h5") == unbroken);
        ASSERT_FALSE(folder.has("c.h5.parts")) << files_of(folder / "c.h5.parts") << ended.err << ended.out;
        ASSERT_FALSE(folder.has("c.h5.merging"));
        std::filesystem::remove(folder / "c.h5");
    }

    Folder folder;
    Figures figures;

  private:
    std::mt19937 random_{2013};
    int started_ = 0;
};

TEST_F(Kills, ChangeNoByte) {
    auto const* const wished = std::getenv("OVERTURN_KILLS");
    int const kills = wished == nullptr ? 6 : std::atoi(wished);
    auto begin = Clock::now();
    ASSERT_EQ(execute(folder, mpirun(2, {"run", "c.toml"})).code, 0);
    double const life_s = std::chrono::duration<double>(Clock::now() - begin).count();
    auto const unbroken = folder.read("c.h5");
    std::filesystem::remove(folder / "c.h5");

    while (figures.kills < kills && !HasFatalFailure()) {
        ++figures.rounds;
        for (int again = draw(1, 3); again > 0 && figures.kills < kills; --again) {
            run_and_kill(life_s);
        }
        resume_to_the_end(unbroken);
    }

    RecordProperty("kills", figures.kills);
    RecordProperty("rounds", figures.rounds);
    RecordProperty("refused_while_ranks_still_wrote", figures.refused);
    for (int i = 0; i < 3; ++i) {
        RecordProperty(std::string("victim ") + victim_names[i], figures.victims[i]);
    }
    for (int i = 0; i < 4; ++i) {
        RecordProperty(std::string("instant ") + instant_names[i], figures.instants[i]);
    }
}

}  // namespace
}  // namespace overturn::testing
