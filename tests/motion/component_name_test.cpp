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
                         {"L", "Tr", "V"},
                         {"comp1", "comp2", "UD"},
                         {"000", "090", "UP"},
                         {"N10E", "N80W", "Vertical"},
                         {"CH1(NS)", "CH2(EW)", "CH3(UD)"},
                         {"acc (EW) [gal]", "acc (NS) [gal]", "acc (UD) [gal]"},
                         {"Acceleration NS", "Acceleration EW", "Acceleration UD"},
                         {"RSN1234_X_TCU049-N", "RSN1234_X_TCU049-E", "RSN1234_X_TCU049-V"},
                         {"Kuzey-G\xC3\xBCney", "Do\xC4\x9Fu-Bat\xC4\xB1",
                          "D\xC3\xBC\xC5\x9F"
                          "ey"},
                         {"\xE5\x8D\x97\xE5\x8C\x97", "\xE6\x9D\xB1\xE8\xA5\xBF", "\xE4\xB8\x8A\xE4\xB8\x8B"},
                         {"\xE4\xB8\x9C\xE8\xA5\xBF\xE5\x90\x91(gal)", "\xE5\x8D\x97\xE5\x8C\x97\xE5\x90\x91(gal)",
                          "\xE7\xAB\x96\xE5\x90\x91(gal)"},
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

TEST(ComponentNames, WhatIsNoneIsUnknown) {
    for (char const* name :
         {"",          "acc",          "Acceleration", "accelerations", "accele", "one",  "two",        "ch1",   "CHN",
          "comp3",     "H3",           "BN3",          "HNA",           "value",  "data", "index",      "a",     "ag",
          "station 7", "N-S vertical", "NS or UD",     "latitude",      "counts", "pga",  "acc 100 Hz", "series"}) {
        EXPECT_EQ(component_in(name).direction, Direction::unknown) << name;
    }
}

// every order of names, a time and an index among them: never a wrong place.
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
