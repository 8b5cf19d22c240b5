// Requirement R-904: every setting is what a user could write, and the campaign's own position is among them.
#include "cost/knob.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "support/campaigns.hpp"

namespace overturn::cost {
namespace {

using testing::input_from;
using testing::levels;
using testing::quick_waves;
using testing::type_b;

std::string const text = quick_waves + type_b + levels("values=[4,6]\n");

Knob const* knob_named(std::vector<Knob> const& knobs, std::string const& name) {
    auto const found = std::find_if(knobs.begin(), knobs.end(), [&](Knob const& knob) { return knob.name == name; });
    return found == knobs.end() ? nullptr : &*found;
}

std::string here(std::vector<Knob> const& knobs, std::string const& name) {
    auto const* knob = knob_named(knobs, name);
    return knob != nullptr && knob->here ? knob->settings.at(*knob->here).label : "none";
}

std::vector<Knob> knobs_from(std::string const& toml) {
    auto const input = input_from(toml);
    return knobs_of(input, parse_campaign(input));
}

TEST(Knobs, EverySettingIsUnderstood) {
    auto const input = input_from(text);
    for (auto const& knob : knobs_of(input, parse_campaign(input))) {
        for (auto const& setting : knob.settings) {
            EXPECT_NO_THROW((void)parse_campaign(with(input, setting.settings))) << knob.name << ": " << setting.label;
        }
    }
    auto const exact = parse_campaign(with(input, reference_settings())).accuracy.rocking;
    EXPECT_EQ(exact.taylor_order, 12);
    EXPECT_EQ(exact.substeps, 16);
    EXPECT_EQ(exact.step_tolerance, 1e-15);
    EXPECT_EQ(exact.settle, 1e-8);
}

TEST(Knobs, StandWhereTheDefaultsDo) {
    auto const knobs = knobs_from(text);

    for (char const* constant : {"step", "step_tolerance", "settle"}) {
        EXPECT_EQ(knob_named(knobs, constant), nullptr) << constant;
    }
    EXPECT_EQ(here(knobs, "v_wes"), "20 rad");
    EXPECT_EQ(here(knobs, "effects"), "auto");
    EXPECT_EQ(knob_named(knobs, "match_tolerance"), nullptr) << "these waves are left as drawn";
}

TEST(Knobs, StandWhereTheCampaignStates) {
    auto const matched = text.substr(0, text.find("match='none'")) + "match='each'\nmatch_tolerance=0.07\n"
                         + text.substr(text.find("[waves.target]"));
    auto const knobs = knobs_from(matched
                                  + "[accuracy]\npanel_phase='17 rad'\n"
                                    "[effects]\nmode='none'\n");

    EXPECT_EQ(here(knobs, "ou_v_e"), "17 rad");
    EXPECT_EQ(here(knobs, "effects"), "none");
    EXPECT_EQ(here(knobs, "match_tolerance"), "0.07");
    EXPECT_EQ(here(knobs, "match_iterations"), "40");  // the default, as `list keys` tells it
}

TEST(Knobs, EffectsAreThoseThatApply) {
    auto const with_all =
        quick_waves + "[waves.vertical]\nratio=0.6\n" + type_b + "friction=0.5\n" + levels("values=[4]\n");
    auto const labels = [](std::vector<Knob> const& knobs) {
        std::vector<std::string> found;
        for (auto const& setting : knob_named(knobs, "effects")->settings) {
            found.push_back(setting.label);
        }
        return found;
    };

    EXPECT_EQ(labels(knobs_from(with_all)),
              (std::vector<std::string>{"none", "vertical", "sliding", "vertical, sliding", "auto"}));
    EXPECT_EQ(labels(knobs_from(text)), (std::vector<std::string>{"none", "auto"}));
    EXPECT_EQ(here(knobs_from(with_all + "[effects]\ninclude=['sliding']\n"), "effects"), "sliding");

    // Where a pad is stated or waves have a transverse component, auto is held against all that can be simulated.
    auto const pad = quick_waves + type_b + "pad={vertical_frequency='67 Hz'}\n" + levels("values=[4]\n");
    EXPECT_EQ(labels(knobs_from(pad)), (std::vector<std::string>{"none", "contact", "auto"}));
    EXPECT_EQ(here(knobs_from(pad), "contact_step"), "0.3");
    EXPECT_EQ(knob_named(knobs_from(text), "contact_step"), nullptr);
    auto const across = quick_waves + "[waves.transverse]\nratio=1\n" + type_b + levels("values=[4]\n");
    EXPECT_EQ(labels(knobs_from(across)), (std::vector<std::string>{"none", "contact", "contact, spatial", "auto"}));
    // Limit states that other effects could not answer do not bar them; the campaign's own setting keeps them.
    auto const limited = text + "[[limits]]\nname='rises'\nquantity='peak_rise'\nabove=0.1\n";
    auto const limited_knobs = knobs_from(limited);
    for (auto const& setting : knob_named(limited_knobs, "effects")->settings) {
        auto const variant = parse_campaign(with(input_from(limited), setting.settings));
        EXPECT_EQ(variant.limits.size(), setting.label == "auto" ? 2U : 1U) << setting.label;
    }
    auto const campaign = input_from(across);
    EXPECT_EQ(effects_reference_settings(parse_campaign(campaign)).back(),
              "effects={include=[\"contact\",\"spatial\"]}");
}

// beds have a knob, their points from corner to corner, held against the most that are simulated; every bed
// takes them, and nothing else. Beds that differ have none, nor have corners and rims.
TEST(Knobs, BedsHaveTheirPoints) {
    auto const with_bases = [](std::string const& first, std::string const& second) {
        std::string bodies;
        for (auto const& base : {first, second}) {
            bodies += type_b;
            bodies.replace(bodies.rfind("name='"), 6, "name='" + std::to_string(bodies.size()));
            bodies += "base={" + base + "}\n";
        }
        return quick_waves + bodies + levels("values=[4]\n");
    };
    auto const flat = with_bases("bedding='flat'", "bedding=0.5");
    auto const knobs = knobs_from(flat);
    auto const* const points = knob_named(knobs, "points");
    ASSERT_NE(points, nullptr);
    EXPECT_EQ(here(knobs, "points"), "15");
    EXPECT_EQ(points->settings.front().label, "5");
    EXPECT_EQ(points->settings.back().label, "41");
    auto const few = parse_campaign(with(input_from(flat), points->settings.front().settings));
    auto const reference = parse_campaign(with(input_from(flat), points->reference));
    EXPECT_EQ(few.bodies[0].footing.base.points, 5);
    EXPECT_EQ(few.bodies[1].footing.base.points, 5);
    EXPECT_FALSE(few.bodies[0].footing.base.corner_share.has_value());
    EXPECT_EQ(few.bodies[1].footing.base.corner_share, 0.5);
    EXPECT_EQ(reference.bodies[0].footing.base.points, 41);

    EXPECT_EQ(knob_named(knobs_from(with_bases("bedding='flat'", "bedding='flat', points=21")), "points"), nullptr);
    EXPECT_EQ(knob_named(knobs_from(with_bases("bedding='corners'", "shape='round'")), "points"), nullptr);
    EXPECT_EQ(knob_named(knobs_from(flat), "rim_points"), nullptr);
}

// In space a bed has 16 points across at most. A knob acts on its own bodies alone: the others would thin out its
// errors.
TEST(Knobs, BedsInSpaceEndWhereTheyCount) {
    auto const knobs = knobs_from(quick_waves + "[waves.transverse]\nratio=1\n" + type_b + "base={shape='round'}\n"
                                  + "[[bodies]]\nname='flat'\nmass='12.6 t'\nbase_width='0.9 m'\ncentre_height='1.045 m'\n"
                                    "inertia='uniform-block'\nbase={bedding='flat'}\n"
                                  + levels("values=[4]\n"));
    auto const* const points = knob_named(knobs, "points");
    ASSERT_NE(points, nullptr);
    EXPECT_EQ(points->settings.back().label, "16");
    EXPECT_EQ(points->bodies, (std::set<std::int64_t>{1}));
    EXPECT_TRUE(knob_named(knobs, "effects")->bodies.empty());
}

// so have rims that stand on points, on a pad that yields or as stated; a continuous one has none.
TEST(Knobs, RimsOnPointsHaveThem) {
    auto const on_pad = [](std::string const& base, std::string const& pad) {
        return quick_waves + type_b + "base={" + base + "}\npad={" + pad + "}\n" + levels("values=[4]\n");
    };
    auto const yields = on_pad("shape='round'", "strength='30 MPa'");
    auto const knobs = knobs_from(yields);
    auto const* const points = knob_named(knobs, "rim_points");
    ASSERT_NE(points, nullptr);
    EXPECT_EQ(here(knobs, "rim_points"), "64");
    EXPECT_EQ(points->settings.front().label, "16");
    EXPECT_EQ(points->settings.back().label, "256");
    auto const few = parse_campaign(with(input_from(yields), points->settings.front().settings));
    EXPECT_EQ(few.bodies[0].footing.base.points, 16);
    EXPECT_EQ(few.bodies[0].footing.pad.strength_pa, 30e6);
    EXPECT_EQ(parse_campaign(with(input_from(yields), points->reference)).bodies[0].footing.base.points, 256);
    EXPECT_EQ(knob_named(knobs, "points"), nullptr);

    EXPECT_EQ(here(knobs_from(on_pad("shape='round', points=100", "")), "rim_points"), "100");
    EXPECT_EQ(knob_named(knobs_from(on_pad("shape='round'", "")), "rim_points"), nullptr);
}

}  // namespace
}  // namespace overturn::cost
