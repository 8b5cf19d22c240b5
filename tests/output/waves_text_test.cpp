// Requirement: every output states how many waves missed their rule, which of its clauses, and how much
// the waves differ beside what was stated.
#include "output/waves_text.hpp"

#include <gtest/gtest.h>

namespace overturn::output {
namespace {

Acceptance srp() {
    Acceptance acceptance;
    acceptance.rule = "srp-3.7.1";
    return acceptance;
}

WaveCounts counts_of(std::int64_t waves, std::int64_t refused) {
    WaveCounts counts;
    counts.waves = waves;
    counts.refused = refused;
    return counts;
}

TEST(WavesText, RefusedOnesAreCountedWithTheirShare) {
    EXPECT_EQ(waves_text(counts_of(4, 0), srp(), 0.95),
              "4 waves that meet srp-3.7.1; 0 of 4 drawn were refused: 0 % [0 %, 60.2 %]");
    EXPECT_EQ(waves_text(counts_of(0, 4), srp(), 0.95),
              "0 waves that meet srp-3.7.1; 4 of 4 drawn were refused: 100 % [39.8 %, 100 %]");
}

// Of 50 asked for and 50 drawn at most, 49.
TEST(WavesText, FewerThanRequestedAreReported) {
    auto acceptance = srp();
    for (auto const most : {1, 2}) {
        acceptance.most_drawn = most;
        auto const text = waves_text(counts_of(49, 1), acceptance, 0.95);
        EXPECT_EQ(text.find("fewer waves are used than waves.count") != std::string::npos, most == 1) << text;
    }
}

TEST(WavesText, NothingIsReportedWhereNothingIsAmiss) {
    EXPECT_EQ(waves_text(counts_of(9, 0), {}, 0.95), "");
    auto counts = counts_of(9, 0);
    counts.failed = 2;
    counts.missed = 1;
    EXPECT_EQ(waves_text(counts, {}, 0.95),
              "9 waves, 1 outside match_tolerance, but used, 2 could not be made (their trials are failed "
              "rows)");
}

TEST(WavesText, UsedWavesThatMissTheirRuleAreReported) {
    auto acceptance = srp();
    auto counts = counts_of(9, 0);
    counts.not_accepted = 3;
    EXPECT_EQ(waves_text(counts, acceptance, 0.95),
              "9 waves, 3 not accepted by srp-3.7.1 (their trials are failed rows)");
    acceptance.uses_refused = true;
    EXPECT_EQ(waves_text(counts, acceptance, 0.95), "9 waves, 3 of them outside srp-3.7.1, but used");
}

TEST(WavesText, ScatterStandsBesideWhatWasStated) {
    AchievedSigma sigma{.waves = 40, .independent = 20, .missed = 3, .measures = {}};
    sigma.measures = {{"pga", "pga", 0.04, 0.4, 0.3, 0.049},
                      {"sa_1", "sa(0.5 s)", 0.5, 0.6, 0.6, 0.097},
                      {"sa_2", "sa(6 s)", 6, {}, 0.6, 0.097}};
    EXPECT_EQ(sigma_text(sigma),
              "achieved sd of ln (stated of Sa), over 20 targets: pga 0.300 +- 0.049 (0.4 at 0.04 s, the shortest "
              "matched), sa(0.5 s) 0.600 +- 0.097 (0.6), sa(6 s) 0.600 +- 0.097 (not matched there); 3 of 40 waves "
              "missed match_tolerance");
    sigma.of_events = true;
    EXPECT_NE(sigma_text(sigma).find("over 20 events:"), std::string::npos);
}

TEST(WavesText, MissedClausesAreALineEach) {
    MissedClauses missed;
    WaveRow row;
    row.horizontal_failures = 1 << 3;
    row.acceptance_failures = 1 << 3;
    row.match_lowest_ratio = 0.78;
    row.match_lowest_period_s = 0.05;
    missed.add(row);
    missed.add(row);
    auto const clause = missed.rows().at(0).clause;
    EXPECT_EQ(missed_clauses_text(missed).find("  " + clause + ", horizontal: missed by 2 waves"), 0U)
        << missed_clauses_text(missed);
    EXPECT_EQ(missed_clauses_text({}), "");
}

}  // namespace
}  // namespace overturn::output
