// Requirement: `overturn fit` says by the contract's names what the trials hold, from a results file or
// from anybody's table; what is not identifiable is null, and bad tables are refused where they are wrong.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/campaign_files.hpp"
#include "store/results_file.hpp"
#include "support/command.hpp"
#include "support/single_blanks.hpp"

namespace overturn::testing {
namespace {

using nlohmann::json;

class Fit : public ::testing::Test {
  protected:
    json table(std::string const& text, std::vector<std::string> const& more = {}) {
        folder.write("t.csv", text);
        auto const ended = overturn(folder, joined({"fit", "--stripes", "t.csv", "--json"}, more));
        EXPECT_EQ(ended.code, 0) << ended.err;
        return json::parse(ended.out);
    }
    void refuse(std::string const& text, std::string const& part) {
        folder.write("t.csv", text);
        auto const ended = overturn(folder, {"fit", "--stripes", "t.csv"});
        EXPECT_EQ(ended.code, 2) << text;
        EXPECT_TRUE(is_one_error_line(ended.err)) << text;
        EXPECT_NE(ended.err.find(part), std::string::npos) << ended.err;
    }

    Folder folder;
};

// The rows of a table that are of a curve.
json of_curve(json const& table, json const& curve) {
    auto rows = json::array();
    for (auto const& row : table) {
        if (row["body"] == curve["body"] && row["limit"] == curve["limit"] && row["measure"] == curve["measure"]) {
            rows.push_back(row);
        }
    }
    return rows;
}

// tables of others, under their usual names and with the unit in the header.
TEST_F(Fit, TablesOfOthersAreRead) {
    auto const own = table("amplitude,trials,overturned\n1,54,2\n1.5,54,25\n2,54,43\n");
    EXPECT_EQ(own["amplitude"], "amplitude");
    for (char const* header :
         {"IM [g],num_gms,num_collapse", "amplitude [g],trials,overturned", "Sa (g),N,collapses"}) {
        auto const theirs = table(header + std::string("\n1,54,2\n1.5,54,25\n2,54,43\n"));
        EXPECT_EQ(theirs["fragility"][0]["median"], own["fragility"][0]["median"]) << header;
        EXPECT_NE(theirs["amplitude"].get<std::string>().find("g"), std::string::npos);
        EXPECT_EQ(theirs["fragility"][0]["units"], "g") << header;
        EXPECT_EQ(theirs["stripes"][0]["units"], theirs["fragility"][0]["units"]) << header;
    }
    for (char const* header :
         {"Sa (g),No. of records,No. of collapses", "PGA_g,n_records,n_collapse", "Sa(1.0s)_gal,total,failures",
          "IML [g],Number of ground motions,Number of collapses", "im level,num_gm,n_coll"}) {
        auto const theirs = table(header + std::string("\n1,54,2\n1.5,54,25\n2,54,43\n"));
        EXPECT_EQ(theirs["fragility"][0]["median"], own["fragility"][0]["median"]) << header;
    }
    for (char const* header : {",IM,num_gms,num_collapse", "stripe,IM,num_gms,num_collapse", "No.,IM,n,collapses"}) {
        auto const theirs = table(header + std::string("\n1,1,54,2\n2,1.5,54,25\n3,2,54,43\n"));
        EXPECT_EQ(theirs["fragility"][0]["median"], own["fragility"][0]["median"]) << header;
    }
    refuse("stripe,IM,num_gms,num_collapse\n1,1,54,2\n7,1.5,54,25\n", "t.csv:3:1: '7' (a count of rows by its name");
    refuse("1,54,2\n1.5,54,25\n", "t.csv:1:1: '1' where names belong");
    refuse("IM,num_gms,fails\n1,54,2\n", "'fails' (unknown)");
    refuse("IM;num_gms;num_collapse\n0,6;40;4\n", "a decimal comma");
    auto const blanks = table("IM [g]   num_gms   num_collapse\n1     54  2\n1.5   54 25\n\n2  54    43\n");
    EXPECT_EQ(blanks["fragility"][0]["median"], own["fragility"][0]["median"]);
    EXPECT_EQ(blanks["amplitude"], "IM [g]");
    refuse("IM [g] num_gms num_collapse\n0,6 40 4\n", "a decimal comma");
    refuse("IM [g],num_gms,num_collapse\n0,6,40,4\n", "are there decimal commas?");
    refuse("IM,trials [g],overturned\n1,54,2\n", "'trials [g]' (unknown)");
    refuse("IM,amplitude,trials,overturned\n1,1,54,2\n", "twice");
}

// text round the table states the unit, contradicts the header, or is reported.
TEST_F(Fit, TextRoundATableIsAccountedFor) {
    std::string const rows = "1,54,2\n1.5,54,25\n2,54,43\n";
    auto const told = table("Stripes of Smith\n# intensities in g\nIM,num_gms,num_collapse\n" + rows + "# the end\n");
    EXPECT_EQ(told["not_understood"], json({"line 1: 'Stripes of Smith'", "line 7: '# the end'"}));
    EXPECT_EQ(table("IM [g],num_gms,num_collapse\n" + rows)["not_understood"], json::array());
    refuse("# units: gal\nIM [g],num_gms,num_collapse\n" + rows, "t.csv:1: unit gal, line 2 says g");
    refuse("# units: cm/s\npga [g],num_gms,num_collapse\n" + rows, "t.csv:1: a unit of velocities, column 'pga [g]'");
    for (char const* line : {"# Collapse counts at each level", "counts of collapse", "# counts", "# raw counts",
                             "# Sa(T1,5%) [g], counts of overturning", "# PGA in g, collapse counts"}) {
        EXPECT_EQ(table(std::string(line) + "\nSa(1 s) [g],num_gms,collapse_count\n" + rows)["fragility"].size(), 1U)
            << line;
    }
    refuse("# units: counts\npga [g],num_gms,num_collapse\n" + rows, "t.csv:1: a unit of counts");
    folder.write("h.csv", "im [g], annual_exceedance\n0.1,1e-2\n1,1e-4\n3,1e-6\n");
    folder.write("t.csv", "# intensities in g\nIM,num_gms,num_collapse\n" + rows);
    auto const with = overturn(folder, {"fit", "--stripes", "t.csv", "--hazard", "h.csv", "--json"});
    EXPECT_EQ(with.code, 0) << with.err;
    EXPECT_FALSE(json::parse(with.out)["frequency"].empty());
}

// a row for each trial says what the counts of its level say.
TEST_F(Fit, SingleTrialsAreRead) {
    auto const counted = table("pga [g],trials,overturned\n0.5,2,0\n1,3,1\n1.5,2,1\n2,2,2\n");
    for (char const* header : {"pga [g],collapsed", "fell;pga [g]", "pga [g]  overturned"}) {
        std::string rows;
        for (auto const& [level, fell] : {std::pair{"1", 0},
                                          {"0.5", 0},
                                          {"2", 1},
                                          {"1", 1},
                                          {"1.5", 0},
                                          {"0.5", 0},
                                          {"1.5", 1},
                                          {"2", 1},
                                          {"1.0", 0}}) {
            bool const first = std::string(header).starts_with("fell");
            rows += first ? fmt::format("{};{}\n", fell, level)
                    : std::string(header).find(',') == std::string::npos
                        ? fmt::format("{}   {}\n", level, fell)
                        : fmt::format("{},{}\n", level, fell == 1 ? "yes" : "no");
        }
        auto const single = table(header + ("\n" + rows));
        EXPECT_EQ(single["fragility"][0]["median"], counted["fragility"][0]["median"]) << header;
        EXPECT_EQ(single["stripes"], counted["stripes"]) << header;
    }
    refuse("pga [g],collapsed\n1,2\n", "each row is one");
    refuse("pga [g],collapsed,failed\n1,1,0\n", "beside a column of counts");
    refuse("pga [g],collapsed,fell\n1,1,0\n", "a second column of verdicts");
}

// The same numbers as tests/stats/fragility_fit_test.cpp, where their derivation stands.
TEST_F(Fit, TableOfKnownAnswer) {
    auto const fit =
        table("# three stripes\noverturned, amplitude ,trials\n\n43,2,54  # the highest\n2,1,54\n25,1.5,54\n",
              {"--design-basis", "1", "--waves", "162"});
    auto const& curve = fit["fragility"][0];

    EXPECT_EQ(curve["identifiable"], true);
    EXPECT_NEAR(curve["median"].get<double>(), 1.57247651593071, 1e-9);
    EXPECT_NEAR(curve["beta"].get<double>(), 0.270033194702542, 1e-9);
    EXPECT_NEAR(curve["median_lower"].get<double>(), 1.4756879325809789, 1e-6);
    EXPECT_NEAR(curve["beta_upper"].get<double>(), 0.3627619282471869, 1e-6);
    EXPECT_NEAR(curve["five_percent_point"].get<double>(), 1.0084829479802333, 1e-9);
    EXPECT_EQ(curve["hclpf"], nullptr);
    EXPECT_EQ(curve["one_percent_point"], nullptr);
    EXPECT_EQ(curve["median_at_95"], nullptr);
    EXPECT_EQ(curve["flags"], json::array({"no-beta-u"}));
    EXPECT_EQ(curve["interval_method"], "profile-likelihood");
    ASSERT_EQ(fit["stripes"].size(), 3U);
    EXPECT_EQ(fit["stripes"][0]["amplitude"], 1);
    EXPECT_EQ(fit["stripes"][0]["level"], 0);
    EXPECT_EQ(fit["stripes"][2]["overturned"], 43);
    EXPECT_EQ(fit["probabilities"].size(), 4U);
    EXPECT_EQ(fit["probabilities"][3]["outside_data"], true);
}

TEST_F(Fit, TablesAsOtherProgramsWriteThem) {
    auto const plain = table("amplitude,trials,overturned\n1,54,2\n1.5,54,25\n2,54,43\n");
    EXPECT_EQ(table("amplitude;trials;overturned\n1;54;2\n1.5;54;25\n2;54;43\n"), plain);
    auto named = table("Amplitude\tTrials\tOverturned\r\n1\t54\t2\r\n1.5\t54\t25\r\n2\t54\t43\r\n").dump();
    EXPECT_NE(named.find("Amplitude"), std::string::npos) << "as the table has it";
    for (std::size_t at = 0; (at = named.find("Amplitude", at)) != std::string::npos;) {
        named[at] = 'a';
    }
    EXPECT_EQ(json::parse(named), plain);
    EXPECT_EQ(table("\"amplitude\",\"trials\",\"overturned\"\n\"1\",54,2\n1.5,54,25\n2,54,43\n"), plain);
}

// three trials at each level may be of the same three waves: counts, and no curve, unless they are stated to
// differ.
TEST_F(Fit, OfFewTrialsALevelGiveNoCurve) {
    auto const levels = [](int trials, int levels) {
        std::string text = "amplitude,trials,overturned\n";
        for (int level = 1; level <= levels; ++level) {
            int const fell = 2 * level > levels ? trials : 0;
            text += fmt::format("{},{},{}\n", level, trials, fell - (level == levels - 1 ? 1 : 0));
        }
        return text;
    };
    auto const three = table(levels(3, 8), {"--beta-u", "0.3"})["fragility"][0];
    EXPECT_EQ(three["state"], "few-waves");
    EXPECT_TRUE(three["hclpf"].is_null());
    EXPECT_EQ(table(levels(5, 8), {"--beta-u", "0.3"})["fragility"][0]["state"], "fitted");
    EXPECT_EQ(table(levels(3, 8), {"--waves", "24"})["fragility"][0]["state"], "fitted");
    // A trial at each of many amplitudes is one of many waves.
    std::string single = "amplitude,trials,overturned\n";
    for (int i = 1; i <= 40; ++i) {
        single += fmt::format("{},1,{}\n", i, (i > 20) == (i % 7 != 0) ? 1 : 0);
    }
    EXPECT_EQ(table(single)["fragility"][0]["state"], "fitted");
}

//
TEST_F(Fit, BetaUMovesHclpf) {
    std::string const stripes = "amplitude,trials,overturned\n1,54,2\n1.5,54,25\n2,54,43\n";
    auto const with = table(stripes, {"--beta-u", "0.3"})["fragility"][0];
    auto const without = table(stripes)["fragility"][0];
    double const five = without["five_percent_point"];

    EXPECT_NEAR(with["hclpf"].get<double>() / five, std::exp(-1.645 * 0.3), 1e-12);
    EXPECT_EQ(with["five_percent_point"], five);
    EXPECT_TRUE(without["hclpf"].is_null());
    EXPECT_NEAR(with["median_at_95"].get<double>() / with["median"].get<double>(), std::exp(-1.6448536269514722 * 0.3),
                1e-12);
    auto const text = single_blanks(overturn(folder, {"fit", "--stripes", "t.csv"}).out);
    EXPECT_NE(text.find(" at least at least (AUC)\n"), std::string::npos) << text;
    auto const least = std::floor(1e4 * without["five_percent_point_lower"].get<double>()) / 1e4;
    EXPECT_NE(text.find(fmt::format(" {:.4g} - ", least)), std::string::npos) << text;
}

// the curve comes first, and a table of many single trials is not printed row by row unless asked for.
TEST_F(Fit, TheCurveComesBeforeItsTable) {
    std::string rows = "pga [g],collapsed\n";
    for (int i = 0; i < 50; ++i) {
        rows += fmt::format("{},{}\n", 0.5 + 0.02 * i, (i * i) % 50 < i ? 1 : 0);
    }
    folder.write("t.csv", rows);
    auto const text = overturn(folder, {"fit", "--stripes", "t.csv"}).out;
    auto const full = overturn(folder, {"fit", "--stripes", "t.csv", "--full"}).out;

    EXPECT_LT(text.find("fragility"), text.find("pga [g] of 0.5 to 1.48, 50 in all: --full shows each")) << text;
    EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 10) << text;
    EXPECT_LT(full.find("fragility"), full.find("trials  overturned")) << full;
    EXPECT_GT(std::count(full.begin(), full.end(), '\n'), 50) << full;
}

// Nothing overturned, everything, one level, separation: null, never a number.
TEST_F(Fit, NotIdentifiableIsNull) {
    for (std::string const rows : {"1,50,0\n2,50,0\n", "1,50,50\n2,50,50\n", "1,50,7\n", "1,50,0\n2,50,50\n",
                                   "1,50,20\n2,50,10\n", "1,50,0\n2,50,1\n3,50,0\n"}) {
        auto const fit = table("amplitude,trials,overturned\n" + rows);
        auto const& curve = fit["fragility"][0];

        EXPECT_EQ(curve["identifiable"], false) << rows;
        for (auto const* key : {"median", "beta", "median_lower", "beta_upper", "hclpf", "profile_median_lower",
                                "bootstrap_beta_upper"}) {
            ASSERT_TRUE(curve.contains(key)) << key;
            EXPECT_TRUE(curve[key].is_null()) << key << " of " << rows;
        }
        EXPECT_FALSE(curve["flags"].empty()) << rows;
        EXPECT_FALSE(fit["warnings"].empty()) << rows;
    }
}

TEST_F(Fit, BadTablesAreRefusedWhereTheyAreWrong) {
    std::string const head = "amplitude,trials,overturned\n";
    refuse("", "t.csv: empty");
    refuse(head, "no stripe");
    refuse("amplitude,trials,tipped\n1,2,1\n", "t.csv:1:18: column 'tipped'");
    refuse("amplitude,trials\n1,2\n", "no column 'overturned'");
    refuse("amplitude,trials,trials,overturned\n1,2,2,1\n", "t.csv:1:18: column 'trials' twice");
    refuse(head + "1,54\n", "2 columns");
    refuse(head + "1,54,x\n", "t.csv:2:6: 'x'");
    refuse(head + "\n1,54, 55\n", "t.csv:3:7: 55 overturned");
    refuse(head + "0,54,1\n", "t.csv:2:1: amplitude 0");
    refuse(head + "-1,54,1\n", "amplitude -1");
    refuse(head + "nan,54,1\n", "not a number");
    refuse(head + "1,5.5,1\n", "not a count");
    refuse(head + "1,54,-1\n", "not a count");
    refuse(head + "1,0,0\n", "no trial");
    refuse(head + "1,54,1\n1,54,2\n", "t.csv:3:1: amplitude 1 twice");
    refuse("amplitude;trials;overturned\n1,5;54;2\n", "t.csv:2:1: '1,5'");
    refuse("# PGA in gal\npga [g],trials,overturned\n0.3,54,2\n0.5,54,9\n",
           "t.csv:1: '# PGA in gal' beside column 'pga [g]' (two units of it");
    EXPECT_EQ(overturn(folder, {"fit"}).code, 2);
    for (auto const* line : {"# PGA in g", "# PGA in g, 0.3 g is 294 gal", "# scaled to a PGA", "# PGA in gal or g"}) {
        folder.write("t.csv", std::string(line) + "\npga [g],trials,overturned\n0.3,54,2\n0.5,54,9\n");
        auto const ended = overturn(folder, {"fit", "--stripes", "t.csv"});
        EXPECT_EQ(ended.code, 0) << line << ended.err;
    }
    folder.write("t.csv", head + "1,54,2\n2,54,40\n");
    for (auto const* confidence : {"0", "0.1", "0.49", "1"}) {
        auto const ended = overturn(folder, {"fit", "--stripes", "t.csv", "--confidence", confidence});
        EXPECT_EQ(ended.code, 2) << confidence;
        EXPECT_NE(ended.err.find("must be at least 0.5"), std::string::npos) << ended.err;
    }
    auto const half = overturn(folder, {"fit", "--stripes", "t.csv", "--confidence", "0.5", "--full"});
    EXPECT_EQ(half.code, 0) << half.err;
    EXPECT_NE(half.out.find("rank (AUC): chance that a trial that overturned"), std::string::npos) << half.out;
    EXPECT_EQ(overturn(folder, {"fit", "no.csv", "--stripes", "t.csv"}).code, 2);
    EXPECT_EQ(overturn(folder, {"fit", "--stripes", "none.csv"}).code, 2);
}

// nothing says of how many waves trials alone at their levels are: as few as a curve needs, unless it is stated.
TEST_F(Fit, TrialsAloneAtTheirLevelsMayBeOfFiveWaves) {
    std::string rows = "pga [g],overturned\n";
    for (int i = 0; i < 40; ++i) {
        rows += fmt::format("{:.3f},{}\n", 0.2 + 0.02 * i, i > 28 || (i > 8 && i % 2 == 0) ? 1 : 0);
    }
    folder.write("alone.csv", rows);
    auto const of = [&](std::vector<std::string> const& more) {
        std::vector<std::string> arguments{"fit", "--stripes", "alone.csv", "--json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        auto const ended = overturn(folder, arguments);
        EXPECT_EQ(ended.code, 0) << ended.err;
        return json::parse(ended.out);
    };
    auto const unstated = of({});
    auto const stated = of({"--waves", "40"});
    auto const& row = unstated["fragility"][0];
    ASSERT_EQ(row["state"], "fitted");
    EXPECT_EQ(row["interval_method"], "widest");
    EXPECT_TRUE(row["waves"].is_null());
    EXPECT_TRUE(row["bootstrap_median_lower"].is_null()) << "resampling one trial a level changes nothing";
    EXPECT_LT(row["five_percent_point_lower"], 0.8 * stated["fragility"][0]["five_percent_point_lower"].get<double>());
    EXPECT_EQ(stated["fragility"][0]["interval_method"], "profile-likelihood");
    EXPECT_EQ(stated["fragility"][0]["waves"], 40);
    auto const words = unstated["warnings"].dump();
    EXPECT_NE(words.find("these 40 trials may be of 5 alone"), std::string::npos) << words;
    EXPECT_NE(words.find("(--waves)"), std::string::npos) << words;
    EXPECT_EQ(stated["warnings"].dump().find("not named"), std::string::npos);
}

/// From a results file: a curve per body and measure, the criterion of both measures, a verdict in words.
TEST_F(Fit, ResultsFile) {
    folder.write("target.csv", target_csv);
    folder.write("c.toml", small_campaign("shared", 20));
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "--set", "levels.values=['600 gal','1200 gal','2000 gal']"}).code, 0);
    auto const fit = json::parse(overturn(folder, {"fit", "c.h5", "--json"}).out);

    std::vector<std::string> measures;
    for (auto const& curve : fit["fragility"]) {
        if (curve["body"] == "type-b") {
            measures.push_back(curve["measure"]);
        }
        for (auto const* key : {"identifiable", "median", "beta", "median_lower", "median_upper", "beta_lower",
                                "five_percent_point", "hclpf", "flags"}) {
            EXPECT_TRUE(curve.contains(key)) << key;
        }
        EXPECT_EQ(curve["identifiable"].get<bool>(), !curve["median"].is_null());
        EXPECT_EQ(curve["waves"], 20);
    }
    EXPECT_EQ(measures, (std::vector<std::string>{"pga", "pgv", "v_wes", "ou_v_e", "v_wes_ratio"}));
    ASSERT_EQ(fit["criterion"].size(), 4U);
    EXPECT_EQ(fit["criterion"][0]["false_safe_share_of"].get<int>(),
              fit["criterion"][0]["false_safe"].get<int>() + fit["criterion"][0]["true_safe"].get<int>());
    auto const criterion = overturn(folder, {"fit", "c.h5", "--section", "criterion"}).out;
    EXPECT_NE(criterion.find("\n[lower, upper]: 95 % interval; it counts all trials of a wave as one, since they may "
                             "end alike\n"),
              std::string::npos)
        << criterion;
    ASSERT_EQ(fit["verdict"].size(), 2U);
    auto const& at_basis = fit["probabilities"][0];
    EXPECT_EQ(at_basis["measure"], "pga");
    EXPECT_EQ(at_basis["multiple"], 1);
    EXPECT_EQ(at_basis["amplitude"], 6);
    EXPECT_EQ(at_basis["trials"], 20);
}

// Type B's restitution is drawn, type A is known exactly: beta^2 = beta_R^2 + beta_U^2, and HCLPF takes them
// apart.
TEST_F(Fit, ReportsThePartOfBetaFromTheBody) {
    folder.write("target.csv", target_csv);
    folder.write("c.toml", small_campaign("shared", 40));
    ASSERT_EQ(
        overturn(folder, {"run", "c.toml", "--set", "levels.values=['600 gal','900 gal','1200 gal','1600 gal']"}).code,
        0);
    auto const fit = json::parse(overturn(folder, {"fit", "c.h5", "--json"}).out);
    int drawn = 0;
    for (auto const& curve : fit["fragility"]) {
        if (!curve["identifiable"].get<bool>()) {
            continue;
        }
        double const r = curve["beta_r"];
        double const u = curve["beta_u"];
        double const beta = curve["beta"];
        auto const of_it = of_curve(fit["drawn"], curve);
        if (curve["body"] == "type-a" || of_it.empty()) {
            EXPECT_TRUE(of_it.empty());
            EXPECT_EQ(curve["hclpf"], nullptr);
            EXPECT_EQ(u, 0);
            EXPECT_EQ(r, beta);
            continue;
        }
        ++drawn;
        if (curve["five_percent_point"].is_null()) {
            EXPECT_EQ(curve["hclpf"], nullptr);
        } else {
            EXPECT_NEAR(curve["hclpf"].get<double>() / (curve["median"].get<double>() * std::exp(-1.645 * (r + u))), 1,
                        1e-9);
            EXPECT_LE(curve["hclpf_lower"].get<double>(), curve["hclpf"].get<double>());
        }
        EXPECT_NEAR(std::hypot(r, u), std::max(beta, u), 1e-12);
        EXPECT_EQ(of_it[0]["quantity"], "restitution");
        EXPECT_LT(of_it[0]["log_median_per_deviation"].get<double>(), 0) << "livelier bodies fall earlier";
    }
    EXPECT_GT(drawn, 0);

    // What is stated comes on top of what was drawn, and lessens no beta_R.
    auto const both = json::parse(overturn(folder, {"fit", "c.h5", "--json", "--beta-u", "0.3"}).out);
    for (std::size_t i = 0; i < fit["fragility"].size(); ++i) {
        auto const& before = fit["fragility"][i];
        auto const& after = both["fragility"][i];
        if (before["hclpf"].is_number()) {
            EXPECT_EQ(after["beta_r"], before["beta_r"]);
            EXPECT_NEAR(after["beta_u"].get<double>(), std::hypot(before["beta_u"].get<double>(), 0.3), 1e-12);
            EXPECT_EQ(after["beta_u_drawn"], before["beta_u_drawn"]);
        }
    }
}

// a campaign states beta_U: `run`, the file and `fit` then give HCLPF, as --beta-u does, which outranks
// it. It moves no trial. Without it the answer says what is missing.
TEST_F(Fit, TakesBetaUOfTheCampaign) {
    folder.write("target.csv", target_csv);
    std::string const levels = "levels.values=['600 gal','700 gal','800 gal','900 gal']";
    auto campaign = small_campaign("shared", 20);
    std::string const drawn = "{distribution='lognormal',median=0.85,beta=0.1}";
    campaign.replace(campaign.find(drawn), drawn.size(), "0.85");
    folder.write("c.toml", campaign);
    auto const plain = overturn(folder, {"run", "c.toml", "--set", levels});
    ASSERT_EQ(plain.code, 0) << plain.err;
    EXPECT_NE(plain.out.find("unknown: needs beta_U; 5 % point "), std::string::npos) << plain.out;
    EXPECT_NE(plain.out.find("it needs beta_U, the spread of the median"), std::string::npos) << plain.out;
    folder.write("u.toml", campaign + "[statistics]\nbeta_u={value=0.3,basis='assumed',source='usual'}\n");
    auto const stated = overturn(folder, {"run", "u.toml", "--set", levels});
    ASSERT_EQ(stated.code, 0) << stated.err;
    EXPECT_NE(stated.out.find("; by beta_U 0.3, assumed\n"), std::string::npos) << stated.out;
    auto const curves = [&](std::vector<std::string> const& arguments) {
        return json::parse(overturn(folder, joined(joined({"fit"}, arguments), {"--json"})).out).at("fragility");
    };
    auto const by_key = curves({"u.h5"});
    EXPECT_EQ(by_key, curves({"c.h5", "--beta-u", "0.3"}));
    EXPECT_TRUE(std::ranges::any_of(by_key, [](json const& curve) { return curve.at("hclpf").is_number(); }));
    EXPECT_EQ(curves({"u.h5", "--beta-u", "0.2"}), curves({"c.h5", "--beta-u", "0.2"}));
    for (std::string const none : {"0", "-0", "-0.3", "nan", "inf"}) {
        folder.write("none.toml", campaign + "[statistics]\nbeta_u=" + none + "\n");
        for (auto const& ended :
             {overturn(folder, {"fit", "u.h5", "--beta-u=" + none}),
              overturn(folder, {"fit", "c.h5", "--beta-u=" + none}),
              overturn(folder, {"report", "c.h5", "-o", "page.html", "--beta-u=" + none}),
              overturn(folder, {"fit", "--median", "0.9 g", "--beta", "0.4", "--beta-u=" + none})}) {
            EXPECT_EQ(ended.code, 2) << none << ": " << ended.out;
            EXPECT_TRUE(is_one_error_line(ended.err)) << none;
            EXPECT_NE(ended.err.find("must be above 0, as statistics.beta_u"), std::string::npos) << ended.err;
        }
        auto const key = overturn(folder, {"run", "none.toml"});
        EXPECT_EQ(key.code, 2) << none;
        EXPECT_NE(key.err.find("statistics.beta_u"), std::string::npos) << key.err;
    }
    auto const other = overturn(folder, {"fit", "u.h5", "--beta-u", "0.2"}).out;
    EXPECT_NE(other.find("; by beta_U 0.2\n"), std::string::npos) << other;
    EXPECT_EQ(store::ResultsReader(folder / "u.h5").reals("trials/peak_rotation"),
              store::ResultsReader(folder / "c.h5").reals("trials/peak_rotation"));
    auto const refused = overturn(folder, {"plan", "c.toml", "--set", "statistics.beta_u=30"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_NE(refused.err.find("statistics.beta_u"), std::string::npos) << refused.err;
}

}  // namespace
}  // namespace overturn::testing
