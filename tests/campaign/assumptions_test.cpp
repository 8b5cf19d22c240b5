// Requirement R-906: a campaign knows how many of its inputs are assumed, and which of the model's assumptions bear on
// it; saying so changes no result.
#include "campaign/assumptions.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "campaign/block_rows.hpp"
#include "campaign/model_assumptions.hpp"
#include "campaign/trial.hpp"
#include "support/campaigns.hpp"

namespace overturn {
namespace {

using testing::campaign_from;
using testing::quick_waves;
using testing::type_b;

std::string const levels = testing::levels("values=[5, 8]\ndesign_basis=6\n");

/// With and without a word on where values come from: the same bytes of every row.
TEST(Assumptions, SayingThemChangesNoRow) {
    auto const annotated = campaign_from(
        "basis='assumed'\n" + quick_waves + "basis={others='measured: here'}\n"
            + "[[bodies]]\nname='type-b'\nmass={value='12.6 t', basis='published', source='x', range=['12 t', '13 t']}\n"
              "base_width={value='0.9 m', basis='assumed'}\ncentre_height='1.045 m'\ninertia='uniform-block'\n"
              "basis='measured'\nsource='y'\n"
            + levels);
    auto const plain = campaign_from(quick_waves + type_b + levels);
    Plan const plan(plain);
    for (std::int64_t block = 0; block < plan.blocks(); ++block) {
        PhaseSeconds ignored;
        EXPECT_EQ(run_block(annotated, plan, block, ignored).pack(), run_block(plain, plan, block, ignored).pack());
    }
}

TEST(Assumptions, AreCountedByWhereValuesComeFrom) {
    auto const tally = [](std::string const& text) { return tally_of(physical_inputs(campaign_from(text))); };

    auto const plain = tally(quick_waves + type_b + levels);
    EXPECT_EQ(plain.assumed + plain.published + plain.measured, 0);
    EXPECT_GT(plain.not_stated, 0);
    EXPECT_GT(plain.by_default, 0) << "gravity, for one";

    auto const body =
        tally(quick_waves + type_b + "basis={mass='published: x', base_width='measured', others='assumed'}\n" + levels);
    EXPECT_EQ(body.published, 1);
    EXPECT_EQ(body.measured, 1);
    EXPECT_EQ(body.assumed, 2) << "height and inertia; a name is no input";
    EXPECT_EQ(body.all(), plain.all());

    auto const all = tally("basis='assumed'\n" + quick_waves + type_b + levels);
    EXPECT_EQ(all.not_stated, 0);
    EXPECT_EQ(all.assumed, plain.not_stated);
    EXPECT_EQ(text_of(InputTally{12, 9, 0, 2, 7}),
              "12 of 30 inputs are assumed, 9 published, 0 measured, 2 without a source, 7 defaults of this program");
}

// Keys that find no room are counted as keys: the first number counts inputs of all bodies.
TEST(Assumptions, KeysWithoutRoomAreCounted) {
    std::vector<config::InputValue> inputs(7);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        inputs[i].key = fmt::format("bodies[{}].{}", i % 2, std::string(40, static_cast<char>('a' + i / 2)));
        inputs[i].basis = config::Basis::assumed;
    }
    auto const key = [](char name) { return "bodies." + std::string(40, name); };
    EXPECT_EQ(assumed_text(inputs), "7 of 7 inputs are assumed (" + key('a') + ", " + key('b') + ", 2 more keys), 0 "
                                                                                                 "without a source");
    inputs.resize(6);
    EXPECT_EQ(assumed_text(inputs), "6 of 6 inputs are assumed (" + key('a') + ", " + key('b') + ", 1 more key), 0 "
                                                                                                 "without a source");
}

// All that the answer rests on is an input: surroundings, levels, limits, rules for waves, and what is left out if the
// campaign says that this is assumed. What things are called, and how much is computed, is none.
TEST(Assumptions, InputsAreWhatTheAnswerRestsOn) {
    auto const listed = [](std::string const& text) {
        std::set<std::string> keys;
        for (auto const& input : physical_inputs(campaign_from(text))) {
            keys.insert(input.key + (input.basis == config::Basis::assumed ? "!" : ""));
        }
        return keys;
    };
    auto waves = quick_waves;
    waves.insert(waves.find("[waves]\n") + 8, "basis={variability='assumed: none'}\n");
    auto const keys = listed("basis={hazard='assumed: none is known'}\n" + waves + type_b + "basis={pad='assumed'}\n"
                             + testing::levels("values=[5, 8]\ndesign_basis=6\nbeyond_design=[8]\n"
                                               "basis={beyond_design='assumed: usual'}\n")
                             + "[site]\ncask=2\nedge={plus_x=3}\nbasis={wall='assumed: far', height='assumed'}\n"
                               "[[limits]]\nname='far'\nquantity='peak_rotation_ratio'\nabove=0.5\n"
                               "[statistics]\nbasis={beta_u='assumed: none'}\n");
    for (char const* key :
         {"hazard!", "waves.variability!", "waves.source", "bodies[0].pad!", "levels.values", "levels.beyond_design!",
          "levels.design_basis", "site.cask", "site.edge.plus_x", "site.wall!", "site.height!", "limits[0].above",
          "limits[0].quantity", "statistics.beta_u!"}) {
        EXPECT_TRUE(keys.contains(key)) << key;
    }
    for (char const* key : {"bodies[0].name", "limits[0].name", "waves.count", "levels.measure", "seed"}) {
        EXPECT_FALSE(keys.contains(key)) << key;
    }
    EXPECT_TRUE(
        listed("basis={site='assumed: nothing stands near'}\n" + quick_waves + type_b + levels).contains("site!"));
    EXPECT_FALSE(is_beta_u_assumed(
        campaign_from(quick_waves + type_b + levels + "[statistics]\nbasis={beta_u='assumed: none'}\n")))
        << "none is given";
    EXPECT_TRUE(is_beta_u_assumed(
        campaign_from(quick_waves + type_b + levels + "[statistics]\nbeta_u=0.3\nbasis={beta_u='assumed'}\n")));
}

// A key beside a body's file outranks the file's own: it is one input.
TEST(Assumptions, WhatIsOutrankedIsNoInput) {
    auto const inputs = [](std::string const& beside) {
        std::string text;
        for (auto const& input : physical_inputs(
                 campaign_from(quick_waves + "[[bodies]]\nfile='b.toml'\n" + beside + levels,
                               {{"b.toml",
                                 "name='type-b'\nmass='12.6 t'\nbase_width='0.9 m'\ncentre_height='1.045 m'\n"
                                 "inertia='uniform-block'\nrestitution={value=0.77, basis='assumed'}\n"
                                 "friction={static=0.7, kinetic=0.6, basis='assumed'}\n"
                                 "pad={vertical_frequency='67 Hz', strength='30 MPa'}\n"}}))) {
            if (input.key.starts_with("bodies[0].restitution") || input.key.starts_with("bodies[0].friction")
                || input.key.starts_with("bodies[0].pad.vertical") || input.key.starts_with("bodies[0].axes")
                || input.key.starts_with("bodies[0].pad.strength")) {
                text += input.key.substr(10) + "=" + input.text + "\n";
            }
        }
        return text;
    };
    EXPECT_EQ(inputs(""),
              "restitution=0.77\nfriction.static=0.7\nfriction.kinetic=0.6\npad.vertical_frequency=67 Hz\n"
              "pad.strength=30 MPa\naxes=3\n");
    EXPECT_EQ(inputs("restitution=0.76\nfriction=0.5\npad={vertical_frequency='49 Hz'}\naxes=1\n"),
              "restitution=0.76\npad.vertical_frequency=49 Hz\npad.strength=30 MPa\naxes=1\nfriction=0.5\n");
}

// A value that no model reads which may run moves nothing: it is no input.
TEST(Assumptions, WhatNoModelReadsIsNoInput) {
    auto const counted = [](std::string const& body, std::string const& key, std::string const& more = "") {
        auto const inputs = physical_inputs(campaign_from(more + quick_waves + type_b + body + levels));
        return std::ranges::any_of(
            inputs, [&](config::InputValue const& input) { return input.key.starts_with("bodies[0]." + key); });
    };
    std::string const stated = "restitution={value=0.9, basis='assumed'}\n";
    std::string const round = "base={shape='round'}\n";
    EXPECT_TRUE(counted(stated, "restitution"));
    EXPECT_TRUE(counted(stated + "base={bedding='flat'}\n", "restitution")) << "matched";
    std::string const housner = "restitution={value='housner', basis='assumed'}\n";
    EXPECT_TRUE(counted(housner, "restitution"));
    EXPECT_FALSE(counted(housner + round, "restitution")) << "a rim has its own";
    EXPECT_FALSE(counted(housner + "base={bedding='flat'}\n", "restitution")) << "and a bed";
    EXPECT_FALSE(counted(stated + "base={bedding='flat'}\npad={match_restitution=false}\n", "restitution"));
    EXPECT_TRUE(counted("pad={match_restitution=false}\n" + stated, "restitution"))
        << "on corners most trials are rigid";
    EXPECT_FALSE(counted("pad={match_restitution=false}\n" + stated, "restitution", "effects={include=['contact']}\n"));
    EXPECT_TRUE(counted(stated + "base={bedding='flat'}\npad={match_restitution=false}\n", "restitution",
                        "effects={mode='none'}\n"))
        << "then it is a block on corners";

    EXPECT_TRUE(counted(round, "base"));
    EXPECT_TRUE(counted("pad={vertical_frequency='67 Hz'}\n", "pad"));
    EXPECT_FALSE(counted("pad={vertical_frequency='67 Hz'}\n", "pad", "effects={include=['vertical']}\n"));

    std::string const friction = "friction={static=0.7, kinetic=0.6}\n";
    EXPECT_TRUE(counted(friction, "friction.static"));
    EXPECT_FALSE(counted(friction + round, "friction.static")) << "points and rims grip by the kinetic one";
    EXPECT_TRUE(counted(friction + round, "friction.kinetic"));
    EXPECT_TRUE(counted("friction={static=0.7, kinetic_ratio=0.8}\n" + round, "friction.static"));
    EXPECT_FALSE(counted(friction, "friction", "effects={mode='none'}\n"));

    EXPECT_FALSE(counted("inertia_y='9 t m2'\n", "inertia_y")) << "shaken in one plane";
    EXPECT_TRUE(counted("inertia_y='9 t m2'\n" + round, "inertia_y"));
}

Bears bears(char const* name, std::string const& text) {
    auto const spec = campaign_from(text);
    for (auto const& one : model_assumptions()) {
        if (one.name == name) {
            return one.bears(spec);
        }
    }
    ADD_FAILURE() << "no assumption " << name;
    return Bears::no;
}

// Of recorded motions the components that were read say it, and one motion without a component is enough.
TEST(Assumptions, AreThoseOfTheComponentsThatRecordsHave) {
    auto const rows = [](char const* peak) {
        std::string text;
        for (int i = 0; i < 200; ++i) {
            text += fmt::format("{:.2f} {}\n", 0.01 * i, i == 50 ? peak : i % 2 == 0 ? "0.5" : "-0.5");
        }
        return text;
    };
    std::map<std::string, std::string> const files{
        {"a", rows("3")}, {"b", rows("2")}, {"c", rows("1.5")}, {"d", rows("4")}};
    auto const of_records = [&](char const* name, std::string const& records) {
        auto const spec =
            campaign_from("[waves]\nsource='records'\n" + records + type_b + "base={shape='round'}\n" + levels, files);
        auto const found = std::ranges::find(model_assumptions(), std::string_view(name), &ModelAssumption::name);
        return found->bears(spec);
    };
    std::string const one = "unit='m/s2'\nfiles=['a', 'd']\n";
    std::string const all = "[[waves.records]]\nunit='m/s2'\nhorizontal='a'\ntransverse='b'\nvertical='c'\n";
    std::string const mixed = all + "[[waves.records]]\nunit='m/s2'\nhorizontal='d'\n";
    EXPECT_EQ(of_records("no-vertical-motion", one), Bears::yes);
    EXPECT_EQ(of_records("no-vertical-motion", all), Bears::no);
    EXPECT_EQ(of_records("no-vertical-motion", mixed), Bears::yes);
    EXPECT_EQ(of_records("one-plane", one), Bears::yes);
    EXPECT_EQ(of_records("one-plane", all), Bears::no);
    EXPECT_EQ(of_records("one-plane", mixed), Bears::where_not_required);
}

TEST(Assumptions, BearOnTheCampaignsTheyAreMadeIn) {
    auto const plain = quick_waves + type_b + levels;
    auto const across = quick_waves + "[waves.transverse]\nratio=1\n[waves.vertical]\nratio=0.667\n" + type_b;
    auto const body = [](std::string const& keys) { return quick_waves + type_b + keys + levels; };

    EXPECT_EQ(bears("one-plane", plain), Bears::yes);
    EXPECT_EQ(bears("one-plane", across + levels), Bears::where_not_required);
    EXPECT_EQ(bears("one-plane", across + "axes=1\n" + levels), Bears::yes);
    EXPECT_EQ(bears("one-plane", across + "base={shape='round'}\n" + levels), Bears::no) << "it is followed in space";
    EXPECT_EQ(bears("no-vertical-motion", plain), Bears::yes);
    EXPECT_EQ(bears("no-vertical-motion", across + levels), Bears::no);
    EXPECT_EQ(bears("rigid-ground", plain), Bears::where_not_required);
    EXPECT_EQ(bears("rigid-ground", plain + "[effects]\nmode='none'\n"), Bears::yes);
    EXPECT_EQ(bears("corner-contact", plain), Bears::yes);
    EXPECT_EQ(bears("corner-contact", body("base={bedding='flat'}\n")), Bears::no);
    EXPECT_EQ(bears("corner-contact", body("base={shape='round'}\n")), Bears::no);
    EXPECT_EQ(bears("corner-contact",
                    body("base={shape='polygon', corners=[[0.45,0.6],[-0.45,0.6],[-0.45,-0.6],[0.45,-0.6]]}\n")),
              Bears::yes);
    EXPECT_EQ(bears("elastic-pad", body("pad={strength='30 MPa'}\n")), Bears::no);
    EXPECT_EQ(bears("rim-of-points", body("base={shape='round'}\npad={strength='30 MPa'}\n")), Bears::yes);
    EXPECT_EQ(bears("rim-of-points", body("base={shape='round'}\n")), Bears::no);
    auto const in_space = [&](std::string const& keys) { return bears("rolling-loss", across + keys + levels); };
    EXPECT_EQ(in_space("base={shape='round'}\n"), Bears::yes);
    EXPECT_EQ(in_space("base={bedding='flat'}\n"), Bears::yes);
    EXPECT_EQ(in_space(""), Bears::no) << "square, on its corners";
    EXPECT_EQ(in_space("axes=1\nbase={shape='round'}\n"), Bears::no);
    EXPECT_EQ(bears("rolling-loss", body("base={shape='round'}\n")), Bears::no) << "one component";
    auto const grips = [&](std::string const& keys) { return bears("rolling-grip", across + keys + levels); };
    EXPECT_EQ(grips("friction=0.5\nbase={shape='round'}\n"), Bears::yes);
    EXPECT_EQ(grips("base={shape='round'}\n"), Bears::no) << "it holds its place";
    EXPECT_EQ(grips("friction=0.5\nbase={shape='round', points=64}\n"), Bears::no);
    EXPECT_EQ(grips("friction=0.5\naxes=1\nbase={shape='round'}\n"), Bears::no);
    EXPECT_EQ(bears("no-slip", plain), Bears::yes);
    EXPECT_EQ(bears("no-slip", body("friction=0.5\n")), Bears::no);
    EXPECT_EQ(bears("no-slip", body("friction=0.5\n") + "[effects]\nmode='none'\n"), Bears::yes);
    EXPECT_EQ(bears("constant-friction", plain), Bears::no);
    EXPECT_EQ(bears("constant-friction", body("friction=0.5\n")), Bears::yes);
    EXPECT_EQ(bears("known-bodies", body("restitution={distribution='lognormal', median=0.8, beta=0.1, high=0.9}\n")),
              Bears::no);
    EXPECT_EQ(bears("fastened-parts", plain), Bears::yes) << "nothing is known of what it is made of";
    auto const stacked = [](std::string const& standing) {
        return quick_waves
               + "[[bodies]]\nbase_width=2\nparts=[{kind='box', mass='9 t', width=2, height=1}, "
                 "{kind='box', mass='9 t', width=2, height=1, bottom=1"
               + standing + "}]\n" + levels;
    };
    EXPECT_EQ(bears("fastened-parts", stacked("")), Bears::yes);
    EXPECT_EQ(bears("fastened-parts", stacked(", fastened=true")), Bears::no);
    EXPECT_EQ(bears("one-spectrum", plain), Bears::yes);
    EXPECT_EQ(bears("independent-components", plain), Bears::no);
    EXPECT_EQ(bears("independent-components", across + levels), Bears::yes);
}

/// Every line is whole, and no effect is reported without the study that found it.
TEST(Assumptions, AreListedInFull) {
    std::set<std::string_view> names;
    for (auto const& one : model_assumptions()) {
        EXPECT_TRUE(names.insert(one.name).second) << one.name;
        EXPECT_FALSE(one.assumed.empty() || one.key.empty() || one.evidence.empty()) << one.name;
        EXPECT_TRUE(one.effect == "not measured" || one.evidence.find("campaigns/") != std::string_view::npos)
            << one.name;
    }
    EXPECT_GE(names.size(), 15U);
}

}  // namespace
}  // namespace overturn
