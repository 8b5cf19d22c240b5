// Requirement R-107: the page on records has a row for each format that is read, and for no other.
#include <cstdlib>
#include <fstream>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "motion/record.hpp"

namespace overturn {
namespace {

TEST(FormatsPage, HasARowForEachFormat) {
    char const* const source = std::getenv("OVERTURN_SOURCE_DIR");
    if (source == nullptr) {
        GTEST_SKIP() << "no OVERTURN_SOURCE_DIR";
    }
    std::ifstream page(std::string(source) + "/src/motion/README.md");
    ASSERT_TRUE(page);
    std::set<std::string> rows;
    for (std::string line; std::getline(page, line) && !line.starts_with("## Tables");) {
        if (line.starts_with("| ") && !line.starts_with("| format ")) {
            rows.insert(line.substr(2, line.find(' ', 2) - 2));
        }
    }
    std::set<std::string> read;
    for (auto const& format : record_formats()) {
        read.insert(std::string(format.name));
    }
    for (auto const* other : {"refused", "components", "list"}) {  // nothing is recognised as one of the last two
        EXPECT_EQ(read.erase(other), 1U) << other;
    }
    EXPECT_EQ(rows, read);
}

}  // namespace
}  // namespace overturn
