// Requirement R-1403: an installation shows in a minute, without Python, that it computes what is known: closed forms,
// published values, stored bytes on any ranks, going on after a stop, and a file system that keeps what it is given.
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "support/command.hpp"

namespace overturn::testing {
namespace {

nlohmann::json qualified(Folder const& folder, std::vector<std::string> const& command) {
    auto const ended = execute(folder, command);
    EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
    return nlohmann::json::parse(ended.out);
}

TEST(Qualify, PassesOnAnyRanks) {
    Folder const folder;
    for (int const ranks : {1, 2, 3}) {
        auto const shown = qualified(folder, mpirun(ranks, {"qualify", "--json"}));
        EXPECT_EQ(shown["ranks"], ranks);
        EXPECT_GE(shown["checks"].size(), 30U);
        std::set<std::string> numbers;
        for (auto const& check : shown["checks"]) {
            EXPECT_TRUE(check["passed"]) << check.dump();
            EXPECT_TRUE(check["remark"] == "" || check["number"] == "F-01") << check.dump();
            EXPECT_TRUE(numbers.insert(check["number"]).second) << check.dump();
        }
    }
    for (auto const& left : std::filesystem::directory_iterator(folder.path())) {
        EXPECT_EQ(left.path().filename().string().rfind("overturn-qualify", 0), std::string::npos) << left.path();
    }
}

TEST(Qualify, WritesAPageThatNamesEveryCheck) {
    Folder const folder;
    auto const ended = overturn(folder, {"qualify", "--html", "page.html", "--date", "1 May 2026"});
    ASSERT_EQ(ended.code, 0) << ended.out << ended.err;
    std::istringstream lines(ended.out);
    auto const page = folder.read("page.html");
    int checks = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("PASS  ")) {
            EXPECT_NE(page.find("<td>" + line.substr(6, 4) + "</td>"), std::string::npos) << line;
            ++checks;
        }
    }
    EXPECT_GE(checks, 30);
    EXPECT_NE(ended.out.find(std::to_string(checks) + " checks pass"), std::string::npos) << ended.out;
    EXPECT_EQ(page.find("http"), std::string::npos);
    EXPECT_NE(page.find("<dt>date</dt><dd>1 May 2026</dd>"), std::string::npos);
}

// As a library of another version might: its own check names it, and the campaign that draws by it; all others pass.
TEST(Qualify, ALibraryThatGivesAnotherNumberFails) {
    Folder const folder;
    auto const ended = execute(folder, joined({"/usr/bin/env", "LD_PRELOAD=" OVERTURN_OTHER_QUANTILE, OVERTURN_PROGRAM},
                                              {"qualify", "--json"}));
    EXPECT_EQ(ended.code, 1) << ended.err;
    auto const shown = nlohmann::json::parse(ended.out);
    EXPECT_FALSE(shown["passed"]);
    for (auto const& check : shown["checks"]) {
        EXPECT_EQ(check["passed"], check["number"] != "N-06" && check["number"] != "C-01") << check.dump();
    }
}

// R-1406.
TEST(Qualify, HoldsItselfAgainstPublishedResults) {
    Folder const folder;
    auto const ended = overturn(folder, {"qualify", "--published", "--json", "--html", "page.html"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    auto const shown = nlohmann::json::parse(ended.out);
    auto const page = folder.read("page.html");
    int derived = 0;
    int printed = 0;
    int apart = 0;
    for (auto const& check : shown["checks"]) {
        auto const number = check["number"].get<std::string>();
        EXPECT_TRUE(check["passed"]) << check.dump();
        EXPECT_FALSE(check["source"].get<std::string>().empty()) << number;
        EXPECT_GT(check["tolerance"], 0) << number;
        auto const remark = check["remark"].get<std::string>();
        EXPECT_EQ(check["agrees"], number[0] != 'D') << check.dump();
        EXPECT_FALSE((remark + check["differs_because"].get<std::string>()).empty())
            << number << " says what decides the difference";
        apart += check["agrees"] ? 0 : 1;
        derived += remark.find("derived again") != std::string::npos ? 1 : 0;
        printed += remark.find("printed") != std::string::npos ? 1 : 0;
        EXPECT_NE(page.find("<td>" + number + "</td>"), std::string::npos);
    }
    EXPECT_GE(shown["checks"].size(), 25U);
    EXPECT_GT(derived, 0);
    EXPECT_GT(printed, 0);
    EXPECT_EQ(apart, 4);
    std::string left_out;
    for (auto const& left : shown["left_out"]) {
        left_out += left["source"].get<std::string>() + "; ";
        EXPECT_FALSE(left["reason"].get<std::string>().empty()) << left.dump();
        EXPECT_NE(page.find(left["reason"].get<std::string>()), std::string::npos) << left.dump();
    }
    for (auto const* source : {"OpenSees", "NUREG/CR-6865", "K08-3", "Vibroengineering (2015)", "HI-2002444"}) {
        EXPECT_NE(left_out.find(source), std::string::npos) << source << " is passed over";
    }
}

TEST(Qualify, AFolderThatKeepsNothingIsRefused) {
    Folder const folder;
    auto const ended = overturn(folder, {"qualify", "none"});
    EXPECT_EQ(ended.code, 2);
    EXPECT_TRUE(is_one_error_line(ended.err)) << ended.err;
}

}  // namespace
}  // namespace overturn::testing
