// Requirement R-107: components find their place by their names, whatever their order, and what is no name of one finds
// none.
#include "motion/component_name.hpp"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

#include "motion/column_role.hpp"
#include "motion/record.hpp"
#include "support/expect_input_error.hpp"
#include "support/read_record.hpp"

namespace overturn {
namespace {

using Three = std::array<std::string, 3>;  // two horizontal ones, the vertical one

// As files in the wild have them; the last two in Shift_JIS and GB 18030.
Three const triples[] = {{"HNN", "HNE", "HNZ"},
                         {"HLN", "HLE", "HLZ"},
                         {"BN1", "BN2", "BNZ"},
                         {"HNR", "HNT", "HNZ"},
                         {"ENN", "ENE", "ENZ"},
                         {"HN1", "HN2", "HNZ"},
                         {"HG1", "HG2", "HGZ"},
                         {"CI.PAS.HNN.10", "CI.PAS.HNE.10", "CI.PAS.HNZ.10"},
                         {"TW.TCU049.00.HNN", "TW.TCU049.00.HNE", "TW.TCU049.00.HNZ"},
                         {"N", "E", "Z"},
                         {"NS", "EW", "UD"},
                         {"N-S", "E-W", "U-D"},
                         {"N-S(cm/s/s)", "E-W(cm/s/s)", "U-D(cm/s/s)"},
                         {"North-South", "East-West", "Up-Down"},
                         {"x", "y", "z"},
                         {"accX", "accY", "accZ"},
                         {"ax_mps2", "ay_mps2", "az_mps2"},
                         {"H1", "H2", "V"},
                         {"h1 (gal)", "h2 (gal)", "ver (gal)"},
                         {"horizontal1", "horizontal2", "vertical"},
                         {"Hor_1", "Hor_2", "Vert"},
                         {"Long", "Trans", "Vert"},
                         {"Longitudinal", "Lateral", "Vertical"},
                         {"Radial", "Transverse", "Up"},
                         {"FN", "FP", "UP"},
                         {"fault-normal", "fault-parallel", "vertical"},
                         {"CH1(N-S)", "CH2(E-W)", "CH3(U-D)"},
                         {"CHN(1) NS", "CHN(2) EW", "CHN(3) UD"},
                         {"Ch. 1 (090 deg)", "Ch. 2 (360 deg)", "Ch. 3 (UP)"},
                         {"S00E", "S90W", "UP"},
                         {"N00E", "N90E", "V"},
                         {"Nord-Sud", "Est-Ouest", "Verticale"},
                         {"Norte-Sur", "Este-Oeste", "Vertical"},
                         {"Nord-Sud", "Est-Ovest", "Verticale"},
                         {"Nord", "Ost", "Vertikal"},
                         {"L", "Tr", "V"},
                         {"comp1", "comp2", "UD"},
                         {"000", "090", "UP"},
                         {"N10E", "N80W", "Vertical"},
                         {"CH1(NS)", "CH2(EW)", "CH3(UD)"},
                         {"K-G", "D-B",
                          "D\xC3\xBC\xC5\x9F"
                          "ey"},
                         {"NS", "EO", "Vertical"},
                         {"Aceleracion N-S", "Aceleracion E-O", "Aceleracion V"},
                         {"Accelerazione Nord", "Accelerazione Est", "Accelerazione Z"},
                         {"Componente Norte", "Componente Oeste", "Componente Vertical"},
                         {"acc (EW) [gal]", "acc (NS) [gal]", "acc (UD) [gal]"},
                         {"Acceleration NS", "Acceleration EW", "Acceleration UD"},
                         {"RSN1234_X_TCU049-N", "RSN1234_X_TCU049-E", "RSN1234_X_TCU049-V"},
                         {"Kuzey-G\xC3\xBCney", "Do\xC4\x9Fu-Bat\xC4\xB1",
                          "D\xC3\xBC\xC5\x9F"
                          "ey"},
                         {"\xE5\x8D\x97\xE5\x8C\x97", "\xE6\x9D\xB1\xE8\xA5\xBF", "\xE4\xB8\x8A\xE4\xB8\x8B"},
                         {"\xE4\xB8\x9C\xE8\xA5\xBF\xE5\x90\x91(gal)", "\xE5\x8D\x97\xE5\x8C\x97\xE5\x90\x91(gal)",
                          "\xE7\xAB\x96\xE5\x90\x91(gal)"},
                         // Upper and lower, with the word for motion; in traditional characters; of Korea.
                         {"\xE5\x8D\x97\xE5\x8C\x97\xE5\x8B\x95(gal)", "\xE6\x9D\xB1\xE8\xA5\xBF\xE5\x8B\x95(gal)",
                          "\xE4\xB8\x8A\xE4\xB8\x8B\xE5\x8B\x95(gal)"},
                         {"NS\xE6\x88\x90\xE5\x88\x86", "EW\xE6\x88\x90\xE5\x88\x86", "UD\xE6\x88\x90\xE5\x88\x86"},
                         {"\xE5\x8D\x97\xE5\x8C\x97\xE5\x90\x91", "\xE6\x9D\xB1\xE8\xA5\xBF\xE5\x90\x91",
                          "\xE5\x9E\x82\xE7\x9B\xB4\xE5\x90\x91"},
                         {"\xE6\xB0\xB4\xE5\xB9\xB3"
                          "1",
                          "\xE6\xB0\xB4\xE5\xB9\xB3"
                          "2",
                          "\xE9\x89\x9B\xE7\x9B\xB4"},
                         {"\xEB\x82\xA8\xEB\xB6\x81", "\xEB\x8F\x99\xEC\x84\x9C", "\xEC\x83\x81\xED\x95\x98"},
                         {"\xEF\xBC\xAE\xEF\xBC\xB3", "\xEF\xBC\xA5\xEF\xBC\xB7", "\xEF\xBC\xB5\xEF\xBC\xA4"},
                         {"\x93\xEC\x96\x6B", "\x93\x8C\x90\xBC", "\x8F\xE3\x89\xBA"},
                         {"\xC4\xCF\xB1\xB1", "\xB6\xAB\xCE\xF7", "\xC9\xCF\xCF\xC2"}};

TEST(ComponentNames, AreFoundInEveryDress) {
    for (auto const& [one, other, up] : triples) {
        if (static_cast<unsigned char>(one[0]) < 0x80) {
            EXPECT_EQ(component_in(one).direction, Direction::horizontal) << one;
            EXPECT_EQ(component_in(other).direction, Direction::horizontal) << other;
            EXPECT_EQ(component_in(up).direction, Direction::up) << up;
            EXPECT_NE(component_in(one).axis, component_in(other).axis) << one;
        }
    }
    for (char const* name : {"DWN", "down", "acc_down"}) {
        EXPECT_EQ(component_in(name).direction, Direction::down) << name;
    }
}

// R-107: a bearing with blanks is one, and what a plain "H" stands before is the direction.
TEST(ComponentNames, AboutNinetyDegreesApart) {
    constexpr double right_deg = 90;
    for (auto const& [one, other] : {std::pair{"N 21 E", "N 69 W"},
                                     {"acc N 21 E (gal)", "acc N 69 W (gal)"},
                                     {"N 5 E", "S 85 E"},
                                     {"H-270", "H-180"},
                                     {"H_E", "H_N"},
                                     {"H E [gal]", "H N [gal]"}}) {
        auto const apart = degrees_between(component_in(one), component_in(other));
        ASSERT_TRUE(apart) << one;
        EXPECT_DOUBLE_EQ(*apart, right_deg) << one;
        auto const text = fmt::format("time (s),{},{}\n0,1,2\n0.01,-3,1\n0.02,2,-4\n0.03,-1,2\n", one, other);
        EXPECT_EQ(read_recording(text, {.name = "f", .unit_mps2 = 0.01}).components.size(), 2) << one;
    }
    EXPECT_EQ(component_in("H").axis, "h");
    EXPECT_EQ(component_in("N-S 2").axis, "n");
}

TEST(ComponentNames, WhatIsNoneIsUnknown) {
    for (char const* name :
         {"",          "acc",          "Acceleration", "accelerations", "accele", "one",  "two",        "ch1",   "CHN",
          "comp3",     "H3",           "BN3",          "HNA",           "value",  "data", "index",      "a",     "ag",
          "station 7", "N-S vertical", "NS or UD",     "latitude",      "counts", "pga",  "acc 100 Hz", "series"}) {
        EXPECT_EQ(component_in(name).direction, Direction::unknown) << name;
    }
}

// R-107: every order of names, a time and an index among them: never a wrong place.
TEST(ComponentNames, NoOrderMisplacesAComponent) {
    int read = 0;
    std::vector<int> order{0, 1, 2, 3, 4};  // horizontals, vertical, time, index
    for (std::size_t trial = 0; trial < std::size(triples) * 120; ++trial) {
        auto const& names = triples[trial % std::size(triples)];
        if (trial % std::size(triples) == 0) {
            std::ranges::next_permutation(order);
        }
        if (std::ranges::find(order, 3) - order.begin() > 2) {
            continue;  // times are looked for in the first three columns
        }
        std::string text;
        for (int row = -1; row < 3; ++row) {
            for (int const what : order) {
                static constexpr std::array others{"time (s)", "index"};
                auto const sign = row % 2 == 0 ? 1 : -1;
                auto const cell = row < 0     ? what < 3 ? names.at(static_cast<std::size_t>(what))
                                                         : std::string(others.at(static_cast<std::size_t>(what - 3)))
                                      : what == 3 ? fmt::format("{}", 0.5 * row)
                                  : what == 4 ? fmt::format("{}", row)
                                              : fmt::format("{}", sign * (what + 1));
                text += (text.empty() || text.back() == '\n' ? "" : ",") + cell;
            }
            text += '\n';
        }
        bool const has_unit = names[0].find("gal") != std::string::npos || names[0].find("/s") != std::string::npos
                              || names[0].find("mps2") != std::string::npos;
        RecordRequest request{.name = "p.csv"};
        request.unit_mps2 = has_unit ? std::nullopt : std::optional(1.0);
        auto const placed = read_placed(text, request);
        auto const& motion = placed.motion;
        double const unit = placed.unit_mps2;
        auto const first_horizontal = std::ranges::find_if(order, [](int what) { return what < 2; });
        EXPECT_EQ(motion.time_step_s, 0.5) << text;
        EXPECT_EQ(motion.horizontal_mps2[0], unit * (*first_horizontal + 1)) << text;
        EXPECT_EQ(motion.transverse_mps2[0], unit * (2 - *first_horizontal)) << text;
        EXPECT_EQ(motion.vertical_mps2[0], unit * 3) << text;
        ++read;
    }
    EXPECT_EQ(read, 72 * std::ssize(triples));
}

// R-107: names of different kinds in one table, as people mix them: placed right, or asked for.
TEST(ComponentNames, NamesOfDifferentKindsAreNeverMisplaced) {
    int placed_right = 0;
    int tables = 0;
    for (std::size_t i = 0; i < std::size(triples) * std::size(triples); ++i) {
        auto const& horizontals = triples[i % std::size(triples)];
        auto const& vertical = triples[i / std::size(triples)];
        Three const names{horizontals[0], horizontals[1], vertical[2]};
        std::vector<int> order{0, 1, 2};
        for (std::size_t turn = 0; turn < i % 6; ++turn) {
            std::ranges::next_permutation(order);
        }
        auto const at = [&](int place) { return static_cast<std::size_t>(order[static_cast<std::size_t>(place)]); };
        auto text = fmt::format("time (s),{},{},{}\n", names.at(at(0)), names.at(at(1)), names.at(at(2)));
        for (int row = 0; row < 4; ++row) {
            int const sign = row % 2 == 0 ? 1 : -1;
            text += fmt::format("{},{},{},{}\n", 0.5 * row, sign * (order[0] + 1), sign * (order[1] + 1),
                                sign * (order[2] + 1));
        }
        ++tables;
        bool const has_unit =
            std::ranges::any_of(names, [](std::string const& name) { return column_role(name).unit.has_value(); });
        RecordRequest request{.name = "p.csv"};
        request.unit_mps2 = has_unit ? std::nullopt : std::optional(1.0);
        try {
            auto const placed = read_placed(text, request);
            EXPECT_EQ(placed.motion.vertical_mps2[0], 3 * placed.unit_mps2) << text;
            placed_right += placed.motion.vertical_mps2[0] == 3 * placed.unit_mps2 ? 1 : 0;
        } catch (InputError const& error) {  // units of one name and not of another, encodings of two kinds
            EXPECT_NE(std::string(error.what()).find("p.csv:"), std::string::npos) << error.what();
        }
    }
    EXPECT_GT(tables, 1000);
    EXPECT_GT(placed_right, 3 * tables / 4);
}

// R-107: a column that names a time, a count of rows or seconds is no motion, in whatever place it stands.
TEST(ComponentNames, TimesAndCountsAreNeverMotions) {
    for (char const* name : {"time",
                             "Time (s)",
                             "t[s]",
                             "sec",
                             "seconds",
                             "elapsed time",
                             "\xE6\x99\x82\xE9\x96\x93(s)",
                             "\xE6\x99\x82\xE5\x88\xBB",
                             "tiempo",
                             "Zeit [s]",
                             "zaman (sn)",
                             "index",
                             "No.",
                             "No",
                             "#",
                             "Unnamed: 0",
                             "row",
                             "\xE7\x95\xAA\xE5\x8F\xB7",
                             "step",
                             "NS (s)",
                             "x (sec)"}) {
        for (int place = 0; place < 3; ++place) {
            std::string text;
            for (int row = -1; row < 4; ++row) {
                std::vector<std::string> cells{row < 0 ? "NS (gal)" : fmt::format("{}", row % 2 == 0 ? 7 : -7),
                                               row < 0 ? "UD (gal)" : fmt::format("{}", row % 2 == 0 ? 5 : -5)};
                cells.insert(cells.begin() + place, row < 0 ? name : fmt::format("{}", row));
                text += fmt::format("{},{},{}\n", cells[0], cells[1], cells[2]);
            }
            try {
                auto const placed = read_placed(text, {.name = "p.csv", .time_step_s = 1.0});
                EXPECT_EQ(placed.motion.horizontal_mps2[0], 7 * placed.unit_mps2) << text;
                EXPECT_EQ(placed.motion.vertical_mps2[0], 5 * placed.unit_mps2) << text;
                EXPECT_TRUE(placed.motion.transverse_mps2.empty()) << text;
            } catch (InputError const& error) {
                EXPECT_NE(std::string(error.what()).find("p.csv:"), std::string::npos) << error.what();
            }
        }
    }
}

TEST(ColumnRoles, QuantitiesAndUnits) {
    struct Said {
        char const* name;
        Quantity quantity;
        std::optional<double> unit;
    };
    for (auto const& [name, quantity, unit] :
         {Said{"Velocity [cm/sec]", Quantity::velocity, 0.01},
          {"N-S(cm/s)", Quantity::velocity, 0.01},
          {"Displacement [cm]", Quantity::displacement, 0.01},
          {"acc", Quantity::acceleration, {}},
          {"Acceleration in m/s2", Quantity::acceleration, 1.0},
          {"time(sec)", Quantity::time, 1.0},
          {"T (ms)", Quantity::time, 1e-3},
          {"index", Quantity::index, {}},
          {"", Quantity::index, {}},
          {"Counts", Quantity::counts, {}},
          {"NS (counts)", Quantity::counts, {}},
          {"Sa (g)", Quantity::spectrum, {}},
          {"poe-0.1", Quantity::hazard, {}},
          {"f", Quantity::frequency, {}},
          {"vel (gal)", Quantity::velocity, {}},
          {"\xE5\x8A\xA0\xE9\x80\x9F\xE5\xBA\xA6(gal)", Quantity::acceleration, 0.01},
          {"\xE9\x80\x9F\xE5\xBA\xA6", Quantity::velocity, {}},
          {"\xE6\x99\x82\xE9\x96\x93", Quantity::time, {}}}) {
        EXPECT_EQ(column_role(name).quantity, quantity) << name;
        EXPECT_EQ(column_role(name).unit, unit) << name;
    }
}

}  // namespace
}  // namespace overturn
