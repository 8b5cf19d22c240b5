// Requirement R-107: text that says which component a column is decides where the column's name is an axis or a number,
// and is an error where it contradicts a name; no column is placed by its name against the text.
#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

#include "motion/record.hpp"
#include "support/expect_input_error.hpp"
#include "support/read_record.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;
using Three = std::array<std::string, 3>;

constexpr double gal = 0.01;

/// \param names joined by commas
std::string under(std::string const& text, std::string const& names) {
    auto const columns = std::ranges::count(names, ',') + 1;
    auto const rows = columns == 2 ? "0,1\n0.01,-2\n0.02,3\n" : "0,1,10,100\n0.01,-2,-20,-200\n0.02,3,30,300\n";
    return fmt::format("{}\n{}\n{}", text, names, rows);
}

PlacedRecord read(std::string const& content) { return read_placed(content, {.name = "f", .unit_mps2 = gal}); }

void expect_refused(std::string const& content, char const* part = "--columns") {
    SCOPED_TRACE(content);
    expect_input_error([&] { (void)read(content); }, "f:1: ", part);
}

// Every order of three components, in every dress of the columns and of the text.
TEST(ComponentMapping, TheTextDecidesInEveryOrder) {
    Three const columns[] = {{"x", "y", "z"},
                             {"acc_x", "acc_y", "acc_z"},
                             {"ax (gal)", "ay (gal)", "az (gal)"},
                             {"X", "Y", "Z"},
                             {"u", "v", "w"},
                             {"ch1", "ch2", "ch3"},
                             {"Channel 1", "Channel 2", "Channel 3"},
                             {"CHN(1)", "CHN(2)", "CHN(3)"},
                             {"a1", "a2", "a3"}};
    Three const words[] = {{"x", "y", "z"},
                           {"x", "y", "z"},
                           {"x", "y", "z"},
                           {"x", "y", "z"},
                           {"u", "v", "w"},
                           {"ch1", "ch2", "ch3"},
                           {"Channel 1", "Channel 2", "Channel 3"},
                           {"Ch. 1", "Ch. 2", "Ch. 3"},
                           {"a1", "a2", "a3"}};
    Three const components[] = {{"NS", "EW", "UD"},           {"N", "E", "Z"},
                                {"north", "east", "up"},      {"longitudinal", "transverse", "vertical"},
                                {"000", "090", "vertical"},   {"HNN", "HNE", "HNZ"},
                                {"N10E", "S80E", "Vertical"}, {"North-South", "East-West", "Up-Down"}};
    constexpr auto forms = std::to_array<char const*>(
        {"# {0}={3} {1}={4} {2}={5}", "# {0}: {3}, {1}: {4}, {2}: {5}", "# {0} = {3}; {1} = {4}; {2} = {5}",
         "{0} ({3}), {1} ({4}), {2} ({5})", "# {0} -> {3}, {1} -> {4}, {2} -> {5}",
         "# ({0}, {1}, {2}) = ({3}, {4}, {5})", "# column 2: {3}, column 3: {4}, column 4: {5}",
         "# {0}: {3}\n# {1}: {4}\n# {2}: {5}"});
    int read_right = 0;
    for (std::size_t c = 0; c < std::size(columns); ++c) {
        for (auto const& named : components) {
            for (auto const* form : forms) {
                std::array order{0U, 1U, 2U};
                do {
                    auto const at = [&](std::size_t i) { return named.at(order.at(i)); };
                    auto const one = at(0), two = at(1), three = at(2);
                    auto const text =
                        fmt::format(fmt::runtime(form), words[c][0], words[c][1], words[c][2], one, two, three);
                    auto const content =
                        under(text, fmt::format("t,{},{},{}", columns[c][0], columns[c][1], columns[c][2]));
                    auto const upright = std::ranges::find(order, 2U) - order.begin();
                    SCOPED_TRACE(content);
                    try {
                        auto const motion = read(content).motion;
                        constexpr std::array firsts{1.0, 10.0, 100.0};
                        EXPECT_EQ(motion.vertical_mps2.front(), gal * firsts.at(static_cast<std::size_t>(upright)));
                        EXPECT_EQ(motion.horizontal_mps2.front(), gal * firsts.at(upright == 0 ? 1 : 0));
                        ++read_right;
                    } catch (InputError const& error) {
                        ADD_FAILURE() << error.what();
                    }
                } while (std::ranges::next_permutation(order).found);
            }
        }
    }
    EXPECT_EQ(read_right, std::size(columns) * std::size(components) * forms.size() * 6);
}

// files of results from before are read as they were meant.
TEST(ComponentMapping, ByPlaceTheTextDecidesNothing) {
    RecordRequest request{.name = "f", .unit_mps2 = gal, .by_place = true};
    EXPECT_EQ(read_placed(under("# x=NS y=UD z=EW", "t,x,y,z"), request).motion.vertical_mps2[0], 100 * gal);
}

TEST(ComponentMapping, IsReported) {
    auto const placed = read(under("# x=NS y=UD z=EW", "t,x,y,z"));
    EXPECT_EQ(placed.components, (std::vector<std::string>{"x", "z", "y"}));
    EXPECT_EQ(placed.statements, (std::vector<std::string>{"line 1: 'x' is horizontal", "line 1: 'y' is vertical",
                                                           "line 1: 'z' is horizontal"}));
    EXPECT_TRUE(placed.unread.empty());
    EXPECT_EQ(read(under("# z positive down", "t,x,y,z")).motion.vertical_mps2[0], -100 * gal);
    EXPECT_EQ(read(under("# UD: positive downwards", "t,NS,EW,UD")).motion.vertical_mps2[0], -100 * gal);
}

// in words of other languages, with what they add to a direction.
TEST(ComponentMapping, OtherLanguages) {
    for (char const* text :
         {"# x:\xE6\xA9\x8B\xE8\xBB\xB8\xE6\x96\xB9\xE5\x90\x91 "
          "y:\xE9\x89\x9B\xE7\x9B\xB4\xE6\x96\xB9\xE5\x90\x91 z:\xE6\xB0\xB4\xE5\xB9\xB3",
          "# x:\xE6\xB0\xB4\xE5\xB9\xB3 y:\xE4\xB8\x8A\xE4\xB8\x8B\xE5\x8B\x95 z:\xE6\xB0\xB4\xE5\xB9\xB3",
          "# eje x: norte, eje y: vertical, eje z: este",
          "# x: kuzey, y: d\xC3\xBC\xC5\x9F"
          "ey, z: do\xC4\x9Fu",
          "# x = Nord, y = Vertikal, z = Ost"}) {
        try {
            EXPECT_EQ(read(under(text, "t,x,y,z")).motion.vertical_mps2[0], 10 * gal) << text;
        } catch (InputError const& error) {
            EXPECT_NE(std::string(error.what()).find("f:1: "), std::string::npos) << error.what();
        }
    }
}

// the text says what it cannot be, or leaves others open.
TEST(ComponentMapping, WhatContradictsOrIsOpenIsAskedFor) {
    for (char const* text : {"# y is vertical", "# the y axis points upwards", "# vertical: y", "# z = EW",
                             "# components: NS, UD, EW", "# order: UD NS EW", "# x y UD", "NS, UD, EW of Kobe",
                             "# E Z N", "# the y component is that of the vertical actuator"}) {
        expect_refused(under(text, "t,x,y,z"));
    }
    expect_refused(under("# N = UD, E = NS, Z = EW", "t,N,E,Z"));
    expect_refused(under("# H1 = UD", "t,H1,H2,V"));
    expect_refused(under("# x = NS, x = UD", "t,x,y,z"));
    auto stated = RecordRequest{.name = "f", .unit_mps2 = gal};
    stated.columns = "time,h1,v,h2";
    EXPECT_EQ(read_placed(under("# y is vertical", "t,x,y,z"), stated).motion.vertical_mps2[0], 10 * gal);
}

// a component that the text states and no column is.
TEST(ComponentMapping, AStatedComponentIsOneOfTheColumns) {
    for (char const* text :
         {"# component EW", "# Comp. 090", "COMP. EW", "# Channel 2: EW", "# Direction: N80W", "# component UD",
          "1995 KOBE EW, dt = 0.01", "# Kobe E-W", "# file KOB_EW.txt", "# XX.ABC.00.HNE", "# UD of Kobe"}) {
        expect_refused(under(text, "t,NS"), "contradict");
    }
    expect_refused(under("# component EW", "t,UD"), "contradict");
    for (char const* text :
         {"# component NS", "# Comp: 360 deg", "# Component N40E", "# Channel 1: NS\n# Channel 2: EW",
          "# component: longitudinal", "# components: NS, EW, UD", "1995 KOBE NS, dt = 0.01", "# NS and EW",
          "# Station of the ew array", "# Comp: 3"}) {
        EXPECT_NO_THROW((void)read(under(text, "t,NS"))) << text;
    }
    EXPECT_NO_THROW((void)read(under("# component EW", "t,acc")));
    EXPECT_EQ(read(under("# Comp: 3", "t,acc")).unread, std::vector<std::string>{"line 1: '# Comp: 3'"});
    RecordRequest stated{.name = "f", .unit_mps2 = gal};
    stated.columns = "time,h1";
    EXPECT_NO_THROW((void)read_placed(under("1995 KOBE EW", "t,NS"), stated));
    EXPECT_NO_THROW((void)read(under("# component EW", "t,NS,EW,UD")));
}

// text of anything else says nothing of components.
TEST(ComponentMapping, OtherTextChangesNothing) {
    for (char const* text :
         {"# x-direction acceleration", "# Station at x = 35.2 N, y = 139.1 E, z = 20 m", "# components X Y Z",
          "# x horizontal, y horizontal, z vertical", "# X: longitudinal, Y: transverse, Z: vertical",
          "# y is not vertical", "# order: NS EW UD", "# N E Z", "# y x z", "# NS and UD of Kobe",
          "# x north, y east, z up"}) {
        auto const motion = read(under(text, "t,x,y,z")).motion;
        EXPECT_EQ(motion.horizontal_mps2[0], gal) << text;
        EXPECT_EQ(motion.vertical_mps2[0], 100 * gal) << text;
    }
}

// networks' files with rows of names in any order.
TEST(ComponentMapping, RowsOfNamesInAnyOrder) {
    Three names{"N-S", "E-W", "U-D"};
    std::ranges::sort(names);
    do {
        auto const nsmn = fmt::format(
            "STRONG GROUND MOTION RECORDS OF TURKIYE\nNUMBER OF DATA : 3\nSAMPLING INTERVAL "
            "(sec) : 0.01\n     {}     {}     {}\n1 10 100\n-2 -20 -200\n3 30 300\n",
            names[0], names[1], names[2]);
        auto const upright = static_cast<std::size_t>(std::ranges::find(names, "U-D") - names.begin());
        constexpr std::array firsts{1.0, 10.0, 100.0};
        EXPECT_EQ(read_placed(nsmn, {.name = "f"}).motion.vertical_mps2[0], gal * firsts.at(upright)) << nsmn;
        auto const asa2 = [&](Three const& above) {
            return fmt::format(
                "ARCHIVO ESTANDAR DE ACELERACION:\nNUMERO DE CANALES : 3\n"
                "ORIENTACION C1-C6 (rumbo;orientacion) : /{}/{}/{}\n"
                "INTERVALO DE MUESTREO, C1-C6 (s) : /0.01/0.01/0.01\n"
                "NUM. TOTAL DE MUESTRAS, C1-C6 : /3/3/3\nACEL. MAX.(Gal), C1-C6 : /3/30/300\n"
                "UNIDADES DE LOS DATOS : Gal\nDATOS DE ACELERACION:\n {} {} {}\n"
                "1 10 100\n-2 -20 -200\n3 30 300\n",
                names[0], names[1], names[2], above[0], above[1], above[2]);
        };
        EXPECT_EQ(read_placed(asa2(names), {.name = "f"}).motion.vertical_mps2[0], gal * firsts.at(upright));
        expect_input_error(
            [&] {
                (void)read_placed(asa2({names[1], names[2], names[0]}), {.name = "f"});
            },
            "f:9: ", "another order than the header's");
    } while (std::ranges::next_permutation(names).found);
}

}  // namespace
}  // namespace overturn
