// Requirement R-107: times printed to few digits or kept in single precision are times, a lost row among them is not,
// and columns without a time are read where that is said.
#include <cmath>
#include <string>

#include "motion/record.hpp"
#include "support/expect_input_error.hpp"
#include "support/read_record.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

constexpr double gal = 0.01;

template <class Print> std::string times(double step, int count, Print&& print, int lost = -1) {
    std::string text;
    for (int i = 0; i < count; ++i) {
        text += i == lost ? "" : print(i * step) + (i % 2 == 0 ? ",1\n" : ",-1\n");
    }
    return text;
}

double step_of(std::string const& text, std::optional<double> stated = {}) {
    return testing::read_record(text, {.name = "a.csv", .unit_mps2 = gal, .time_step_s = stated}).time_step_s;
}

auto const three_decimals = [](double t) { return fmt::format("{:.3f}", t); };
auto const cut_off = [](double t) { return fmt::format("{:.3f}", std::floor(t * 1000 + 1e-6) / 1000); };
auto const six_figures = [](double t) { return fmt::format("{:.6g}", t); };
auto const single = [](double t) { return fmt::format("{:.18f}", static_cast<double>(static_cast<float>(t))); };
auto const exponents = [](double t) { return fmt::format("{:.4E}", t); };

TEST(PrintedTimes, FewDigitsAreForgiven) {
    EXPECT_NEAR(step_of(times(1 / 60.0, 3000, three_decimals)), 1 / 60.0, 1e-6);
    EXPECT_NEAR(step_of(times(1 / 60.0, 3000, cut_off)), 1 / 60.0, 1e-6);
    EXPECT_NEAR(step_of(times(0.005, 30000, single)), 0.005, 1e-9);
    EXPECT_NEAR(step_of(times(1 / 150.0, 3000, six_figures)), 1 / 150.0, 1e-7);
    EXPECT_NEAR(step_of(times(0.01, 1000, exponents)), 0.01, 1e-6);
    EXPECT_NEAR(step_of(times(0.02, 3000, three_decimals)), 0.02, 1e-15);
}

TEST(PrintedTimes, LostRowsAreFound) {
    for (int const lost : {1, 700, 1500, 2998}) {
        for (auto const& text : {times(1 / 60.0, 3000, three_decimals, lost), times(1 / 60.0, 3000, cut_off, lost),
                                 times(0.005, 3000, single, lost), times(1 / 150.0, 3000, six_figures, lost),
                                 times(0.02, 3000, three_decimals, lost)}) {
            expect_input_error([&] { (void)step_of(text); }, "a.csv:" + std::to_string(lost + 1) + ": ",
                               "a row is lost");
        }
    }
}

// A step below the last digit: only the user can know it.
TEST(PrintedTimes, TooFewDigitsNeedTheStep) {
    auto const two_decimals = [](double t) { return fmt::format("{:.2f}", t); };
    auto const text = times(0.005, 2000, two_decimals);
    expect_input_error([&] { (void)step_of(text); }, "too few digits", "state its time step");
    EXPECT_EQ(step_of(text, 0.005), 0.005);
    expect_input_error([&] { (void)step_of(text, 0.006); }, "a.csv:");
    auto const whole = times(
        1, 20, [](double t) { return fmt::format("{:.0f}", t); }, 7);
    expect_input_error([&] { (void)step_of(whole, 1); }, "a.csv:8: ", "from 6 to 8 s");
}

TEST(PrintedTimes, StatedStepWinsWithinTheDigits) {
    auto const text = times(1 / 60.0, 3000, three_decimals);
    EXPECT_EQ(step_of(text, 1 / 60.0), 1 / 60.0);
    expect_input_error([&] { (void)step_of(text, 0.02); }, "contradict");
}

TEST(Components, AreReadWithoutATime) {
    std::string const two = "0.1 0.2\n-0.3 0.4\n0.5 -0.6\n";
    RecordRequest const stated{.name = "a.txt", .format = "components", .unit_mps2 = 1, .time_step_s = 0.01};
    expect_input_error([&] { (void)testing::read_record(two, stated); }, "a.txt:1: column 1", "ambiguous");
    auto named = stated;
    named.columns = "h1,h2";
    auto const motion = testing::read_record(two, named);
    EXPECT_EQ(motion.horizontal_mps2, (std::vector{0.1, -0.3, 0.5}));
    EXPECT_EQ(motion.transverse_mps2, (std::vector{0.2, 0.4, -0.6}));
    EXPECT_TRUE(motion.vertical_mps2.empty());
    EXPECT_EQ(motion.time_step_s, 0.01);
    auto by_content = stated;
    by_content.format = "auto";
    expect_input_error([&] { (void)testing::read_record(two, by_content); }, "a.txt:1: column 1", "State --columns");
    EXPECT_EQ(read_placed("NS,UD\n0.1,0.2\n-0.3,0.4\n", by_content).says, "NS, vertical UD");
    EXPECT_EQ(read_placed("NS,EW,UD\n1,2,3\n4,5,6\n", by_content).says, "NS, transverse EW, vertical UD");
    by_content.time_step_s.reset();
    expect_input_error([&] { (void)testing::read_record("NS,UD\n0.1,0.2\n-0.3,0.4\n", by_content); },
                       "time step missing");
    // A digitiser's "x,y" is a time and a value.
    EXPECT_EQ(testing::read_record("x,y\n0,1\n0.1,2\n0.2,3\n0.3,4\n", {.unit_mps2 = 1}).time_step_s, 0.3 / 3);
    expect_input_error([&] { (void)testing::read_record("0 1 2 3\n1 1 2 3\n", stated); }, "ambiguous");
}

}  // namespace
}  // namespace overturn
