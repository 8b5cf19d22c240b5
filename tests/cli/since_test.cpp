// Requirement R-1003: which format a column came with is reported on the page of columns, and is so of the files kept
// from then.
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "store/format_versions.hpp"
#include "store/results_file.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

using Path = std::pair<std::string, std::string>;  // group, column

Path parted(std::string const& path) {
    auto const slash = path.rfind('/');
    return slash == std::string::npos ? Path{"", path} : Path{path.substr(0, slash), path.substr(slash + 1)};
}

// "limits/touches/stripes/type-a/level" -> "limits/<limit>/stripes/<body>/level"; a model of trials may have a body's
// name.
std::string generic(std::string const& path, std::set<std::string> const& bodies) {
    std::istringstream parts(path);
    std::string text;
    std::string before;
    for (std::string part; std::getline(parts, part, '/'); before = part) {
        bool const body = !before.empty() && before != "trials" && bodies.contains(part);
        auto const name = before == "limits" ? "<limit>" : body ? "<body>" : part == "subset-0" ? "subset-<n>" : part;
        text += (text.empty() ? "" : "/") + name;
    }
    return text;
}

// The columns of a list as the golden files are: "/trials/v_wes real64 m/s".
std::set<std::string> columns_of(std::string const& list) {
    std::set<std::string> bodies;
    std::vector<std::string> paths;
    std::istringstream lines(list);
    for (std::string line; std::getline(lines, line);) {
        paths.push_back(line.substr(1, line.find(' ') - 1));
        constexpr std::string_view of_body = "bodies/";
        if (paths.back().starts_with(of_body)) {
            bodies.insert(paths.back().substr(of_body.size(), paths.back().rfind('/') - of_body.size()));
        }
    }
    std::set<std::string> columns;
    for (auto const& path : paths) {
        columns.insert(generic(path, bodies));
    }
    return columns;
}

std::string golden(std::string const& name) { return read_text(std::filesystem::path(OVERTURN_GOLDEN) / name); }

std::set<std::string> columns_of(std::int64_t version) {
    auto columns = columns_of(golden(fmt::format("columns-{}.txt", version)));
    columns.merge(columns_of(golden(fmt::format("columns-rare-{}.txt", version))));
    return columns;
}

TEST(Since, IsTheFirstFormatWhoseFilesHoldTheColumn) {
    std::map<std::string, std::int64_t> first;
    for (auto version = store::oldest_format_read; version <= store::format_version; ++version) {
        for (auto const& path : columns_of(version)) {
            first.try_emplace(path, version);
        }
    }
    std::set<std::int64_t> seen;
    for (auto const& path : columns_of(store::format_version)) {
        auto const [group, column] = parted(path);
        EXPECT_EQ(store::first_format_of(group, column), first.at(path)) << path;
        seen.insert(first.at(path));
    }
    EXPECT_GE(seen.size(), 3U) << "columns of each format were looked at";
}

TEST(Since, StandsOnThePage) {
    auto const page = golden("../../src/store/COLUMNS.md");
    EXPECT_NE(page.find("\n| `cav` | m/s | 5 | "), std::string::npos);
    EXPECT_NE(page.find("\n| `pga` | m/s2 |  | "), std::string::npos);
    EXPECT_EQ(store::first_format_of("waves", "epsilon_between_1s"), 4) << "of waves whose parts are stated";
    EXPECT_EQ(store::first_format_of("grid_by_level/<body>", "verdict"), 5);
    EXPECT_EQ(store::first_format_of("grid/<body>", "uplift"), 3);
}

}  // namespace
}  // namespace overturn::testing
