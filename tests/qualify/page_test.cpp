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
    EXPECT_NE(text.find("FAIL  X-02  a < b (sum & difference): 2 m, expected 2.5, error 5.0e-01 (at most 1.0e-01); "
                        "seen <here>"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("1 of 2 checks FAIL"), std::string::npos) << text;
    auto const json = json_of(shown);
    EXPECT_FALSE(json["passed"]);
    EXPECT_TRUE(json["checks"][0]["passed"]);
    EXPECT_FALSE(json["checks"][1]["passed"]);
    auto const page = page_of(shown);
    EXPECT_NE(page.find("class=\"fail\"><td>FAIL</td><td>X-02</td><td>a &lt; b</td>"), std::string::npos) << page;
    EXPECT_NE(page.find("sum &amp; difference"), std::string::npos);
    EXPECT_NE(page.find("1 of 2 checks FAIL"), std::string::npos);
}

// JSON knows no NaN.
TEST(QualifyPage, WhatWasNotFoundIsNull) {
    auto const shown = with({"X-02", "two", "sum", "m", std::numeric_limits<double>::quiet_NaN(), 2.5, 0.1});
    EXPECT_TRUE(json_of(shown)["checks"][1]["found"].is_null());
    EXPECT_FALSE(shown.passed());
}

}  // namespace
}  // namespace overturn::qualify
