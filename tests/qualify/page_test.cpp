// Requirement R-1403: what fails in a qualification is called so, in text, JSON and page, and fails the whole of it;
// nothing that was not found passes.
#include "qualify/page.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace overturn::qualify {
namespace {

Qualification with(Check check) {
    Qualification shown;
    shown.checks = {{"X-01", "one", "sum", "1", 1, 1, 0}, std::move(check)};
    return shown;
}

TEST(QualifyCheck, PassesWithinItsTolerance) {
    Check check{"X-02", "two", "sum", "m", 2, 2.5, 0.5};
    EXPECT_TRUE(check.passed());
    EXPECT_TRUE(with(check).passed());
    check.found = 3.5;
    EXPECT_FALSE(check.passed());
    EXPECT_FALSE(with(check).passed());
    check.found = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(check.passed());
    check.found = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(check.passed());
}

TEST(QualifyPage, CallsAFailureSo) {
    auto const shown = with({"X-02", "a < b", "sum & difference", "m", 2, 2.5, 0.1, "seen <here>"});
    auto const text = text_of(shown);
    EXPECT_NE(text.find("PASS  X-01"), std::string::npos) << text;
    EXPECT_NE(
        text.find("FAIL  X-02  a < b (sum & difference): 2 m, expected 2.5, error 5.0e-01 (at most 1.0e-01); seen\n"
                  "            <here>\n"),
        std::string::npos)
        << text;
    EXPECT_NE(text.find("\n1 of 2 checks FAIL: X-02\n"), std::string::npos) << text;
    auto const json = json_of(shown);
    EXPECT_FALSE(json["passed"]);
    EXPECT_TRUE(json["checks"][0]["passed"]);
    EXPECT_FALSE(json["checks"][1]["passed"]);
    auto const page = page_of(shown);
    EXPECT_NE(page.find("class=\"fail\"><td>FAIL</td><td>X-02</td><td>a &lt; b</td>"), std::string::npos) << page;
    EXPECT_NE(page.find("sum &amp; difference"), std::string::npos);
    EXPECT_NE(page.find("1 of 2 checks FAIL: X-02"), std::string::npos);
}

// A printed number that is known to be wrong is no failure, and is not passed over either.
TEST(QualifyPage, ListsWhatDiffersFromItsSourceWithTheReason) {
    Check known{"X-02", "two", "misprint", "m", 2, 2.5, 0.1};
    known.differs_because = "rounded twice";
    auto shown = with(known);
    EXPECT_TRUE(shown.passed());
    EXPECT_FALSE(shown.checks[1].agrees());
    auto const text = text_of(shown);
    EXPECT_NE(
        text.find("DIFF  X-02  two (misprint): 2 m, expected 2.5, error 5.0e-01 (at most 1.0e-01); rounded twice"),
        std::string::npos)
        << text;
    EXPECT_NE(text.find("1 checks pass, and 1 differ from what is printed, each for its reason: X-02"),
              std::string::npos)
        << text;
    EXPECT_TRUE(json_of(shown)["checks"][0]["agrees"]);
    EXPECT_FALSE(json_of(shown)["checks"][1]["agrees"]);
    EXPECT_EQ(json_of(shown)["checks"][1]["differs_because"], "rounded twice");
    EXPECT_NE(page_of(shown).find("<td>DIFF</td><td>X-02</td>"), std::string::npos);

    shown.checks[1].found = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(shown.passed()) << "nothing was found";
    shown.checks[1].found = 2.45;
    EXPECT_EQ(text_of(shown).find("rounded twice"), std::string::npos) << "it agrees";
}

TEST(QualifyPage, ListsWhatIsLeftOut) {
    auto shown = with({"X-02", "two", "sum", "m", 2, 2, 0.1});
    shown.left_out = {{"three & four", "a report", "could not be consulted"}};
    EXPECT_NE(text_of(shown).find("left out: three & four (a report): could not be consulted\n"), std::string::npos);
    EXPECT_NE(text_of(shown).find("all 2 checks pass"), std::string::npos);
    EXPECT_EQ(json_of(shown)["left_out"][0]["reason"], "could not be consulted");
    EXPECT_NE(page_of(shown).find("<td>left out</td><td></td><td>three &amp; four</td><td>a report</td>"),
              std::string::npos);
}

// JSON knows no NaN.
TEST(QualifyPage, WhatWasNotFoundIsNull) {
    auto const shown = with({"X-02", "two", "sum", "m", std::numeric_limits<double>::quiet_NaN(), 2.5, 0.1});
    EXPECT_TRUE(json_of(shown)["checks"][1]["found"].is_null());
    EXPECT_FALSE(shown.passed());
}

}  // namespace
}  // namespace overturn::qualify
