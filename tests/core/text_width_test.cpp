// Requirement R-905: widths are columns of a terminal, not bytes; expected: Unicode Standard Annex 11 (East Asian
// width).
#include "core/text_width.hpp"

#include <gtest/gtest.h>

namespace overturn {
namespace {

TEST(TextWidth, CountsColumnsOfATerminal) {
    EXPECT_EQ(text_width(""), 0U);
    EXPECT_EQ(text_width("cask"), 4U);
    EXPECT_EQ(text_width("Beh\u00e4lter"), 8U);
    EXPECT_EQ(text_width("\u30ad\u30e3\u30b9\u30af"), 8U);  // kyasuku, four wide characters
    EXPECT_EQ(text_width("m/s\u00b2"), 4U);
}

TEST(TextWidth, CutsBetweenCharacters) {
    std::string_view const mixed = "\u00e4\u30ad b";
    EXPECT_EQ(text_head(mixed, 0), "");
    EXPECT_EQ(text_head(mixed, 1), "\u00e4");
    EXPECT_EQ(text_head(mixed, 2), "\u00e4") << "half a wide character is none";
    EXPECT_EQ(text_head(mixed, 3), "\u00e4\u30ad");
    EXPECT_EQ(text_head(mixed, 9), mixed);
    EXPECT_EQ(text_tail(mixed, 0), "");
    EXPECT_EQ(text_tail(mixed, 2), " b");
    EXPECT_EQ(text_tail(mixed, 3), " b");
    EXPECT_EQ(text_tail(mixed, 4), "\u30ad b");
    EXPECT_EQ(text_tail(mixed, 9), mixed);
}

}  // namespace
}  // namespace overturn
