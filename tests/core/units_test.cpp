// Requirement R-901: every input quantity accepts a unit of its own dimension, a bare number is SI, anything else is
// refused.
#include "core/units.hpp"

#include "support/expect_input_error.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;
using testing::near;

TEST(Units, FieldUnitsAreConverted) {
    EXPECT_TRUE(near(parse_quantity("117 t", Dimension::mass), 117000, testing::rounding));
    EXPECT_TRUE(near(parse_quantity("892 gal", Dimension::acceleration), 8.92, testing::rounding));
    EXPECT_TRUE(near(parse_quantity("100 kine", Dimension::velocity), 1.0, testing::rounding));
    EXPECT_TRUE(near(parse_quantity("0.3 g", Dimension::acceleration), 0.3 * 9.80665, testing::rounding));
    EXPECT_TRUE(near(parse_quantity("5 min", Dimension::time), 300, testing::rounding));
    EXPECT_TRUE(near(parse_quantity("12 t m2", Dimension::inertia), 12000, testing::rounding));
}

TEST(Units, BareNumberIsSi) { EXPECT_EQ(parse_quantity(" 3.4 ", Dimension::length), 3.4); }

TEST(Units, WrongUnitIsRefusedWithTheAcceptedOnes) {
    expect_input_error([] { (void)parse_quantity("3 gal", Dimension::mass); }, "'gal'", "not a unit of mass", "kg, t");
    expect_input_error([] { (void)parse_quantity("0.5 m", Dimension::none); }, "pure number");
}

TEST(Units, NotANumberIsRefused) {
    for (char const* text : {"", "m", "1,5 m", "nan", "inf", "1e999", "0x10", "1.5m"}) {
        expect_input_error([&] { (void)parse_quantity(text, Dimension::length); });
    }
}

TEST(Units, NumbersOfOldFortranFilesAreRead) {
    double value = 0;
    EXPECT_TRUE(parse_number(".8075668E-03", value));
    EXPECT_EQ(value, 0.8075668e-3);
    EXPECT_TRUE(parse_number("+1.5D-03", value));
    EXPECT_EQ(value, 1.5e-3);
    EXPECT_TRUE(parse_number("-.5", value));
    EXPECT_EQ(value, -0.5);
    EXPECT_FALSE(parse_number("+-1", value));
    EXPECT_FALSE(parse_number("1 2", value));
}

}  // namespace
}  // namespace overturn
