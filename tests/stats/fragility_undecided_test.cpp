// Requirement R-706: trials without a verdict are neither forgotten nor guessed: intervals hold whatever they would
// have done, and where that decides the median there is none.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "stats/fragility.hpp"

namespace overturn {
namespace {

std::vector<Stripe> stripes_with(std::vector<std::int64_t> const& undecided) {
    std::vector<Stripe> stripes{{.amplitude = 4, .trials = 100, .overturned = 2},
                                {.amplitude = 6, .trials = 100, .overturned = 20},
                                {.amplitude = 8, .trials = 100, .overturned = 50},
                                {.amplitude = 11, .trials = 100, .overturned = 80},
                                {.amplitude = 14, .trials = 100, .overturned = 95}};
    for (std::size_t i = 0; i < undecided.size(); ++i) {
        stripes[i].undecided = undecided[i];
    }
    return stripes;
}

// The same stripes if each undecided trial had stood, or fallen.
std::vector<Stripe> as_if(std::vector<Stripe> stripes, bool fallen) {
    for (auto& stripe : stripes) {
        stripe.overturned += fallen ? stripe.undecided : 0;
        stripe.undecided = 0;
    }
    return stripes;
}

FragilityFit fit_of(std::vector<Stripe> const& stripes) {
    FragilityRequest request;
    request.beta_u = 0.3;
    return fit_fragility(FragilityData::of_stripes(stripes), request);
}

/// Property: the ends are the outermost of those of the three tables that the trials might have made.
TEST(Undecided, IntervalsAreTheHullOfBothExtremes) {
    auto const stripes = stripes_with({0, 0, 4, 5, 5});
    auto const fit = fit_of(stripes);
    auto const standing = fit_of(as_if(stripes, false));
    auto const fallen = fit_of(as_if(stripes, true));

    ASSERT_TRUE(fit.identifiable() && standing.identifiable() && fallen.identifiable());
    auto const expect_hull = [](Interval const& of, Interval const& a, Interval const& b, Interval const& own) {
        EXPECT_EQ(of.lower, std::min({a.lower, b.lower, own.lower}));
        EXPECT_EQ(of.upper, std::max({a.upper, b.upper, own.upper}));
    };
    auto const& own = *fit.profile;
    expect_hull(fit.intervals().median, standing.profile->median, fallen.profile->median, own.median);
    expect_hull(fit.intervals().beta, standing.profile->beta, fallen.profile->beta, own.beta);
    expect_hull(*fit.intervals().hclpf, *standing.profile->hclpf, *fallen.profile->hclpf, *own.hclpf);
    EXPECT_GT(fit.intervals().median.upper - fit.intervals().median.lower, own.median.upper - own.median.lower);
    EXPECT_TRUE(has(fit.flags, FragilityFlag::undecided_trials));
}

/// One in twenty of a stripe below the median is the last that leaves one; far above it they do not matter.
TEST(Undecided, TooManyBelowTheMedianLeaveNone) {
    EXPECT_TRUE(fit_of(stripes_with({0, 5, 0, 0, 0})).identifiable());
    auto const none = fit_of(stripes_with({0, 6, 0, 0, 0}));
    EXPECT_EQ(none.state, FragilityState::undecided);
    EXPECT_FALSE(none.identifiable());
    EXPECT_FALSE(none.profile || none.ends);
    EXPECT_EQ(none.undecided, 6);
    EXPECT_TRUE(fit_of(stripes_with({0, 0, 0, 0, 5})).identifiable());
}

/// A stripe in which none is decided is no stripe of the curve, and yet decides that there is none.
TEST(Undecided, AStripeWithoutAnyVerdictCounts) {
    auto stripes = stripes_with({});
    stripes.insert(stripes.begin() + 2, Stripe{.amplitude = 7, .trials = 100, .undecided = 100});
    EXPECT_EQ(fit_of(stripes).state, FragilityState::undecided);
}

/// Single trials: a tenth of them stands for a stripe; P at a quoted intensity is then given by no curve.
TEST(Undecided, SingleTrialsAreJudgedInTenths) {
    std::vector<SingleTrial> decided;
    std::vector<SingleTrial> open;
    for (std::int64_t i = 0; i < 1000; ++i) {
        double const at = 2 + 0.01 * static_cast<double>(i);
        bool const fell = (i * 7919) % 1000 < i;
        (i >= 300 && i < 320 ? open : decided).push_back({at, i, fell});
    }
    FragilityRequest request;
    request.quotes = {{3, 1}};
    auto const fit = fit_fragility(FragilityData::of_trials(decided, false, open), request);
    EXPECT_EQ(fit.state, FragilityState::undecided);
    EXPECT_EQ(fit.undecided, 20);
    EXPECT_FALSE(fit.quotes[0].probability);
    open.resize(3);
    EXPECT_TRUE(fit_fragility(FragilityData::of_trials(decided, false, open), request).identifiable());
}

}  // namespace
}  // namespace overturn
