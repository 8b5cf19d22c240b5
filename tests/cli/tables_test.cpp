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

// Names of all columns of a file, as JSON has them: with the unit.
std::set<std::string> names_in(store::ResultsReader const& file) {
    std::set<std::string> names;
    for (auto const& column : file.columns()) {
        auto const name = column.path.substr(column.path.rfind('/') + 1);
        bool const by_row = column.units.find(';') != std::string::npos;
        names.insert(by_row ? name : Field{name, column.units, {}}.key());
    }
    return names;
}

// Names of an object that no column of the file has.
std::set<std::string> names_beside(std::set<std::string> const& names, json const& object) {
    std::set<std::string> beside;
    for (auto const& [name, value] : object.items()) {
        if (!names.contains(name)) {
            beside.insert(name);
        }
    }
    return beside;
}

using Names = std::set<std::string>;

// One motion, one trial and one wave have the names of the file's columns; what no file has is listed here.
TEST(Tables, OfOneMotionHaveTheNamesOfTheFile) {
    Folder folder;
    folder.write("target.csv", target_csv);
    folder.write("c.toml", small_campaign("shared", 2));
    folder.write("body.toml", "mass='12.6 t'\nbase_width='0.9 m'\ncentre_height='1.045 m'\ninertia='uniform-block'\n");
    ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
    ASSERT_EQ(overturn(folder, {"wave", "c.toml", "--wave", "1", "-o", "w.csv"}).code, 0);
    store::ResultsReader const file(folder / "c.h5");
    auto const names = names_in(file);
    auto const of = [&](std::vector<std::string> const& command) {
        auto const ended = overturn(folder, command);
        EXPECT_EQ(ended.code, 0) << ended.err;
        return json::parse(ended.out);
    };

    auto const rock = of({"rock", "--body", "body.toml", "--wave", "w.csv", "--json"});
    EXPECT_EQ(names_beside(names, rock), (Names{"matching", "record", "stated"}));
    for (auto const& [name, value] : rock.at("stated").items()) {
        auto const has_name = [&](store::ColumnMeaning const& c) { return c.path.ends_with("/" + name); };
        EXPECT_TRUE(std::ranges::any_of(file.columns(), has_name)) << name;
    }

    auto const spectrum = of({"spectrum", "--wave", "w.csv", "--body", "body.toml", "--json"});
    EXPECT_EQ(names_beside(names, spectrum),
              (Names{"damping", "energy", "period_s", "psa_mps2", "psv_mps", "record", "residual_velocity_over_pgv",
                     "sa_mps2", "sd_m", "stated", "sv_mps", "v_e0_mps", "v_e_mps"}));
    EXPECT_EQ(names_beside(names, spectrum.at("energy")),
              (Names{"stated", "v_wes_running_mps", "v_wes_running_time_s"}));

    auto const rocking =
        of({"spectrum", "--rocking", "--wave", "w.csv", "--body", "body.toml", "--rocking-periods", "4", "--json"});
    EXPECT_EQ(names_beside(names, rocking.at("curves").at(0).at("points").at(0)), (Names{"fate", "rocking_period_s"}));

    auto const wave = of({"wave", "c.toml", "--wave", "1", "--json"});
    EXPECT_EQ(names_beside(names, wave),
              (Names{"acceptance", "bands", "match", "pgd_drift", "time_step_s", "vertical_match"}));

    auto const trial = of({"replay", "c.h5", "--trial", "1", "--json"}).at("row");
    EXPECT_EQ(names_beside(names, trial),
              (Names{"contact", "edge_margin_m", "least_clearance_m", "rocking", "sliding", "spatial", "stated"}))
        << "the two lengths are in files of campaigns with a site";
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
