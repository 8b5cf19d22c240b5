// Requirement R-1403: the page of a check that is filed holds its names and numbers as they are.
#include "output/record_page.hpp"

#include <gtest/gtest.h>

namespace overturn::output {
namespace {

TEST(RecordPage, TextsAreNoHtml) {
    auto const page = html_of({.title = "1 < 2",
                               .facts = {{"file", "\"a & b\".h5"}},
                               .head = {"check"},
                               .rows = {{.cells = {"<script>"}, .passed = false}}});
    EXPECT_NE(page.find("<h1>1 &lt; 2</h1>"), std::string::npos);
    EXPECT_NE(page.find("<dt>file</dt><dd>&quot;a &amp; b&quot;.h5</dd>"), std::string::npos);
    EXPECT_NE(page.find("<td>&lt;script&gt;</td>"), std::string::npos);
    EXPECT_EQ(page.find("<script>"), std::string::npos);
}

}  // namespace
}  // namespace overturn::output
