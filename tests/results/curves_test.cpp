// Requirement R-1001: curves that several processes fit are those of one, bit by bit.
#include "results/curves.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>
#include <gtest/gtest.h>

#include "campaign/block_rows.hpp"
#include "core/random_stream.hpp"
#include "output/write_results.hpp"
#include "response/registry.hpp"
#include "support/campaigns.hpp"
#include "support/temporary_folder.hpp"

namespace overturn {
namespace {

// A campaign of lognormal capacities: one body that scatters, a limit beside overturning, some trials undecided.
std::string campaign() {
    auto waves = testing::quick_waves;
    std::string const few = "count=3";
    return waves.replace(waves.find(few), few.size(), "count=120") + testing::type_a + testing::type_b
           + "restitution={distribution='lognormal',median=0.85,beta=0.1}\nfriction=0.5\n"
           + testing::levels("values={from=2, to=13, count=6}\ndesign_basis=2\n")
           + "[[limits]]\nname='tilts'\nquantity='peak_rotation_ratio'\nabove=0.5\n";
}

class SharedCurves : public ::testing::Test {
  protected:
    [[nodiscard]] std::vector<std::byte> rows(std::int64_t block) const {
        auto const [first, count] = plan.waves_of_block(block);
        BlockRows made;
        made.measures.resize(count * spec.bodies.size());
        for (std::int64_t w = first; w < first + count; ++w) {
            RandomStream stream(5, static_cast<std::uint64_t>(w), Purpose::body_scatter, 0);
            WaveRow wave;
            wave.id = static_cast<std::int64_t>(plan.wave_id(w));
            wave.pga_mps2 = 1;
            wave.pgv_mps = 0.1 * std::exp(gsl_ran_gaussian(stream.gsl(), 0.3));
            made.waves.push_back(wave);
            double const capacity = 6 * std::exp(gsl_ran_gaussian(stream.gsl(), 0.4));
            for (auto t = w * plan.trials_per_wave(); t < (w + 1) * plan.trials_per_wave(); ++t) {
                made.trials.rows.push_back(row(t, capacity * wave.pgv_mps / 0.1));
            }
        }
        made.trials.extra.resize(made.trials.rows.size() * ModelSelector(spec.effects, spec.accuracy).extra_bytes());
        return made.pack();
    }

    /// The file's bytes, with curves by `fit`.
    [[nodiscard]] std::string file(FitCurves const& fit) const {
        Statistics statistics(spec);
        (void)write_results(folder / "c.h5", input, spec, plan, plan, [&](auto block) { return rows(block); },
                            statistics, {}, store::Layout::plain, {.curves = fit});
        return testing::slurp(folder / "c.h5");
    }

    /// Fits by so many processes, each with every so-many-th curve and the trials of their bodies alone.
    [[nodiscard]] static FitCurves by_processes(CampaignSpec const& of_process, std::int64_t count) {
        return [&of_process, count](CampaignCurves const& curves) {
            std::vector<MeasuredFragility> all(curves.count());
            for (std::int64_t first = 0; first < std::min(count, curves.count()); ++first) {
                std::vector<bool> wanted(of_process.bodies.size());
                for (auto curve = first; curve < curves.count(); curve += count) {
                    wanted[curves.body_of(curve)] = true;
                }
                Statistics statistics(of_process);
                statistics.add_counts(curves.statistics().counts());
                curves.statistics().measured().give([&](std::int64_t body) { return wanted[body]; },
                                                    [&](std::string const& piece) { statistics.take_trials(piece); });
                CampaignCurves const own(of_process, statistics, curves.options());
                BytesOut out;
                for (auto curve = first; curve < curves.count(); curve += count) {
                    own.give(curve, out);
                }
                auto const bytes = out.take();
                BytesIn in(bytes);
                for (auto curve = first; curve < curves.count(); curve += count) {
                    all[curve] = curves.take(curve, in);
                }
                EXPECT_TRUE(in.at_end());
            }
            return all;
        };
    }

    testing::TemporaryFolder folder;
    CampaignInput input = testing::input_from(campaign());
    CampaignSpec spec = parse_campaign(input);
    Plan plan{spec};

  private:
    [[nodiscard]] TrialRow row(std::int64_t number, double capacity) const {
        constexpr std::int64_t undecided = 97;
        auto const trial = plan.trial(number);
        TrialRow row;
        row.wave = static_cast<std::int64_t>(plan.wave_id(trial.wave));
        row.body = trial.body;
        row.level = trial.level;
        row.amplitude = row.scale = spec.levels.levels[trial.level].value;
        bool const falls = row.amplitude > capacity * (trial.body == 0 ? 1.2 : 1);
        row.verdict = number % undecided == 0 ? Verdict::contact_lost : falls ? Verdict::overturned : Verdict::rocked;
        row.v_wes_mps = 0.2 * row.amplitude * (1 + 0.01 * static_cast<double>(trial.wave % 10));
        row.ou_v_e_mps = 0.4 * row.amplitude;
        row.v_ereq_mps = 1.35;
        row.peak_rotation_ratio = falls ? 4 : 0.7 * row.amplitude / capacity;
        return row;
    }
};

TEST_F(SharedCurves, AreThoseOfOneProcess) {
    auto const alone = file({});
    EXPECT_EQ(count_curves(spec), 2 * 2 * 5) << "bodies, limit states, measures";
    for (std::int64_t const processes : {2, 3, 100}) {
        EXPECT_TRUE(file(by_processes(spec, processes)) == alone) << processes;
    }
}

// Another seed resamples other waves.
TEST_F(SharedCurves, AreWhatTheProcessesMadeOfThem) {
    auto other = parse_campaign(input);
    other.seed = spec.seed + 1;
    EXPECT_FALSE(file(by_processes(other, 3)) == file({}));
}

}  // namespace
}  // namespace overturn
