// Requirement R-108: the baseline of a record is corrected as it is stated (mean, polynomial, high-pass with corner,
// order and phase), so that its PGV and PGD are the ground's; without a word nothing is touched.
#include "generators/record_baseline.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/units.hpp"
#include "motion/drift.hpp"
#include "support/expect_input_error.hpp"
#include "support/sources.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;
using testing::source_of;

constexpr double dt = 0.01;

// 60 s of ground that begins and ends at rest: a sine of 1 Hz under a smooth hill, with the drift added to it.
template <class Drifts> GroundMotion shaken(Drifts&& drift) {
    GroundMotion motion{.time_step_s = dt, .horizontal_mps2 = {}, .transverse_mps2 = {}, .vertical_mps2 = {}};
    for (int i = 0; i <= 6000; ++i) {
        double const t = i * dt;
        double const hill = t > 10 && t < 50 ? std::pow(std::sin(pi * (t - 10) / 40), 2) : 0;
        motion.horizontal_mps2.push_back(2 * hill * std::sin(2 * pi * t) + drift(t));
    }
    return motion;
}

double const true_pgv = drift_of(shaken([](double) { return 0.0; })).pgv_mps;

TEST(RecordBaseline, NoneTouchesNoBit) {
    auto const before = shaken([](double) { return 0.044; });
    auto motion = before;
    correct_record(motion, parse_baseline("none"));
    EXPECT_EQ(motion.horizontal_mps2, before.horizontal_mps2);
    EXPECT_TRUE(drift_of(before).excessive());
    EXPECT_NEAR(drift_of(before).end_velocity_mps, 0.044 * 60, 0.01);
}

// Closed form: an offset is the mean of a record whose own mean is 0.
TEST(RecordBaseline, MeanTakesAnOffsetOff) {
    auto motion = shaken([](double) { return 0.044; });
    correct_record(motion, parse_baseline("mean"));
    EXPECT_NEAR(drift_of(motion).pgv_mps, true_pgv, 1e-3 * true_pgv);
    EXPECT_FALSE(drift_of(motion).excessive());
}

// Closed form: what is added as the second derivative of t^2 ... t^6 comes off, whatever it is.
TEST(RecordBaseline, PolynomialTakesItsOwnKindOff) {
    auto const plain = shaken([](double) { return 0.0; });
    auto motion = shaken([](double t) {
        double const s = t / 60;
        return 0.05 - 0.3 * s + 0.4 * s * s - 0.2 * s * s * s + 0.03 * s * s * s * s;
    });
    auto alone = plain;
    correct_record(motion, parse_baseline("polynomial"));
    correct_record(alone, parse_baseline("polynomial"));
    for (std::size_t i = 0; i < plain.samples(); i += 10) {
        EXPECT_NEAR(motion.horizontal_mps2[i], alone.horizontal_mps2[i], 4e-9);  // dt^2 / 12 of its curvature:
                                                                                 // lines between samples
    }
    EXPECT_NEAR(drift_of(motion).end_velocity_mps, 0, 1e-7);
}

// Closed form: a steady sine passes with 1 / (1 + (corner / f)^(2 order)), in phase, or with the Butterworth filter's
// own modulus and delay where it is causal.
TEST(RecordBaseline, SinesPassWithTheResponseStated) {
    for (int const order : {2, 4}) {
        for (double const ratio : {0.8, 1.0, 1.5, 3.0}) {
            constexpr double corner = 0.5;
            GroundMotion motion{.time_step_s = dt, .horizontal_mps2 = {}, .transverse_mps2 = {}, .vertical_mps2 = {}};
            for (int i = 0; i <= 40000; ++i) {
                double const hill = std::pow(std::sin(pi * i / 40000), 2);  // ends in quiet, as records do
                motion.horizontal_mps2.push_back(hill * std::sin(2 * pi * corner * ratio * i * dt));
            }
            auto zero = motion;
            auto causal = motion;
            correct_record(zero, {BaselineMethod::high_pass, corner, order, FilterPhase::zero});
            correct_record(causal, {BaselineMethod::high_pass, corner, order, FilterPhase::causal});
            double const gain = 1 / (1 + std::pow(1 / ratio, 2 * order));
            double peak = 0;
            for (std::size_t i = 19870; i < 20130; ++i) {
                EXPECT_NEAR(zero.horizontal_mps2[i], gain * motion.horizontal_mps2[i], 2e-4) << order << ' ' << ratio;
                peak = std::max(peak, std::abs(causal.horizontal_mps2[i]));
            }
            EXPECT_NEAR(peak, std::sqrt(gain), 2e-3) << order << ' ' << ratio;
        }
    }
}

// Property: a causal filter moves nothing before the first motion comes, a zero-phase one does; the polynomial, smooth
// and small, is what is left of either there.
TEST(RecordBaseline, CausalKeepsTheQuietBeforeTheOnset) {
    auto const late = [] {
        GroundMotion motion{.time_step_s = dt, .horizontal_mps2 = {}, .transverse_mps2 = {}, .vertical_mps2 = {}};
        for (int i = 0; i <= 20000; ++i) {
            bool const shakes = i > 10000 && i < 10100;
            motion.horizontal_mps2.push_back(shakes ? std::pow(std::sin(pi * (i - 10000) / 100), 2) : 0.0);
        }
        return motion;
    };
    auto causal = late();
    auto zero = late();
    correct_record(causal, {BaselineMethod::high_pass, 1, 4, FilterPhase::causal});
    correct_record(zero, {BaselineMethod::high_pass, 1, 4, FilterPhase::zero});
    double before = 0, ahead = 0;
    for (std::size_t i = 9900; i < 9999; ++i) {
        before = std::max(before, std::abs(causal.horizontal_mps2[i]));
        ahead = std::max(ahead, std::abs(zero.horizontal_mps2[i]));
    }
    EXPECT_LT(before, 0.01 * ahead);
    EXPECT_GT(ahead, 0.05);
}

// an offset of some gal no longer makes PGV ten times too large.
TEST(RecordBaseline, PgvIsTheGroundsAgain) {
    auto const drifting = shaken([](double t) { return 0.044 - 0.0005 * t; });
    EXPECT_GT(drift_of(drifting).pgv_mps, 3 * true_pgv);
    for (auto const* text : {"polynomial", "high-pass 0.05 Hz"}) {
        auto motion = drifting;
        correct_record(motion, parse_baseline(text));
        EXPECT_NEAR(drift_of(motion).pgv_mps, true_pgv, 0.03 * true_pgv) << text;
        EXPECT_NEAR(drift_of(motion).end_velocity_mps, 0, 1e-7) << text;
        EXPECT_LT(drift_of(motion).pgd_m, 0.3) << text;
    }
}

TEST(RecordBaseline, MeanAloneHidesNoDrift) {
    auto motion = shaken([](double t) { return 0.2 * std::cos(pi * t / 60); });  // ends at rest, 70 m away
    EXPECT_LT(drift_of(motion).share(), 0.05);
    EXPECT_TRUE(drift_of(motion).excessive());
}

// 40 s of 2 Hz, which no correction of long periods touches.
std::string two_hertz() {
    std::string text;
    for (int i = 0; i <= 4000; ++i) {
        double const t = 0.01 * i;
        text += fmt::format("{:.2f},{:.6f}\n", t, 100 * std::pow(std::sin(pi * t / 40), 2) * std::sin(4 * pi * t));
    }
    return text;
}

TEST(RecordBaseline, IsStatedInTheTable) {
    std::map<std::string, std::string> const files{{"a.csv", two_hertz()},
                                                   {"short.csv", "0,0\n0.01,10\n0.02,-20\n0.03,0\n"}};
    auto const label = [&](std::string const& baseline) {
        return source_of("source='records'\nfiles=['a.csv']\nunit='gal'\nbaseline=" + baseline + "\n", files)
            ->make(1, 0)
            .label;
    };
    EXPECT_EQ(label("'none'"), "a.csv");
    auto const expect = [&](std::string const& baseline, std::string const& said) {
        EXPECT_TRUE(label(baseline).starts_with("a.csv, " + said + " (PGA ")) << label(baseline);
    };
    expect("'mean'", "mean taken off");
    expect("'polynomial'", "baseline polynomial taken off");
    expect("'high-pass 0.05 Hz'", "high-passed at 0.05 Hz (Butterworth, order 4, zero phase)");
    expect("{high_pass='0.1 Hz', order=2, phase='causal'}", "high-passed at 0.1 Hz (Butterworth, order 2, causal)");
    auto const own = source_of(
        "source='records'\n[[records]]\nhorizontal='a.csv'\nunit='gal'\nbaseline='mean'\n"
        "[[records]]\nhorizontal='short.csv'\nunit='gal'\n",
        files);
    EXPECT_EQ(own->make(1, 0).label, label("'mean'"));
    EXPECT_EQ(own->make(1, 1).label, "short.csv");
    auto const refuse = [&](std::string const& baseline, char const* part) {
        expect_input_error([&] { (void)label(baseline); }, "c.toml:4:", part);
    };
    refuse("'men'", "Did you mean 'mean'?");
    refuse("'high-pass 0 Hz'", "must be above 0");
    refuse("'high-pass 1e-9 Hz'", "at least 0.001 Hz");
    refuse("'high-pass 0.02 Hz'", "below 0.025 Hz, 1 / duration");
    // By hand: the mean is -2.5 gal, so that 20 gal become 17.5, and 0.1 gal s at the end 0.10104 where it turns.
    auto const shifted =
        source_of("source='records'\nfiles=['short.csv']\nunit='gal'\nbaseline='mean'\n", files)->make(1, 0).label;
    EXPECT_TRUE(shifted.starts_with("short.csv, mean taken off (PGA -12.5 %, PGV +1.04 %, PGD ")) << shifted;
    EXPECT_NE(shifted.find(" %, Sa from 0.3 to 10 s by "), std::string::npos) << shifted;
    // Each component has its own: the first two that of short.csv, the vertical one has no mean.
    std::map<std::string, std::string> const three{
        {"three.csv", "time,NS,EW,UD\n0,0,0,1\n0.01,10,10,-1\n0.02,-20,-20,1\n0.03,0,0,-1\n"}};
    auto const each =
        source_of("source='records'\nfiles=['three.csv']\nunit='gal'\nbaseline='mean'\n", three)->make(1, 0).label;
    EXPECT_NE(each.find("mean taken off (PGA -12.5 %, PGV "), std::string::npos) << each;
    EXPECT_NE(each.find("; transverse PGA -12.5 %, PGV "), std::string::npos) << each;
    EXPECT_NE(each.find("; vertical PGA +0 %, PGV +0 %, PGD +0 %; Sa from 0.3 to 10 s by "), std::string::npos) << each;
    EXPECT_NE(each.find(" % at most, transverse by "), std::string::npos) << each;
    EXPECT_NE(each.find(" %, vertical by +0 %)"), std::string::npos) << each;
    refuse("'high-pass 50 Hz'", "a quarter of the sampling frequency");
    refuse("{order=2}", "high_pass");
    refuse("{high_pass='0.1 Hz', order=40}", "1 to 10");
    refuse("{high_pass='0.1 Hz', phase='linear'}", "zero, causal");
    refuse("{high_pass='0.1 Hz', corner=1}", "unknown key");
}

TEST(RecordBaseline, WaveKnowsHowItEnds) {
    std::map<std::string, std::string> const files{{"a.csv", "0,0\n0.01,10\n0.02,20\n0.03,0\n"}};
    auto const raw = source_of("source='records'\nfiles=['a.csv']\nunit='gal'\n", files);
    auto const mean = source_of("source='records'\nfiles=['a.csv']\nunit='gal'\nbaseline='mean'\n", files);
    EXPECT_NEAR(raw->drift(0)->end_velocity_mps, 0.003, 1e-15);
    EXPECT_EQ(raw->drift(0)->share(), 1);
    // Ten times a record is no drift of its own: what is beyond belief is judged before scaling.
    Drift const large{.pgv_mps = 10, .pgd_m = 20, .end_velocity_mps = 0, .end_displacement_m = 0, .factor = 10};
    EXPECT_FALSE(large.excessive());
    EXPECT_EQ(source_of("source='records'\nfiles=['a.csv']\nunit='gal'\nscale=10\n", files)->drift(0)->factor, 10);
    EXPECT_LT(std::abs(mean->drift(0)->end_velocity_mps), 0.002);
}

// the drift of the other components is reported too.
TEST(Drift, IsLookedForInEveryComponent) {
    auto motion = shaken([](double) { return 0.0; });
    EXPECT_FALSE(drift_of(motion).any_excessive());
    motion.transverse_mps2 = motion.horizontal_mps2;
    motion.vertical_mps2 = shaken([](double) { return 0.3; }).horizontal_mps2;
    auto const drift = drift_of(motion);
    EXPECT_FALSE(drift.excessive());
    EXPECT_TRUE(drift.any_excessive());
    ASSERT_EQ(drift.others.size(), 1U);
    EXPECT_NE(drift.text().find("; its vertical component ends at 18 m/s ("), std::string::npos) << drift.text();
    EXPECT_EQ(drift.text().find("transverse"), std::string::npos);
    // 18 m/s and 0.3 * 60^2 / 2 m, over 0.3048 m.
    auto const in_feet = drift.text({.velocity = "ft/s", .length = "ft"});
    EXPECT_NE(in_feet.find("ends at 59.1 ft/s ("), std::string::npos) << in_feet;
    EXPECT_NE(in_feet.find(" 1.77e+03 ft from where it began"), std::string::npos) << in_feet;
    EXPECT_EQ(in_feet.find(" m"), std::string::npos) << in_feet;
}

}  // namespace
}  // namespace overturn
