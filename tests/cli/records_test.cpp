// Requirement: records mean what they say: a baseline that drifts is corrected, or its PGV and PGD are no
// levels.
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/python.hpp"
#include "core/outward.hpp"
#include "core/units.hpp"
#include "store/results_file.hpp"
#include "support/command.hpp"
#include "support/line_width.hpp"

namespace overturn::testing {
namespace {

using nlohmann::json;

std::string const body = "mass='12.6 t'\nbase_width='0.9 m'\ncentre_height='1.045 m'\ninertia='uniform-block'\n";

// Two seconds of period, 40 s, with an offset [gal] that shortens the period a little.
std::string record(double offset) {
    std::string text = "time_s,acc (gal)\n";
    for (int i = 0; i <= 4000; ++i) {
        double const t = 0.01 * i;
        double const hill = std::pow(std::sin(pi * t / 40), 2);
        text += fmt::format("{:.2f},{:.6f}\n", t, 100 * hill * std::sin((1 + 0.001 * offset) * pi * t) + offset);
    }
    return text;
}

std::string campaign(std::string const& waves, std::string const& measure, std::string const& values) {
    return "seed=1\n[waves]\nsource='records'\n" + waves + "[[bodies]]\nname='b'\n" + body + "[levels]\nmeasure='"
           + measure + "'\nvalues=[" + values + "]\n";
}

class RecordsOnTheLine : public ::testing::Test {
  protected:
    RecordsOnTheLine() {
        folder.write("drifts.csv", record(4.4));
        folder.write("rests.csv", record(0));
        folder.write("body.toml", body);
    }
    // r0.csv, r1.csv, ...
    void write_records(int count) {
        for (int i = 0; i < count; ++i) {
            folder.write(fmt::format("r{}.csv", i), record(0.2 * i));
        }
    }
    static std::string files_of(int count) {
        std::string files;
        for (int i = 0; i < count; ++i) {
            files += fmt::format("{}'r{}.csv'", i == 0 ? "" : ",", i);
        }
        return "files=[" + files + "]\n";
    }
    Folder folder;
};

//
TEST_F(RecordsOnTheLine, DriftingPgvIsNoLevel) {
    std::string const files = "files=['rests.csv','drifts.csv']\n";
    folder.write("c.toml", campaign(files, "pgv", "'50 kine'"));
    auto const refused = overturn(folder, {"run", "c.toml"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_TRUE(is_one_error_line(refused.err));
    for (char const* part : {"c.toml:12:9: levels.measure: pgv of wave 1 (which ends at 176 kine (",
                             "State a baseline in [waves], for example baseline = {high_pass = \"0.05 Hz\"}"}) {
        EXPECT_NE(refused.err.find(part), std::string::npos) << refused.err;
    }
    folder.write("d.toml", campaign(files, "pgd", "'0.5 m'"));
    EXPECT_EQ(planned(folder, {"d.toml"}).code, 2);

    folder.write("c.toml", campaign(files + "baseline={high_pass='0.05 Hz'}\n", "pgv", "'50 kine'"));
    auto const plan = planned(folder, {"c.toml"});
    EXPECT_EQ(plan.code, 0) << plan.err;
    EXPECT_NE(plan.out.find("record    1: PGV 31.73 kine, PGD 0.1008 m, "), std::string::npos) << plan.out;
    EXPECT_EQ(plan.out.find("warning"), std::string::npos) << plan.out;
}

// A record that ends at rest and far away: no level by pgd without a word.
TEST_F(RecordsOnTheLine, PgdOfAFlingIsReported) {
    std::string text = "time_s,acc (gal)\n";
    for (int i = 0; i <= 2000; ++i) {
        text += fmt::format("{:.2f},{:.6f}\n", 0.01 * i, 20 * std::sin(pi * i / 1000.0));
    }
    folder.write("fling.csv", text);
    folder.write("c.toml", campaign("files=['fling.csv']\n", "pgd", "'1 m'"));
    auto const plan = planned(folder, {"c.toml"});
    EXPECT_NE(plan.out.find("levels by pgd scale by what it is left at"), std::string::npos) << plan.out << plan.err;
}

TEST_F(RecordsOnTheLine, DriftIsReportedWhereLevelsDoNotNeedIt) {
    folder.write("c.toml", campaign("files=['drifts.csv']\n", "pga", "'300 gal'"));
    char const* const warning = "record 'drifts.csv' ends at 1.76 m/s (";
    EXPECT_NE(planned(folder, {"c.toml"}).out.find(warning), std::string::npos);
    auto const run = overturn(folder, {"run", "c.toml"});
    EXPECT_NE(run.err.find(std::string("warning: ") + warning), std::string::npos) << run.err;
    EXPECT_NE(overturn(folder, {"wave", "c.toml", "--wave", "0", "-o", "w.csv"}).err.find(warning), std::string::npos);
    auto const rock = overturn(folder, {"rock", "--body", "body.toml", "--wave", "drifts.csv"});
    EXPECT_NE(unwrapped(rock.out).find("its baseline drifts, correct it with --baseline"), std::string::npos)
        << rock.out;
    // PGA in the units that records are written in, and no line is wider than a terminal.
    auto const shown = overturn(folder, {"spectrum", "--wave", "drifts.csv"}).out;
    auto const pga =
        json::parse(overturn(folder, {"spectrum", "--wave", "drifts.csv", "--json"}).out)["pga_mps2"].get<double>();
    EXPECT_NE(shown.find(fmt::format(" m/s2 = {:.2f} gal = {:.4g} g, ", 100 * pga, pga / 9.80665)), std::string::npos)
        << shown;
    EXPECT_NE(unwrapped(shown).find("its baseline drifts, correct it with --baseline"), std::string::npos) << shown;
    std::istringstream lines(shown);
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(line.size(), 100U) << line;
    }
    auto const spectrum = [&](std::string const& baseline) {
        return json::parse(
            overturn(folder, {"spectrum", "--wave", "drifts.csv", "--json", "--baseline", baseline}).out);
    };
    EXPECT_NEAR(spectrum("none")["residual_velocity_mps"].get<double>(), 1.76, 0.01);
    EXPECT_LT(std::abs(spectrum("polynomial")["residual_velocity_mps"].get<double>()), 1e-6);
    EXPECT_LT(spectrum("polynomial")["pgv_mps"].get<double>(), 0.36);
    EXPECT_EQ(overturn(folder, {"spectrum", "--wave", "rests.csv"}).out.find("drifts"), std::string::npos);
}

// in ft, where bodies are in ft; 4.4 gal over 40 s are 1.76 m/s and 35.2 m.
TEST_F(RecordsOnTheLine, DriftIsInTheUnitsOfTheCampaign) {
    auto in_feet = campaign("files=['drifts.csv']\n", "pga", "'0.3 g'");
    auto const at = in_feet.find("'0.9 m'");
    in_feet.replace(at, 7, "'3 ft'");
    folder.write("c.toml", in_feet);
    auto const plan = planned(folder, {"c.toml", "--full"});
    auto const text = unwrapped(plan.out);
    EXPECT_NE(text.find("record 'drifts.csv' ends at 5.77 ft/s ("), std::string::npos) << text;
    EXPECT_TRUE(std::regex_search(text, std::regex("of its PGV\\), 11[56] ft from where it began"))) << text;
    EXPECT_EQ(text.find(" m/s"), std::string::npos) << text;
}

// what was read is said, so that a reader can be checked: format, components, unit, step, count, duration.
TEST_F(RecordsOnTheLine, TheReadingIsReported) {
    char const* const line = "columns, acc (gal), gal, 0.01 s, 4001 samples, 40 s\n";
    EXPECT_TRUE(overturn(folder, {"spectrum", "--wave", "rests.csv"}).out.starts_with(std::string("read as ") + line));
    EXPECT_NE(overturn(folder, {"rock", "--body", "body.toml", "--wave", "rests.csv"})
                  .out.find(std::string("read as          ") + line),
              std::string::npos);
    auto const record = json::parse(overturn(folder, {"spectrum", "--wave", "rests.csv", "--json"}).out)["record"];
    EXPECT_TRUE(record["statements"].is_array());
    EXPECT_EQ(record["format"], "columns");
    EXPECT_EQ(record["components"], json::array({"acc (gal)"}));
    EXPECT_EQ(record["unit"], "gal");
    EXPECT_NEAR(record["time_step_s"].get<double>(), 0.01, 1e-12);
    EXPECT_EQ(record["samples"], 4001);
    EXPECT_NEAR(record["duration_s"].get<double>(), 40, 1e-9);
}

// a record that levels scale by more than five is said, before any work.
TEST_F(RecordsOnTheLine, ScaledRecordsAreReported) {
    std::string const line = "record 'rests.csv' is scaled by up to ";
    folder.write("c.toml", campaign("files=['rests.csv']\n", "pga", "'300 gal'"));
    EXPECT_EQ(planned(folder, {"c.toml"}).out.find(line), std::string::npos);
    folder.write("c.toml", campaign("files=['rests.csv']\nscale=2\n", "pga", "'300 gal','900 gal'"));
    auto const plan = planned(folder, {"c.toml"});
    EXPECT_NE(plan.out.find(line + "9.02: beyond 5"), std::string::npos) << plan.out;
    EXPECT_NE(overturn(folder, {"run", "c.toml"}).err.find(line), std::string::npos);
    for (char const* measure : {"sa'\nperiod='2 s", "cav"}) {
        folder.write("c.toml", campaign("files=['rests.csv']\n", measure, "1000"));
        auto const high = overturn(folder, {"plan", "c.toml"});
        EXPECT_NE(high.out.find(line), std::string::npos) << measure << high.out << high.err;
    }
}

// the largest factor is one number in the warning and in the caution, rounded up: 9.0536 is 9.06.
TEST_F(RecordsOnTheLine, TheLargestFactorIsOneNumber) {
    double const peak = json::parse(overturn(folder, {"spectrum", "--wave", "rests.csv", "--json"}).out)["pga_mps2"];
    folder.write("c.toml", campaign("files=['rests.csv']\n", "pga", fmt::format("{:.12g}", 9.0536 * peak)));
    auto const run = overturn(folder, {"run", "c.toml"});
    EXPECT_NE(unwrapped(run.err).find("is scaled by up to 9.06: beyond 5"), std::string::npos) << run.err;
    EXPECT_NE(unwrapped(run.out).find("is scaled by more than 5, up to 9.06: "), std::string::npos) << run.out;
}

// how many records drift, or are scaled by more than five, stands with the answer: also where the file
// has their hashes alone, so that nobody knows.
TEST_F(RecordsOnTheLine, DriftAndScaleStandWithTheAnswer) {
    auto const answered = [&](std::string const& waves, std::string const& values) {
        folder.write("c.toml", campaign(waves, "pga", values));
        std::filesystem::remove(folder / "c.h5");
        auto const ended = overturn(folder, {"run", "c.toml"});
        EXPECT_EQ(ended.code, 0) << ended.err;
        EXPECT_EQ(unwrapped(overturn(folder, {"fit", "c.h5"}).out).find("caution:") != std::string::npos,
                  unwrapped(ended.out).find("caution:") != std::string::npos);
        return unwrapped(ended.out);
    };
    std::string const three = "files=['rests.csv','drifts.csv','r1.csv']\n";
    write_records(2);
    auto const both = answered(three + "scale=2\n", "'300 gal','900 gal'");
    EXPECT_NE(both.find("caution: 2 of 3 records drift, 3 are scaled by more than 5, up to 9.0"), std::string::npos)
        << both;
    auto const drift = answered(three, "'300 gal'");
    EXPECT_NE(drift.find("caution: 2 of 3 records drift: "), std::string::npos) << drift;
    EXPECT_EQ(answered("files=['rests.csv']\n", "'300 gal'").find("caution:"), std::string::npos);
    auto const scaled = answered("files=['rests.csv']\nscale=2\n", "'900 gal'");
    EXPECT_NE(scaled.find("caution: 1 of 1 record is scaled by more than 5, up to 9.0"), std::string::npos) << scaled;

    folder.write("c.toml", "inputs='hash-only'\n" + campaign(three, "pga", "'300 gal'"));
    std::filesystem::remove(folder / "c.h5");
    ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
    auto const withheld = unwrapped(overturn(folder, {"fit", "c.h5"}).out);
    EXPECT_NE(withheld.find("whether records drift or are scaled by more than 5 is not known here"), std::string::npos)
        << withheld;
}

// what a baseline correction does to PGA, PGV, PGD and Sa is said by every verb that makes one.
TEST_F(RecordsOnTheLine, TheEffectOfABaselineIsReported) {
    folder.write("c.toml", campaign("files=['drifts.csv']\nbaseline='mean'\n", "pga", "'100 gal'"));
    for (auto const& arguments : std::vector<std::vector<std::string>>{
             {"plan", "c.toml"}, {"spectrum", "--wave", "drifts.csv", "--baseline", "mean"}}) {
        auto const ended = overturn(folder, arguments);
        auto const told = unwrapped(ended.out) + ended.err;
        auto const at = told.find("mean taken off (PGA ");
        ASSERT_NE(at, std::string::npos) << told;
        for (auto const* part : {", PGV -", ", PGD -", ", Sa from 0.3 to 10 s by "}) {
            EXPECT_NE(told.find(part, at), std::string::npos) << part << told;
        }
    }
}

// of few recorded motions each is a row, with how near it came to a limit; of drawn waves none is.
TEST_F(RecordsOnTheLine, OfFewEachIsARow) {
    folder.write("c.toml", campaign("files=['rests.csv']\n", "pga", "'1 g', '3 g'")
                               + "[[limits]]\nname='tilts'\nquantity='peak_rotation_ratio'\nabove=0.5\n");
    auto const run = overturn(folder, {"run", "c.toml"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.out, overturn(folder, {"fit", "c.h5"}).out + "results: c.h5\n");
    EXPECT_EQ(run.out.find("tilt [deg]"), run.out.find("tilt [deg]", run.out.find("\n== records\n")))
        << "percentiles of one";
    store::ResultsReader const file(folder / "c.h5");
    auto const ratios = file.reals("trials/peak_rotation_ratio");
    auto const at = run.out.find("\n== records\n");
    ASSERT_NE(at, std::string::npos) << run.out;
    for (std::size_t t = 0; t < ratios.size(); ++t) {
        bool const fell = ratios[t] > 1;  // it passed every limit, by no ratio of this one's
        auto const said = fell ? std::string("fell\n") : fmt::format("{:.3g} of tilts\n", ratios[t] / 0.5);
        EXPECT_NE(run.out.find(said, at), std::string::npos) << run.out;
    }
    EXPECT_NE(run.out.find("rests.csv", at), std::string::npos) << run.out;
    auto const fit = nlohmann::json::parse(overturn(folder, {"fit", "c.h5", "--json"}).out);
    auto const& rows = fit.at("records");
    ASSERT_EQ(rows.size(), ratios.size());
    EXPECT_EQ(rows[0].at("record"), "rests.csv");
    EXPECT_EQ(rows[0].at("peak_rotation_rad"), file.reals("trials/peak_rotation")[0]);
    EXPECT_TRUE(rows[0].at("peak_slip_m").is_null()) << "without friction nothing slips";
}

// a row that does not fit a line goes on below, again behind its record, body and level; the ratio of the tilt
// to alpha, which is the limit of overturning, is rounded up.
TEST_F(RecordsOnTheLine, EachRowOfFewNamesItsTrial) {
    auto text = campaign("files=['rests.csv']\n", "pga", "'0.1 g', '1 g'");
    text.replace(text.find("[[bodies]]"), 10, "[[bodies]]\nfriction=0.9");
    text.insert(text.find("[levels]"), "[[bodies]]\nname='the second of the two'\nfriction=0.3\n" + body);
    folder.write("c.toml",
                 text + "[[limits]]\nname='leaves-the-pad-to-the-north'\nquantity='peak_slip'\nabove='1 mm'\n");
    auto const run = overturn(folder, {"run", "c.toml"});
    ASSERT_EQ(run.code, 0) << run.err;
    std::istringstream lines(run.out.substr(run.out.find("\n== records\n") + 12));
    int rows = 0;
    for (std::string line; std::getline(lines, line) && !line.empty();) {
        if (line.starts_with("rests.csv")) {
            ++rows;
            EXPECT_TRUE(line.find("  b  ") != std::string::npos
                        || line.find("  the second of the two  ") != std::string::npos)
                << line;
            EXPECT_TRUE(line.find(" 0.1 g ") != std::string::npos || line.find(" 1 g ") != std::string::npos) << line;
        }
    }
    EXPECT_EQ(rows, 8) << "two blocks of four trials\n" << run.out;
    EXPECT_EQ(too_wide(run.out), "");
    store::ResultsReader const file(folder / "c.h5");
    for (auto const ratio : file.reals("trials/peak_rotation_ratio")) {
        EXPECT_TRUE(ratio > 1 || ratio == 0
                    || run.out.find(fmt::format(" {:.3g}  ", rounded_up(ratio))) != std::string::npos)
            << ratio << run.out;
    }
}

// What fell slid until it fell: no slip of it stands beside those of bodies that stand.
TEST_F(RecordsOnTheLine, WhatFellHasNoSlip) {
    auto text = campaign("files=['rests.csv']\n", "pga", "'0.1 g', '3 g'");
    text.replace(text.find("name='b'\n"), 9, "name='b'\nfriction=1.2\n");
    folder.write("c.toml", text);
    auto const run = overturn(folder, {"run", "c.toml"});
    ASSERT_EQ(run.code, 0) << run.err;
    auto const records = run.out.substr(run.out.find("\n== records\n"));
    auto const at = records.find(" overturned ");
    ASSERT_NE(at, std::string::npos) << records;
    auto const row = records.substr(at, records.find('\n', at) - at);
    EXPECT_NE(row.find("fell"), row.rfind("fell")) << "slip and tilt: " << row;
    EXPECT_LT(records.find(" at-rest "), at) << "the control: " << records;
}

// fewer than five records give counts and no probability: in the text, in JSON (null, with the reason) and in
// the headlines of the page. Five give one.
TEST_F(RecordsOnTheLine, OfFewerThanFiveThereIsNoProbability) {
    folder.write("c.toml", campaign("files=['rests.csv']\n", "pga", "'1 g', '3 g'"));
    auto const run = overturn(folder, {"run", "c.toml"});
    ASSERT_EQ(run.code, 0) << run.err;
    auto const answer = run.out.substr(0, run.out.find("\n== "));
    EXPECT_NE(answer.find("1 record: no probability, which needs 5 or more"), std::string::npos) << answer;
    EXPECT_NE(answer.find(" overturned "), std::string::npos) << answer;
    EXPECT_NE(answer.find(" of 1 "), std::string::npos) << answer;
    EXPECT_NE(answer.find("HCLPF      needs 5 records or more (1 here)\n"), std::string::npos) << answer;
    for (auto const* const none : {"P(", "P <=", "0.975", "95 %"}) {
        EXPECT_EQ(answer.find(none), std::string::npos) << none << " in\n" << answer;
    }
    auto const rows = json::parse(overturn(folder, {"fit", "c.h5", "--json"}).out).at("answer");
    ASSERT_EQ(rows.size(), 2U);
    for (auto const& row : rows) {
        for (auto const* const name : {"probability", "lower", "upper", "hclpf", "peak_rotation_ratio_p95"}) {
            EXPECT_TRUE(row.at(name).is_null()) << row;
        }
        EXPECT_EQ(row.at("no_probability"), "1 record: no probability, which needs 5 or more");
        EXPECT_EQ(row.at("trials"), 1);
    }

    write_records(5);
    folder.write("five.toml", campaign(files_of(5), "pga", "'1 g', '3 g'"));
    auto const five = overturn(folder, {"run", "five.toml"});
    EXPECT_NE(five.out.find(" P(overturn) "), std::string::npos) << five.out << five.err;
    EXPECT_EQ(five.out.find("no probability"), std::string::npos) << five.out;
    EXPECT_TRUE(five.out.starts_with("5 waves; 95 % intervals\n")) << "slip and tilt are rows of records\n" << five.out;
    EXPECT_TRUE(json::parse(overturn(folder, {"fit", "five.h5", "--json"}).out)
                    .at("answer")
                    .at(0)
                    .at("no_probability")
                    .is_null());
}

// nor is there one anywhere else: four records that would hold a curve give counts in every table of the file,
// of JSON and of the text, and no curve, percentile or annual frequency.
TEST_F(RecordsOnTheLine, OfFewerThanFiveNoTableHasAProbability) {
    write_records(5);
    auto const levels = "'0.3 g', '0.42 g', '0.44 g', '0.5 g', '1 g'";
    folder.write("four.toml", campaign(files_of(4), "pga", levels));
    folder.write("five.toml", campaign(files_of(5), "pga", levels));
    folder.write("hazard.csv", "pga [g], annual_exceedance\n0.1,1e-2\n5,1e-7\n");
    for (auto const* const name : {"four", "five"}) {
        auto const run = overturn(folder, {"run", fmt::format("{}.toml", name)});
        ASSERT_EQ(run.code, 0) << run.err;
    }
    auto const fit_of = [&](char const* file) {
        return json::parse(overturn(folder, {"fit", file, "--json", "--hazard", "hazard.csv", "--beta-u", "0.2"}).out);
    };
    auto const numbers = [](json const& fit) {
        std::size_t count = 0;
        for (auto const* const table : {"stripes", "fragility", "isotonic", "band", "probabilities", "together",
                                        "quantiles", "frequency", "criterion", "answer"}) {
            for (auto const& row : fit.value(table, json::array())) {
                for (auto const* const key : {"probability", "lower", "upper", "median", "p95", "hclpf",
                                              "mean_per_year", "false_alarm_share"}) {
                    count += row.contains(key) && !row.at(key).is_null() ? 1 : 0;
                }
            }
        }
        return count;
    };
    auto const four = fit_of("four.h5");
    EXPECT_EQ(numbers(four), 0U) << four.dump(1);
    EXPECT_GT(numbers(fit_of("five.h5")), 20U) << "the control";
    EXPECT_EQ(four.at("fragility").at(0).at("state"), "few-records");
    EXPECT_EQ(four.at("fragility").at(0).at("trials"), 20);
    auto const text = overturn(folder, {"fit", "four.h5", "--full", "--hazard", "hazard.csv", "--beta-u", "0.2"}).out;
    for (auto const* const none : {"P(", "P <=", "95 % interval", "a year"}) {
        EXPECT_EQ(text.find(none), std::string::npos) << none << " in\n" << text;
    }
    EXPECT_NE(text.find("4 records: no probability, which needs 5 or more"), std::string::npos) << text;
    auto const asked = overturn(folder, {"fit", "four.h5", "--section", "frequency", "--hazard", "hazard.csv"}).out;
    EXPECT_NE(asked.find("== frequency\n4 records: no probability"), std::string::npos) << asked;
    EXPECT_NE(asked.find("annual frequency needs 5 records or more (4 here)"), std::string::npos) << asked;
    if (has_python(folder, "h5py, matplotlib")) {
        auto const paged = overturn(folder, {"report", "four.h5", "-o", "p.html", "--hazard", "hazard.csv"});
        ASSERT_EQ(paged.code, 0) << paged.err;
        auto const page = folder.read("p.html");
        auto const row = page.find("<td", page.find("annual frequency of each limit state"));
        auto const cells = page.substr(row, page.find("</tr>", row) - row);
        EXPECT_NE(cells.find("not known"), std::string::npos) << cells;
        EXPECT_EQ(cells.find("beta_U"), std::string::npos) << cells;
    }
    auto const moved = overturn(folder, {"cost", "four.toml", "--sensitivity"});
    EXPECT_EQ(moved.code, 2) << moved.out;
    EXPECT_NE(moved.err.find("4 recorded motions (no probability, which needs 5 or more"), std::string::npos)
        << moved.err;
}

// eight rows of four stations are four samples: counts alone, and a warning that names two rows.
TEST_F(RecordsOnTheLine, ComponentsOfOneStationAreOneSample) {
    std::string files = "files=[";
    for (int station = 0; station < 5; ++station) {
        for (int component = 0; component < 2; ++component) {
            auto const name = fmt::format("s{}_{}.csv", station, component == 0 ? "NS" : "EW");
            folder.write(name, record(0.2 * (2 * station + component)));
            files += "'" + name + (station < 4 ? "'," : component == 0 ? "'," : "'");
        }
    }
    auto const levels = "'0.3 g', '0.42 g', '0.44 g', '0.5 g', '1 g'";
    folder.write("ten.toml", campaign(files + "]\n", "pga", levels));
    folder.write("eight.toml", campaign(files + "]\ncount=8\n", "pga", levels));
    auto const eight = overturn(folder, {"run", "eight.toml"});
    ASSERT_EQ(eight.code, 0) << eight.err;
    EXPECT_NE(eight.out.find("8 records of 4 recordings: no probability, which needs 5 recordings or more"),
              std::string::npos)
        << eight.out;
    EXPECT_NE(eight.err.find("'s0_NS.csv' and 's0_EW.csv' are components of one"), std::string::npos) << eight.err;
    auto const ten = overturn(folder, {"run", "ten.toml"});
    ASSERT_EQ(ten.code, 0) << ten.err;
    auto const fit = json::parse(overturn(folder, {"fit", "ten.h5", "--json"}).out);
    EXPECT_EQ(fit.at("waves_alike"), 2);
    auto const& stripe = fit.at("stripes").at(0);
    EXPECT_EQ(stripe.at("trials"), 10);
    // Nothing fell in ten trials of five stations: the exact upper end of 0 of 5.
    EXPECT_NEAR(stripe.at("upper").get<double>(), 1 - std::pow(0.025, 0.2), 1e-9) << stripe.dump();
}

// how far a site's limit is away is a length, not a ratio.
TEST_F(RecordsOnTheLine, ASitesNearestLimitIsALength) {
    folder.write("c.toml", campaign("files=['rests.csv']\n", "pga", "'0.01 g'") + "[site]\nwall='0.4 m'\n");
    auto const run = overturn(folder, {"run", "c.toml"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_NE(run.out.find("  400 mm to touches\n"), std::string::npos) << run.out;
    char const* const by_default = "\nat-rest: slid less than 1 mm, and no edge of its base rose 1 mm\n";
    EXPECT_NE(run.out.find(by_default), std::string::npos) << run.out;
    // In inches a default that nobody typed stays 1 mm; what was typed is as it was typed.
    auto const in_inches = campaign("files=['rests.csv']\n", "pga", "'0.01 g'") + "[site]\nwall='15 in'\n";
    auto const answered = [&](std::string const& more) {
        folder.write("i.toml", in_inches + more);
        std::filesystem::remove(folder / "i.h5");
        return overturn(folder, {"run", "i.toml"}).out;
    };
    auto const usual = answered("");
    EXPECT_NE(usual.find("  15 in to touches\n"), std::string::npos) << usual;
    EXPECT_NE(usual.find(by_default), std::string::npos) << usual;
    auto const typed = answered("[measures]\nslid_from='0.1 in'\n");
    EXPECT_NE(typed.find("\nat-rest: slid less than 0.1 in, and no edge of its base rose 1 mm\n"), std::string::npos)
        << typed;
}

// the program reads what it wrote, without a word on units.
TEST_F(RecordsOnTheLine, WaveOfACampaignIsReadBack) {
    folder.write("c.toml", campaign("files=['rests.csv']\n", "pga", "'300 gal'"));
    ASSERT_EQ(overturn(folder, {"wave", "c.toml", "--wave", "0", "-o", "w.csv"}).code, 0);
    auto const read = [&](char const* file) {
        return json::parse(overturn(folder, {"spectrum", "--wave", file, "--json"}).out);
    };
    EXPECT_EQ(read("w.csv")["pga_mps2"], read("rests.csv")["pga_mps2"]);
    EXPECT_EQ(read("w.csv")["record"]["unit"], "m/s2");
}

// a target that ends where a body rocks, and a wave that nobody has felt, are said before any work.
TEST_F(RecordsOnTheLine, TargetsThatSayTooLittleOrTooMuch) {
    auto const campaign_of = [](std::string const& target) {
        return "seed=1\n[waves]\nsource='spectrum-compatible'\ncount=1\nduration='40.96 s'\ntime_step='0.02 s'\n"
               "match='each'\nmatch_iterations=3\n[waves.target]\n"
               + target
               + "\n[waves.envelope]\nshape='jennings'\nrise='4 s'\nlevel_end='20 s'\nend='38 s'\n"
                 "[[bodies]]\nname='b'\n"
               + body + "[levels]\nmeasure='pga'\nvalues=['300 gal']\n";
    };
    auto const everywhere = [&](std::string const& target) {
        folder.write("t.toml", campaign_of(target));
        std::filesystem::remove(folder / "t.h5");
        return std::vector{planned(folder, {"t.toml"}).out, overturn(folder, {"run", "t.toml"}).err,
                           overturn(folder, {"wave", "t.toml", "--wave", "0", "-o", "w.csv"}).err};
    };
    auto const short_one = everywhere("kind='acceleration'\npoints=[[0.05,3],[0.3,5],[2,5]]");
    for (auto const& said : short_one) {
        EXPECT_NE(said.find("compared with their target from 0.05 s to 2 s only, but b rocks at 0.53 s to 5.33 s"),
                  std::string::npos)
            << said;
    }
    EXPECT_NE(short_one[2].find("SI ratio not covered"), std::string::npos) << short_one[2];
    EXPECT_NE(short_one[2].find("(compared from 0.05 s to 2.00 s only)"), std::string::npos) << short_one[2];
    for (auto const& said : everywhere("kind='acceleration'\npoints=[[2,5],[10,1]]")) {
        EXPECT_NE(said.find("from 2 s to 10 s only"), std::string::npos) << said;
    }
    folder.write("gal.csv", "period [s],Sa [gal]\n0.02,300\n0.1,700\n1,500\n10,80\n");
    folder.write("none.csv", "0.02,300\n0.1,700\n1,500\n10,80\n");
    for (auto const& said : everywhere("kind='acceleration'\nfile='gal.csv'")) {
        EXPECT_EQ(said.find("warning"), std::string::npos) << said;
    }
    folder.write("t.toml", campaign_of("kind='acceleration'\nfile='none.csv'"));
    auto const refused = planned(folder, {"t.toml"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_NE(refused.err.find("unit of the ordinates missing"), std::string::npos) << refused.err;
    for (auto const& said : everywhere("kind='acceleration'\nunit='m/s2'\nfile='none.csv'")) {
        EXPECT_NE(said.find(" g before any scaling"), std::string::npos) << said;
    }
    for (auto const& said : everywhere("kind='acceleration'\nunit='gal'\nfile='none.csv'")) {
        EXPECT_EQ(said.find("warning"), std::string::npos) << said;
    }
}

// The classic long-period records as they are found: sane amplitudes by PGV once their baseline is corrected.
TEST_F(RecordsOnTheLine, ClassicRecordsAtFiftyKine) {
    std::string const folder_of_records = std::getenv("OVERTURN_RECORDS") != nullptr
                                              ? std::getenv("OVERTURN_RECORDS")
                                              : std::string(OVERTURN_CAMPAIGNS) + "/../../shared/records";
    auto const files = folder_of_records + "/csv_two_column/";
    if (!std::filesystem::exists(files + "Hachinohe1968_HachinoheHarbour_NS.csv")) {
        GTEST_SKIP() << "no folder of records: set OVERTURN_RECORDS to one";
    }
    std::string const keys = "files=['" + files + "ImperialValley1940_ElCentro_NS.csv','" + files
                             + "Hachinohe1968_HachinoheHarbour_NS.csv']\nunit='gal'\n";
    folder.write("none.toml", campaign(keys, "pgv", "'50 kine'"));
    EXPECT_EQ(planned(folder, {"none.toml"}).code, 2);
    folder.write("c.toml", campaign(keys + "baseline='polynomial'\n", "pgv", "'50 kine'"));
    ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
    for (auto const& [wave, pgv_low, pgv_high, factor] :
         {std::tuple{0, 0.33, 0.38, 1.41}, std::tuple{1, 0.34, 0.41, 1.34}}) {
        auto const told = json::parse(
            overturn(folder, {"wave", "c.toml", "--wave", std::to_string(wave), "--json", "-o", "w.csv"}).out);
        double const pgv = told["pgv_mps"].get<double>();
        EXPECT_GT(pgv, pgv_low) << wave;
        EXPECT_LT(pgv, pgv_high) << wave;
        EXPECT_NEAR(0.5 / pgv, factor, 0.02) << wave;
        EXPECT_LT(told["pga_mps2"].get<double>() * 0.5 / pgv, 5) << wave;
        EXPECT_GT(told["pga_mps2"].get<double>() * 0.5 / pgv, 3) << wave;
    }
}

}  // namespace
}  // namespace overturn::testing
