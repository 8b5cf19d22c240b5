// Requirement R-107: columns of numbers are read with a stated unit only, and "auto" goes by content and never guesses.
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "core/units.hpp"
#include "motion/record.hpp"
#include "support/expect_input_error.hpp"
#include "support/read_record.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::exact_formula;
using testing::expect_input_error;
using testing::near;

constexpr double gal = 0.01;

GroundMotion read(std::string const& content, RecordRequest request = {.unit_mps2 = gal}) {
    request.name = "a.csv";
    return testing::read_record(content, request);
}

std::vector<double> const three{100 * gal, -200 * gal, 300 * gal};

// a unit in a column's name is read, and one that is stated otherwise is an error.
TEST(Columns, NamesMayStateTheUnit) {
    struct Named {
        char const* name;
        double si;
    };
    RecordRequest const silent;
    for (auto const& [name, si] : {Named{"ax_mps2", 1},
                                   {"acceleration (g)", g0},
                                   {"Acc(gal)", gal},
                                   {"NS [cm/s2]", gal},
                                   {"a_cmps2", gal},
                                   {"EW (m/s/s)", 1},
                                   {"acc_Gal", gal},
                                   {"a (mm/s2)", 1e-3},
                                   {"acc (m/s\xC2\xB2)", 1},
                                   {"acc (cm s^-2)", gal},
                                   {"acc (m.s-2)", 1},
                                   {"acc (ms-2)", 1},
                                   {"acc (mg)", 1e-3 * g0},
                                   {"acc (%g)", 1e-2 * g0},
                                   {"x (ft/s2)", 0.3048}}) {
        auto const text = std::string("time_s,") + name + "\n0,1\n0.5,-2\n1,3\n";
        EXPECT_EQ(read(text, silent).horizontal_mps2, (std::vector{1 * si, -2 * si, 3 * si})) << name;
    }
    for (char const* name : {"a_g", "acc", "a_horizontal", "acc (EW)"}) {
        auto const text = std::string("t,") + name + "\n0,100\n0.5,-200\n";
        expect_input_error([&] { (void)read(text, silent); }, "unit missing");
    }
    expect_input_error([&] { (void)read("t,a_mps2\n0,100\n0.5,-200\n"); }, "a.csv:1", "contradict");
    expect_input_error([&] { (void)read("t,x_mps2,y_gal\n0,1,1\n0.5,2,2\n", silent); }, "a.csv:1", "different units");
    auto const all = read("time_s,ax_mps2,ay_mps2,az_mps2\n0,1,2,3\n0.5,4,5,6\n", silent);
    EXPECT_EQ(all.transverse_mps2, (std::vector<double>{2, 5}));
    EXPECT_EQ(all.vertical_mps2, (std::vector<double>{3, 6}));
}

// no velocity or displacement is read as an acceleration, and no unit that is not known as the stated one.
TEST(Columns, WhatIsNoAccelerationIsLeftOutOrRefused) {
    for (char const* names : {"Time (s),Acc (cm/s2),Vel (cm/s)", "time,acc,vel", "t,a,velocity", "t,a,Disp_m",
                              "t,a,b (cm)", "t,a_mps2,v_mps", "Time [sec]  Acc [gal]  Velocity [cm/sec]"}) {
        auto const placed =
            read_placed(std::string(names) + "\n0,1,1\n0.5,2,2\n",
                        {.name = "a.csv",
                         .unit_mps2 = std::string_view(names).find("mps2") == std::string::npos ? std::optional(gal)
                                                                                                : std::nullopt});
        EXPECT_EQ(placed.components.size(), 1U) << names;
        ASSERT_FALSE(placed.statements.empty()) << names;
        EXPECT_TRUE(placed.statements.back().starts_with("left out: ")) << placed.statements.back();
    }
    for (char const* names : {"t,vel (cm/s)", "t,velocity", "Time [sec] Velocity [cm/sec]", "t,N-S(cm/s)",
                              "t,a (counts)", "t,vel (gal)", "t,Sa (g)"}) {
        auto const text = std::string(names) + "\n0,1\n0.5,2\n";
        expect_input_error([&] { (void)read(text); }, "a.csv:1: column '", "columns are a time and accelerations",
                           "Leave it out");
    }
    for (char const* unit : {"g/10", "in/s/Hz", "N"}) {
        auto const text = fmt::format("t,acc ({})\n0,1\n0.5,2\n", unit);
        if (std::string_view(unit) == "N") {
            EXPECT_NO_THROW((void)read(text)) << "a direction";
            continue;
        }
        expect_input_error([&] { (void)read(text); }, "a.csv:1: ", "is no unit of acceleration that is known");
    }
}

// times are in the unit that their column says, and may not contradict a comment.
TEST(Columns, TimesMayBeInMilliseconds) {
    for (char const* name : {"time (ms)", "t [msec]", "time_ms"}) {
        auto const motion = read(std::string(name) + ",acc\n0,100\n20,-200\n40,300\n");
        EXPECT_DOUBLE_EQ(motion.time_step_s, 0.02) << name;
        EXPECT_EQ(motion.horizontal_mps2, three);
    }
    auto const printed = read("time (ms),acc\n0,1\n3.3,2\n6.7,3\n10,4\n13.3,5\n16.7,6\n20,7\n");
    EXPECT_NEAR(printed.time_step_s, 0.02 / 6, 1e-12);
    expect_input_error([] { (void)read("# dt = 0.005 s\n0,1\n0.02,2\n0.04,3\n"); },
                       "a.csv:1: time step 0.005 s where the times rise by 0.02 s");
    EXPECT_NO_THROW((void)read("# dt = 20 ms\n0,1\n0.02,2\n0.04,3\n"));
}

TEST(Columns, TimeAndHorizontalInEveryDress) {
    for (char const* text : {"0,100\n0.5,-200\n1,300\n", "t,acc\n0,100\n0.5,-200\n1,300", "0 100\n0.5 -200\n1 300\n",
                             "t;acc\n0;100\n0.5; -200\n1 ;300\n", "0\t100\r\n0.5\t-200\r\n1\t300\r\n",
                             "\xEF\xBB\xBFt,acc\n0,100\n0.5,-200\n1,300\n",
                             "# Time Series: A 1992 - B-345\n# Time (s),Acceleration\n0.0,1.0E2\n0.5,-2.D2\n1,+300\n",
                             "% 1 2 3\n; 4\n  0 ,  100 \n\n 0.5 , -200\n#between\n 1.0, 300  \n\n",
                             "Time \x89\xC1\x91\xAC\x93\x78\n0,100\r\r\n0.5,-200\r\r\n1,300\r\r\n",
                             "5,100\n5.5,-200\n6,300\n", "-1 100\n-.5 -200\n0 300\n"}) {
        auto const motion = read(text);
        EXPECT_EQ(motion.time_step_s, 0.5) << text;
        EXPECT_EQ(motion.horizontal_mps2, three) << text;
        EXPECT_TRUE(motion.vertical_mps2.empty());
    }
}

TEST(Columns, ThirdColumnIsVertical) {
    auto const motion = read("time,a_horizontal,a_vertical\n0,100,10\n0.5,-200,20\n1,300,30\n");

    EXPECT_EQ(motion.horizontal_mps2, three);
    EXPECT_EQ(motion.vertical_mps2, (std::vector{10 * gal, 20 * gal, 30 * gal}));
    EXPECT_TRUE(motion.transverse_mps2.empty());
}

TEST(Columns, FourColumnsHoldBothHorizontalComponents) {
    for (char const* names : {"time,a_horizontal,a_transverse,a_vertical\n", "t,NS,EW,UD\n", "t,x,y,z\n",
                              "time_s,ax,ay,az\n", "time HNN HNE HNZ\n", "T (s),horizontal1,horizontal2,vertical\n"}) {
        auto const motion = read(names + std::string("0,100,1,10\n0.5,-200,2,20\n1,300,3,30\n"));
        EXPECT_EQ(motion.horizontal_mps2, three) << names;
        EXPECT_EQ(motion.transverse_mps2, (std::vector{1 * gal, 2 * gal, 3 * gal})) << names;
        EXPECT_EQ(motion.vertical_mps2, (std::vector{10 * gal, 20 * gal, 30 * gal})) << names;
    }
}

// no column finds its place by standing there: what has no name that is known is asked for.
TEST(Columns, WhatIsNotNamedIsAskedFor) {
    for (char const* names : {"", "t,one,two,three\n", "t,ch1,ch2,ch3\n", "t,comp1,comp2,comp3\n", "t,BN1,BN2,BN3\n"}) {
        auto const text = names + std::string("0,100,1,10\n0.5,-200,2,20\n1,300,3,30\n");
        expect_input_error([&] { (void)read(text); }, "a.csv:1: column ", "ambiguous", "State --columns time,h1,h2,v");
        auto const motion = read(text, {.unit_mps2 = gal, .columns = "time,h2,v,h1"});
        EXPECT_EQ(motion.horizontal_mps2, (std::vector{10 * gal, 20 * gal, 30 * gal}));
        EXPECT_EQ(motion.transverse_mps2, three);
        EXPECT_EQ(motion.vertical_mps2, (std::vector{1 * gal, 2 * gal, 3 * gal}));
        EXPECT_TRUE(read(text, {.unit_mps2 = gal, .columns = "time,h1,-,-"}).vertical_mps2.empty());
    }
    expect_input_error([] { (void)read("t,one,two,three\n0,1,2,3\n1,2,3,4\n", {.unit_mps2 = gal, .columns = "h1,v"}); },
                       "4 columns, 'h1,v' stated");
    expect_input_error([] { (void)read("t,one\n0,1\n1,2\n", {.unit_mps2 = gal, .columns = "time,up-ish"}); },
                       "'up-ish' for column 2");
}

// what is stated of a column may not contradict its name.
TEST(Columns, StatedColumnsMustNotContradictNames) {
    for (auto const& [names, stated] : {std::pair{"t,NS,UD", "time,v,h1"},
                                        {"t,vel (cm/s),acc", "time,h1,v"},
                                        {"index,time,acc", "time,h1,v"},
                                        {"acc,time,EW", "time,h1,h2"}}) {
        expect_input_error(
            [&, text = std::string(names) + "\n0,1,2\n1,2,3\n", columns = std::string(stated)] {
                (void)read(text, {.unit_mps2 = gal, .columns = columns});
            },
            "a.csv:1: column '", "contradict each other");
    }
}

TEST(Columns, NamesOfAnyOrderAreObeyed) {
    auto const two = read("time,acc_NS,acc_EW (gal)\n0,100,1\n0.5,-200,2\n1,300,3\n");
    EXPECT_EQ(two.transverse_mps2, (std::vector{1 * gal, 2 * gal, 3 * gal}));
    EXPECT_TRUE(two.vertical_mps2.empty());
    auto const up_first = read("t,UD,NS\n0,1,100\n0.5,2,-200\n1,3,300\n");
    EXPECT_EQ(up_first.horizontal_mps2, three);
    EXPECT_EQ(up_first.vertical_mps2, (std::vector{1 * gal, 2 * gal, 3 * gal}));
    expect_input_error([] { (void)read("t,d,v,a\n0,1,2,3\n1,1,2,3\n"); }, "a.csv:1: ", "'v'");
    expect_input_error([] { (void)read("t,NS,N\n0,1,2\n1,1,2\n"); }, "'NS' and 'N' (two of one direction)");
    for (char const* names :
         {"000,180", "000,010", "N10E,N20E", "350,010", "NS,000", "N30E,N10W", "EW,N80E", "N05E,S10W"}) {
        auto const text = std::string("time,") + names + "\n0,1,2\n1,1,2\n";
        expect_input_error([&] { (void)read(text, {.name = "a", .unit_mps2 = 1}); }, "two of one direction", "columns");
        EXPECT_NO_THROW((void)read(text, {.name = "a", .unit_mps2 = 1, .columns = "time,h1,h2"})) << names;
    }
    for (char const* names : {"000,090", "045,135", "N10E,S80E", "N10E,N80W", "NS,090", "230,320", "h1,h2", "N,E",
                              "S20W,N70W", "000,060"}) {
        EXPECT_NO_THROW((void)read(std::string("time,") + names + "\n0,1,2\n1,1,2\n", {.unit_mps2 = 1})) << names;
    }
}

TEST(Columns, ColumnsRecordedDownwardsAreTurned) {
    auto const motion = read("t,NS,DOWN\n0,100,1\n0.5,-200,2\n1,300,3\n");
    EXPECT_EQ(motion.vertical_mps2, (std::vector{-1 * gal, -2 * gal, -3 * gal}));
}

TEST(Columns, DecimalCommasAreRefused) {
    expect_input_error([] { (void)read("t;a\n0,00;1,5\n0,01;1,25\n"); }, "a.csv:2: ", "decimal point");
}

TEST(Columns, AnAbsurdPeakIsAWrongUnit) {
    expect_input_error([] { (void)read("0,341\n0.02,-200\n", {.unit_mps2 = 9.80665}); }, "a.csv: ", "peak of 341 g");
}

TEST(Columns, OneColumnNeedsATimeStep) {
    auto const motion = read("acc\n100\n-200\n300\n", {.unit_mps2 = gal, .time_step_s = 0.25});

    EXPECT_EQ(motion.horizontal_mps2, three);
    EXPECT_EQ(motion.time_step_s, 0.25);
    expect_input_error([] { (void)read("100\n-200\n300\n"); }, "a.csv:1: ", "time step missing");
    for (double const step : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
        expect_input_error([&] { (void)read("100\n-200\n", {.unit_mps2 = gal, .time_step_s = step}); },
                           "a.csv: ", "positive and finite");
    }
}

TEST(Columns, UnitIsNeverGuessed) {
    expect_input_error([] { (void)read("Time (s),Acceleration\n0,1\n0.5,2\n", {}); }, "a.csv:2: ", "unit missing",
                       "State --unit gal|g|m/s2");
}

TEST(Columns, PrintedRoundingOfTimesIsForgiven) {
    std::string text;
    for (int i = 0; i < 3000; ++i) {
        text += fmt::format("{:.5f},{}\n", i / 60.0, i % 2 == 0 ? 1 : -1);
    }
    EXPECT_TRUE(near(read(text).time_step_s, 1 / 60.0, testing::printed_digits));
}

TEST(Columns, NonUniformTimeIsRefusedAtItsLine) {
    expect_input_error([] { (void)read("t,a\n0,1\n1,1\n2,1\n4,1\n5,1\n6,1\n"); }, "a.csv:5: ", "from 2 to 4 s");
    expect_input_error([] { (void)read("0,1\n1,1\n1,1\n2,1\n3,1\n"); }, "a.csv:3: ", "uniform");
    expect_input_error([] { (void)read("t,a\n3,1\n2,1\n1,1\n"); }, "a.csv:3: ", "times rise");
    expect_input_error([] { (void)read("t,a\n0,1\n0,1\n0,1\n"); }, "a.csv:", "uniform");
    expect_input_error([] { (void)read("3,1\n2,1\n1,1\n"); }, "a.csv:1: column 1", "ambiguous");
    expect_input_error([] { (void)read("NS,EW,UD\n-0.012,0.064,-0.010\n0.005,0.028,-0.011\n-0.1,2,3\n"); },
                       "a.csv:2: ", "time step missing");
    expect_input_error([] { (void)read("0,1\n"); }, "a.csv:1: ", "one row only");
}

TEST(Columns, BadRowsAreRefusedAtTheirLine) {
    for (char const* bad :
         {"1,nan", "1,inf", "nan,1", "1,-Infinity", "1,x", "1,", "1,1,1", "1", "1,,1", "1;1;1", "1,1 # c", "1,1e999",
          "1,1.0E-06-2.0E-06", "1,\"x\"", "1,\"1", "1,1,", "1,1,1,1", "text", "t,acc"}) {
        expect_input_error([&] { (void)read("t,a\n0,1\n" + std::string(bad) + "\n2,1\n"); }, "a.csv:3: ");
    }
    expect_input_error([] { (void)read("nan,nan\n0,1\n1,1\n"); }, "a.csv:1: ", "not a finite number");
    expect_input_error(
        [] { (void)read("0,1,2,3,4\n1,1,2,3,4\n2,1,2,3,4\n3,1,2,3,4\n", {.format = "columns", .unit_mps2 = gal}); },
        "a.csv:1: ", "5 columns without names");
    expect_input_error([] { (void)read("# only\n", {.format = "columns", .unit_mps2 = gal}); }, "a.csv:1: ", "no row");
}

TEST(Columns, StatedStepMustNotContradictTheTimes) {
    EXPECT_NO_THROW((void)read("0,1\n0.5,1\n", {.unit_mps2 = gal, .time_step_s = 0.5}));
    expect_input_error([] { (void)read("0,1\n0.5,1\n", {.unit_mps2 = gal, .time_step_s = 0.25}); }, "contradict");
}

TEST(RecordFormats, AreRecognisedByContentOnly) {
    // A file of columns with another head than its format's: read by its statements, or asked for what they lack.
    expect_input_error([] { (void)read("SITE X,1,2\n LAT. 35\n UNIT gal\n NS,EW,UD\n1,2,3\n2,2,3\n", {}); },
                       "a.csv:5: ", "time step missing");
    expect_input_error([] { (void)read("<!DOCTYPE html>\n<html>\n"); }, "format not recognised");
    expect_input_error([] { (void)read(""); }, "empty");
    expect_input_error([] { (void)read("\xEF\xBB\xBF \r\n\n"); }, "a.csv: ");
    expect_input_error([] { (void)read(std::string("0\0,\0", 4)); }, "UTF-16");
    expect_input_error([] { (void)read("0,1\n1,1\n", {.format = "colums"}); }, "Did you mean 'columns'?");
}

// names, units and a rule may stand in lines of their own; a table without numbers is refused.
TEST(RecordFormats, HeadsOfSeveralLines) {
    for (char const* head : {"time,acc\n(s),(gal)\n", "# x\ntime,acc\ns,gal\n---,---\n",
                             "one\ntwo\nTime [s]  Acc [gal]\n", "Time\tAcc\nsec\tcm/s/s\n"}) {
        auto const motion = read(head + std::string("0,100\n0.5,-200\n1,300\n"), {});
        EXPECT_EQ(motion.horizontal_mps2, three) << head;
        EXPECT_EQ(motion.time_step_s, 0.5) << head;
    }
    expect_input_error([] { (void)read("time,a_horizontal\n"); }, "a.csv: ", "format not recognised");
    expect_input_error([] { (void)read("<html>\n"); }, "a.csv: ", "format not recognised");
}

TEST(RecordFormats, AreListedWithASummary) {
    ASSERT_EQ(record_formats().size(), 22U);
    for (auto const& format : record_formats()) {
        EXPECT_FALSE(format.summary.empty());
    }
}

}  // namespace
}  // namespace overturn
