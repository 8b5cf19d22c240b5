// Requirement R-106: named acceptance rules are judged clause by clause with their figures, and the matcher reaches
// them for the targets of both countries, to 10 s.
#include "generators/acceptance.hpp"

#include <cmath>

#include "generators/wave_quality.hpp"
#include "spectra/named_targets.hpp"
#include "spectra/response_spectrum.hpp"
#include "support/expect_input_error.hpp"
#include "support/sources.hpp"

namespace overturn {
namespace {

AcceptanceRule rule_of(char const* name) { return config::find_entry(acceptance_rules(), name, "rule").value; }

// A spectrum that meets every limit exactly; each test breaks one.
MatchFacts borderline() {
    MatchFacts facts;
    facts.figures.lowest_ratio = 0.90;
    facts.figures.highest_ratio = 1.30;
    facts.figures.longest_below = 9;
    facts.figures.mean_ratio = 1.0199;
    facts.figures.cov = 0.05;
    facts.worst_decade = 0.05;
    facts.intensity_ratio = 1;
    facts.judged_to_s = 10;
    facts.defined_to_s = 10;
    return facts;
}

std::vector<std::string> failing(std::vector<Clause> const& clauses) {
    std::vector<std::string> names;
    for (auto const& clause : clauses) {
        if (!clause.passed()) {
            names.push_back(clause.name);
        }
    }
    return names;
}

using Names = std::vector<std::string>;

TEST(Acceptance, SrpLimitsAreThosePrinted) {
    auto const srp = rule_of("srp-3.7.1");
    EXPECT_TRUE(all_passed(spectrum_clauses(srp, borderline())));
    auto facts = borderline();
    facts.figures.lowest_ratio = 0.8999;
    EXPECT_EQ(failing(spectrum_clauses(srp, facts)), Names{"lowest ratio"});
    facts = borderline();
    facts.figures.longest_below = 10;
    EXPECT_EQ(failing(spectrum_clauses(srp, facts)), Names{"adjacent below"});
    facts = borderline();
    facts.figures.highest_ratio = 1.3001;
    EXPECT_EQ(failing(spectrum_clauses(srp, facts)), Names{"highest ratio"});
    facts = borderline();
    facts.judged_to_s = 9;
    EXPECT_EQ(failing(spectrum_clauses(srp, facts)), Names{"judged to"});
    facts = borderline();
    facts.worst_decade = 0.0501;
    EXPECT_EQ(failing(spectrum_clauses(srp, facts)), Names{"worst decade"});
    EXPECT_EQ(failing(wave_clauses(srp, {0.0101, 19.9, 1.1e-6, 0.17})),
              (Names{"time step", "duration", "end velocity", "component correlation"}));
    EXPECT_TRUE(all_passed(wave_clauses(srp, {0.01, 20, 1e-6, 0.16})));
    facts = borderline();
    facts.intensity_ratio = -1;
    EXPECT_TRUE(all_passed(spectrum_clauses(srp, facts))) << "the Japanese rule's, of which this one says nothing";
}

TEST(Acceptance, JapaneseLimitsAreThosePrinted) {
    auto const japan = rule_of("japan");
    auto facts = borderline();
    facts.figures.lowest_ratio = 0.85;
    facts.figures.highest_ratio = 2;  // not asked
    facts.figures.longest_below = 50;
    EXPECT_EQ(failing(spectrum_clauses(japan, facts)), Names{});
    facts.figures.lowest_ratio = 0.849;
    facts.figures.cov = 0.0501;
    facts.figures.mean_ratio = 0.979;
    facts.intensity_ratio = 0.999;
    EXPECT_EQ(failing(spectrum_clauses(japan, facts)),
              (Names{"lowest ratio", "SI ratio", "cov of the ratio", "error of the mean"}));
}

TEST(Acceptance, FailedClausesAreBits) {
    auto const names = clause_names();
    std::vector<Clause> clauses{band_clause("a body", 0.06)};
    EXPECT_EQ(failed_clauses(clauses), std::int64_t{1} << 12);
    EXPECT_EQ(names.at(12), "rocking band");
    EXPECT_NE(clauses[0].text().find("[T0, T1] of a body 0.06 (at most 0.05): fail"), std::string::npos);
    clauses[0].figure = 0.04;
    EXPECT_EQ(failed_clauses(clauses), 0);
    clauses.push_back({"lowest ratio, vertical", 0.5, 0.9, true});
    EXPECT_EQ(names.at(3), "lowest ratio");
    EXPECT_EQ(failed_clauses(clauses), std::int64_t{1} << 3);
}

struct Case {
    char const* target;
    char const* rule;
};
class Waves : public ::testing::TestWithParam<Case> {};

// Judged here afresh: the program's spectrum, but the rule's own words at 0.1 Hz to 50 Hz, 100 frequencies a decade.
TEST_P(Waves, MeetTheRule) {
    auto const source = testing::source_of(std::string("source='spectrum-compatible'\nduration='120 s'\nacceptance='")
                                           + GetParam().rule + "'\n[target]\nspectrum='" + GetParam().target
                                           + "'\n[envelope]\nrise=10\nlevel_end=60\nend=110\n");
    auto const target = config::find_entry(named_targets(), GetParam().target, "target").value({});
    auto const periods = log_periods(0.02, 10, 271);
    for (std::uint64_t wave = 0; wave < 20; ++wave) {
        auto const made = source->make(2013, wave);

        EXPECT_TRUE(all_passed(made.clauses)) << wave;
        auto const& a = made.motion.horizontal_mps2;
        auto const spectrum = response_spectrum(a, 0.01, periods, 0.05);
        int below = 0;
        for (std::size_t i = 0; i < periods.size(); ++i) {
            double const ratio = spectrum.psa_mps2[i] / target.psa_mps2(periods[i]);
            below = ratio < 1 ? below + 1 : 0;
            EXPECT_GE(ratio, made.rule.lowest_ratio - 1e-12) << wave << " at " << periods[i];
            EXPECT_LE(ratio, made.rule.highest_ratio + 1e-12) << wave << " at " << periods[i];
            EXPECT_LE(below, made.rule.most_adjacent_below) << wave << " at " << periods[i];
        }
        auto const quality = wave_quality(made.motion);
        EXPECT_LT(quality.end_velocity_ratio, 1e-6);
        EXPECT_TRUE(all_passed(wave_clauses(made.rule, {0.01, 120, quality.end_velocity_ratio, 0})));
    }
}

INSTANTIATE_TEST_SUITE_P(Rules, Waves,
                         ::testing::Values(Case{"mlit-ch1", "srp-3.7.1"}, Case{"mlit-ka1", "srp-3.7.1"},
                                           Case{"rg-1.60", "srp-3.7.1"}, Case{"mlit-ch1", "japan"},
                                           Case{"mlit-ka1", "japan"}, Case{"rg-1.60", "japan"}),
                         [](auto const& one) { return "case_" + std::to_string(one.index); });

TEST(Acceptance, WavesThatMissTheRuleSayWhere) {
    auto const source = testing::source_of(
        "source='spectrum-compatible'\nduration='19 s'\nacceptance='srp-3.7.1'\nmatch_iterations=1\n"
        "[target]\nspectrum='rg-1.60'\n");
    for (std::uint64_t wave = 0; wave < 5; ++wave) {
        auto const made = source->make(1, wave);
        EXPECT_FALSE(all_passed(made.clauses)) << "one iteration cannot do it";
        EXPECT_FALSE(made.match.matched);
        EXPECT_NE(failed_clauses(made.clauses), 0);
        EXPECT_FALSE(all_passed(wave_clauses(made.rule, {0.01, made.motion.duration_s(), 0, 0})))
            << "and 19 s are short";
    }
}

/// A rule is not said to be met where the user's target says nothing: below its first period, at another damping of a
/// further component; and what lies beyond its last one is said and not judged.
TEST(Acceptance, IsRefusedWhereNoTargetIsStated) {
    auto const with = [](std::string const& target, std::string const& more = {}) {
        return testing::source_of("source='spectrum-compatible'\nduration='40 s'\nacceptance='srp-3.7.1'\n[target]\n"
                                  + target + "[envelope]\nshape='jennings'\nrise='4 s'\nlevel_end='25 s'\nend='36 s'\n"
                                  + more);
    };
    testing::expect_input_error([&] { (void)with("points=[[5,1],[10,0.5]]\nkind='acceleration'\n"); },
                                "the target begins at 5 s");
    testing::expect_input_error(
        [&] { (void)with("spectrum='rg-1.60'\n", "[vertical.target]\nspectrum='rg-1.60-vertical'\ndamping=0.1\n"); },
        "at 5 % damping");
    EXPECT_NO_THROW((void)with("points=[[0.1,6],[0.5,6],[10,1]]\nkind='acceleration'\n")) << "judged from 0.1 s on";
    auto const source = with("points=[[0.02,2],[0.1,6],[0.5,6],[3,1]]\nkind='acceleration'\nlongest=10\n");
    EXPECT_EQ(source->about().compared_periods->to_s, 3);
    EXPECT_NE(source->about().text.find("beyond its end at 3 s"), std::string::npos) << source->about().text;
}

}  // namespace
}  // namespace overturn
