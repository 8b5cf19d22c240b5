// Requirement R-413: `spectrum --rocking` gives the largest rotation of blocks over 2 pi / p and alpha under a record,
// as text, JSON, csv and a figure; `spectrum --periods` gives response spectra at stated periods.
#include <cmath>
#include <sstream>

#include <nlohmann/json.hpp>

#include "support/spectrum_verb.hpp"

namespace overturn::testing {
namespace {

using nlohmann::json;

constexpr double gravity = 9.80665;

class RockingSpectrum : public SpectrumVerb {
  protected:
    RockingSpectrum() : SpectrumVerb({"--unit", "m/s2"}) {}
    void SetUp() override {
        // Ground that moves at 0.45 m/s after 10 ms.
        folder.write("step.csv", "time,a\n0,0\n0.005,90\n0.01,0\n0.015,0\n0.02,0\n0.025,0\n");
        std::string wave = "time,a\n";
        for (int i = 0; i <= 300; ++i) {
            wave += fmt::format("{:.2f},{:.9f}\n", 0.01 * i, 4 * std::sin(2 * M_PI * 0.01 * i));
        }
        folder.write("wave.csv", wave);
    }

    // Of a block after the step: what turns it while the ground moves, then energy, cos(alpha - theta) = cos(alpha -
    // theta1) + omega^2 / (2 p^2). Its own tilt meanwhile is left out of what rights it: p T squared of it, 1e-3.
    static double cosine_after_step(double alpha, double p) {
        constexpr int pieces = 20'000;
        constexpr double whole = 0.01;
        constexpr double d = whole / pieces;
        double omega = 0;
        double theta = 0;
        for (int i = 0; i < pieces; ++i) {
            double const t = (i + 0.5) * d;
            double const a = 90 * (1 - std::abs(t - 0.005) / 0.005);
            double const turning = p * p * (a * std::cos(alpha) / gravity - std::sin(alpha));
            if (omega > 0 || turning > 0) {
                theta += d * (omega + 0.5 * d * turning);
                omega += d * turning;
            }
        }
        return std::cos(alpha - theta) + omega * omega / (2 * p * p);
    }
};

// The step, then the closed form of energy.
TEST_F(RockingSpectrum, UnderAStepOfVelocityIsTheClosedForm) {
    auto const shown = json::parse(
        done({"--wave", "step.csv", "--rocking", "--alpha", "10 deg,0.25", "--rocking-periods", "0.8:20:12", "--json"})
            .out);

    ASSERT_EQ(shown["curves"].size(), 2U);
    int fallen = 0;
    int standing = 0;
    for (auto const& curve : shown["curves"]) {
        double const alpha = curve["alpha_rad"];
        EXPECT_NEAR(curve["restitution"], 1 - 1.5 * std::pow(std::sin(alpha), 2), 1e-12);
        ASSERT_EQ(curve["points"].size(), 12U);
        for (auto const& point : curve["points"]) {
            double const p = point["p_radps"];
            EXPECT_NEAR(p * point["rocking_period_s"].get<double>(), 2 * M_PI, 1e-12);
            double const cosine = cosine_after_step(alpha, p);
            ASSERT_GT(std::abs(cosine - 1), 1e-4) << "too near to balance to be told";
            if (cosine >= 1) {
                EXPECT_EQ(point["fate"], "overturns") << p;
                EXPECT_TRUE(point["peak_rotation_rad"].is_null());
                ++fallen;
            } else {
                double const theta = alpha - std::acos(cosine);
                EXPECT_EQ(point["fate"], "stands") << p;
                EXPECT_NEAR(point["peak_rotation_rad"], theta, 5e-3 * theta) << p;
                EXPECT_NEAR(point["peak_rotation_ratio"].get<double>() * alpha, point["peak_rotation_rad"], 1e-12);
                ++standing;
            }
        }
    }
    EXPECT_GE(fallen, 2);
    EXPECT_GE(standing, 12);
}

TEST_F(RockingSpectrum, HoldsTheBodysOwnRotation) {
    folder.write("body.toml",
                 "name='slab'\nmass='12.6 t'\nbase_width='1.2 m'\ncentre_height='2 m'\ninertia='uniform-block'\n"
                 "restitution=0.9\n");
    std::vector<std::string> const of{"--wave", "wave.csv", "--body", "body.toml"};
    auto const shown = json::parse(done(joined(of, {"--rocking", "--json"})).out);
    auto const rock = overturn(
        folder, joined(joined({"rock"}, of), {"--unit", "m/s2", "--scale", "1", "--effects", "none", "--json"}));

    double const own = shown["body_rocking_period_s"];
    EXPECT_NEAR(own, 2 * M_PI / std::sqrt(0.75 * gravity / std::hypot(0.6, 2)), 1e-9);
    double const peak = json::parse(rock.out)["peak_rotation_rad"];
    EXPECT_GT(peak, 0);
    std::size_t seen = 0;
    for (auto const& point : shown["curves"][0]["points"]) {
        if (point["rocking_period_s"] == own) {
            ++seen;
            EXPECT_NEAR(point["peak_rotation_rad"], peak, 1e-12);
        }
    }
    EXPECT_EQ(seen, 1U);
    EXPECT_EQ(shown["curves"][0]["points"].size(), 37U);
    EXPECT_NEAR(shown["curves"][0]["restitution"], 0.9, 1e-15);
    EXPECT_NE(done(joined(of, {"--rocking"})).out.find("slab: 2 pi / p = "), std::string::npos);
}

TEST_F(RockingSpectrum, TextIsRoundedUpAndCsvIsExact) {
    auto const ended = done({"--wave", "step.csv", "--rocking", "--alpha", "0.25", "--restitution", "0.8",
                             "--rocking-periods", "0.8,6", "-o", "r.csv"});
    double const p = 2 * M_PI / 6;
    double const theta = 0.25 - std::acos(cosine_after_step(0.25, p));
    EXPECT_NE(ended.out.find("overturns"), std::string::npos) << ended.out;
    std::istringstream rows(folder.read("r.csv"));
    std::string row;
    std::getline(rows, row);
    EXPECT_EQ(row, "alpha_rad,restitution,rocking_period_s,p_radps,fate,peak_rotation_rad,peak_rotation_ratio");
    std::getline(rows, row);
    EXPECT_NE(row.find(",overturns,,"), std::string::npos) << row;
    std::getline(rows, row);
    double const ratio = std::stod(row.substr(row.rfind(',') + 1));
    EXPECT_NEAR(ratio, theta / 0.25, 5e-3 * theta / 0.25);
    double const told = std::stod(ended.out.substr(ended.out.rfind(' ')));
    EXPECT_GE(told, ratio);
    EXPECT_LE(told, 1.01 * ratio);
}

TEST_F(RockingSpectrum, FigureIsDrawnFromTheSameNumbers) {
    expect_drawn_from_the_same_numbers({"--wave", "wave.csv", "--rocking"});
}

TEST_F(RockingSpectrum, ResponseSpectraAreAtStatedPeriods) {
    auto const all = json::parse(done({"--wave", "wave.csv", "--json"}).out);
    auto const few = json::parse(done({"--wave", "wave.csv", "--json", "--periods", "0.02,20,1"}).out);

    ASSERT_EQ(few["period_s"], (std::vector<double>{0.02, 20, 1}));
    EXPECT_EQ(few["sa_mps2"][0], all["sa_mps2"].front());
    EXPECT_NEAR(few["sa_mps2"][1], all["sa_mps2"].back().get<double>(), 1e-12);
    EXPECT_EQ(few["v_e_mps"].size(), 3U);
    auto const text = done({"--wave", "wave.csv", "--periods", "0.5:2:3"}).out;
    EXPECT_NE(text.find("\n   1.0000 "), std::string::npos) << text;
    EXPECT_EQ(text.find("all 3 periods"), std::string::npos) << text;
}

TEST_F(RockingSpectrum, RefusesWhatHasNoMeaning) {
    std::vector<std::string> const of{"--wave", "wave.csv", "--unit", "m/s2"};
    auto const with = [&](std::vector<std::string> const& more) { return joined(of, more); };
    refused({"--rocking"}, "--wave (missing)");
    refused(with({"--rocking", "--pulse", "ricker"}), "of an overturning spectrum");
    refused(with({"--rocking", "--overturning"}), "State one of them");
    refused(with({"--rocking", "--periods", "1"}), "of response spectra");
    refused(with({"--rocking-periods", "1"}), "State --rocking too");
    refused(with({"--rocking", "--alpha", "100 deg"}), "must lie between 0 and 90");
    refused(with({"--rocking", "--alpha", "60 deg"}), "State --restitution");
    refused(with({"--rocking", "--alpha", "20"}), "20");
    refused(with({"--rocking", "--restitution", "1.2"}), "0 to 1");
    refused(with({"--rocking", "--rocking-periods", "1,1e300"}), "1e+300 is none from 0.01 to 1000");
    refused(with({"--periods", "1e-9"}), "1e-09 is none from 0.001 to 1000");
    refused(with({"--periods", "0"}), "not a number above 0");
    refused(with({"--periods", "1:inf:4"}), "not a number above 0");
    refused(with({"--periods", "1", "--plot", "o.svg"}), "periods of its own");
}

}  // namespace
}  // namespace overturn::testing
