// Requirement R-905: a table for the terminal is as narrow as what stands in it, and goes on below where a line ends.
#include "output/detail/columns_text.hpp"

#include <gtest/gtest.h>

namespace overturn::output {
namespace {

TEST(ColumnsText, AreAsWideAsWhatStandsInThem) {
    EXPECT_EQ(
        columns_text(
            {{{"pga\ngal", {"5", "500"}}, {"P", {"0.0125", "1"}}}, {{"", {"design", ""}, TextColumn::Side::left}}}, 2),
        "  pga\n"
        "  gal       P\n"
        "    5  0.0125  design\n"
        "  500       1\n");
}

// wide characters take two columns, bytes beyond ASCII none of their own.
TEST(ColumnsText, CountColumnsNotBytes) {
    EXPECT_EQ(columns_text({{{"body", {"cask", "Beh\u00e4lter", "\u5bb9\u5668"}, TextColumn::Side::left},
                             {"slip", {"1", "20", "3"}}}}),
              "body      slip\n"
              "cask         1\n"
              "Beh\u00e4lter    20\n"
              "\u5bb9\u5668         3\n");
}

TEST(ColumnsText, StandCloserBeforeTheyGoOnBelow) {
    auto const wide = [](std::size_t width) { return TextGroup{{std::string(width, 'h'), {"1"}}}; };
    auto const two = columns_text({wide(49), wide(49)});
    EXPECT_EQ(two.find('\n'), 100U) << two;
    auto const one = columns_text({wide(50), wide(49)});
    EXPECT_EQ(one.find('\n'), 100U) << one;

    auto const below = columns_text({{{"T", {"a"}}, {std::string(48, 'b'), {"2"}}}, wide(48), wide(52)});
    std::string const blanks(47, ' ');
    EXPECT_EQ(below, "T  " + std::string(48, 'b') + "\na  " + blanks + "2\n" + "T  " + std::string(48, 'h') + "\na  "
                         + blanks + "1\n" + "T  " + std::string(52, 'h') + "\na  " + blanks + "    1\n");
}

}  // namespace
}  // namespace overturn::output
