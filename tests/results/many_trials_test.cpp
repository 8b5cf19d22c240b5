// Requirement R-712: of millions of trials all count in every curve and interval, in the memory that is stated.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <gsl/gsl_randist.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "core/random_stream.hpp"
#include "results/analysis.hpp"
#include "results/statistics.hpp"
#include "results/together.hpp"
#include "support/campaigns.hpp"

namespace overturn {
namespace {

constexpr double median_mps2 = 6;
constexpr double beta = 0.4;

// Rows of two bodies as a campaign of so many waves at twelve levels would give them: lognormal capacities over the
// level, a PGV that scatters about it.
class ManyRows {
  public:
    ManyRows()
        : spec_(testing::campaign_from(testing::quick_waves + testing::type_a + testing::type_b
                                       + testing::levels("values={from=2, to=13, count=12}\ndesign_basis=2\n"))),
          statistics_(spec_) {}

    void fill(std::int64_t waves) {
        for (std::int64_t w = 0; w < waves; ++w) {
            RandomStream stream(5, static_cast<std::uint64_t>(w), Purpose::body_scatter, 0);
            double const capacity = median_mps2 * std::exp(gsl_ran_gaussian(stream.gsl(), beta));
            WaveRow wave;
            wave.id = w;
            wave.pga_mps2 = 1;
            wave.pgv_mps = 0.1 * std::exp(gsl_ran_gaussian(stream.gsl(), 0.3));
            statistics_.add(wave, std::vector<MeasureRow>(spec_.bodies.size()));
            for (std::int64_t level = 0; level < 12; ++level) {
                for (int body = 0; body < 2; ++body) {
                    statistics_.add(trial(w, level, body, capacity));
                }
            }
        }
    }
    [[nodiscard]] CampaignSpec const& spec() const { return spec_; }
    [[nodiscard]] Statistics const& statistics() const { return statistics_; }

  private:
    [[nodiscard]] TrialRow trial(std::int64_t wave, std::int64_t level, int body, double capacity) const {
        TrialRow row;
        row.wave = wave;
        row.body = body;
        row.level = level;
        row.amplitude = row.scale = spec_.levels.levels[static_cast<std::size_t>(level)].value;
        bool const falls = row.amplitude > capacity * (body == 0 ? 1.2 : 1);
        row.verdict = falls ? Verdict::overturned : Verdict::rocked;
        row.v_wes_mps = 0.2 * row.amplitude;
        row.ou_v_e_mps = 0.4 * row.amplitude;
        row.v_ereq_mps = 1.35;
        row.peak_rotation_ratio = falls ? 4 : 0.3;
        row.response_velocity_mps = falls ? row.v_ereq_mps : 0.02 * row.amplitude;
        return row;
    }

    CampaignSpec spec_;
    Statistics statistics_;
};

double peak_gigabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) * 1024 / 1e9;
}

// More than the million at which curves once stopped learning.
TEST(ManyTrials, AllCount) {
    constexpr std::int64_t waves = 45'000;
    ManyRows rows;
    rows.fill(waves);
    auto const& trials = rows.statistics().measured();

    EXPECT_EQ(trials.passed_by(), 0);
    EXPECT_EQ(trials.singles(1, measure_named("pgv")).size(), 12U * waves);
    EXPECT_EQ(trials.singles(1, measure_named("pgv")).back().id, waves - 1);
    auto const together = bodies_together(rows.spec(), rows.statistics());
    auto const& counted = rows.statistics().bodies();
    ASSERT_EQ(together.front().joint.any.size(), 12U);
    for (std::size_t l = 0; l < 12; ++l) {
        EXPECT_EQ(together.front().joint.any[l].trials, waves);
        EXPECT_EQ(together.front().joint.any[l].overturned, counted[1].stripes[l].overturned) << "the weaker one";
    }
}

TEST(ManyTrials, TakeTheMemoryThatPlanStates) {
    ManyRows const rows;
    constexpr double bytes = 80 + 4 * 8;  // and four measures that do not scale: V_WES, ouV_E, both over V_Ereq
    EXPECT_EQ(memory_of_trials(rows.spec(), 1'000'000), 1e6 * bytes);
    EXPECT_EQ(memory_of_trials(rows.spec(), 1'000'000'000), static_cast<double>(most_trials_held) * bytes) << "bounded";
}

// By hand: OVERTURN_MANY_TRIALS=10000000 prints how long the curves of so many take, in which memory.
TEST(ManyTrials, Measured) {
    char const* const wanted = std::getenv("OVERTURN_MANY_TRIALS");
    if (wanted == nullptr) {
        GTEST_SKIP() << "OVERTURN_MANY_TRIALS is not set";
    }
    using Clock = std::chrono::steady_clock;
    auto const since = [](Clock::time_point begin) {
        return std::chrono::duration<double>(Clock::now() - begin).count();
    };
    auto const begin = Clock::now();
    ManyRows rows;
    rows.fill(std::stoll(wanted) / 24);
    std::printf("%s rows counted: %.1f s, %.2f GB at most\n", wanted, since(begin), peak_gigabytes());
    auto const fitted = Clock::now();
    auto const bodies = analyse(rows.spec(), rows.statistics(), {});
    std::printf("all curves: %.1f s, %.2f GB at most\n", since(fitted), peak_gigabytes());
    for (auto const& curve : bodies[1].fragility) {
        auto const& ends = curve.fit.intervals();
        std::printf("  %s: %lld waves, median %.5g [%.5g, %.5g]\n", curve.name.c_str(),
                    static_cast<long long>(curve.fit.waves), std::exp(curve.fit.line->log_median()), ends.median.lower,
                    ends.median.upper);
    }
    auto const& ends = bodies[1].over_levels().fit.intervals();
    EXPECT_NEAR(std::exp(bodies[1].over_levels().fit.line->log_median()) / median_mps2, 1, 0.01);
    EXPECT_LT(ends.median.upper / ends.median.lower, 1.01);
}

}  // namespace
}  // namespace overturn
