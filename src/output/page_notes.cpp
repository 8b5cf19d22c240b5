#include <fmt/format.h>

#include "campaign/assumptions.hpp"
#include "output/detail/fit_words.hpp"
#include "output/detail/quote_text.hpp"
#include "output/detail/together_text.hpp"
#include "output/page_text.hpp"

namespace overturn::output {
namespace {

// Of real outcomes, which the page counts itself: it fills the numbers in.
Json outcome_notes() {
    return {
        {"agreement",
         "{falls} falls in {tests} tests of {motions} motions. The time history agrees with {agreement} of them (95 %: "
         "{agreement_interval}). {false_safe} of the tests are false safe ({false_safe_interval}). The intervals "
         "resample motions with all their tests."},
        {"brier",
         "Brier score {score}; the score of a prediction that gives every test the share of falls is {share}."},
        {"several", "{bodies} bodies represent it. {rule} Half of the votes predict a test safe. Votes: {votes}."},
        {"rule_left_out",
         "On each motion those bodies vote that agree with the outcomes of the other motions within a standard error "
         "of "
         "the best."},
        {"rule_all", "All bodies vote, as there is no other motion to choose by."},
        {"vote", "{body} ({count} of {motions})"},
        {"more_votes", "and {count} more"},
        {"one",
         "One body represents it, the same for every motion. Its file states whether its values were fitted to these "
         "outcomes (Assumptions)."},
        {"undecided", "{undecided} of {tested} tests are left out: their trials have no verdict."},
        {"counts",
         "False safe: predicted to stand, yet fell. The exact interval takes tests as independent. Tests of one motion "
         "are not, so it is too narrow."},
        {"areas", "Chance that a test that fell has more of it than one that stood: 0.5 is chance, 1 a perfect order."},
        {"areas_of_several", "Ratios are geometric means over the bodies that agree best with all tests."},
        {"threshold", "threshold on {measure}, of the other motions"},
        {"false_safe_tests",
         "Fell, though the time history or a criterion predicted that it stands; least rotation first"},
        {"no_false_safe", "No test fell that the time history or a criterion predicted to stand."},
        {"no_verdict", "None of its tests has a trial with a verdict."},
        {"not_tested", "It was not tested."},
        {"histories", "Fell, though predicted to stand"}};
}

}  // namespace

Json page_notes(Answered const& of) {
    Json notes{
        {"bodies",
         "The outline shows the parts of the body. A dashed outline is a block about the centre of gravity, for scale. "
         "Only base, centre of gravity and inertia enter the equations."},
        {"criterion",
         "False safe: the measure is below V_Ereq, yet the body overturned. False alarm: it is above V_Ereq, yet the "
         "body did not overturn. An interval counts all trials of a wave as one, since they may end alike."},
        {"response", "V_resp / V_Ereq of trials that moved but did not overturn: median (5th to 95th percentile)."},
        {"rare",
         "An estimate that is not trusted or not resolved is not reported. In its place stands the upper bound from "
         "plain trials."},
        {"telling_trials",
         "Nearest miss and largest slip are of trials that did not overturn. Non-monotonic: the same wave overturned "
         "the body at a lower level."},
        {"frequency",
         "Annual frequency. The interval includes what lies beyond the levels and beyond the hazard curve. Beside it "
         "stand the mean by the fitted curve and the part of that mean by motions beyond the levels or the hazard "
         "curve."},
        {"variability", fmt::format("Variability of the waves: {}.", of.spec.source->about().variability)},
        {"other_measures", "The " + other_measures_text(of.spec.levels.measure_label()) + "."},
        {"together", alternatives_text(of.spec)},
        {"many_bodies", "{bodies} bodies: no more than {most} are drawn in one picture."},
        {"checks",
         "A check without a record counts as not run. Its row names the command that writes the record (--record)."},
        {"hand_unsafe",
         "Above the simulated median the calculation by hand is on the unsafe side. That is so for {bodies}: do not "
         "quote it."},
        {"check_failed", "FAILED: {check}: {result}."},
        {"sensitivity",
         "Each value that is stated to be assumed is moved alone, to both ends of its range or by a tenth, under the "
         "same waves."},
        {"quantiles",
         "In brackets: distribution-free confidence interval (order statistics), open where there are too few trials. "
         "A trial that overturned counts as larger than every slip and rotation."},
        {"assumptions", text_of(tally_of(physical_inputs(of.spec))) + "."},
        {"more_inputs", "{more} more: overturn fit --json lists all."},
        {"no_more_effects", "affects trials that require no further effect"},
        {"model_assumptions",
         "Unsafe: where the assumption fails, more overturns than is computed. The effects were found by studies of "
         "this project, each under its own waves."},
        {"outcomes", outcome_notes()}};
    if (!of.analysis.empty() && of.analysis.front().grid) {
        auto why = grid_text(of.analysis.front().over_levels().fit.waves);
        notes["grid"] = "A" + why.substr(1) + ", no probability and no quantile.";
        notes["grid_standing"] =
            "Stood up to: the highest level at which it stood; it may lie above the least that overturned it.";
    }
    return notes;
}

}  // namespace overturn::output
