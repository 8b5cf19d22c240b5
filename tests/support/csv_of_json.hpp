/// Tables beside a page's figures, held against what `overturn fit --json` says.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace overturn::testing {

/// The rows of a JSON list whose `key` is `value`.
inline std::vector<nlohmann::ordered_json> rows_where(nlohmann::ordered_json const& list, std::string const& key,
                                                      std::string const& value) {
    std::vector<nlohmann::ordered_json> rows;
    for (auto const& row : list) {
        if (row.at(key) == value) {
            rows.push_back(row);
        }
    }
    return rows;
}

/// Is `csv` these rows, under their names and in their order, but for "stated" (values in the typed units)? \pre there
/// is a row, and no cell holds a comma
inline void expect_rows(std::string const& csv, std::vector<nlohmann::ordered_json> const& rows) {
    ASSERT_FALSE(rows.empty());
    std::string head;
    for (auto const& [key, value] : rows.front().items()) {
        head += key == "stated" ? "" : (head.empty() ? "" : ",") + key;
    }
    EXPECT_EQ(csv.substr(0, csv.find('\n')), head);
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + static_cast<std::ptrdiff_t>(rows.size()));
    auto const last = csv.rfind('\n', csv.size() - 2) + 1;
    auto const first = rows.back().begin().value();
    auto const cell = first.is_string() ? first.get<std::string>() : first.dump();
    EXPECT_EQ(csv.substr(last, cell.size() + 1), cell + ",");
}

}  // namespace overturn::testing
