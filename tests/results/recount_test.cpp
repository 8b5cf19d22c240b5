// Requirement R-1003: a file's trials, counted from the columns that counts need, say what all of their columns say.
#include "results/recount.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

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

// A file of rows that no simulation gave: every verdict, effect, model and reason, and responses about the limits.
class Recount : public ::testing::Test {
  protected:
    Recount() {
        (void)write_results(
            path(), input_, spec_, plan_, plan_, [this](auto block) { return rows(block); }, written_);
    }

    [[nodiscard]] std::filesystem::path path() const { return folder_ / "c.h5"; }
    [[nodiscard]] Statistics const& written() const { return written_; }
    [[nodiscard]] CampaignSpec const& spec() const { return spec_; }
    [[nodiscard]] std::vector<std::pair<std::int64_t, FailureReason>> const& failed() const { return failed_; }

  private:
    std::vector<std::byte> rows(std::int64_t block) {
        auto const [first, count] = plan_.waves_of_block(block);
        BlockRows made;
        made.measures.resize(count * spec_.bodies.size());
        for (std::int64_t w = first; w < first + count; ++w) {
            made.waves.emplace_back();
            made.waves.back().id = plan_.wave_id(w);
            made.waves.back().duration_s = w == 1 ? 30 : 20.48;
        }
        auto const each = plan_.trials_per_wave();
        for (std::int64_t t = first * each; t < (first + count) * each; ++t) {
            made.trials.rows.push_back(row(t));
        }
        made.trials.extra.resize(made.trials.rows.size() * ModelSelector(spec_.effects, spec_.accuracy).extra_bytes());
        return made.pack();
    }

    TrialRow row(std::int64_t number) {
        auto const below = [&](std::size_t most) { return gsl_rng_uniform_int(stream_.gsl(), most); };
        auto const trial = plan_.trial(number);
        TrialRow row;
        row.wave = plan_.wave_id(trial.wave);
        row.body = trial.body;
        row.level = trial.level;
        row.amplitude = spec_.levels.levels.at(trial.level).value;
        row.verdict = verdicts()[below(verdicts().size())].value;
        row.required = static_cast<std::int64_t>(below(16));
        row.effects = static_cast<std::int64_t>(below(16));
        row.model = model_categories()[below(model_categories().size())].value;
        auto const reasons = reason_categories();
        row.reason = reasons[below(reasons.size())].value;
        row.v_wes_safe = static_cast<std::int64_t>(below(2));
        row.ou_v_e_safe = static_cast<std::int64_t>(below(2));
        row.peak_slip_m = 0.02 * static_cast<double>(below(4));
        row.peak_rotation_ratio = 0.1 * static_cast<double>(below(10));
        row.overturn_time_s = static_cast<double>(10 + below(30));
        row.time_of_peak_s = static_cast<double>(10 + below(30));
        if (row.verdict == Verdict::failed) {
            row.failure = failures()[below(failures().size())].value;
            failed_.emplace_back(number, row.failure);
        }
        return row;
    }

    testing::TemporaryFolder folder_;
    CampaignInput input_ = testing::input_from(testing::quick_waves + testing::type_a + "friction=0.5\n" + testing::type_b
                                               + testing::levels("values={from=1, to=6, count=100}\n")
                                               + "[[limits]]\nname='slips'\nquantity='peak_slip'\nabove='3 cm'\n"
                                                 "[[limits]]\nname='tilts'\nquantity='peak_rotation_ratio'\nabove=0.5\n"
                                                 "[[limits]]\nname='either'\nany=['slips', 'tilts']\n");
    CampaignSpec spec_ = parse_campaign(input_);
    Plan plan_{spec_};
    RandomStream stream_{3, 0, Purpose::body_scatter, 0};
    std::vector<std::pair<std::int64_t, FailureReason>> failed_;
    Statistics written_{spec_};
};

void expect_same(Statistics const& counted, Statistics const& all) {
    EXPECT_EQ(counted.waves().waves, all.waves().waves);
    ASSERT_EQ(counted.bodies().size(), all.bodies().size());
    for (std::size_t b = 0; b < all.bodies().size(); ++b) {
        auto const& one = counted.bodies()[b];
        auto const& other = all.bodies()[b];
        EXPECT_EQ(one.ends, other.ends);
        EXPECT_EQ(one.required, other.required);
        EXPECT_EQ(one.left_out, other.left_out);
        EXPECT_EQ(one.fell_after_record, other.fell_after_record);
        EXPECT_EQ(one.peaked_after_record, other.peaked_after_record);
        EXPECT_EQ(one.models, other.models);
        for (std::size_t limit = 0; limit < 4; ++limit) {
            for (std::size_t l = 0; l < 100; ++l) {
                EXPECT_EQ(one.stripes_of(limit)[l].overturned, other.stripes_of(limit)[l].overturned);
                EXPECT_EQ(one.stripes_of(limit)[l].undecided, other.stripes_of(limit)[l].undecided);
            }
        }
        for (std::size_t l = 0; l < 100; ++l) {
            EXPECT_EQ(one.v_wes[l].true_safe, other.v_wes[l].true_safe);
            EXPECT_EQ(one.ou_v_e[l].false_alarm, other.ou_v_e[l].false_alarm);
        }
    }
}

TEST_F(Recount, CountsFromFewColumnsWhatAllSay) {
    store::ResultsReader const file(path());
    auto const counted = recount(file, spec(), TrialsHeld::none);
    auto const all = recount(file, spec());

    expect_same(all, written());
    expect_same(counted, written());
    EXPECT_TRUE(counted.measured().singles(0, measure_named("level")).empty()) << "none is held";
    EXPECT_FALSE(all.measured().singles(0, measure_named("level")).empty());
}

TEST_F(Recount, NamesEveryFailedTrialWithItsReason) {
    store::ResultsReader const file(path());
    std::vector<std::pair<std::int64_t, FailureReason>> found;
    each_failed(file, spec(), [&](std::int64_t number, FailureReason reason) { found.emplace_back(number, reason); });

    EXPECT_GT(found.size(), 30U);
    EXPECT_EQ(found, failed());
}

}  // namespace
}  // namespace overturn
