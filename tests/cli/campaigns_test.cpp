// Requirement R-907: every campaign file that comes with the program runs, and begins with its question and its cost.
#include <algorithm>
#include <cstdlib>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>
#include <toml++/toml.h>

#include "support/command.hpp"

namespace overturn::testing {
namespace {

// Records are not ours to pass on: the folder is where a developer keeps some; empty if nowhere.
std::string records() {
    auto const* const named = std::getenv("OVERTURN_RECORDS");
    std::filesystem::path const beside(OVERTURN_CAMPAIGNS "/../../shared/records");
    auto const folder = named != nullptr ? std::filesystem::path(named) : beside;
    return std::filesystem::is_directory(folder) ? folder.string() : std::string();
}

// what `plan` shows of a study fits a terminal's screen.
void expect_one_screen(std::string const& text) {
    constexpr std::size_t width = 100;
    constexpr std::ptrdiff_t height = 45;
    EXPECT_LE(std::count(text.begin(), text.end(), '\n'), height) << text;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(line.size(), width) << line;
    }
}

TEST(Campaigns, AreAcceptedAsTheyStand) {
    Folder const folder;
    int count = 0;
    for (auto const& file : std::filesystem::directory_iterator(OVERTURN_CAMPAIGNS)) {
        if (file.path().extension() != ".toml") {
            continue;
        }
        auto const text = read_text(file.path());
        EXPECT_TRUE(text.starts_with("#:schema schema.json\n# Question: ")) << file.path();
        EXPECT_NE(text.find("\n# Cost: "), std::string::npos) << file.path();
        if (std::regex_search(text, std::regex("\nfolder += "))) {
            continue;  // see below
        }
        auto const ended = overturn(folder, {"plan", file.path()});
        EXPECT_EQ(ended.code, 0) << ended.err;
        expect_one_screen(ended.out);
        ++count;
    }
    EXPECT_GE(count, 5);
}

// Keys that no study states are shown in small campaigns of their own.
TEST(Campaigns, ExamplesAreAcceptedAsTheyStand) {
    Folder const folder;
    int count = 0;
    for (auto const& file : std::filesystem::directory_iterator(OVERTURN_CAMPAIGNS "/examples")) {
        if (file.path().extension() == ".toml") {
            EXPECT_TRUE(read_text(file.path()).starts_with("#:schema ../schema.json\n# Keys by example: "))
                << file.path();
            auto const ended = planned(folder, {file.path()});
            EXPECT_EQ(ended.code, 0) << ended.err;
            ++count;
        }
    }
    EXPECT_GE(count, 5);
}

// Paths of all keys of a table, "bodies.parts.kind", however the tables are written and listed.
void add_paths(toml::table const& table, std::string const& place, std::set<std::string>& paths) {
    for (auto const& [key, value] : table) {
        auto const path = place + std::string(key.str());
        paths.insert(path);
        if (auto const* inner = value.as_table()) {
            add_paths(*inner, path + ".", paths);
        }
        if (auto const* list = value.as_array()) {
            for (auto const& each : *list) {
                if (auto const* inner = each.as_table()) {
                    add_paths(*inner, path + ".", paths);
                }
            }
        }
    }
}

// a key that nobody shows is a key that nobody finds. One that means the same in other tables is shown in one.
TEST(Campaigns, EveryKeyHasAnExample) {
    Folder const folder;
    std::set<std::string> shown;
    for (auto const& file : std::filesystem::recursive_directory_iterator(OVERTURN_CAMPAIGNS)) {
        if (file.path().extension() == ".toml") {
            add_paths(toml::parse_file(file.path().string()),
                      file.path().parent_path().filename() == "bodies" ? "bodies." : "", shown);
        }
    }
    std::map<std::string, bool> keys;
    for (auto const& table : nlohmann::json::parse(overturn(folder, {"list", "keys", "--json"}).out)) {
        for (auto const& key : table["keys"]) {
            auto const name = key["key"].get<std::string>();
            auto& is_shown = keys[name + ": " + key["meaning"].get<std::string>()];
            for (auto const& place : table["places"]) {
                auto const path = place["path"].get<std::string>();
                is_shown = is_shown || shown.contains(path.empty() ? name : path + "." + name);
            }
        }
    }
    for (auto const& [key, is_shown] : keys) {
        EXPECT_TRUE(is_shown) << key;
    }
    EXPECT_GT(keys.size(), 150U);
}

// the study of recorded waves asks for the user's own records, and runs where they are.
TEST(Campaigns, RecordsAreTheUsers) {
    Folder const folder;
    std::string const campaign = OVERTURN_CAMPAIGNS "/records_one_axis.toml";
    for (auto const& [file, named] :
         {std::pair<std::string, std::string>{campaign, "records"}, {OVERTURN_CAMPAIGNS "/granite.toml", "granite"}}) {
        auto const refused = planned(folder, {file});
        EXPECT_EQ(refused.code, 2);
        EXPECT_TRUE(is_one_error_line(refused.err));
        EXPECT_NE(
            refused.err.find("waves.folder: '" + named
                             + "' (no such folder; records are not part of the program). Name the one where yours "
                               "lie: --set waves.folder=FOLDER"),
            std::string::npos)
            << refused.err;
    }
    if (records().empty()) {
        GTEST_SKIP() << "no folder of records: set OVERTURN_RECORDS to one";
    }
    auto const run = overturn(folder, {"run", campaign, "--set", "waves.folder=" + records(), "-o", "r.h5"});
    ASSERT_EQ(run.code, 0) << run.err;
    auto const verified = overturn(folder, {"verify", "r.h5"});  // from the file alone
    EXPECT_EQ(verified.code, 0) << verified.out << verified.err;
}

}  // namespace
}  // namespace overturn::testing
