// Requirement R-901: people read levels, curves, quotes and notes in the unit that they wrote; files and JSON are SI
// whatever was written.
#include <algorithm>
#include <cmath>
#include <regex>
#include <string>
#include <tuple>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/campaign_files.hpp"
#include "support/command.hpp"
#include "support/line_width.hpp"
#include "support/single_blanks.hpp"

namespace overturn::testing {
namespace {

using nlohmann::json;

std::string const limit = "[[limits]]\nname='touches'\nquantity='peak_slip'\nabove='4 cm'\n";

// In inches, kip and g.
std::string campaign_in_inches() {
    auto campaign = small_campaign("shared", 20);
    auto const replace = [&](std::string const& from, std::string const& to) {
        for (auto at = campaign.find(from); at != std::string::npos; at = campaign.find(from)) {
            campaign.replace(at, from.size(), to);
        }
    };
    replace("mass='12.6 t'", "mass='27.8 KIP'");
    replace("base_width='1.36 m'", "base_width='53.5 in'");
    replace("centre_height='1.045 m'", "centre_height='3.43 ft'");
    replace("values=['300 gal','600 gal','1200 gal']", "values=['0.3 g','0.6 g','1.8 g']");
    replace("design_basis='600 gal'", "design_basis='0.6 g'");
    replace("friction=0.5", "friction=0.2");  // slides
    return campaign;
}

// "stated" of a name, in the unit, is the SI value of the column.
void expect_typed(json const& row, std::string const& name, std::string const& column, std::string const& unit,
                  double si) {
    ASSERT_TRUE(row.contains(column) && row.at("stated").contains(name)) << row.dump(2);
    auto const& typed = row.at("stated").at(name);
    EXPECT_EQ(typed.at("unit"), unit) << name;
    ASSERT_EQ(typed.at("value").is_null(), row.at(column).is_null()) << row.dump(2);
    if (!typed.at("value").is_null()) {
        EXPECT_DOUBLE_EQ(typed.at("value").get<double>() * si, row.at(column).get<double>()) << name;
    }
}

constexpr double inch_m = 0.0254, g_mps2 = 9.80665, degree_rad = 3.14159265358979323846 / 180;

class Units : public ::testing::Test {
  protected:
    // What `fit` prints and its JSON, of the small campaign with these levels.
    std::pair<std::string, json> fit(std::string const& levels) const {
        auto campaign = small_campaign("shared", 24);
        auto const from = campaign.find("measure='pga'");
        campaign.replace(from, campaign.find("waves='shared'") - from, levels);
        std::filesystem::remove(folder.path() / "c.h5");
        folder.write("target.csv", target_csv);
        folder.write("c.toml", campaign + limit);
        auto const run = overturn(folder, {"run", "c.toml", "-o", "c.h5"});
        EXPECT_EQ(run.code, 0) << run.err;
        EXPECT_EQ(run.out, overturn(folder, {"fit", "c.h5"}).out + "results: c.h5\n");
        auto const table = overturn(folder, {"fit", "c.h5", "--full"});
        auto const values = overturn(folder, {"fit", "c.h5", "--json"});
        EXPECT_EQ(table.code + values.code, 0) << table.err << values.err;
        EXPECT_EQ(too_wide(table.out), "");
        return {table.out, json::parse(values.out)};
    }

    Folder folder;
};

// Every number of a curve over the levels, found in the table as the JSON's over the unit's SI value.
void expect_reported(std::string const& table, json const& all, std::string const& measure, std::string const& unit,
                     double si) {
    auto const columns = single_blanks(table);
    int curves = 0;
    for (auto const& curve : all["fragility"]) {
        if (curve["measure"] != measure || !curve["identifiable"].get<bool>()) {
            continue;
        }
        ++curves;
        auto const told = [&](json const& value) { return fmt::format("{:.4g}", value.get<double>() / si); };
        // To four digits, ends outwards and capacities downwards.
        auto const rounded = [&](json const& value, bool up) {
            constexpr double noise = 1e-9;
            double const x = value.get<double>() / si;
            double const place = std::pow(10, 3 - std::floor(std::log10(x)));
            return fmt::format("{:.4g}", (up ? std::ceil(x * place - noise) : std::floor(x * place + noise)) / place);
        };
        auto const line = fmt::format(
            " {} {} {} ", measure + " " + unit, told(curve["median"]),
            fmt::format("[{}, {}]", rounded(curve["median_lower"], false), rounded(curve["median_upper"], true)));
        EXPECT_NE(columns.find(line), std::string::npos) << line << "\n" << table;
        auto const point = [&](char const* key) {
            return curve[key].is_null() ? std::string("-") : rounded(curve[key], false);
        };
        EXPECT_NE(columns.find(fmt::format(" {} {} ", point("five_percent_point_lower"), point("hclpf_lower"))),
                  std::string::npos)
            << table;
    }
    EXPECT_GT(curves, 0) << all["fragility"].dump(1);
}

// A slip in feet has no digits left: beside m it is in inches, as in text and JSON, in tables and in histories.
TEST_F(Units, OfColumnsAreThoseOfTheText) {
    auto campaign = campaign_in_inches();
    for (auto at = campaign.find("53.5 in"); at != std::string::npos; at = campaign.find("53.5 in")) {
        campaign.replace(at, 7, "4.46 ft");
    }
    folder.write("target.csv", target_csv);
    folder.write("f.toml", campaign);
    auto const run = overturn(folder, {"run", "f.toml"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_NE(run.out.find("slip [in]"), std::string::npos) << run.out;
    ASSERT_EQ(overturn(folder, {"export", "f.h5", "--as", "csv"}).code, 0);
    auto const trials = folder.read("f.tables/trials.csv");
    auto const head = trials.substr(0, trials.find('\n'));
    EXPECT_NE(head.find("peak_slip [m],peak_slip [in]"), std::string::npos) << head;
    EXPECT_EQ(head.find("[ft]"), std::string::npos) << head;
    ASSERT_EQ(overturn(folder, {"replay", "f.h5", "--trial", "0", "--history", "h.csv"}).code, 0);
    auto const history = folder.read("h.csv");
    EXPECT_NE(history.find("[in]"), std::string::npos) << history.substr(0, 200);
    EXPECT_EQ(history.find("[ft]"), std::string::npos) << history.substr(0, 200);
}

TEST_F(Units, CurvesQuotesAndNotesAreInThatOfTheLevels) {
    auto const [table, values] =
        fit("measure='pga'\nvalues=['300 gal','600 gal','800 gal','1200 gal','1500 gal']\ndesign_basis='600 gal'\n");

    expect_reported(table, values, "pga", "gal", 0.01);
    EXPECT_NE(table.find("1.5 x design basis, pga 900 gal"), std::string::npos) << table;
    EXPECT_EQ(table.find("m/s2"), std::string::npos) << table;
    // Stripes of the limit state, and quantiles level by level.
    auto const at = table.find("limit state touches");
    ASSERT_NE(at, std::string::npos);
    auto const columns = single_blanks(table);
    EXPECT_NE(columns.find("\n 300 ", columns.find("limit state touches")), std::string::npos) << table;
    EXPECT_NE(columns.find("\n 300 ", columns.find("peak_slip cm of the trials")), std::string::npos) << table;
    auto flowing = table;
    std::ranges::replace(flowing, '\n', ' ');
    EXPECT_NE(single_blanks(flowing).find("half of these trials exceed the limit between 800 and 1200 gal"),
              std::string::npos)
        << table;
    EXPECT_NE(table.find("pgv m/s"), std::string::npos) << "of no unit that was written";
}

// V_WES and PGV are velocities: beside levels in kine they are in kine.
TEST_F(Units, MeasuresOfTheSameDimensionFollow) {
    auto const [table, values] = fit("measure='pgv'\nvalues=['30 kine','60 kine','80 kine','120 kine']\n");

    expect_reported(table, values, "v_wes", "kine", 0.01);
    EXPECT_NE(table.find("pga m/s2"), std::string::npos) << table;
}

// The unit that was asked for is that of every velocity in plan, run, merge and fit, V_Ereq of the header too.
TEST_F(Units, VelocitiesArePrintedAsRequested) {
    std::vector<std::string> const kine{"--velocities", "kine"};
    folder.write("k.toml", small_campaign("shared", 6));
    folder.write("target.csv", target_csv);
    auto const told = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), kine.begin(), kine.end());
        auto const ended = overturn(folder, arguments);
        EXPECT_TRUE(ended.code == 0 || ended.code == 3) << ended.err;
        return ended.out;
    };
    auto const planned = told({"plan", "k.toml"});
    EXPECT_NE(planned.find("V_Ereq [kine]\n"), std::string::npos) << planned;
    EXPECT_NE(planned.find(" 134.89\n"), std::string::npos) << planned;
    auto const ran = told({"run", "k.toml", "-o", "k.h5", "--full"});
    for (auto const* part : {"1/2", "2/2"}) {
        (void)told({"run", "k.toml", "-o", "parts.h5", "--part", part});
    }
    auto const merged = told({"merge", "parts.h5", "--full"});
    for (auto const& text : {ran, merged, told({"fit", "k.h5", "--full"})}) {
        EXPECT_NE(text.find("V_Ereq 134.9 kine\n"), std::string::npos) << text;
        EXPECT_NE(text.find("v_wes kine"), std::string::npos) << text;
        EXPECT_EQ(text.find("m/s\n"), std::string::npos) << text;
        EXPECT_EQ(text.find("v_wes m/s"), std::string::npos) << text;
    }
    auto const refused = overturn(folder, {"run", "k.toml", "-o", "l.h5", "--velocities", "furlong"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_NE(refused.err.find("--velocities: unit 'furlong'"), std::string::npos) << refused.err;
}

// A campaign in inches, pounds and g is read in these, wherever numbers are shown; JSON has both.
TEST_F(Units, EverythingIsReadInTheUnitsOfTheCampaign) {
    auto const campaign = campaign_in_inches();
    auto const fast = "[[limits]]\nname='fast'\nquantity='v_resp'\nabove='60 kine'\n";
    folder.write("target.csv", target_csv);
    folder.write("c.toml", campaign + fast);
    auto const ran = overturn(folder, {"run", "c.toml", "--section", "records,stripes,responses,trials"});
    ASSERT_EQ(ran.code, 0) << ran.err;

    auto const expect_all = [](std::string const& text, std::vector<std::string> const& parts) {
        for (auto const& part : parts) {
            EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
        }
        for (auto const* const si : {" m/s", "m/s2", " mm", " kg", " m,"}) {
            EXPECT_EQ(text.find(si), std::string::npos) << si << " in\n" << text;
        }
    };
    expect_all(ran.out,
               {"slip [in]", "R 49.", " in, restitution", " kine\n", "peak_slip in of the trials", " slip in "});
    auto const by_hand = overturn(folder, {"fit", "c.h5", "--section", "hand"}).out;
    EXPECT_TRUE(std::regex_search(by_hand, std::regex(";\\s+slides\\s+[0-9.]+\\s+in\\s+at"))) << by_hand;
    auto const pad = std::string("[[bodies]]\nname='crushed'\nmass='12.6 t'\nbase_width='1.36 m'\n")
                     + "centre_height='1.045 m'\ninertia='uniform-block'\npad={strength='4 ksi'}\n";
    folder.write("p.toml", campaign + fast + pad);
    expect_all(overturn(folder, {"plan", "p.toml"}).out,
               {"mass [kip]", "uplift [g]", "V_Ereq [kine]", "4 ksi", " 27.8 "});
    auto const plan = json::parse(overturn(folder, {"plan", "c.toml", "--json"}).out);
    auto const& body = plan.at("bodies").at(0);
    EXPECT_EQ(body.at("stated").at("mass").at("unit"), "kip");
    EXPECT_NEAR(body.at("stated").at("mass").at("value").get<double>(), 27.8, 1e-9);
    EXPECT_NEAR(body.at("mass_kg").get<double>(), 27800 * 0.45359237, 1e-6);  // international pound, 1959
    EXPECT_NEAR(body.at("stated").at("half_width").at("value").get<double>(), 53.5 / 2, 1e-9);

    // Histories and tables have SI, and behind it the units of the campaign.
    auto const again = overturn(folder, {"replay", "c.h5", "--trial", "1", "--history", "h.csv"});
    ASSERT_EQ(again.code, 0);
    expect_all(again.out, {"peak slip ", " in, "});
    folder.write("b.toml",
                 "mass='27.8 kip'\nbase_width='53.5 in'\ncentre_height='41 in'\ninertia='uniform-block'\n"
                 "friction=0.2\n");
    std::string push = "time (s),acc (g)\n";
    for (int i = 0; i < 100; ++i) {
        push += fmt::format("{:.2f},{}\n", 0.01 * i, i > 0 && i < 50 ? 0.25 : 0);
    }
    folder.write("w.csv", push);
    auto const rock = overturn(folder, {"rock", "--body", "b.toml", "--wave", "w.csv"});
    expect_all(rock.out, {" in at most, ", " in/s"});
    EXPECT_TRUE(std::regex_search(rock.out, std::regex("uplift\\s+at\\s+0\\.6524\\s+g,"))) << "b / h, " << rock.out;
    auto const history = folder.read("h.csv");
    EXPECT_NE(history.substr(0, history.find('\n')).find("_m,top_x_m,slip [in],slip_velocity [kine],x [in],"),
              std::string::npos)
        << history.substr(0, history.find('\n'));
    ASSERT_EQ(overturn(folder, {"export", "c.h5", "--as", "csv"}).code, 0);
    for (auto const& [file, titles] :
         {std::pair{"c.tables/trials.csv", "peak_slip [m],peak_slip [in],"},
          {"c.tables/trials.csv", "v_resp [m/s],v_resp [kine],"},
          {"c.tables/waves.csv", "pga [m/s2],pga [g],pgv [m/s],pgv [kine],"},
          {"c.tables/curves.csv",
           "hclpf_lower [unit in column units],hclpf_lower [g],hclpf_upper [unit in column units],"}}) {
        EXPECT_NE(folder.read(file).find(titles), std::string::npos) << titles;
    }
}

// JSON has the numbers of the answer, of a record, of a trial and of one motion as SI and, under "stated", with
// value and unit as they were typed.
TEST_F(Units, JsonHasWhatWasTypedBesideSi) {
    folder.write("target.csv", target_csv);
    folder.write("c.toml", campaign_in_inches());
    ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
    auto const fit = json::parse(overturn(folder, {"fit", "c.h5", "--json"}).out);
    ASSERT_FALSE(fit.at("answer").empty());
    for (auto const& row : fit.at("answer")) {
        expect_typed(row, "amplitude", "amplitude", "g", g_mps2);
        expect_typed(row, "hclpf", "hclpf", "g", g_mps2);
        expect_typed(row, "peak_slip_p95", "peak_slip_p95_m", "in", inch_m);
        expect_typed(row, "peak_rotation_p95", "peak_rotation_p95_rad", "deg", degree_rad);
    }
    EXPECT_GT(fit.at("answer").at(0).at("peak_slip_p95_m").get<double>(), 0);
    // So have all other tables: by the column's unit, by that of the levels, by that of the row.
    for (auto const& row : fit.at("stripes")) {
        expect_typed(row, "amplitude", "amplitude", "g", g_mps2);
    }
    for (auto const& row : fit.at("bodies")) {
        expect_typed(row, "mass", "mass_kg", "kip", 1000 * 0.45359237);
        expect_typed(row, "half_width", "half_width_m", "in", inch_m);
        expect_typed(row, "alpha", "alpha_rad", "deg", degree_rad);
        EXPECT_FALSE(row.at("stated").contains("restitution")) << "has no unit";
    }
    int over_pga = 0, over_pgv = 0;
    for (auto const& row : fit.at("fragility")) {
        if (row.at("measure") == "pga") {
            expect_typed(row, "median", "median", "g", g_mps2);
            ++over_pga;
        } else if (row.at("measure") == "pgv") {
            expect_typed(row, "median", "median", "in/s", inch_m);
            ++over_pgv;
        }
    }
    EXPECT_GT(over_pga, 0);
    EXPECT_GT(over_pgv, 0);
    for (auto const& row : fit.at("quantiles")) {
        if (row.at("quantity") == "peak_slip") {
            expect_typed(row, "p95", "p95", "in", inch_m);
        }
        expect_typed(row, "amplitude", "amplitude", "g", g_mps2);
    }

    auto const again = json::parse(overturn(folder, {"replay", "c.h5", "--trial", "1", "--json"}).out);
    EXPECT_TRUE(again.at("bit_equal").get<bool>()) << again.at("different");
    EXPECT_EQ(again.at("trial"), 1);
    auto const& row = again.at("row");
    expect_typed(row, "amplitude", "amplitude", "g", g_mps2);
    expect_typed(row, "peak_slip", "peak_slip_m", "in", inch_m);
    expect_typed(row, "peak_rotation", "peak_rotation_rad", "deg", degree_rad);
    EXPECT_EQ(row.at("verdict"), "slid");

    folder.write("b.toml", "mass='27.8 kip'\nbase_width='53.5 in'\ncentre_height='41 in'\ninertia='uniform-block'\n");
    folder.write("w.csv", "time (s),acc (g)\n0,0\n0.01,0.9\n0.02,0.9\n0.03,0\n0.04,0\n");
    auto const one = json::parse(overturn(folder, {"rock", "--body", "b.toml", "--wave", "w.csv", "--json"}).out);
    expect_typed(one, "peak_rotation", "peak_rotation_rad", "deg", degree_rad);
    expect_typed(one, "v_ereq", "v_ereq_mps", "in/s", inch_m);
    EXPECT_GT(one.at("peak_rotation_rad").get<double>(), 0);
}

// spectra of a record are in its unit, and in those of the body; where neither is typed, in SI.
TEST_F(Units, SpectraOfARecordAreInThoseOfRecordAndBody) {
    folder.write("b.toml", "mass='27.8 kip'\nbase_width='4 ft'\ncentre_height='2 ft'\ninertia='uniform-block'\n");
    folder.write("w.csv", "time (s),acc (g)\n0,0\n0.01,0.9\n0.02,0.9\n0.03,0\n0.04,0\n");
    folder.write("n.csv", "time,a\n0,0\n0.01,0.9\n0.02,0.9\n0.03,0\n0.04,0\n");
    constexpr double foot_m = 0.3048;
    auto const shown = [&](std::vector<std::string> const& more) {
        auto arguments =
            std::vector<std::string>{"spectrum", "--wave", more.empty() || more[0] != "--unit" ? "w.csv" : "n.csv"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        auto const ended = overturn(folder, arguments);
        EXPECT_EQ(ended.code, 0) << ended.err;
        return ended.out;
    };
    auto const heads = [&](std::vector<std::string> const& more) {
        auto const text = single_blanks(shown(more));
        auto const at = text.find("period s");
        return text.substr(at, text.find('\n', at) - at);
    };
    std::vector<std::string> const with_body{"--periods", "0.5", "--body", "b.toml"};
    EXPECT_EQ(heads({}), "period s Sa g pSv m/s Sd m V_E m/s V_E0 m/s");
    EXPECT_EQ(heads({"--unit", "m/s2"}), "period s Sa m/s2 pSv m/s Sd m V_E m/s V_E0 m/s");
    EXPECT_EQ(heads({"--unit", "gal"}), "period s Sa gal pSv m/s Sd m V_E m/s V_E0 m/s");
    EXPECT_EQ(heads({"--unit", "2.5e-6 m/s2"}), "period s Sa m/s2 pSv m/s Sd m V_E m/s V_E0 m/s") << "of no name";
    EXPECT_EQ(heads(with_body), "period s Sa g pSv ft/s Sd ft V_E ft/s V_E0 ft/s");

    auto const text = single_blanks(shown(with_body));
    EXPECT_EQ(text.find(" m/s,"), std::string::npos) << text;
    EXPECT_EQ(text.find(" m,"), std::string::npos) << text;
    auto const found = json::parse(shown({"--periods", "0.5", "--body", "b.toml", "--json"}));
    std::string row = " 0.5000";
    for (auto const& [name, column, unit, si] : {std::tuple{"sa", "sa_mps2", "g", g_mps2},
                                                 {"psv", "psv_mps", "ft/s", foot_m},
                                                 {"sd", "sd_m", "ft", foot_m},
                                                 {"v_e", "v_e_mps", "ft/s", foot_m},
                                                 {"v_e0", "v_e0_mps", "ft/s", foot_m}}) {
        auto const& typed = found.at("stated").at(name);
        EXPECT_EQ(typed.at("unit"), unit) << name;
        double const value = typed.at("value").at(0).get<double>();
        EXPECT_NEAR(value * si, found.at(column).at(0).get<double>(), 1e-12) << name;
        row += fmt::format(" {:.5g}", value);
    }
    EXPECT_NE(text.find(row + "\n"), std::string::npos) << row << " in\n" << text;
    expect_typed(found, "pga", "pga_mps2", "g", g_mps2);
    expect_typed(found, "pgv", "pgv_mps", "ft/s", foot_m);
    expect_typed(found, "pgd", "pgd_m", "ft", foot_m);
    expect_typed(found.at("energy"), "v_ereq", "v_ereq_mps", "ft/s", foot_m);

    auto const factors = shown({"--overturning", "--body", "b.toml"});
    EXPECT_NE(factors.find("; alpha g = 0.7854 g\n"), std::string::npos) << "pi / 4, " << factors;
    EXPECT_NE(factors.find("(PGA 0.9 g)"), std::string::npos) << factors;
    auto const ranges = json::parse(shown({"--overturning", "--body", "b.toml", "--json"}));
    expect_typed(ranges.at("points").at(0), "uplift", "uplift_mps2", "g", g_mps2);
    expect_typed(ranges.at("points").at(0).at("ranges").at(0), "to", "to_mps2", "g", g_mps2);
    auto const tilts = single_blanks(shown({"--rocking", "--body", "b.toml"}));
    EXPECT_NE(tilts.find("(PGA 0.9 g)"), std::string::npos) << tilts;
    // Of a pulse the amplitudes are in the body's unit of acceleration, if it states one.
    folder.write("g.toml", folder.read("b.toml") + "gravity='1 g'\n");
    auto const pulse = [&](char const* body) {
        return single_blanks(
            overturn(folder, {"spectrum", "--overturning", "--pulse", "one-sine", "--ratios", "1", "--body", body})
                .out);
    };
    EXPECT_NE(pulse("b.toml").find(" Hz m/s2 m/s2 alpha g\n"), std::string::npos) << pulse("b.toml");
    EXPECT_NE(pulse("g.toml").find(" Hz g g alpha g\n"), std::string::npos) << pulse("g.toml");
}

// JSON and the file do not know how the levels were written.
TEST_F(Units, JsonStaysSi) {
    auto in_gal = fit("measure='pga'\nvalues=['300 gal','600 gal','800 gal','1200 gal','1500 gal']\n").second;
    auto const [table, in_si] = fit("measure='pga'\nvalues=[3, 6, 8, 12, 15]\n");

    for (char const* name : {"fragility", "stripes"}) {
        ASSERT_FALSE(in_gal[name].empty());
        for (auto& row : in_gal[name]) {
            bool const of_levels = name == std::string("stripes") || row["measure"] == "pga";
            EXPECT_EQ(row.contains("stated"), of_levels) << "gal beside SI";
            row.erase("stated");
        }
        auto si = in_si[name];
        for (auto& row : si) {
            row.erase("stated");
        }
        EXPECT_EQ(in_gal[name], si);
    }
    EXPECT_EQ(in_gal["fragility"][0]["units"], "m/s2");
    expect_reported(table, in_si, "pga", "m/s2", 1);
}

}  // namespace
}  // namespace overturn::testing
