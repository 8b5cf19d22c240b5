// Requirement: every campaign file that comes with the program runs, and begins with its question and its cost.
#include <algorithm>

#include "support/command.hpp"

namespace overturn::testing {
namespace {

TEST(Campaigns, AreAcceptedAsTheyStand) {
    Folder const folder;
    int count = 0;
    for (auto const& file : std::filesystem::directory_iterator(OVERTURN_CAMPAIGNS)) {
        if (file.path().extension() != ".toml") {
            continue;
        }
        auto const text = read_text(file.path());
        EXPECT_TRUE(text.starts_with("# Question: ")) << file.path();
        EXPECT_NE(text.find("\n# Cost: "), std::string::npos) << file.path();
        auto const ended = overturn(folder, {"plan", file.path()});
        EXPECT_EQ(ended.code, 0) << ended.err;
        ++count;
    }
    EXPECT_GE(count, 5);
}

}  // namespace
}  // namespace overturn::testing
