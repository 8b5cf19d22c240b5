// Requirement R-713: a trial's history leaves at no instant less of the room than its row, whatever model follows it.
#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "campaign/judged.hpp"
#include "campaign/kept_history.hpp"
#include "campaign/trial.hpp"

namespace overturn {
namespace {

using testing::campaign_from;
using testing::Keeper;
using testing::Kept;
using testing::slides;
using testing::with_site;

// of a campaign's trial the other cask is that of its own trial, at the same instants.
TEST(SiteHistory, ATrialHasTheOtherOnesPath) {
    auto const spec = campaign_from(
        with_site("cask={plus_x='3 m'}\ncask_body='type-a'\n", slides + testing::type_a + "friction=0.05\n"));
    PhaseSeconds seconds;
    auto const wave = prepare_wave(spec, Plan(spec), 0, seconds);
    auto const history = [&](std::int64_t body) {
        Kept kept;
        Keeper keeper(kept);
        (void)run_trial(spec, wave, body, 1, &keeper);
        return kept.columns;
    };
    auto const own = history(0);
    auto const other = history(1);
    auto const& times = own.at("time_s");
    std::size_t met = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        auto const same = std::ranges::find(other.at("time_s"), times[i]) - other.at("time_s").begin();
        auto const at = static_cast<std::size_t>(same);
        if (at == other.at("time_s").size()) {
            continue;
        }
        ++met;
        double const left_m = 3 - own.at("reach_plus_x_m")[i] - other.at("reach_minus_x_m")[at];
        constexpr double a_step_m = 0.02;  // that it came back by since the instant before
        ASSERT_LE(own.at("clearance_m")[i], left_m + 1e-12) << times[i];
        ASSERT_GE(own.at("clearance_m")[i], left_m - a_step_m) << times[i];
    }
    EXPECT_GT(met, times.size() / 2);
    EXPECT_GT(std::ranges::max(other.at("reach_minus_x_m")), 0.1) << "it moves far more than by such a step";
}

struct Case {
    char const* name;
    char const* site;
    std::string bodies;
    char const* levels;
    friend void PrintTo(Case const& one, std::ostream* out) { *out << one.name; }
};

class SiteHistoryOf : public ::testing::TestWithParam<Case> {};

/// The least of a history before its body lies: a row ends with the last step before that.
double least_standing(Kept const& kept, std::string const& key) {
    auto const& tilts = kept.columns.at(kept.columns.contains("tilt_rad") ? "tilt_rad" : "rotation_rad");
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < tilts.size(); ++i) {
        least = std::abs(tilts[i]) < pi / 2 - 1e-12 ? std::min(least, kept.columns.at(key)[i]) : least;
    }
    return least;
}

// at no instant is less left than the row of the trial says, whatever model follows it; beside walls the row
// takes no more than three times what is lost: slip s and lean l count as of one instant and side, and at some instant
// the larger of s and l - s is lost.
TEST_P(SiteHistoryOf, TheRowHoldsAtEveryInstant) {
    auto const& of = GetParam();
    auto text = with_site(of.site, of.bodies);
    text.replace(text.find("values=[4,8]"), std::string("values=[4,8]").size(), of.levels);
    text.insert(text.find("[[bodies]]"), "[waves.transverse]\nratio=0.8\n");
    auto const spec = campaign_from(text);
    PhaseSeconds seconds;
    int moved = 0;
    for (std::int64_t number = 0; number < 3; ++number) {
        auto const wave = prepare_wave(spec, Plan(spec), number, seconds);
        for (std::int64_t level = 0; level < 2; ++level) {
            Kept kept;
            Keeper keeper(kept);
            auto const row = run_trial(spec, wave, 0, level, &keeper).rows.front();
            if (kept.columns.empty() || std::isnan(row.edge_margin_m)) {
                continue;
            }
            constexpr double rounding_m = 1e-9;
            double const clearance_m = least_standing(kept, "clearance_m");
            double const margin_m = least_standing(kept, "edge_margin_m");
            EXPECT_LE(row.least_clearance_m, clearance_m + rounding_m) << number << " " << level;
            EXPECT_LE(row.edge_margin_m, margin_m + rounding_m) << number << " " << level;
            moved += margin_m < 2 - 1e-3 ? 1 : 0;
            if (!spec.site.cask_body) {
                EXPECT_LT(3 - row.least_clearance_m, 3 * (3 - clearance_m) + 1e-3) << number << " " << level;
            }
        }
    }
    EXPECT_GE(moved, 3);
}

std::string const slender = testing::type_b;
INSTANTIATE_TEST_SUITE_P(
    Models, SiteHistoryOf,
    ::testing::Values(
        Case{"sliding", "wall='3 m'\nedge='2 m'\n", slides, "values=[4,8]"},
        Case{"slide_rock", "wall='3 m'\nedge='2 m'\n", slender + "friction=0.44\n", "values=[5,7]"},
        Case{"flat", "wall='3 m'\nedge='2 m'\n", slender + "friction=0.4\nbase={bedding='flat'}\naxes=1\n",
             "values=[5,7]"},
        Case{"square", "wall='3 m'\nedge='2 m'\n", slender + "friction=0.4\nbase={bedding='flat'}\n", "values=[4,6]"},
        Case{"round", "wall='3 m'\nedge='2 m'\n", slender + "friction=0.4\nbase={shape='round'}\n", "values=[4,6]"},
        Case{"neighbour", "cask='3 m'\ncask_body='type-a'\nedge='2 m'\nwall='4 m'\n",
             slides + testing::type_a + "friction=0.2\n", "values=[4,8]"},
        Case{"like", "cask='3 m'\nedge='2 m'\n", slides + "base={shape='round'}\n", "values=[4,6]"}),
    [](auto const& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace overturn
