// Requirement R-104: a target may be stated as acceleration, pseudo-velocity, displacement or energy velocity, for any
// damping that the user says how to convert, and nothing is converted silently.
#include <cmath>

#include "core/units.hpp"
#include "spectra/target_input.hpp"
#include "support/expect_input_error.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::exact_formula;
using testing::expect_input_error;
using testing::near;

TargetSpectrum read(char const* text) {
    InputFiles files(std::map<std::string, std::string>{});
    auto const table = config::Table::parse(text, "c.toml");
    auto target = read_target(table, files);
    table.finish();
    return target;
}

// psa = w psv = w^2 sd by definition, between the points of a table too, where each is a power law.
TEST(TargetKinds, AreReadingsOfOneSpectrum) {
    auto const velocity = read("kind='pseudo-velocity'\npoints=[[0.5,1],[2,2]]");
    auto const displacement = read("kind='displacement'\npoints=[[0.5,'2 cm'],[2,'32 cm']]");

    EXPECT_TRUE(near(velocity.psv_mps(1), std::sqrt(2.0), exact_formula));
    for (double const period : {0.5, 0.8, 1.0, 1.7, 2.0}) {
        double const w = 2 * pi / period;
        EXPECT_TRUE(near(displacement.psa_mps2(period), w * w * 0.08 * period * period, exact_formula));
        EXPECT_TRUE(near(velocity.psa_mps2(period), w * velocity.psv_mps(period), exact_formula));
    }
    EXPECT_FALSE(velocity.is_energy());
    EXPECT_FALSE(displacement.is_energy());
}

// A velocity of the model is the prototype's times the time scale s^1/2 (similarity law), at a period that is as well.
TEST(TargetKinds, EnergyVelocityScalesAsAVelocity) {
    auto const prototype = read("kind='energy-velocity'\ndamping=0.1\npoints=[[0.5,'100 kine'],[2,'200 kine']]");
    auto const model = prototype.at_time_scale(0.632);

    EXPECT_TRUE(prototype.is_energy());
    EXPECT_TRUE(model.is_energy());
    EXPECT_TRUE(near(prototype.psv_mps(1), std::sqrt(2.0), exact_formula));
    EXPECT_TRUE(near(model.psv_mps(0.632), 0.632 * std::sqrt(2.0), exact_formula));
}

// Printed values: Fh = 1.5/(1+10h) gives 1.25, 1, 0.75, 0.5 at 2, 5, 10, 20 %; eta = sqrt(10/(5+xi)) 1.195, 1, 0.816.
TEST(DampingRules, HaveTheirPrintedFactors) {
    auto const factor = [](char const* rule, double damping) {
        return config::find_entry(damping_rules(), rule, "rule").value(damping);
    };
    EXPECT_TRUE(near(factor("japan", 0.02), 1.25, exact_formula));
    EXPECT_TRUE(near(factor("japan", 0.05), 1, exact_formula));
    EXPECT_TRUE(near(factor("japan", 0.10), 0.75, exact_formula));
    EXPECT_TRUE(near(factor("japan", 0.20), 0.5, exact_formula));
    EXPECT_TRUE(near(factor("eurocode-8", 0.02), 1.19523, testing::Tolerance{1e-5, "printed"}));
    EXPECT_TRUE(near(factor("eurocode-8", 0.05), 1, exact_formula));
    EXPECT_TRUE(near(factor("eurocode-8", 0.10), 0.81650, testing::Tolerance{1e-5, "printed"}));
    expect_input_error([&] { (void)factor("eurocode-8", 0.3); }, "0.55", "Lower it");
}

TEST(DampingRules, CarryATargetThereAndBack) {
    auto const five = read("spectrum='mlit-ch1'");
    auto const two = read("spectrum='mlit-ch1'\nstated_damping=0.05\ndamping=0.02\ndamping_rule='japan'");
    auto const rule = config::find_entry(damping_rules(), "japan", "rule").value;

    EXPECT_EQ(two.damping(), 0.02);
    EXPECT_TRUE(near(two.psa_mps2(3), 1.25 * five.psa_mps2(3), exact_formula));
    EXPECT_TRUE(near(two.at_damping(0.05, rule).psa_mps2(3), five.psa_mps2(3), exact_formula));
}

TEST(DampingRules, AreNeverAppliedUnasked) {
    expect_input_error([] { (void)read("spectrum='mlit-ch1'\nstated_damping=0.05\ndamping=0.02"); },
                       "c.toml:2:", "stated_damping", "Add damping_rule");
    expect_input_error([] { (void)read("spectrum='mlit-ch1'\ndamping=0.02\ndamping_rule='japan'"); },
                       "c.toml:1:", "0.05 only");
    expect_input_error([] { (void)read("spectrum='mlit-ch1'\ndamping=0.05\ndamping_rule='japon'"); }, "'japan'?");
    expect_input_error(
        [] {
            (void)read(
                "kind='energy-velocity'\npoints=[[1,1],[2,2]]\nstated_damping=0.1\ndamping=0.05\n"
                "damping_rule='japan'");
        },
        "c.toml:4:", "no rule");
    expect_input_error([] { (void)read("kind='displacement'\npoints=[[1,'1 gal'],[2,2]]"); }, "c.toml:2:", "gal");
}

}  // namespace
}  // namespace overturn
