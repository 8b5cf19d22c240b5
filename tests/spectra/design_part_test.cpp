// Requirement R-104: of a table with several ordinates the one that is named is read, line for line; nothing is
// guessed.
#include "spectra/detail/design_part.hpp"

#include <string>

#include <gtest/gtest.h>

#include "spectra/target_spectrum.hpp"
#include "support/expect_input_error.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

std::string const design =
    "# ASCE 7-16, 5 % damped\nPeriod (s),SaDesign (g),SaMCER (g)\n0.1,0.8,1.2\n1,0.5,0.75 # end\n";

TEST(DesignPart, AColumnIsTakenByItsName) {
    EXPECT_EQ(table_of_one_ordinate(design, "d.csv", "SaMCER"),
              "# ASCE 7-16, 5 % damped\nPeriod (s),SaMCER (g)\n0.1,1.2\n1,0.75 # end\n");
    EXPECT_EQ(table_of_one_ordinate(design, "d.csv", "SaDesign (g)"),
              "# ASCE 7-16, 5 % damped\nPeriod (s),SaDesign (g)\n0.1,0.8\n1,0.5 # end\n");
    auto const target = parse_target_table(*table_of_one_ordinate(design, "d.csv", "SaMCER"), "d.csv",
                                           TargetKind::acceleration, 0.05, std::nullopt);
    EXPECT_DOUBLE_EQ(target.psa_mps2(1), 0.75 * 9.80665);
}

// frequencies, semicolons and blanks part such tables as they do others.
TEST(DesignPart, SeparatorsAreThoseOfTheHeader) {
    EXPECT_EQ(table_of_one_ordinate("f (Hz);Sa [g];Sv [cm/s]\n1;2;3\n", "d.csv", "Sv"), "f (Hz),Sv [cm/s]\n1,3\n");
    EXPECT_EQ(table_of_one_ordinate("T(s) median(g) p84(g)\n1 2 3\n", "d.txt", "p84"), "T(s),p84(g)\n1,3\n");
}

// what a spectrum scatters by is no second one; it is left out, and reported.
TEST(DesignPart, SpreadsAreNoOrdinates) {
    for (std::string const spread : {"sigma", "Sa uncertainty (g)", "ln std", "dispersion", "Sa_sigma"}) {
        EXPECT_EQ(table_of_one_ordinate("T (s),Sa (g)," + spread + "\n1,2,3\n", "d.csv", ""),
                  "T (s),Sa (g) # left out: " + spread + "\n1,2\n");
    }
    for (std::string const other : {"Sa + 1 sigma (g)", "Sa 84th (g)"}) {
        expect_input_error([&] { (void)table_of_one_ordinate("T (s),Sa (g)," + other + "\n1,2,3\n", "d.csv", ""); },
                           "d.csv:1: 2 ordinates");
    }
    EXPECT_EQ(table_of_one_ordinate("T (s),Sa (g),Sv (m/s),sigma\n1,2,3,4\n", "d.csv", "Sv"), "T (s),Sv (m/s)\n1,3\n");
}

// two columns, and columns without names of such a table, are left to the reader of tables.
TEST(DesignPart, OtherTablesAreLeftAlone) {
    for (auto const* text : {"", "T,Sa\n1,2\n", "1 2\n", "1,2,3\n2,3,4\n", "site,lon,lat\n1,2,3\n"}) {
        EXPECT_FALSE(table_of_one_ordinate(text, "d.csv", "")) << text;
    }
}

// no part, a part that is none, one that stands twice, a row that is too short, each with its line.
TEST(DesignPart, WhatIsNotCertainIsRefused) {
    auto const refuse = [](std::string const& text, std::string const& part, std::string const& why) {
        expect_input_error([&] { (void)table_of_one_ordinate(text, "d.csv", part); }, "d.csv:", why);
    };
    refuse(design, "", "2: 2 ordinates: SaDesign (g), SaMCER (g) (which is meant?). State part = ");
    refuse(design, "Sa", "2: 2 ordinates: SaDesign, SaMCER ('Sa' is not one of them alone)");
    refuse("T,Sa (g),Sa (gal)\n1,2,3\n", "Sa", "1: 2 ordinates: Sa, Sa ('Sa' is not one of them alone)");
    refuse("T,Sa (g),Sv (m/s)\n1,2,3\n2,3\n", "Sv", "3:3: 2 columns (the header has 3)");
}

}  // namespace
}  // namespace overturn
