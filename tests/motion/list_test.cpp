// Requirement R-107: plain lists (1, 5, 6, 8 values a line) are read with a stated unit and step only.
#include <string>

#include "motion/record.hpp"
#include "support/expect_input_error.hpp"
#include "support/read_record.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

RecordRequest const stated{.name = "a.txt", .unit_mps2 = 0.01, .time_step_s = 0.02};

std::vector<double> const twelve{0.0, 0.01, 0.02, 0.03, 0.04, 0.05, -0.06, 0.07, 0.08, -0.09, 0.1, 0.11};

/// 0, 1, 2, ... 5, -6, 7, 8, -9, 10, 11 in lines of `per_line`.
std::string list_of(int per_line) {
    std::string text;
    for (int i = 0; i < 12; ++i) {
        text +=
            fmt::format("{:10.4f}", i % 3 == 0 && i > 3 ? -1.0 * i : i) + (i % per_line == per_line - 1 ? "\n" : "");
    }
    return text;
}

TEST(List, AnyNumberToALine) {
    for (int const per_line : {5, 6, 8, 12}) {
        auto const motion = testing::read_record(list_of(per_line), stated);
        EXPECT_EQ(motion.time_step_s, 0.02);
        ASSERT_EQ(motion.samples(), 12U) << per_line;
        for (std::size_t i = 0; i < 12; ++i) {
            EXPECT_DOUBLE_EQ(motion.horizontal_mps2[i], twelve[i]) << per_line;
        }
    }
    EXPECT_EQ(testing::read_record(list_of(1), stated).horizontal_mps2,
              testing::read_record(list_of(5), stated).horizontal_mps2);
    auto explicit_list = stated;
    explicit_list.format = "list";
    EXPECT_EQ(testing::read_record(list_of(3), explicit_list).samples(), 12U);
}

TEST(List, ProseTrailerAndGluedNumbers) {
    auto const plain = testing::read_record(list_of(6), stated).horizontal_mps2;
    EXPECT_EQ(testing::read_record("Data of 1940 (12 points at 0.02 sec)\na row of 6\n*** Begin data ***\n" + list_of(6)
                                       + "*** End Data ***\n\n",
                                   stated)
                  .horizontal_mps2,
              plain);
    EXPECT_EQ(testing::read_record("1.0E-01-2.0E-01+3.0D-01-.4-5-6\n", stated).horizontal_mps2,
              (std::vector{0.1 * 0.01, -0.2 * 0.01, 0.3 * 0.01, -0.4 * 0.01, -5 * 0.01, -6 * 0.01}));
}

TEST(List, UnitAndStepAreNeverGuessed) {
    expect_input_error([] { (void)testing::read_record(list_of(6), {.name = "a.txt", .time_step_s = 0.02}); },
                       "a.txt:1: ", "unit missing");
    expect_input_error([] { (void)testing::read_record(list_of(6), {.name = "a.txt", .unit_mps2 = 0.01}); },
                       "a.txt:1: ", "time step missing");
}

TEST(List, LostValuesAndTimeColumnsAreRefused) {
    expect_input_error([] { (void)testing::read_record("1 2 3 4 5\n1 2 3 4\n1 2 3 4 5\n", stated); },
                       "a.txt:2: ", "a row of 4");
    expect_input_error([] { (void)testing::read_record("1 2 3 4 5\n1 2 3 4 5 6\n", stated); },
                       "a.txt:2: ", "a row of 6");
    expect_input_error([] { (void)testing::read_record("1 2 3 4 5\n1 2 nan 4 5\n", stated); }, "a.txt:2: ", "'nan'");
    expect_input_error([] { (void)testing::read_record("0 2 3 4 5\n.1 2 3 1 5\n.2 2 3 4 5\n.3 1 1 1 1\n", stated); },
                       "a.txt:1: ", "time column");
}

}  // namespace
}  // namespace overturn
