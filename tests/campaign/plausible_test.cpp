// Requirement R-904: what is stated of a body, its waves or its levels and hardly meant is a line of one table; what is
// usual gets none.
#include <algorithm>

#include <gtest/gtest.h>

#include "campaign/warnings.hpp"
#include "support/campaigns.hpp"

namespace overturn {
namespace {

struct Stated {
    std::string mass = "'138 t'", width = "3.4", height = "2.9", more = {};
};

std::vector<std::string> of_body(Stated const& body) {
    return warnings_of(
        testing::campaign_from(testing::quick_waves
                               + fmt::format("[[bodies]]\nname='cask'\nmass={}\nbase_width={}\ncentre_height={}\n"
                                             "inertia='uniform-block'\n{}\n",
                                             body.mass, body.width, body.height, body.more)
                               + testing::levels("values=[3]\n"))
            .bodies.front());
}

void expect_reported(std::vector<std::string> const& lines, std::string const& part) {
    EXPECT_TRUE(
        std::ranges::any_of(lines, [&](std::string const& line) { return line.find(part) != std::string::npos; }))
        << "no '" << part << "' in: " << fmt::format("{}", lines.empty() ? "nothing" : lines.front());
}

// Casks of 30 to 180 t as they are built, a model, a test block; in any unit.
TEST(Plausible, UsualBodiesGetNoLine) {
    for (auto const& body : std::vector<Stated>{{},
                                                {"'118 t'", "2.4", "2.55"},
                                                {"'163 t'", "3.37", "3.0"},
                                                {"'304000 lb'", "'11 ft'", "'114 in'"},
                                                {"'12.6 t'", "0.9", "1.045"},
                                                {"'138 t'", "3.4", "2.9", "friction={static=0.5, kinetic_ratio=0.9}"},
                                                {"'138 t'", "3.4", "2.9", "slope='1 deg'\naxes=1"}}) {
        auto const lines = of_body(body);
        EXPECT_TRUE(lines.empty()) << body.mass << ' ' << body.width << ": " << lines.front();
    }
}

TEST(Plausible, SlipsInABodyGetOne) {
    expect_reported(of_body({"'138 t'", "1.7", "2.9"}), "kg/m3");
    expect_reported(of_body({"'118 t'", "2.4", "5.1"}),
                    "over half the width is 4.25 (casks 1.5 to 3)");  // the full height
    expect_reported(of_body({"'138 t'", "3.4", "1.45"}), "over half the width is 0.853");
    expect_reported(of_body({"'138 t'", "5.8", "1.7", "restitution=0.3"}), "over half the width is 0.586");
    expect_reported(of_body({"'200 t'", "3.4", "5.8"}), "over half the width is 3.41");  // heavy, and the full height
    expect_reported(of_body({"304000", "3.4", "2.9"}), "kg, t or lb?");
    expect_reported(of_body({"260000", "2.4", "2.55"}), "kg, t or lb?");  // pounds as a bare number
    expect_reported(of_body({"'138000 lb'", "3.4", "2.9"}), "kg, t or lb?");
    expect_reported(of_body({"138", "3.4", "2.9"}), "kg, t or lb?");
    auto const with = [](std::string const& more) { return of_body({"'138 t'", "3.4", "2.9", more}); };
    expect_reported(with("restitution=0.05"), "of Housner's");
    expect_reported(with("friction=0.04"), "static friction 0.04");
    expect_reported(with("friction={static=0.5, kinetic=0.05}"), "kinetic friction is 0.1 of the static one");
    expect_reported(with("gravity=1"), "gravity 1 m/s2 (9.78 to 9.83 m/s2 on Earth)");
    expect_reported(with("similarity={direction='to-model', length=2.5}"), "similarity.length 2.5");
    expect_reported(with("slope=0.2\naxes=1"), "slope 11.5 deg");
    expect_reported(with("initial_tilt=0.2\naxes=1"), "initial_tilt 11.5 deg");
    expect_reported(of_body({"{distribution='normal', mean='138 t', deviation='5 kg'}", "3.4", "2.9"}),
                    "mass scatters by 0.0036");
    expect_reported(with("offset=0.6\naxes=1"), "offset 0.6 m is 0.35 of half the width");
    expect_reported(with("pad={vertical_frequency=2}"), "pad.vertical_frequency 2 Hz");
    expect_reported(with("pad={strength='1000 MPa'}"), "pad.strength 1000 MPa");
    expect_reported(with("base={shape='round', points=32}"), "a rim of 32 points (none: the rim is continuous");
    expect_reported(with("base={shape='round', points=32}\npad={strength='30 MPa'}"),
                    "64 or more on a pad that yields");
    expect_reported(with("base={shape='round', points=256}"), "a rim of 256 points");
    EXPECT_TRUE(with("base={shape='round'}\npad={strength='30 MPa'}").empty());
    expect_reported(with("pad={normal_restitution=0.95, match_restitution=false}"), "pad.normal_restitution 0.95");
    expect_reported(with("pad={tangential_ratio=80}"), "pad.tangential_ratio 80");
    expect_reported(with("pad={tangential_damping=30}"), "pad.tangential_damping 30 (a fraction of critical");
    expect_reported(with("inertia_y='5200 t m2'"), "inertia_y is 10 of");
    expect_reported(with("inertia_z='53200 t m2'"), "inertia_z is 102 of");
    expect_reported(with("friction={distribution='lognormal', median=0.3, beta=0.8, high=1}"), "friction scatters by");
    expect_reported(of_body({"{distribution='normal', mean='138 t', deviation='50 t'}", "3.4", "2.9"}),
                    "mass scatters by 36");
}

TEST(Plausible, InertiaAboutACornerAndRadiiForDiametersGetOne) {
    auto const of = [](std::string const& keys) {
        return warnings_of(testing::campaign_from(testing::quick_waves + "[[bodies]]\nname='cask'\nbase_width='3.4 m'\n"
                                                  + keys + testing::levels("values=[3]\n"))
                               .bodies.front());
    };
    std::string const whole = "mass='138 t'\ncentre_height='2.9 m'\ninertia=";
    expect_reported(of(whole + "'2080 t m2'\n"), "1.15 about its corner");
    EXPECT_TRUE(of(whole + "'520 t m2'\n").empty());
    std::string const part = "parts=[{kind='cylinder', mass='118 t', height='5.2 m', diameter=";
    expect_reported(of(part + "'1.2 m'}]\n"), "a cylinder of 2.006e+04 kg/m3 (steel 7850 kg/m3, solid)");
    EXPECT_TRUE(of(part + "'2.4 m'}]\n").empty());
}

//
TEST(Plausible, PartsThatMoveOnEachOtherFirstGetOne) {
    auto const of = [](std::string const& of_cask, std::string const& of_body = {}) {
        return warnings_of(testing::campaign_from(testing::quick_waves + "[[bodies]]\nname='c'\nbase_width=3.4\n"
                                                  + of_body
                                                  + "parts=[{kind='cylinder', mass='117 t', diameter=2.5, height=5.4, "
                                                    "bottom=0.35"
                                                  + of_cask + "}, {kind='box', mass='21 t', width=3.4, height=0.35}]\n"
                                                  + testing::levels("values=[3]\n"))
                               .bodies.front());
    };
    auto const tips = of("");
    ASSERT_EQ(tips.size(), 1U);
    EXPECT_EQ(
        tips.front(),
        "c: part 1 tips on the part below at 0.463 g, before the whole body tips at 0.651 g (all parts are computed "
        "as one body). State fastened = true if no motion is possible there; else add a body of the parts above: "
        "mass 117 t, base_width 2.5 m, centre_height 2.7 m, base = {shape = \"round\"}");
    auto const narrow = warnings_of(
        testing::campaign_from(testing::quick_waves
                               + "[[bodies]]\nname='c'\nbase_width=3.4\nparts=[{kind='box', mass='117 t', width=2.5, "
                                 "height=5.4, bottom=0.35}, {kind='box', mass='21 t', width=3.4, height=0.35}]\n"
                               + testing::levels("values=[3]\n"))
            .bodies.front());
    ASSERT_EQ(narrow.size(), 1U);
    EXPECT_TRUE(narrow.front().ends_with("centre_height 2.7 m")) << "a box has a square foot";
    expect_reported(of("", "gravity=4.9\n"), "c: part 1 tips on the part below at 0.463 g");  // of its own gravity
    EXPECT_TRUE(of(", fastened=true").empty());
    EXPECT_EQ(of(", fastened=false"), tips);
    EXPECT_TRUE(of("", "friction=0.4\n").empty()) << "the whole slides first";
    expect_reported(of("", "friction=0.5\n"), "before the whole body slides at 0.5 g");
    expect_reported(of("", "friction={distribution='uniform', low=0.3, high=0.5}\n"),
                    "before the whole body slides at 0.5 g");
    expect_reported(of(", friction=0.3", "friction=0.4\n"),
                    "part 1 slides on the part below at 0.3 g, before the whole body");
    expect_reported(of("", "slope='2 deg'\naxes=1\n"),
                    "tips on the part below at 0.421 g, before the whole body tips at 0.602");
    auto const sunk = warnings_of(
        testing::campaign_from(testing::quick_waves
                               + "[[bodies]]\nname='c'\nbase_width=3.4\nparts=[{kind='cylinder', mass='117 t', "
                                 "diameter=2.5, height=5.4, bottom=0.34}, {kind='box', mass='21 t', width=3.4, "
                                 "height=0.35}]\n"
                               + testing::levels("values=[3]\n"))
            .bodies.front());
    expect_reported(sunk, "part 1 stands above the base, but no other part ends at its bottom");
}

std::vector<std::string> of_campaign(std::string const& waves, std::string const& levels = "values=[3]\n",
                                     std::string const& more = {}) {
    return warnings_of(testing::campaign_from(waves + testing::type_b + testing::levels(levels) + more));
}
std::string with(std::string const& before, std::string const& now) {
    auto text = testing::quick_waves;
    return text.replace(text.find(before), before.size(), now);
}
std::string const target = "spectrum='mlit-ch1'\ntime_scale=0.632";

TEST(Plausible, KeysOutsideOfWhatIsUsualGetALine) {
    expect_reported(of_campaign("[waves]\nsource='spectrum-compatible'\ncount=1\nduration='1.28 s'\nmatch='none'\n"
                                "[waves.target]\nspectrum='mlit-ch1'\n"),
                    "waves.duration 1.28 s (earthquakes shake for");
    expect_reported(of_campaign(with(target, "spectrum='rg-1.60'\npga=0.3")),
                    "waves.target.pga 0.3 (design earthquakes");
    expect_reported(of_campaign(with(target, "points=[[0.05,5],[2,5]]\nkind='acceleration'\ndamping=0.5")),
                    "waves.target.damping 0.5");
    expect_reported(of_campaign(with("time_scale=0.632", "time_scale=6.32")), "waves.target.time_scale 6.32");
    expect_reported(of_campaign(testing::quick_waves + "[waves.vertical]\nratio=6.67\n"), "waves.vertical.ratio 6.67");
    expect_reported(of_campaign(testing::quick_waves + "[waves.transverse]\nratio=0.1\n"),
                    "waves.transverse.ratio 0.1");
    expect_reported(of_campaign(testing::quick_waves, "values=[3]\n", "[statistics]\nconfidence=0.05\n"),
                    "statistics.confidence 0.05 (0.9 or 0.95). Check it");
    expect_reported(of_campaign(testing::quick_waves, "values=[3]\n", "[measures]\nslid_from=1\n"),
                    "measures.slid_from 1 (1 mm)");
    expect_reported(of_campaign(testing::quick_waves + "[waves.transverse]\nratio=1\ncorrelation=0.9\n"),
                    "waves.transverse.correlation 0.9");
    expect_reported(of_campaign(testing::quick_waves, "values=[3]\n", "[statistics]\ntarget_half_width=0.45\n"),
                    "statistics.target_half_width 0.45");
    expect_reported(
        of_campaign("[waves]\nsource='spectrum-compatible'\ncount=1\nduration='30 s'\nmatch='none'\n[waves.target]\n"
                    "spectrum='mlit-ch1'\n[waves.envelope]\nshape='jennings'\nrise='0.04 s'\n"
                    "level_end='0.16 s'\nend='0.28 s'\n"),
        "waves.envelope is level for 0.12 s (strong shaking lasts 5 s to minutes)");
    for (auto const& line : of_campaign(testing::quick_waves + "[waves.vertical]\nratio=0.667\n", "values=[3]\n",
                                        "[statistics]\nconfidence=0.9\n[measures]\nslid_from='2 mm'\n")) {
        EXPECT_EQ(line.find("Check it"), std::string::npos) << line;
    }
}

// 41 points across are 16 in space, whatever was asked for.
TEST(Plausible, BedsFinerThanSpaceHoldsGetALine) {
    auto const across = testing::quick_waves + "[waves.transverse]\nratio=1\n" + testing::type_b;
    auto const told = [](std::string const& text) {
        auto const lines = warnings_of(testing::campaign_from(text + testing::levels("values=[3]\n")));
        return std::ranges::any_of(lines, [](auto const& line) { return line.find("16 by 16") != std::string::npos; });
    };
    EXPECT_TRUE(told(across + "base={bedding='flat', points=17}\n"));
    EXPECT_FALSE(told(across + "base={bedding='flat', points=16}\n"));
    EXPECT_FALSE(told(across + "axes=1\nbase={bedding='flat', points=41}\n"));
    EXPECT_FALSE(told(testing::quick_waves + testing::type_b + "base={bedding='flat', points=41}\n"));
}

// RG 1.60 prints its vertical spectra for the horizontal pga: reduced once more they err to the unsafe side.
TEST(Plausible, VerticalTargetsThatAreNoneGetALine) {
    auto const lines = [](std::string const& vertical) {
        return of_campaign(with(target, "spectrum='rg-1.60'\npga='0.3 g'") + "[waves.vertical.target]\n" + vertical);
    };
    expect_reported(lines("spectrum='rg-1.60'\npga='0.3 g'\n"), "1 times the horizontal one (vertical motion is half");
    expect_reported(lines("spectrum='rg-1.60'\n"), "waves.vertical.target is rg-1.60, 1 times the horizontal one");
    expect_reported(of_campaign(with(target, "spectrum='rg-1.60-vertical'\npga='0.3 g'")),
                    "waves.target is rg-1.60-vertical (a vertical spectrum, lower");
    expect_reported(lines("spectrum='rg-1.60-vertical'\npga='0.2 g'\n"),
                    "0.667 times the horizontal one (RG 1.60 prints");
    for (auto const* sound : {"spectrum='rg-1.60'\npga='0.2 g'\n", "spectrum='rg-1.60-vertical'\npga='0.3 g'\n",
                              "spectrum='rg-1.60-vertical'\n"}) {
        for (auto const& line : lines(sound)) {
            EXPECT_EQ(line.find("waves.vertical"), std::string::npos) << line;
        }
    }
}

TEST(Plausible, LevelsInAnotherUnitOrOrderGetALine) {
    auto const lines = [](std::string const& levels) { return of_campaign(testing::quick_waves, levels); };
    expect_reported(lines("values=['30 g']\n"),
                    "levels up to pga 294.2 m/s2 = 29420 gal (the strongest records stay below 5 g). "
                    "Check the unit, g");
    expect_reported(lines("values=['0.3 gal', '0.6 gal']\n"),
                    "levels up to pga 0.6 gal (casks do not move below 20 gal)");
    expect_reported(lines("values=['9 g']\ndesign_basis='0.3 g'\n"),
                    "the highest level, 9 g, is 30 times the design basis");
    expect_reported(lines("values=['0.3 g', '0.6 g', '0.09 g']\n"), "level 0.09 g is listed behind 0.6 g");
    for (auto const& line : lines("values=['0.1 g', '0.3 g', '0.6 g']\ndesign_basis='0.2 g'\n")) {
        EXPECT_EQ(line.find("level"), std::string::npos) << line;
    }
}

// Periods in another unit scale to the levels and move the ground as nothing does.
TEST(Plausible, PeriodsInAnotherUnitGetALine) {
    auto const lines = [](std::string const& periods) {
        return of_campaign("[waves]\nsource='pulse'\nshape='one-sine'\namplitude='0.5 g'\nperiods=" + periods + "\n");
    };
    expect_reported(lines("[50]"), "m/s at the highest level (the strongest records stay below 4 m/s)");
    expect_reported(lines("[50]"), "moves the ground by");
    for (auto const& line : lines("['0.5 s', '2 s']")) {
        EXPECT_EQ(line.find("wave 0"), std::string::npos) << line;
    }
}

// Across it takes no pga from the horizontal target.
TEST(Plausible, ComponentsOfOtherStrengthGetALine) {
    auto const lines = [](std::string const& component) {
        return of_campaign(with(target, "spectrum='rg-1.60'\npga='0.3 g'") + component);
    };
    std::string const across = "[waves.transverse.target]\nspectrum='rg-1.60'\npga=";
    expect_reported(lines(across + "'1 g'\n"), "times as strong across");
    expect_reported(lines(across + "'0.03 g'\n"), "times as strong across");
    expect_reported(lines("[waves.vertical.target]\nspectrum='mlit-ch1'\nscale=0.01\n"),
                    "wave 0 is very weak vertically");
    for (auto const& component :
         {across + "'0.3 g'\n", std::string("[waves.transverse]\nratio=1\n[waves.vertical]\nratio=0.667\n")}) {
        for (auto const& line : lines(component)) {
            EXPECT_EQ(line.find("wave 0"), std::string::npos) << line;
        }
    }
}

// A longest period beyond the target's end matches nothing.
TEST(Plausible, LongestBeyondTheTargetGetsALine) {
    auto const lines = [](std::string const& longest) {
        auto waves = with("match='none'", "match='each'");
        waves.replace(waves.find(target), target.size(),
                      "points=[[0.05,5],[4,5]]\nkind='acceleration'\nlongest=" + longest);
        return of_campaign(waves);
    };
    expect_reported(lines("9"), "waves.target.longest 9 (the target ends before it");
    for (auto const& line : lines("4")) {
        EXPECT_EQ(line.find("waves.target.longest 4 "), std::string::npos) << line;
    }
}

}  // namespace
}  // namespace overturn
