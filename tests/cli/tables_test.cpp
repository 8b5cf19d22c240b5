// Requirement R-1003: the results file and `fit --json` have the same tables, by the same names, with the same numbers.
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <string_view>

#include <nlohmann/json.hpp>

#include "cli/campaign_files.hpp"
#include "store/results_file.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

using json = nlohmann::json;

// "stripes" of "stripes/type-a" and of "limits/touches/stripes/type-a".
std::string table_of(std::string const& path) {
    auto const begin = path.starts_with("limits/") ? path.find('/', 7) + 1 : 0;
    return path.substr(begin, path.find('/', begin) - begin);
}

// The columns of each table in the file, by the names that JSON gives them.
std::map<std::string, std::set<std::string>> columns_of(store::ResultsReader const& file, json const& fit) {
    std::map<std::string, std::set<std::string>> tables;
    for (auto const& column : file.columns()) {
        auto const table = table_of(column.path);
        if (!fit.contains(table)) {
            continue;
        }
        auto const name = column.path.substr(column.path.rfind('/') + 1);
        auto const& row = fit.at(table).at(0);
        // The unit stands in the name unless it is that of the levels or of the row's measure.
        tables[table].insert(row.contains(name) ? name : Field{name, column.units, {}}.key());
    }
    return tables;
}

// Adds tables that the list of columns calls JSON's alone; their names.
std::set<std::string> add_of_page(std::string const& page, std::map<std::string, std::set<std::string>>& tables) {
    constexpr std::string_view head = "fit --json: ";
    std::set<std::string> added;
    std::string table;
    std::istringstream lines(page);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(head)) {
            table = *added.insert(line.substr(head.size())).first;
        } else if (!table.empty() && line.starts_with("  ") && line[2] != ' ') {
            tables[table].insert(line.substr(2, line.find(' ', 2) - 2));
        }
    }
    return added;
}

TEST(Tables, OfFileAndJsonShareAllNames) {
    Folder folder;
    folder.write("target.csv", target_csv);
    folder.write("c.toml",
                 small_campaign("shared", 8) + "[[limits]]\nname='tilts'\nquantity='peak_rotation_ratio'\nabove=0.1\n");
    ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
    auto const fit = json::parse(overturn(folder, {"fit", "c.h5", "--json"}).out);
    store::ResultsReader const file(folder / "c.h5");
    std::set<std::string> const constants{
        "body",     "limit",       "confidence",      "measure", "units",           "label",
        "quantity", "level_units", "independent_are", "method",  "demand_fractile", "stated"};
    std::set<std::string> const words{"warnings", "verdict", "assumptions", "unknown_columns"};

    auto stored = columns_of(file, fit);
    auto const page = overturn(folder, {"list", "columns", "c.h5"}).out;
    for (auto const& name : add_of_page(page, stored)) {
        EXPECT_FALSE(file.has(name)) << name;
    }

    for (auto const& [table, rows] : fit.items()) {
        if (!rows.is_array() || rows.empty() || words.contains(table)) {
            continue;
        }
        ASSERT_TRUE(stored.contains(table)) << table << " is not in the file";
        std::set<std::string> named;
        for (auto const& row : rows) {
            for (auto const& [name, value] : row.items()) {
                named.insert(name);
            }
        }
        for (auto const& name : stored.at(table)) {
            EXPECT_TRUE(named.contains(name)) << table << "/" << name << " is not in the JSON";
        }
        for (auto const& name : named) {
            EXPECT_TRUE(stored.at(table).contains(name) || constants.contains(name))
                << table << ": " << name << " is not in the file";
        }
    }
    EXPECT_GE(stored.size(), 12U);
}

// Every number of a curve and of a stripe, NaN where JSON has null.
TEST(Tables, OfFileAndJsonHaveTheSameNumbers) {
    Folder folder;
    folder.write("target.csv", target_csv);
    folder.write("c.toml", small_campaign("shared", 8));
    ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
    auto const fit = json::parse(overturn(folder, {"fit", "c.h5", "--json"}).out);
    store::ResultsReader const file(folder / "c.h5");
    int compared = 0;
    for (std::string const table : {"fragility", "stripes", "criterion", "probabilities", "criterion_by_level"}) {
        std::map<std::string, std::size_t> next;
        for (auto const& row : fit.at(table)) {
            auto const body = row.at("body").get<std::string>();
            auto const group =
                table + "/" + body + (table == "criterion_by_level" ? "/" + row.at("measure").get<std::string>() : "");
            auto const place = next[group]++;
            for (auto const& [name, value] : row.items()) {
                auto const path = group + "/" + name;
                if (!file.has(path) || !(value.is_number() || value.is_null())) {
                    continue;
                }
                double const stored = file.reals(path).at(place);
                EXPECT_TRUE(value.is_null() ? !std::isfinite(stored) : stored == value.get<double>())
                    << path << " " << place << ": " << stored << " and " << value;
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 1000);
}

}  // namespace
}  // namespace overturn::testing
