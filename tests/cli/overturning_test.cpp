// Requirement R-410: `spectrum --overturning` gives every range of amplitude as text, JSON, csv and a figure, for a
// body file or a stated block, under pulses and under a record.
#include <algorithm>
#include <cmath>
#include <sstream>
#include <tuple>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "support/single_blanks.hpp"
#include "support/spectrum_verb.hpp"

namespace overturn::testing {
namespace {

using nlohmann::json;

class Overturning : public SpectrumVerb {
  protected:
    Overturning() : SpectrumVerb({"--overturning"}) {}

    std::vector<std::string> const block{"--p", "2", "--alpha", "0.25", "--restitution", "0.9"};
};

// The notch of the nonlinear block at omega/p = 5, known to seven digits; chords of the pulse miss 1e-6 of it.
TEST_F(Overturning, JsonAndCsvHoldTheNotch) {
    auto const shown = json::parse(
        done(joined(block, {"--pulse", "one-sine", "--ratios", "5", "--json", "-o", "o.csv", "--highest", "8"})).out);

    ASSERT_EQ(shown["points"].size(), 1U);
    auto const& point = shown["points"][0];
    EXPECT_NEAR(point["omega_over_p"], 5, 1e-12);
    EXPECT_NEAR(point["frequency_hz"], 5 * 2 / (2 * M_PI), 1e-12);
    EXPECT_NEAR(point["overturning_over_alpha_g"], 3.032339, 3e-6 * 3);
    EXPECT_EQ(point["stands_to_mps2"], point["overturning_mps2"]);
    EXPECT_NEAR(point["uplift_mps2"], std::tan(0.25) * 9.80665, 1e-9);
    auto const& ranges = point["ranges"];
    ASSERT_EQ(ranges.size(), 4U) << ranges;
    EXPECT_EQ(ranges[1]["fate"], "overturns-with-impact");
    EXPECT_NEAR(ranges[1]["to_over_alpha_g"], 6.743019, 3e-6 * 7);
    EXPECT_EQ(ranges[2]["fate"], "stands");
    EXPECT_EQ(ranges[3]["fate"], "overturns-without-impact");
    EXPECT_NEAR(ranges[3]["from_over_alpha_g"], 7.493000, 3e-6 * 7);

    std::istringstream csv(folder.read("o.csv"));
    std::string head;
    std::getline(csv, head);
    EXPECT_EQ(head, "omega_over_p,frequency_hz,period_s,fate,from_mps2,to_mps2,from_over_alpha_g,to_over_alpha_g");
    std::size_t rows = 0;
    for (std::string row; std::getline(csv, row); ++rows) {
        EXPECT_NE(row.find(ranges[rows]["fate"].get<std::string>()), std::string::npos) << row;
    }
    EXPECT_EQ(rows, ranges.size());
}

// The notch of the linearised block beside the closed form of its upper edge (Zhang and Makris 2001; derived again).
TEST_F(Overturning, ClosedFormStandsBesideTheLinearisedBlock) {
    std::vector<std::string> const asked{"--linearised", "--highest", "9", "--step", "0.1", "--json"};
    for (auto const& [pulse, ratio, edge] : {std::tuple{"one-sine", "5", 7.168128838}, {"half-sine", "4", 2.7907980}}) {
        auto const shown = json::parse(done(joined(joined(block, {"--pulse", pulse, "--ratios", ratio}), asked)).out);
        auto const& point = shown["points"][0];
        EXPECT_NEAR(point["closed_form_over_alpha_g"], edge, 1e-6 * edge);
        EXPECT_NEAR(point["ranges"].back()["from_over_alpha_g"], edge, 3e-6 * edge);
    }
    auto const other = json::parse(done(joined(joined(block, {"--pulse", "ricker", "--ratios", "4"}), asked)).out);
    EXPECT_FALSE(other["points"][0].contains("closed_form_over_alpha_g"));
}

// Pulses that begin and end with a jump: a rectangle's closed form (Housner 1963), and a cosine by another integrator
// (fourth order, steps of 1e-3 and 2e-4).
TEST_F(Overturning, PulsesJumpWhereTheyDo) {
    auto const of = [&](std::string const& pulse, std::vector<std::string> const& more) {
        return json::parse(done(joined(joined(block, {"--pulse", pulse, "--ratios", "4", "--json"}), more)).out);
    };
    double const rectangle = of("rectangle", {"--linearised"})["points"][0]["overturning_over_alpha_g"];
    EXPECT_NEAR(std::cosh(2 * M_PI / 4), 1 + 1 / (2 * rectangle * (rectangle - 1)), 1e-7);
    auto const cosine = of("one-cosine", {})["points"][0]["ranges"];
    EXPECT_NEAR(cosine[1]["from_over_alpha_g"], 3.68711, 3e-5);
    EXPECT_NEAR(cosine[1]["to_over_alpha_g"], 5.89882, 3e-5);
}

// A file's friction, base and pad are not in the spectrum, which says so; a base's own restitution is.
TEST_F(Overturning, WhatItLeavesOutOfABodyIsReported) {
    std::string const body =
        "name='b'\nmass='12.6 t'\nbase_width='1.36 m'\ncentre_height='1.045 m'\n"
        "inertia='uniform-block'\n";
    folder.write("plain.toml", body + "friction=0.9\n");
    folder.write("round.toml", body + "friction=0.5\nbase={shape='round'}\n");
    std::vector<std::string> const asked{"--pulse", "one-sine", "--ratios", "2", "--highest", "3"};
    auto const of = [&](char const* file) {
        return json::parse(done(joined(joined({"--body", file}, asked), {"--json"})).out);
    };
    auto const plain = of("plain.toml");
    ASSERT_EQ(plain["left_out"].size(), 1U);
    EXPECT_EQ(plain["left_out"][0], "b: its friction 0.9");
    auto const round = of("round.toml");
    ASSERT_EQ(round["left_out"].size(), 2U);
    EXPECT_EQ(round["left_out"][0], "b: its friction 0.5, with which it slides before it rocks");
    folder.write("c.toml",
                 "seed=1\n[waves]\nsource='pulse'\nshape='one-sine'\nperiods=['1 s']\namplitude='1 m/s2'\n"
                 "time_step='0.01 s'\n[[bodies]]\nfile='round.toml'\n[levels]\nmeasure='pga'\nvalues=['1 g']\n");
    auto const plan = overturn(folder, {"plan", "c.toml"}).out;
    EXPECT_NE(plan.find(fmt::format("rocks with restitution {:.4f} (from", round["restitution"].get<double>())),
              std::string::npos)
        << plan << round["restitution"];
    EXPECT_NE(done(joined({"--body", "round.toml"}, asked)).out.find("not in these numbers: b: its friction 0.5"),
              std::string::npos);
}

TEST_F(Overturning, ParametersOfThePulseAreReported) {
    std::vector<std::string> const pulse{
        "--pulse", "mavroeidis-papageorgiou", "--gamma", "1.5", "--phase", "90 deg", "--ratios", "2", "--highest", "2"};
    auto const shown = json::parse(done(joined(joined(block, pulse), {"--json"})).out);

    EXPECT_EQ(shown["gamma"], 1.5);
    EXPECT_NEAR(shown["phase_rad"], M_PI / 2, 1e-15);
    EXPECT_NE(done(joined(block, pulse)).out.find("mavroeidis-papageorgiou (gamma 1.5, phase 90 deg)"),
              std::string::npos);
}

// Five digits, rounded so that what overturns is no less than it is.
TEST_F(Overturning, TextIsRoundedToTheSafeSide) {
    auto const text =
        done(joined(block, {"--pulse", "one-sine", "--frequencies", "1.5915494309,30", "--highest", "10"})).out;

    auto one_line = text;
    std::ranges::replace(one_line, '\n', ' ');
    EXPECT_NE(single_blanks(one_line).find("3.0323 stands to 3.0323; overturns with impact to 6.7431; stands to 7.493"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("> 10.21"), std::string::npos) << "nothing overturned, and it says up to where: " << text;
    EXPECT_NE(text.find("narrower than 1 % may be missed"), std::string::npos);
}

TEST_F(Overturning, OfABodyUnderARecordIsAFactorOnIt) {
    folder.write("body.toml",
                 "name='b'\nmass='12.6 t'\nbase_width='0.4 m'\ncentre_height='1 m'\ninertia='uniform-block'\n"
                 "restitution=0.9\n");
    std::string wave = "time,a\n";
    for (int i = 0; i <= 200; ++i) {
        wave += fmt::format("{:.2f},{:.9f}\n", 0.01 * i, 0.5 * std::sin(M_PI * 0.01 * i));
    }
    folder.write("w.csv", wave);
    std::vector<std::string> const record{"--body", "body.toml", "--wave", "w.csv", "--unit", "m/s2"};
    auto const shown = json::parse(done(joined(record, {"--json"})).out);

    EXPECT_NEAR(shown["pga_mps2"], 0.5, 1e-9);
    auto const& ranges = shown["points"][0]["ranges"];
    ASSERT_GE(ranges.size(), 2U);
    double const factor = ranges[1]["from_factor"];
    EXPECT_NEAR(shown["points"][0]["overturning_mps2"].get<double>(), 0.5 * factor, 1e-9);
    auto const verdict = [&](double scale) {
        auto const ended = overturn(folder, {"rock", "--body", "body.toml", "--wave", "w.csv", "--unit", "m/s2",
                                             "--scale", fmt::format("{}", scale), "--effects", "none", "--json"});
        return json::parse(ended.out)["verdict"].get<std::string>();
    };
    EXPECT_EQ(verdict(factor * (1 + 1e-8)), "overturned");
    EXPECT_EQ(verdict(factor * (1 - 1e-8)), "rocked");
    EXPECT_NE(done(record).out.find("times the record"), std::string::npos);
}

TEST_F(Overturning, FigureIsDrawnFromTheSameNumbers) {
    expect_drawn_from_the_same_numbers(joined(block, {"--pulse", "half-sine", "--ratios", "1,4"}));
}

TEST_F(Overturning, RefusesWhatHasNoMeaning) {
    refused({}, "--wave (missing)");
    refused({"--wave", "w.csv", "--pulse", "ricker"}, "State --overturning too");
    refused({"--overturning", "--pulse", "one-sine"}, "State --body");
    refused({"--overturning"}, "State --pulse or --wave");
    auto const with = [&](std::vector<std::string> const& more) {
        return joined(joined({"--overturning"}, block), more);
    };
    refused(with({"--pulse", "one_sine"}), "'one-sine'?");
    refused(with({"--pulse", "ricker", "--ratios", "1:2"}), "first:last:count");
    refused(with({"--pulse", "ricker", "--ratios", "1,x"}), "not a number above 0");
    refused(with({"--pulse", "ricker", "--ratios", "1", "--frequencies", "1"}), "Leave one of them out");
    refused(with({"--pulse", "ricker", "--gamma", "2"}), "--gamma and --phase");
    refused(with({"--pulse", "mavroeidis-papageorgiou", "--gamma", "2"}), "--gamma and --phase");
    refused(with({"--pulse", "ricker", "--highest", "1"}), "--highest");
    refused({"--highest", "3", "--wave", "w.csv"}, "State --overturning too");
    refused(with({"--pulse", "ricker", "--ratios", "1e300"}), "--ratios '1e300' (1e+300 is none from 0.0001 to 10000)");
    refused(with({"--pulse", "ricker", "--frequencies", "1,1e-9"}), "--frequencies '1,1e-9' (1e-09 is none from");
    refused(with({"--pulse", "ricker", "--unit", "g"}), "of a record");
    refused(with({"--pulse", "ricker", "--baseline", "mean"}), "of a record");
    refused(with({"--pulse", "ricker", "--damping", "0.1"}), "--damping (of response spectra)");
    for (auto const* gamma : {"1", "101", "nan"}) {
        refused(with({"--pulse", "mavroeidis-papageorgiou", "--gamma", gamma, "--phase", "0"}), "above 1, to 100");
    }
    refused(with({"--pulse", "mavroeidis-papageorgiou", "--gamma", "2", "--phase", "1 m"}), "--phase unit 'm'");
    refused({"--overturning", "--pulse", "ricker", "--p", "2", "--alpha", "14deg", "--restitution", "0.9"},
            "--alpha '14deg'");
    refused({"--overturning", "--pulse", "ricker", "--p", "2", "--alpha", "90 deg", "--restitution", "0.9"},
            "read as 90 deg; it must lie between 0 and 90");
    refused({"--overturning", "--pulse", "ricker", "--p", "2", "--alpha", "14", "--restitution", "0.9"}, "802.1 deg");
    refused(with({"--pulse", "ricker", "--ratios", "1", "-o", "nowhere/x.csv"}), "Choose another place");
    refused({"--overturning", "--pulse", "ricker", "--p", "2", "--alpha", "0.25", "--restitution", "1.2"}, "0 to 1");
    folder.write("tilted.toml",
                 "name='b'\nmass='12.6 t'\nbase_width='0.4 m'\ncentre_height='1 m'\ninertia='uniform-block'\n"
                 "initial_tilt='0.01'\n");
    refused({"--overturning", "--pulse", "ricker", "--body", "tilted.toml"},
            "an overturning spectrum is of a symmetric body at rest");
}

}  // namespace
}  // namespace overturn::testing
