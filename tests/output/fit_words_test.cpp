// Requirement R-704: what a reader must know of a fit is said in one sentence each, with its numbers.
#include "output/detail/fit_words.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "output/detail/fit_names.hpp"
#include "support/stripe_tables.hpp"

namespace overturn::output {
namespace {

using overturn::testing::fit_of;
using overturn::testing::table_of;

std::vector<std::string> words_of(FragilityFit const& fit) { return warnings_of(fit, {"m/s2"}, 0.95); }

std::ptrdiff_t with(std::vector<std::string> const& texts, std::string_view part) {
    return std::ranges::count_if(texts, [&](auto const& text) { return text.find(part) != std::string::npos; });
}

TEST(FitWords, BoundsWithoutACurveAreReportedFirst) {
    EXPECT_EQ(words_of(fit_of(table_of({{2, 100, 0}, {4, 100, 0}, {6, 100, 0}, {8, 100, 0}}))).at(0),
              "nothing overturned: no curve; P <= 0.03622 at 8 m/s2 (none of 100, 95 %)");
    EXPECT_EQ(words_of(fit_of(table_of({{2, 50, 50}, {4, 50, 50}}))).at(0),
              "everything overturned: no curve; P >= 0.9288 at 2 m/s2 (all of 50, 95 %)");
    auto const one = words_of(fit_of(table_of({{2, 100, 0}, {4, 100, 0}, {8, 200, 1}})));
    EXPECT_NE(one.at(0).find("at or above 8 m/s2; P there in [0.000126, 0.0276]"), std::string::npos) << one.at(0);
    EXPECT_EQ(with(one, "only one trial overturned"), 1);
    EXPECT_TRUE(one.at(0).ends_with("State higher levels")) << "more levels below would tell nothing: " << one.at(0);
    EXPECT_EQ(output::state_words(fit_of(table_of({{2, 100, 0}, {4, 100, 0}, {8, 200, 1}}))), "levels too low");
    auto const split = words_of(fit_of(table_of({{2, 20, 0}, {4, 20, 0}, {6, 20, 20}, {8, 20, 20}})));
    EXPECT_TRUE(
        split.at(0).ends_with("beta cannot be estimated; half of these trials overturn between 4 and 6 m/s2. "
                              "State more levels there"))
        << "neither a beta nor a median that the penalty makes up: " << split.at(0);
    EXPECT_EQ(output::state_words(fit_of(table_of({{2, 20, 0}, {4, 20, 0}, {6, 20, 20}, {8, 20, 20}}))),
              "levels too far apart");
    EXPECT_EQ(words_of(fit_of(table_of({{2, 20, 7}}))).at(0), "one level only: a curve needs two; see its interval");
    EXPECT_EQ(words_of(fit_of({})).at(0), "no trial has a verdict: nothing is known");
    EXPECT_EQ(grid_text(1), "a grid of 1 frequency is no sample: no curve");
    EXPECT_EQ(grid_text(15), "a grid of 15 frequencies is no sample: no curve");
}

// Trials without a verdict are counted.
TEST(FitWords, UndecidedTrialsAreCounted) {
    FragilityFit fit;
    fit.state = FragilityState::undecided;
    fit.undecided = 6;
    EXPECT_NE(words_of(fit).at(0).find("(6 in all)"), std::string::npos);
    EXPECT_EQ(name_of(fit.state), "undecided");
}

TEST(FitWords, StripesBesideADoubtfulPointAreReported) {
    auto const fit = fit_of(table_of({{2, 50, 1}, {3, 50, 40}, {4, 50, 10}, {6, 50, 45}, {8, 50, 49}}));
    auto const texts = warnings_of(fit, {"gal", 0.01}, 0.95);
    EXPECT_EQ(with(texts, "do not use the 5 % point or HCLPF; 1 of 50 at 200 gal: P in [0.000506, 0.107]"), 1)
        << fmt::format("{}", fmt::join(texts, "\n"));
}

TEST(FitWords, StripesOfFewAreReportedTogether) {
    auto const texts = words_of(fit_of(table_of({{2, 1000, 1}, {3, 1000, 2}, {4, 1000, 3}})));
    EXPECT_EQ(with(texts, "P <= 0.00435 at 2 m/s2, P >= 0.000734 at 4 m/s2 (6 of 3000"), 1) << texts.back();
}

TEST(FitWords, AQuoteInTheTailIsWarnedOf) {
    auto const fit =
        fit_of(table_of({{2, 200, 0}, {3, 54, 4}, {4, 54, 30}, {6, 54, 50}}), {{2, 1}, {3, 1.5}, {1, 0.5}});
    EXPECT_EQ(with(words_of(fit), "along the lognormal tail"), 1);
}

TEST(FitWords, GroupsThatCountAsOneAreReported) {
    auto const fit =
        fit_of({{.amplitude = 2, .trials = 200, .group_size = 10}, {.amplitude = 4, .trials = 200, .group_size = 10}});
    auto const text = words_of(fit).at(0);
    EXPECT_NE(text.find("(none of 200, counting 10 as one, 95 %)"), std::string::npos) << text;
}

/// The words of other limit states: nobody reads of overturning where slip was meant.
TEST(FitWords, OtherLimitStatesHaveTheirOwn) {
    FragilityRequest request;
    request.passing = Passing::exceeded;
    auto const none = fit_fragility(FragilityData::of_stripes(table_of({{2, 100, 0}, {8, 100, 0}})), request);
    auto const split = fit_fragility(FragilityData::of_stripes(table_of({{2, 100, 0}, {8, 100, 1}})), request);

    EXPECT_EQ(name_of(none.state, none.passing), "nothing-exceeded");
    EXPECT_EQ(words_of(none).at(0),
              "no trial exceeded the limit: no curve; P <= 0.03622 at 8 m/s2 (none of 100, 95 %)");
    EXPECT_EQ(with(words_of(split), "at most one level has both trials that exceed the limit and trials that do not"),
              1);
    EXPECT_EQ(with(words_of(split), "half of these trials exceed the limit at or above 8 m/s2; P there in ["), 1);
    EXPECT_EQ(with(words_of(split), "only one trial exceeded the limit: the fit depends"), 1);
    for (auto const& fit : {none, split}) {
        auto texts = words_of(fit);
        std::ranges::copy(names_of(fit.flags, fit.passing), std::back_inserter(texts));
        EXPECT_EQ(with(texts, "overturned"), 0) << fmt::format("{}", fmt::join(texts, "\n"));
    }
}

TEST(FitWords, FlagsHaveTheirNames) {
    EXPECT_EQ(names_of(bit(FragilityFlag::nothing_overturned) | bit(FragilityFlag::no_beta_u)),
              (std::vector<std::string>{"nothing-overturned", "no-beta-u"}));
}

// Every fit whose beta_U is wide says so, before anything but its state.
TEST(FitWords, AWideBetaUComesBeforeAnythingButTheState) {
    FragilityData data;
    for (double const a : {0.5, 1.0, 2.0}) {
        data.points.push_back({std::log(a), 100, std::round(100 * 0.5 * std::erfc(-std::log(a) / 0.4 / std::sqrt(2)))});
    }
    FragilityRequest request;
    request.beta_u = 3;
    auto const lines = warnings_of(fit_fragility(data, request), {"g", 1}, 0.95);
    ASSERT_FALSE(lines.empty());
    EXPECT_NE(lines.front().find("beta_U 3 divides HCLPF by 139"), std::string::npos) << lines.front();
    request.beta_u = 0.3;
    for (auto const& line : warnings_of(fit_fragility(data, request), {"g", 1}, 0.95)) {
        EXPECT_EQ(line.find("divides"), std::string::npos) << line;
    }
}

}  // namespace
}  // namespace overturn::output
