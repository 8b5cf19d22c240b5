// Requirement R-1106: a pipe that nobody writes to, a device, a socket, a folder and a file of a terabyte in the place
// of any input are one line that says what to do, at once.
#include <cstring>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

#include "cli/campaign_files.hpp"
#include "cli/python.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

std::string const body_toml = "mass='12.6 t'\nbase_width='0.9 m'\ncentre_height='1.045 m'\ninertia='uniform-block'\n";

struct Thing {
    std::string name;
    std::string told;  ///< what the error calls it
};

/// One of each kind of thing that is no file that could be read.
class NoFile : public ::testing::Test {
  protected:
    NoFile() {
        folder.write("target.csv", target_csv);
        folder.write("c.toml", small_campaign("shared", 1));
        folder.write("body.toml", body_toml);
        folder.write("wave.csv", "# time_s,a_mps2\n0,0\n0.01,1\n0.02,0\n");
        EXPECT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
        std::filesystem::create_directory(folder / "folder");
        folder.write("huge", "x");
        std::filesystem::resize_file(folder / "huge", std::uintmax_t{1} << 40);  // sparse: takes no room
        listen();
    }
    ~NoFile() override { ::close(socket_); }

    /// Each of the commands with each thing in the place of THING.
    void refuse(std::vector<std::vector<std::string>> const& commands, std::vector<Thing> const& things) const {
        for (auto const& command : commands) {
            for (auto const& [name, told] : things) {
                auto stated = command;
                for (auto& word : stated) {
                    if (auto const at = word.find("THING"); at != std::string::npos) {
                        word.replace(at, 5, name);
                    }
                }
                auto const ended = execute(folder, joined({"timeout", "60", OVERTURN_PROGRAM}, stated));
                auto const said = command.front() + " " + name + ": ";
                EXPECT_EQ(ended.code, 2) << said << ended.err;
                EXPECT_TRUE(is_one_error_line(ended.err)) << said;
                EXPECT_NE(ended.err.find(told), std::string::npos) << said << ended.err;
            }
        }
    }

    Folder folder;

  private:
    void listen() {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::strncpy(address.sun_path, (folder / "socket").c_str(), sizeof address.sun_path - 1);
        socket_ = ::socket(AF_UNIX, SOCK_STREAM, 0);
        EXPECT_EQ(::bind(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    }
    int socket_ = -1;
};

std::vector<Thing> const no_files{
    {"/dev/zero", "(a device, no file). Write what it gives to a file, and name that"},
    {"/dev/null", "(a device, no file). Write"},
    {"pipe", "(a pipe, no file). Write"},
    {"socket", "(a socket, no file). Write"},
    {"folder", "(a folder). Name one file in it"},
    {"huge", "(larger than 1073741824 bytes). Check that it is the right file"},
};

TEST_F(NoFile, AsACampaign) {
    refuse({{"plan", "THING"},
            {"run", "THING"},
            {"cost", "THING"},
            {"spectra", "THING"},
            {"wave", "THING", "--wave", "0"}},
           no_files);
}

TEST_F(NoFile, AsABodyOrARecord) {
    refuse({{"rock", "--body", "THING", "--wave", "wave.csv"},
            {"spectrum", "--overturning", "--body", "THING", "--pulse", "one-sine"},
            {"rock", "--body", "body.toml", "--wave", "THING"},
            {"spectrum", "--wave", "THING"}},
           no_files);
}

TEST_F(NoFile, NamedByACampaign) {
    refuse({{"plan", "c.toml", "--set", "waves.target.file='THING'"},
            {"run", "c.toml", "--set", "waves.target.file='THING'"},
            {"plan", "c.toml", "--set", "bodies=[{file='THING'}]"},
            {"plan", "c.toml", "--set", "waves={source='records',files=['THING']}"}},
           no_files);
}

TEST_F(NoFile, AsATableOfFit) {
    refuse({{"fit", "--stripes", "THING"},
            {"fit", "--capacities", "THING"},
            {"fit", "--median", "0.9 g", "--beta", "0.4", "--hazard", "THING"}},
           no_files);
}

TEST_F(NoFile, AsAnAnswerOfNew) {
    std::vector<std::string> const stated{"new",          "n.toml", "--mass",         "1 t",  "--centre-height", "1 m",
                                          "--base-width", "1 m",    "--design-basis", "0.3 g"};
    auto without_folder = no_files;  // a folder of records is an answer
    std::erase_if(without_folder, [](Thing const& thing) { return thing.name == "folder"; });

    refuse({joined(stated, {"--spectrum", "THING", "--spectrum-kind", "acceleration"}),
            joined(stated, {"--spectrum", "mlit-ch1", "--hazard", "THING"})},
           no_files);
    refuse({joined(stated, {"--records", "THING"})}, without_folder);
    EXPECT_FALSE(folder.has("n.toml"));
}

TEST_F(NoFile, AsResults) {
    ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
    std::vector<Thing> const things{{"/dev/zero", "nor any file: a device)"},
                                    {"/dev/null", "nor any file: a device)"},
                                    {"pipe", "nor any file: a pipe)"},
                                    {"socket", "nor any file: a socket)"},
                                    {"folder", "nor any file: a folder)"}};

    refuse({{"fit", "THING"},
            {"report", "THING", "-o", "page.html"},
            {"export", "THING"},
            {"status", "THING"},
            {"verify", "THING"},
            {"merge", "THING"},
            {"replay", "THING", "--trial", "0"},
            {"list", "columns", "THING"}},
           things);
    refuse({{"fit", "c.h5", "--hazard", "THING"},
            {"report", "c.h5", "-o", "page.html", "--hazard", "THING"},
            {"report", "c.h5", "-o", "page.html", "--outcomes", "THING"}},
           no_files);
    EXPECT_FALSE(folder.has("page.html"));
}

TEST_F(NoFile, AmongPartsOfARun) {
    folder.write("c.toml", small_campaign("shared", 16));
    for (auto const& [name, said] : {std::pair<std::string, std::string>{"campaign.record", "damaged record"},
                                     {"0000000000.block", "0000000000.block (a pipe, no file)"}}) {
        ASSERT_EQ(overturn(folder, {"run", "c.toml", "--part", "1/2"}).code, 0);
        auto const part = folder / ("c.h5.parts/" + name);
        ASSERT_TRUE(std::filesystem::remove(part)) << name;
        ASSERT_EQ(::mkfifo(part.c_str(), 0600), 0);

        auto const resumed = execute(folder, {"timeout", "60", OVERTURN_PROGRAM, "run", "c.toml", "--resume"});
        EXPECT_EQ(resumed.code, 0) << "what cannot be read is made again: " << resumed.err;
        EXPECT_NE(resumed.err.find(said), std::string::npos) << resumed.err;
        EXPECT_EQ(overturn(folder, {"verify", "c.h5"}).code, 0);
        std::filesystem::remove(folder / "c.h5");
    }
}

// R-1009.
TEST_F(NoFile, AsResultsInPython) {
    if (!has_python(folder, "h5py")) {
        GTEST_SKIP() << "no h5py to read with (install python3-h5py)";
    }
    for (std::string const name : {"/dev/zero", "/dev/null", "pipe", "socket", "folder"}) {
        auto const opened = open_in_python(folder, name);
        EXPECT_EQ(opened.code, 2) << name << opened.err;
        EXPECT_NE(opened.out.find(name + ": no results file (nor any file: "), std::string::npos) << opened.out;
    }
}

}  // namespace
}  // namespace overturn::testing
