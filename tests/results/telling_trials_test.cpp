// Requirement R-905: the trials to inspect are found among the stored ones: of every body the first overturned, the
// nearest miss, the largest slip, and verdicts that change back at a higher level.
#include "results/telling_trials.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "output/detail/event_text.hpp"
#include "support/campaigns.hpp"

namespace overturn {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr auto rest = Verdict::at_rest;
constexpr auto slid = Verdict::slid;
constexpr auto rocked = Verdict::rocked;
constexpr auto fell = Verdict::overturned;
constexpr auto lost = Verdict::contact_lost;
constexpr auto failed = Verdict::failed;

// Three waves, two bodies, three levels: eighteen trials, wave by wave, then body, then level.
CampaignSpec campaign(std::string const& levels = "values=[3,6,9]\n") {
    return testing::campaign_from(testing::quick_waves + testing::type_a + "friction=0.3\n" + testing::type_b
                                  + "friction=0.3\n" + testing::levels(levels));
}

std::vector<Verdict> const verdicts{rest, fell, rocked, rest, slid,   rocked,   // wave 0: non-monotonic
                                    rest, fell, fell,   slid, lost,   failed,   // wave 1
                                    fell, slid, rocked, rest, rocked, rocked};  // wave 2: non-monotonic, further
std::vector<double> const rotations{0, 1.6, 0.4, 0, 0, 0.95, 0, 1.6, 1.6, 0, 2, unknown, 1.6, 0.1, 0.7, 0, 0.95, 0.3};
std::vector<double> const slips{0, 9, 0.02, 0, 0.3, 0.1, 0, 9, 9, 0.05, unknown, unknown, 9, 0.5, 0.5, 0, 0.2, 0.3};

TEST(TrialsToInspect, AreTheOnesFoundByHand) {
    auto const spec = campaign();
    auto const found = telling_trials(spec, Plan(spec), {verdicts, rotations, slips});

    ASSERT_EQ(found.size(), 7U);
    auto const expect = [&](std::size_t place, TellingKind kind, std::int64_t trial, std::int64_t wave,
                            std::int64_t body, std::int64_t level) {
        auto const& t = found[place];
        EXPECT_EQ(t.kind, kind) << place;
        EXPECT_EQ(t.trial, trial) << place;
        EXPECT_EQ(t.wave, wave) << place;
        EXPECT_EQ(t.body, body) << place;
        EXPECT_EQ(t.level, level) << place;
        EXPECT_EQ(t.amplitude, 3.0 * static_cast<double>(level + 1)) << place;
        EXPECT_EQ(t.verdict, verdicts[static_cast<std::size_t>(trial)]) << place;
        EXPECT_EQ(t.peak_rotation_ratio, rotations[static_cast<std::size_t>(trial)]) << place;
        EXPECT_EQ(t.peak_slip_m, slips[static_cast<std::size_t>(trial)]) << place;
    };
    expect(0, TellingKind::first_overturned, 12, 2, 0, 0);  // the lowest level, though of a later wave
    expect(1, TellingKind::nearest_miss, 14, 2, 0, 2);      // not 1.6 of those that fell
    expect(2, TellingKind::largest_slip, 13, 2, 0, 1);      // of equal ones the first; not 9 m of those that fell
    expect(3, TellingKind::non_monotonic, 14, 2, 0, 2);     // farther above its fall than wave 0's; one a wave
    expect(4, TellingKind::non_monotonic, 2, 0, 0, 2);
    expect(5, TellingKind::nearest_miss, 5, 0, 1, 2);  // not the undecided one's 2
    expect(6, TellingKind::largest_slip, 4, 0, 1, 1);
    EXPECT_TRUE(std::isnan(found[0].overturned_at));
    EXPECT_EQ(found[3].overturned_at, 3);
    EXPECT_EQ(found[4].overturned_at, 6);
}

// what a base without friction wanders on points is no slip to look at.
TEST(TrialsToInspect, ShowNoSlipOfABodyWithoutFriction) {
    auto const spec = testing::campaign_from(testing::quick_waves + testing::type_a + testing::type_b
                                             + testing::levels("values=[3,6,9]\n"));
    for (auto const& trial : telling_trials(spec, Plan(spec), {verdicts, rotations, slips})) {
        EXPECT_NE(trial.kind, TellingKind::largest_slip);
    }
}

// A file that ended early holds the first waves; a wave of its own at every level can change nothing back.
TEST(TrialsToInspect, OfAPartAndOfIndependentWaves) {
    auto const shared = campaign();
    TrialColumns const first_wave{std::span(verdicts).first(6), std::span(rotations).first(6),
                                  std::span(slips).first(6)};
    auto const early = telling_trials(shared, Plan(shared), first_wave);
    ASSERT_EQ(early.size(), 6U);
    EXPECT_EQ(early[0].trial, 1);
    EXPECT_EQ(early[3].kind, TellingKind::non_monotonic);

    auto const independent = campaign("values=[3,6,9]\nwaves='independent'\n");
    for (auto const& t : telling_trials(independent, Plan(independent), {verdicts, rotations, slips})) {
        EXPECT_NE(t.kind, TellingKind::non_monotonic) << t.trial;
    }
}

TEST(TrialsToInspect, GiveTheCommandThatReplaysThem) {
    auto const spec = campaign();
    auto const found = telling_trials(spec, Plan(spec), {verdicts, rotations, slips});
    auto const text = output::telling_text(spec, found, "some.h5");

    EXPECT_NE(text.find("overturn replay some.h5 --trial N"), std::string::npos) << text;
    EXPECT_NE(text.find("fell at\n"), std::string::npos) << text;
    EXPECT_NE(text.find(spec.levels.text(3) + "\n"), std::string::npos) << text;
    EXPECT_EQ(text.find(" \n"), std::string::npos) << text;
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2 + 7) << text;
    EXPECT_EQ(output::telling_text(spec, std::vector<TellingTrial>{}, "some.h5"), "");
}

// Everyone gets one before anyone gets two, no one more than offered; of too many as many evenly spread get one.
TEST(TrialsToInspect, AreSharedFairly) {
    using Counts = std::vector<std::size_t>;
    EXPECT_EQ(share_fairly(Counts{5, 1, 0, 4}, 12), (Counts{5, 1, 0, 4}));
    EXPECT_EQ(share_fairly(Counts{5, 1, 0, 4}, 6), (Counts{3, 1, 0, 2}));
    EXPECT_EQ(share_fairly(Counts(14, 6), 14), Counts(14, 1));
    EXPECT_EQ(share_fairly(Counts{3, 3, 0, 3, 3, 3}, 2), (Counts{1, 0, 0, 1, 0, 0}));
    EXPECT_EQ(share_fairly(Counts{}, 12), Counts{});
    EXPECT_EQ(share_fairly(Counts{2, 2}, 0), (Counts{0, 0}));
}

}  // namespace
}  // namespace overturn
