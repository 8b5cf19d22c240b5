// Requirement R-706: limit states of the user's own are a rule over a trial's stored row: passed, kept, or not known;
// what is not known is never counted as kept.
#include "campaign/limit_state.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include <gtest/gtest.h>

#include "campaign/block_rows.hpp"
#include "campaign/trial.hpp"
#include "campaign/warnings.hpp"
#include "response/registry.hpp"
#include "results/analysis.hpp"
#include "results/statistics.hpp"
#include "support/expect_input_error.hpp"
#include "support/limited_campaigns.hpp"

namespace overturn {
namespace {

using testing::row_of;
using testing::tilts;
using testing::touches;
using testing::with_limits;

class Judged {
  public:
    explicit Judged(std::string const& limits, std::string const& more = "")
        : spec(with_limits(limits, more)),
          selector(spec.effects, spec.accuracy),
          judge_(spec.limits, selector),
          extra(selector.extra_bytes()) {
        selector.put_defaults(extra);
    }
    // 'p' passed, 'k' kept, '?' not known.
    [[nodiscard]] char operator()(TrialRow const& row, std::size_t limit = 1) const {
        auto const outcomes = judge_.judge(row, extra);
        EXPECT_TRUE(outcomes.is_decided(limit) || !outcomes.has_passed(limit));
        return !outcomes.is_decided(limit) ? '?' : outcomes.has_passed(limit) ? 'p' : 'k';
    }

    [[nodiscard]] double near(TrialRow const& row, std::size_t limit) const {
        return judge_.nearness(limit, row, extra);
    }

    CampaignSpec spec;
    ModelSelector selector;

  private:
    LimitJudge judge_;

  public:
    std::vector<std::byte> extra;
};

TEST(LimitState, OverturningIsAlwaysThereAndFirst) {
    Judged const judged("");

    ASSERT_EQ(judged.spec.limits.size(), 1U);
    EXPECT_EQ(judged.spec.limits[0].name, "overturning");
    EXPECT_EQ(judged(row_of(Verdict::overturned, 0, 2), 0), 'p');
    EXPECT_EQ(judged(row_of(Verdict::rocked, 0, 0.9), 0), 'k');
    EXPECT_EQ(judged(row_of(Verdict::contact_lost, 0, 0.9), 0), '?');
    EXPECT_EQ(judged(row_of(Verdict::failed, never, never), 0), '?');
}

/// Strictly beyond the threshold, in the unit it was written in; a trial without a verdict decides nothing.
TEST(LimitState, ThresholdOnAStoredQuantity) {
    Judged const judged(touches);

    EXPECT_EQ(definition_of(judged.spec.limits[1], judged.spec.limits), "peak_slip > 30 cm");
    EXPECT_EQ(judged(row_of(Verdict::slid, std::nextafter(0.3, 1), 0)), 'p');
    EXPECT_EQ(judged(row_of(Verdict::slid, 0.3, 0)), 'k');
    EXPECT_EQ(judged(row_of(Verdict::at_rest, 0, 0)), 'k');
    EXPECT_EQ(judged(row_of(Verdict::failed, never, never)), '?');
    EXPECT_EQ(judged(row_of(Verdict::contact_lost, 0.1, 0)), '?');
    EXPECT_EQ(judged(row_of(Verdict::slid, never, 0)), '?');
}

/// What tips over hits its neighbour, however little it had slid or rocked before; unless the limit says
/// otherwise, which its definition then says too.
TEST(LimitState, AFallPassesEveryLimit) {
    std::string const light = "[[limits]]\nname='light'\nquantity='min_contact_force_ratio'\nbelow=0.2\n";
    std::string const alone = "overturned='excluded'\n";
    Judged const judged(touches + tilts + light + "[[limits]]\nname='both'\nall=['touches','light']\n");
    Judged const without(touches + alone + tilts + alone + light + alone);
    auto row = row_of(Verdict::overturned, 0.1, 1.2);
    row.min_contact_force_ratio = 0.9;
    for (std::size_t limit = 0; limit < 5; ++limit) {
        EXPECT_EQ(judged(row, limit), 'p') << limit;
        EXPECT_GT(judged.near(row, limit), 1) << limit;
    }
    EXPECT_EQ(judged(row_of(Verdict::overturned, never, 1.2)), 'p') << "whatever else is known of it";
    EXPECT_EQ(judged(row_of(Verdict::rocked, 0.1, 0.4)), 'k');
    EXPECT_EQ(judged(row_of(Verdict::contact_lost, 0.1, 1.2)), '?');

    EXPECT_EQ(without(row, 1), 'k');
    EXPECT_EQ(without(row, 2), 'p') << "it rotated past the limit before it fell";
    EXPECT_EQ(without(row, 3), 'k');
    EXPECT_EQ(without(row_of(Verdict::overturned, never, 1.2)), '?');
    EXPECT_DOUBLE_EQ(without.near(row, 1), 0.1 / 0.3);
    EXPECT_EQ(definition_of(without.spec.limits[1], without.spec.limits), "peak_slip > 30 cm without overturning");
}

// what is joined says it too, where a fall alone does not pass it, in every line that names it.
TEST(LimitState, LinesSayWhereAFallDoesNotPassIt) {
    Judged const judged("[[limits]]\nname='slides'\nquantity='peak_slip'\nabove='30 cm'\noverturned='excluded'\n" + tilts
                        + "[[limits]]\nname='one'\nany=['slides']\n[[limits]]\nname='either'\nany=['slides','tilts']\n"
                          "[[limits]]\nname='both'\nall=['slides','overturning']\n");
    auto const& limits = judged.spec.limits;
    std::vector<std::string> said;
    std::vector<std::string> definitions;
    for (auto const& limit : limits) {
        said.push_back(full_name(limit, limits));
        definitions.push_back(definition_of(limit, limits));
    }
    EXPECT_EQ(said, (std::vector<std::string>{"overturning", "slides without overturning", "tilts",
                                              "one without overturning", "either", "both without overturning"}));
    EXPECT_EQ(definitions[3], "any of slides without overturning");
    EXPECT_EQ(definitions[4], "any of slides without overturning, tilts");
}

/// How near a trial came is at least 1 where it passed a limit and at most 1 where it kept within it, and rises with
/// the response; `any` is as near as its nearest, `all` as its farthest.
TEST(LimitState, NearnessIsNestedWithPassing) {
    Judged const judged(touches + tilts + "[[limits]]\nname='one'\nany=['touches','tilts']\n"
                        + "[[limits]]\nname='both'\nall=['touches','tilts']\n"
                        + "[[limits]]\nname='fell'\nany=['touches','overturning']\n");
    for (double const slip : {0.0, 0.15, 0.29, 0.31, 2.0}) {
        for (double const ratio : {0.0, 0.25, 0.49, 0.51, 0.99, 1.5}) {
            auto const row = row_of(ratio > 1 ? Verdict::overturned : Verdict::rocked, slip, ratio);
            for (std::size_t limit = 0; limit < judged.spec.limits.size(); ++limit) {
                double const near = judged.near(row, limit);
                EXPECT_EQ(judged(row, limit) == 'p', near > 1) << limit << ' ' << slip << ' ' << ratio;
            }
            double const fell = ratio > 1 ? ratio : 0;
            EXPECT_DOUBLE_EQ(judged.near(row, 1), std::max(slip / 0.3, fell));
            EXPECT_DOUBLE_EQ(judged.near(row, 2), std::max(ratio / 0.5, fell));
            EXPECT_EQ(judged.near(row, 3), std::max(judged.near(row, 1), judged.near(row, 2)));
            EXPECT_EQ(judged.near(row, 4), std::min(judged.near(row, 1), judged.near(row, 2)));
        }
    }
    EXPECT_TRUE(std::isnan(judged.near(row_of(Verdict::rocked, never, 0.2), 3)));
}

/// The slip of a trial that would have slipped, without slip being simulated, is 0 in its row and yet not known.
TEST(LimitState, WhatWasNotSimulatedIsNotKnown) {
    Judged const judged(touches);
    auto row = row_of(Verdict::rocked, 0, 0.1);
    row.required = mask_of(Effect::sliding);

    EXPECT_EQ(judged(row), '?');
    row.effects = mask_of(Effect::sliding);
    EXPECT_EQ(judged(row), 'k');
}

/// Slip at the end has a side; its size counts. Below: a lower bound on what must not be passed downwards.
TEST(LimitState, MagnitudesAndLowerLimits) {
    Judged const judged(
        "[[limits]]\nname='moved'\nquantity='residual_slip'\nabove='1 cm'\n"
        "[[limits]]\nname='light'\nquantity='min_contact_force_ratio'\nbelow=0.2\n"
        "[[limits]]\nname='knocks'\nquantity='impacts'\nabove=3\n"
        "[[limits]]\nname='hard'\nquantity='peak_impact_velocity'\nabove='10 kine'\n");
    auto row = row_of(Verdict::rocked, 0.5, 0);
    row.residual_slip_m = -0.02;
    row.min_contact_force_ratio = 0.19;
    row.impacts = 4;
    row.peak_impact_velocity_mps = 0.11;

    EXPECT_EQ(judged(row, 1), 'p');
    EXPECT_EQ(judged(row, 2), 'p');
    EXPECT_EQ(judged(row, 3), 'p');
    EXPECT_EQ(judged(row, 4), 'p');
    row.residual_slip_m = 0.005;
    row.min_contact_force_ratio = 0.2;
    row.impacts = 3;
    row.peak_impact_velocity_mps = 0.09;
    EXPECT_EQ(judged(row, 1), 'k');
    EXPECT_EQ(judged(row, 2), 'k');
    EXPECT_EQ(judged(row, 3), 'k');
    EXPECT_EQ(judged(row, 4), 'k');
}

/// Kleene's logic over passed, kept and not known: all nine pairs.
TEST(LimitState, AnyAndAllOfOthers) {
    Judged const judged(touches + tilts + "[[limits]]\nname='either'\nany=['touches','tilts']\n"
                        + "[[limits]]\nname='both'\nall=['touches','tilts']\n"
                        + "[[limits]]\nname='worst'\nany=['both','overturning']\n");
    std::string either;
    std::string both;
    for (double const slip : {0.4, 0.1, never}) {
        for (double const ratio : {0.6, 0.1, never}) {
            auto const row = row_of(Verdict::rocked, slip, ratio);
            either += judged(row, 3);
            both += judged(row, 4);
        }
    }

    EXPECT_EQ(either, "ppppk?p??");
    EXPECT_EQ(both, "pk?kkk?k?");
    EXPECT_EQ(judged(row_of(Verdict::overturned, 0, 2), 5), 'p');
    EXPECT_EQ(judged(row_of(Verdict::failed, never, never), 3), '?');
    EXPECT_EQ(definition_of(judged.spec.limits[5], judged.spec.limits), "any of both, overturning");
}

/// A quantity of contact's own is read from the record of the model that answered, and calls for that model.
TEST(LimitState, QuantitiesOfAModelCallForIt) {
    Judged judged("[[limits]]\nname='rises'\nquantity='peak_rise'\nabove='1 mm'\n");
    ASSERT_TRUE(has(judged.spec.effects.include, Effect::contact));
    ASSERT_EQ(judged.spec.effects.mode, EffectMode::automatic);
    std::int64_t const rocking = 1;
    std::int64_t contact = 0;
    for (auto const& [traits, offset] : judged.selector.extra_parts()) {
        if (traits->name == "contact") {
            contact = traits->number;
            set_real(std::span(judged.extra).subspan(offset), field_named(traits->fields, "peak_rise"), 0.002);
        }
    }
    auto row = row_of(Verdict::rocked, 0, 0.1);
    row.model = contact;

    EXPECT_EQ(judged(row), 'p');
    row.model = rocking;
    EXPECT_EQ(judged(row), '?') << "no contact ran";
    EXPECT_EQ(with_limits(touches).effects.include, 0U) << "auto calls for sliding by itself";
}

/// With such a limit every trial is simulated on points, those at rest too, and every one of them has the quantity.
TEST(LimitState, EveryTrialHasTheQuantitiesOfALimit) {
    auto const spec = with_limits("[[limits]]\nname='pressed'\nquantity='peak_contact_force_ratio'\nabove=1.2\n");
    Plan const plan(spec);
    ModelSelector const selector(spec.effects, spec.accuracy);
    Statistics statistics(spec);
    PhaseSeconds seconds;
    std::int64_t passed = 0;
    for (std::int64_t b = 0; b < plan.blocks(); ++b) {
        auto const block = run_block(spec, plan, b, seconds);
        statistics.add(block);
        std::size_t at = 0;
        for (auto const& row : block.trials.rows) {
            EXPECT_EQ(row.reason, stated_reason);
            auto const own =
                std::span(block.trials.extra).subspan(selector.extra_bytes() * at++, selector.extra_bytes());
            for (auto const& [traits, offset] : selector.extra_parts()) {
                if (traits->number == row.model) {
                    auto const force = field_named(traits->fields, "peak_contact_force_ratio");
                    passed += real_at(own.subspan(offset), force) > 1.2 ? 1 : 0;
                }
            }
        }
    }
    auto const& limit = statistics.bodies()[0].limits.at(0);
    std::int64_t counted = 0;
    for (auto const& stripe : limit.stripes) {
        EXPECT_EQ(stripe.decided(), stripe.trials);
        counted += stripe.overturned;
    }

    EXPECT_EQ(limit.unknown, 0);
    EXPECT_EQ(counted, passed);
    EXPECT_GT(passed, 0);
}

/// Calling for contact is no other simulation than stating it: the same rows to the bit, with and without friction.
TEST(LimitState, CallsForWhatStatedEffectsSimulate) {
    std::string const pressed = "[[limits]]\nname='pressed'\nquantity='peak_contact_force_ratio'\nabove=1.2\n";
    for (bool const slips : {false, true}) {
        auto text = testing::quick_waves + testing::type_b;
        text += slips ? "friction=0.5\n" : "";
        text += testing::levels("values=[3,9]\n") + pressed;
        auto const called = testing::campaign_from(text);
        text += slips ? "[effects]\ninclude=['contact','sliding']\n" : "[effects]\ninclude=['contact']\n";
        auto const stated = testing::campaign_from(text);
        PhaseSeconds seconds;
        auto const a = run_block(called, Plan(called), 0, seconds).trials;
        auto const b = run_block(stated, Plan(stated), 0, seconds).trials;

        ASSERT_EQ(a.rows.size(), b.rows.size());
        for (std::size_t t = 0; t < a.rows.size(); ++t) {
            auto row = b.rows[t];
            row.required = a.rows[t].required;  // auto asks all models what would act
            EXPECT_TRUE(same_bits(a.rows[t], row)) << differing(a.rows[t], row).front();
        }
    }
}

/// How hard a body lands is asked of those that fell: a fall passes such a limit by its own figure alone, and a
/// body that stands never.
TEST(LimitState, OfTheLandingIsPassedByItsFigureOnly) {
    std::string const hard = "[[limits]]\nname='hard'\nquantity='landing_top_velocity'\nabove='5 m/s'\n";
    Judged const judged(hard);
    auto row = row_of(Verdict::overturned, 0.1, 1.2);
    row.landing_top_mps = 9;
    EXPECT_EQ(judged(row), 'p');
    row.landing_top_mps = 4;
    EXPECT_EQ(judged(row), 'k');
    row.landing_top_mps = never;
    EXPECT_EQ(judged(row), '?') << "it left the ground under a model that does not follow it";
    EXPECT_EQ(judged(row_of(Verdict::rocked, 0.1, 0.9)), 'k');
    EXPECT_EQ(definition_of(judged.spec.limits[1], judged.spec.limits), "landing_top_velocity > 5 m/s");
    testing::expect_input_error([&] { (void)with_limits(hard + "overturned='excluded'\n"); }, "limits[0].overturned");
}

/// Counted by hand: two passed, one kept, one failed, one whose slip is not known, one that fell without sliding, where
/// falls are left out.
TEST(LimitState, StripesCountTrials) {
    auto const spec = with_limits(touches + "overturned='excluded'\n");
    Statistics statistics(spec);
    for (auto const& row :
         {row_of(Verdict::slid, 0.4, 0), row_of(Verdict::slid, 0.5, 0), row_of(Verdict::slid, 0.1, 0),
          row_of(Verdict::failed, never, never), row_of(Verdict::slid, never, 0), row_of(Verdict::overturned, 0, 2)}) {
        auto at = row;
        at.level = 1;
        statistics.add(at);
    }
    auto const& body = statistics.bodies()[0];
    auto const& stripe = body.stripes_of(1)[1];

    EXPECT_EQ(stripe.trials, 6);
    EXPECT_EQ(stripe.overturned, 2);
    EXPECT_EQ(stripe.failed, 1);
    EXPECT_EQ(stripe.undecided, 1);
    EXPECT_EQ(stripe.probability(), 0.5);
    EXPECT_EQ(stripe.interval(0.95).upper, clopper_pearson(4, 6, 0.95).upper);
    EXPECT_EQ(body.limits[0].unknown, 1);
    EXPECT_EQ(body.limits[0].fell_within, 1);
    EXPECT_EQ(body.stripes_of(0)[1].overturned, 1);
    EXPECT_EQ(body.stripes_of(1)[0].trials, 0);
}

}  // namespace
}  // namespace overturn
