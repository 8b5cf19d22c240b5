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

    [[nodiscard]] BlockRows rows(std::int64_t first, std::int64_t count) const {
        BlockRows block;
        for (std::int64_t w = first; w < first + count; ++w) {
            RandomStream stream(5, static_cast<std::uint64_t>(w), Purpose::body_scatter, 0);
            double const capacity = median_mps2 * std::exp(gsl_ran_gaussian(stream.gsl(), beta));
            WaveRow wave;
            wave.id = w;
            wave.pga_mps2 = 1;
            wave.pgv_mps = 0.1 * std::exp(gsl_ran_gaussian(stream.gsl(), 0.3));
            wave.duration_s = w % 5 == 0 ? 20 : 30;
            block.waves.push_back(wave);
            block.measures.resize(block.measures.size() + spec_.bodies.size());
            for (std::int64_t level = 0; level < 12; ++level) {
                for (int body = 0; body < 2; ++body) {
                    block.trials.rows.push_back(trial(w, level, body, capacity));
                }
            }
        }
        return block;
    }
    void fill(std::int64_t waves) {
        constexpr std::int64_t at_once = 1000;
        for (std::int64_t first = 0; first < waves; first += at_once) {
            statistics_.add(rows(first, std::min(at_once, waves - first)));
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
        row.overturn_time_s = falls ? 25 : never;  // after the end of some waves
        row.required = level % 4;
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

void hand_on(Statistics const& from, Statistics& to) {
    from.measured().give([](std::int64_t /*body*/) { return true; },
                         [&](std::string const& piece) { to.take_trials(piece); });
}

// What ranks do that merge together.
TEST(ManyTrials, CountedInPartsAreTheSame) {
    ManyRows whole;
    whole.fill(300);
    Statistics together(whole.spec());
    std::int64_t first = 0;
    for (std::int64_t const count : {1, 120, 179}) {
        Statistics part(whole.spec());
        part.add(whole.rows(first, count));
        together.add_counts(part.counts());
        hand_on(part, together);
        first += count;
    }
    EXPECT_EQ(together.counts(), whole.statistics().counts());
    auto const& of_body = together.bodies()[1];
    EXPECT_GT(of_body.fell_after_record[11], 30) << "a fifth of the waves are short";
    EXPECT_LT(of_body.fell_after_record[11], 65);
    EXPECT_EQ(of_body.stripes[11].trials, 300);
    EXPECT_EQ(together.waves().waves, 300);
    auto const kept = together.measured().singles(0, measure_named("pgv"));
    auto const held = whole.statistics().measured().singles(0, measure_named("pgv"));
    EXPECT_TRUE(std::ranges::equal(kept, held, [](auto const& a, auto const& b) {
        return a.intensity == b.intensity && a.wave == b.wave && a.overturned == b.overturned;
    }));
}

TEST(ManyTrials, AreCountedBeyondThoseThatAreHeld) {
    constexpr std::int64_t waves = 84'000;
    ManyRows rows;
    rows.fill(waves);
    auto const& held = rows.statistics().measured();
    auto const first_waves = static_cast<std::int64_t>((most_trials_held + 23) / 24);
    EXPECT_EQ(held.singles(0, measure_named("pgv")).back().id, first_waves - 1);
    EXPECT_EQ(held.passed_by(), (waves - first_waves) * 24);
    EXPECT_EQ(rows.statistics().bodies()[0].stripes[3].trials, waves);

    // By several processes: up to the same wave, whoever read it.
    Statistics all(rows.spec());
    for (std::int64_t const first : {0, 50'000}) {
        Statistics part(rows.spec());
        for (auto wave = first; wave < first + 50'000; wave += 1000) {
            part.add(rows.rows(wave, 1000));
        }
        hand_on(part, all);
    }
    EXPECT_EQ(all.measured().singles(0, measure_named("pgv")).back().id, first_waves - 1);
    EXPECT_EQ(all.measured().passed_by(), (100'000 - first_waves) * 24);
}

// What rank 0 gives the ranks that fit beside it: nothing of a body whose curves they do not fit.
TEST(ManyTrials, AreHandedOnInPieces) {
    constexpr std::int64_t waves = 6000;
    ManyRows rows;
    rows.fill(waves);
    Statistics of_one(rows.spec());
    Statistics of_all(rows.spec());
    int pieces = 0;
    rows.statistics().measured().give([](std::int64_t body) { return body == 1; },
                                      [&](std::string const& piece) { of_one.take_trials(piece); });
    rows.statistics().measured().give([](std::int64_t /*body*/) { return true; },
                                      [&](std::string const& piece) {
                                          EXPECT_LT(piece.size(), 5'000'000U);
                                          ++pieces;
                                          of_all.take_trials(piece);
                                      });
    EXPECT_GT(pieces, 3);
    auto const values = [](Statistics const& of, std::int64_t body, char const* measure) {
        std::vector<double> values;
        for (auto const& trial : of.measured().singles(body, measure_named(measure))) {
            values.insert(values.end(), {trial.intensity, static_cast<double>(trial.wave),
                                         static_cast<double>(trial.id), trial.overturned ? 1.0 : 0.0});
        }
        return values;
    };
    for (auto const* const measure : {"level", "pgv", "v_wes", "v_wes_ratio"}) {  // linear in the wave's scale, and not
        auto const held = values(rows.statistics(), 1, measure);
        EXPECT_EQ(held.size(), 4U * 12U * waves);
        EXPECT_EQ(values(of_one, 1, measure), held) << measure;
        EXPECT_EQ(values(of_all, 1, measure), held) << measure;
        EXPECT_TRUE(values(of_one, 0, measure).empty());
        EXPECT_EQ(values(of_all, 0, measure), values(rows.statistics(), 0, measure));
    }
}

TEST(ManyTrials, AreHandedOnWithHowManyWerePassedBy) {
    ManyRows rows;
    rows.fill(84'000);
    Statistics handed_on(rows.spec());
    rows.statistics().measured().give([](std::int64_t /*body*/) { return false; },
                                      [&](std::string const& piece) { handed_on.take_trials(piece); });
    EXPECT_GT(handed_on.measured().passed_by(), 0);
    EXPECT_EQ(handed_on.measured().passed_by(), rows.statistics().measured().passed_by());
}

// Of these more than counts is taken from waves, in their order.
TEST(ManyTrials, DoNotAddUpWhereWavesAreJudgedOrDrawnOneByOne) {
    auto const adds_up = [](std::string const& waves) {
        return Statistics::add_up(
            testing::campaign_from(waves + testing::type_a + testing::levels("values=[2.0, 4.0]\n")));
    };
    EXPECT_TRUE(adds_up(testing::quick_waves));
    auto judged = testing::quick_waves;
    judged.replace(judged.find("match='none'"), 12, "acceptance='japan'");
    EXPECT_FALSE(adds_up(judged));
    EXPECT_FALSE(adds_up("[waves]\nsource='harmonic'\namplitude='1 m/s2'\nfrequencies=[0.5, 1]\nduration='20 s'\n"));
    auto drawn = testing::quick_waves + "[waves.variability]\ncorrelation='baker-jayaram-2008'\nsigma=0.4\n";
    drawn.erase(drawn.find("match='none'\n"), 13);
    EXPECT_FALSE(adds_up(drawn));
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
