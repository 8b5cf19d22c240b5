// Requirement R-905: a page shows texts as they are: nothing in them is HTML.
#include <string>

#include <gtest/gtest.h>

#include "core/digit.hpp"
#include "core/escaped_html.hpp"

namespace overturn {
namespace {

TEST(EscapedHtml, NothingOfTheTextIsRead) {
    EXPECT_EQ(escaped_html("a < b & \"c\" > d"), "a &lt; b &amp; &quot;c&quot; &gt; d");
    EXPECT_EQ(escaped_html("ü '5' %"), "ü '5' %");
}

// Digits are those of ASCII alone.
TEST(IsDigit, OfAsciiAlone) {
    for (int letter = -128; letter < 128; ++letter) {
        auto const text = std::string(1, static_cast<char>(letter));
        EXPECT_EQ(is_digit(text[0]), std::string("0123456789").find(text) != std::string::npos) << letter;
    }
}

}  // namespace
}  // namespace overturn
