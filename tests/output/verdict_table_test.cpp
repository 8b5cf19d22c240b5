// Requirement R-701: the ends of every row of a table of verdicts, printed or as columns, are all of its trials.
#include <numeric>
#include <sstream>

#include <gtest/gtest.h>

#include "core/random_stream.hpp"
#include "output/stripe_text.hpp"
#include "response/registry.hpp"
#include "results/statistics.hpp"
#include "support/campaigns.hpp"

namespace overturn {
namespace {

/// A campaign of 60 waves, whose trials end anyhow among some of the verdicts.
Statistics ended_among(CampaignSpec const& spec, std::span<Verdict const> verdicts, std::uint64_t draw) {
    Statistics statistics(spec);
    RandomStream stream(3, draw, Purpose::body_scatter, 0);
    for (std::int64_t wave = 0; wave < 60; ++wave) {
        WaveRow row;
        row.id = wave;
        row.pga_mps2 = 3;
        statistics.add(row, std::vector<MeasureRow>(spec.bodies.size()));
        for (std::int64_t l = 0; l < std::ssize(spec.levels.levels); ++l) {
            TrialRow trial;
            trial.wave = wave;
            trial.level = l;
            trial.amplitude = spec.levels.levels[static_cast<std::size_t>(l)].value;
            trial.verdict = verdicts[gsl_rng_uniform_int(stream.gsl(), verdicts.size())];
            statistics.add(trial);
        }
    }
    return statistics;
}

// The whole numbers that rows begin with: level, trials, ends; P is none.
std::vector<std::vector<int>> rows_of(std::string const& text) {
    std::vector<std::vector<int>> rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::vector<int> row;
        for (std::string word; words >> word && word.find_first_not_of("0123456789") == std::string::npos;) {
            row.push_back(std::stoi(word));
        }
        if (row.size() > 4) {
            rows.push_back(row);
        }
    }
    return rows;
}

// Verdicts in every mixture: all of them, each alone, and by chance.
TEST(VerdictTable, EndsAddUpToTrials) {
    auto const spec = testing::campaign_from(testing::quick_waves + testing::type_b + "friction=0.5\n"
                                             + testing::levels("values=[3, 6, 9]\n") + "[measures]\nenergy=false\n");
    for (std::uint64_t mixture = 1; mixture < (1U << verdicts().size()); mixture += 5) {
        std::vector<Verdict> among;
        for (std::size_t v = 0; v < verdicts().size(); ++v) {
            if ((mixture >> v & 1) != 0) {
                among.push_back(verdicts()[v].value);
            }
        }
        auto const statistics = ended_among(spec, among, mixture);
        auto const text = output::stripes_text(spec, statistics, std::nullopt);
        auto const rows = rows_of(text);
        ASSERT_EQ(rows.size(), 3U) << text;
        for (auto const& row : rows) {
            EXPECT_EQ(row[1], 60) << text;
            EXPECT_EQ(std::accumulate(row.begin() + 2, row.end(), 0), row[1]) << text;
        }
    }
}

}  // namespace
}  // namespace overturn
