// Requirement R-904: what can only be a slip is refused where a campaign is to be run, or is a line that states what to
// look at; what is sound is not doubted.
#include "campaign/detail/unsound.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "campaign/warnings.hpp"
#include "support/campaigns.hpp"
#include "support/expect_input_error.hpp"

namespace overturn {
namespace {

std::string const slip_limit = "[[limits]]\nname='touches'\nquantity='peak_slip'\nabove=";

void judge(std::string const& text) {
    auto const input = testing::input_from(text);
    refuse_unsound(input, parse_campaign(input));
}

std::string scene(std::string const& levels, std::string const& limits = {}) {
    return testing::quick_waves + testing::type_b + "friction=0.5\n" + testing::levels(levels) + limits;
}

bool told(std::vector<std::string> const& lines, std::string const& what) {
    return std::ranges::any_of(lines, [&](std::string const& line) { return line.find(what) != std::string::npos; });
}

TEST(Unsound, NumberWithoutAUnitBesideLevelsThatHaveOne) {
    for (auto const* levels :
         {"values=['0.3 g', 0.5]\n", "values=['0.3 g']\ndesign_basis=0.3\n", "values=['0.3 g']\nbeyond_design=[0.5]\n",
          "values=[0.3]\ndesign_basis='0.3 g'\n", "values={from='0.1 g', to=1, count=4}\n"}) {
        testing::expect_input_error([&] { judge(scene(levels)); }, "levels.", "without a unit beside levels in g");
    }
    testing::expect_input_error([&] { judge(scene("values=['0.3 g']\n", slip_limit + "0.8\n")); }, "limits[0].above",
                                "0.8 without a unit beside levels in g (a bare number is m). Write its unit");
    for (auto const* sound :
         {"values=[3, 5]\ndesign_basis=3\n", "values=['0.3 g']\n", "values={from='0.1 g', to='1 g', count=4}\n"}) {
        EXPECT_NO_THROW(judge(scene(sound, slip_limit + "'0.8 m'\n"))) << sound;
    }
    EXPECT_NO_THROW(judge(scene("values=[3, 5]\n", slip_limit + "0.8\n"))) << "all of it is SI";
    EXPECT_NO_THROW(
        judge(scene("values=['0.3 g']\n", "[[limits]]\nname='rises'\nquantity='peak_rotation_ratio'\nabove=0.5\n")));
}

// Of a distribution and of a list of pairs as well: 138 t with a deviation of 5 kg has none.
TEST(Unsound, NumberWithoutAUnitBesideOneOfTheSameQuantity) {
    auto const body = [](std::string const& mass) {
        return testing::campaign_from(testing::quick_waves + "[[bodies]]\nname='box'\nbase_width='3.4 m'\nmass=" + mass
                                      + "\ncentre_height='2.9 m'\ninertia='uniform-block'\n"
                                      + testing::levels("values=[3]\n"));
    };
    for (auto const* mixed :
         {"{distribution='normal', mean='138 t', deviation=5}", "{distribution='uniform', low=130, high='140 t'}",
          "{distribution='lognormal', median='138 t', beta=0.1, high=150}"}) {
        testing::expect_input_error([&] { (void)body(mixed); }, "bodies[0].mass", "without a unit beside",
                                    "in t (a bare number is kg)");
    }
    for (auto const* sound :
         {"{distribution='normal', mean='138 t', deviation='5 t'}", "{distribution='uniform', low=130e3, high=140e3}",
          "{distribution='lognormal', median='138 t', beta=0.1}"}) {
        EXPECT_NO_THROW((void)body(sound)) << sound;
    }
    auto const target = [](std::string const& points) {
        auto waves = testing::quick_waves;
        waves.replace(waves.find("spectrum='mlit-ch1'\ntime_scale=0.632"), 36, "kind='acceleration'\npoints=" + points);
        return testing::campaign_from(waves + testing::type_b + testing::levels("values=[3]\n"));
    };
    testing::expect_input_error([&] { (void)target("[['0.05 s','0.3 g'],['2 s',0.2]]"); }, "waves.target.points",
                                "0.2 without a unit beside 0.3 g (a bare number is m/s2)");
    testing::expect_input_error([&] { (void)target("[['20 ms',3],[2,3]]"); }, "waves.target.points",
                                "2 without a unit beside 20 ms");
    EXPECT_NO_THROW((void)target("[[0.05,'0.3 g'],[2,'0.2 g']]")) << "each column has one";
}

// Angular velocities have units of their own.
TEST(Unsound, SpinsAreStatedInTheirUnits) {
    std::string const spins = "[[limits]]\nname='lands hard'\nquantity='landing_spin'\nabove=";
    auto const threshold = [&](std::string const& above) {
        return testing::campaign_from(scene("values=['0.3 g']\n", spins + above + "\n")).limits[1].threshold;
    };
    EXPECT_EQ(threshold("'1.5 rad/s'"), 1.5);
    EXPECT_NEAR(threshold("'90 deg/s'"), pi / 2, 1e-15);
    EXPECT_NO_THROW(judge(scene("values=['0.3 g']\n", spins + "'1.5 rad/s'\n")));
    testing::expect_input_error([&] { judge(scene("values=['0.3 g']\n", spins + "1.5\n")); }, "limits[0].above",
                                "a bare number is rad/s");
    for (auto const* wrong : {"'1.5 m/s'", "'1.5'", "'-1 rad/s'"}) {
        testing::expect_input_error([&] { (void)threshold(wrong); }, "limits[0].above", "rad/s or deg/s");
    }
}

// Energies over the mass likewise; a bare number has no other unit that it could be.
TEST(Unsound, EnergiesOfLandingsHaveUnits) {
    auto const limit = [](std::string const& above) {
        return testing::campaign_from(
                   scene("values=['0.3 g']\n",
                         "[[limits]]\nname='hard'\nquantity='landing_energy'\nabove=" + above + "\n"))
            .limits[1];
    };
    EXPECT_EQ(limit("'17.5 J/kg'").threshold, 17.5);
    EXPECT_EQ(limit("'17.5 kJ/t'").threshold, 17.5);
    EXPECT_EQ(limit("17.5").threshold, 17.5);
    for (auto const* wrong : {"'17.5 kJ'", "'17.5 m/s'", "'17.5'", "'-1 J/kg'"}) {
        testing::expect_input_error([&] { (void)limit(wrong); }, "limits[0].above", "J/kg or kJ/t");
    }
}

// A results file that has them is still read.
TEST(Unsound, IsNotAskedOfWhatIsReadOnly) {
    EXPECT_NO_THROW((void)testing::campaign_from(scene("values=['0.3 g', 0.5]\n")));
}

TEST(Plausible, MistypedCampaignsGetOne) {
    auto const lines = [](std::string const& waves, std::string const& levels, std::string const& limits = {}) {
        return warnings_of(testing::campaign_from(waves + testing::type_b + "friction=0.5\n" + levels + limits));
    };
    auto waves = testing::quick_waves;
    auto const with = [&](std::string const& before, std::string const& now) {
        auto text = testing::quick_waves;
        return text.replace(text.find(before), before.size(), now);
    };
    EXPECT_TRUE(told(lines(waves, testing::levels("values=[0.3, 0.5]\n")), "Write \"0.5 g\" if that was meant"));
    // Type B rises from 4.22 m/s2 on.
    EXPECT_TRUE(told(lines(waves, testing::levels("values=[0.5, 2]\n")), "no body slips or rises below 4.22 m/s2"));
    EXPECT_FALSE(told(lines(waves, testing::levels("values=['0.1 g', '0.2 g']\n")), "no body slips"));
    EXPECT_TRUE(told(
        lines(waves, testing::levels("values=[3]\n"), "[[limits]]\nname='hits'\nquantity='peak_slip'\nbelow='0.3 m'\n"),
        "limit 'hits': peak_slip below 0.3 m is passed by a body at rest"));
    auto const near = [&](char const* below) {
        return lines(
            waves, testing::levels("values=[3]\n"),
            fmt::format("[site]\nwall='0.8 m'\n[[limits]]\nname='near'\nquantity='least_clearance'\nbelow='{}'\n",
                        below));
    };
    EXPECT_TRUE(told(near("0.9 m"), "is passed by a body at rest, which has 0.8 m"));
    EXPECT_TRUE(told(near("90 cm"), "is passed by a body at rest, which has 80 cm"));
    EXPECT_TRUE(told(near("0.9"), "is passed by a body at rest, which has 0.8 m"));
    EXPECT_FALSE(told(near("0.7 m"), "at rest"));
    EXPECT_TRUE(told(lines(waves + "[waves.vertical]\nratio=6.67\n", testing::levels("values=[3]\n")),
                     "wave 0 is stronger vertically"));
    EXPECT_TRUE(told(lines(with("time_step='0.02 s'", "time_step='0.1 s'"), testing::levels("values=[3]\n")),
                     "time step of 0.1 s: nothing above 5 Hz"));
    for (auto const& line : lines(waves + "[waves.vertical]\nratio=0.667\n", testing::levels("values=[3, 6]\n"))) {
        EXPECT_EQ(line.find("time step"), std::string::npos) << line;
        EXPECT_EQ(line.find("vertically"), std::string::npos) << line;
        EXPECT_EQ(line.find("if that was meant"), std::string::npos) << line;
    }
}

// Published: RG 1.60 prints its vertical spectra for the horizontal peak acceleration, so that both have one pga.
TEST(Plausible, AVerticalTargetTakesThePgaOfTheHorizontalOne) {
    auto const vertical_pga = [](std::string const& target, std::string const& vertical) {
        auto waves = testing::quick_waves;
        waves.replace(waves.find("spectrum='mlit-ch1'\ntime_scale=0.632"), 36, target);
        waves.replace(waves.find("match='none'"), 12, "match='each'");
        auto const spec = testing::campaign_from(waves + "[waves.vertical.target]\nspectrum='rg-1.60-vertical'\n"
                                                 + vertical + testing::type_b + testing::levels("values=[3]\n"));
        return peak_of(spec.source->make(1, 0).motion.vertical_mps2);
    };
    std::string const rg = "spectrum='rg-1.60'\npga='0.3 g'\n";
    EXPECT_EQ(vertical_pga(rg, ""), vertical_pga(rg, "pga='0.3 g'\n"));
    EXPECT_GT(vertical_pga(rg, "pga='0.6 g'\n"), 1.5 * vertical_pga(rg, ""));
    testing::expect_input_error([&] { (void)vertical_pga("spectrum='mlit-ch1'\n", ""); },
                                "waves.vertical.target.spectrum", "'rg-1.60-vertical' without pga");
}

// A body so squat that Housner's restitution is negative stands by the one that is stated, in its own file as well.
TEST(Squat, BodiesStandByTheirStatedRestitution) {
    std::string const squat = "mass='1 t'\nbase_width='1.8 m'\ncentre_height='0.6 m'\ninertia='uniform-block'\n";
    auto const read = [&](std::string const& more, std::string const& file) {
        auto const body =
            file.empty() ? "[[bodies]]\nname='box'\n" + squat + more : "[[bodies]]\nname='box'\nfile='b.toml'\n" + more;
        return testing::campaign_from(testing::quick_waves + body + testing::levels("values=[3]\n"),
                                      {{"b.toml", squat + file}});
    };
    EXPECT_EQ(read("restitution=0.3\n", "").bodies[0].body.restitution(), 0.3);
    EXPECT_EQ(read("", "restitution=0.3\n").bodies[0].body.restitution(), 0.3);
    EXPECT_EQ(read("restitution=0.4\n", "restitution=0.3\n").bodies[0].body.restitution(), 0.4);
    EXPECT_EQ(read("restitution=0.4\n", "friction=0.5\n").bodies[0].body.restitution(), 0.4) << "the file states none";
    for (auto const* key : {"offset='5 cm'\n", "slope='1 deg'\n", "initial_tilt='1 deg'\n", "pad={}\n"}) {
        EXPECT_EQ(read("axes=1\nrestitution=0.4\n", key).bodies[0].body.restitution(), 0.4) << key;
        EXPECT_EQ(read("axes=1\n", std::string("restitution=0.4\n") + key).bodies[0].body.restitution(), 0.4) << key;
    }
    // Of a polygon none may be stated, and none is needed.
    std::string const polygon = "base={shape='polygon', corners=[[0.9,0.9],[-0.9,0.9],[-0.9,-0.9],[0.9,-0.9]]}\n";
    EXPECT_EQ(read(polygon, "").bodies[0].body.restitution(), 0);
    EXPECT_EQ(read("", polygon).bodies[0].body.restitution(), 0);
    EXPECT_EQ(read(polygon, "friction=0.5\n").bodies[0].body.restitution(), 0);
    auto const drawn = read("restitution={distribution='uniform', low=0.2, high=0.4}\n", "");
    EXPECT_NEAR(drawn.bodies[0].body.restitution(), 0.3, 1e-12);
    for (auto const* without : {"", "restitution='housner'\n"}) {
        testing::expect_input_error([&] { (void)read(without, ""); }, "Housner's restitution is -0.03846");
    }
}

std::vector<std::string> of_target(std::string const& target, std::string const& levels) {
    auto waves = testing::quick_waves;
    std::string const before = "spectrum='mlit-ch1'\ntime_scale=0.632";
    waves.replace(waves.find(before), before.size(), target);
    auto const by = levels.starts_with("measure") ? "[levels]\n" + levels : testing::levels(levels);
    return warnings_of(testing::campaign_from(waves + testing::type_b + by));
}
std::string points(char const* first_two, std::string const& more = {}) {
    return fmt::format("points=[{},[1,3],[10,0.3]]\nkind='acceleration'\n{}", first_two, more);
}

TEST(Unsound, DesignBasisThatIsNotTheTargets) {
    auto const basis = [](std::string const& level) {
        return fmt::format("values=['{0}']\ndesign_basis='{0}'\n", level);
    };
    auto const rg = [](std::string const& more) { return "spectrum='rg-1.60'\n" + more; };
    struct Case {
        std::string target, level;
        char const* said;  // empty: nothing
    };
    for (auto const& [target, level, said] : std::vector<Case>{
             {rg("pga='0.3 g'"), "0.2 g",
              "design basis 0.2 g, but the target spectrum has 0.3 g at its shortest period"},
             {rg("pga='0.3 g'\nscale=2"), "0.3 g", "has 0.6 g at its shortest period, 0.01 s"},
             {rg("pga='0.3 g'\nscale=2"), "0.6 g", ""},
             {rg("pga='0.3 g'\ntime_scale=0.5"), "0.3 g", ""},
             {rg(""), "0.3 g", ""},  // printed for 1 g: a shape
             {points("[0,3],[0.1,7]"), "400 gal",
              "design basis 400 gal, but the target spectrum has 300 gal at period 0"},
             {points("[0,3],[0.1,7]"), "310 gal", "has 300 gal at period 0"},
             {points("[0,3],[0.1,7]"), "295 gal", ""},
             {points("[0,3],[0.1,7]", "stated_damping=0.02\ndamping_rule='eurocode-8'\n"), "300 gal", ""},
             {points("[0,3],[0.1,7]", "scale=0.5\n"), "300 gal", "has 150 gal at period 0"},
             {points("[0,1],[0.1,2]", "unit='g'\n"), "0.3 g", ""},
             {points("[0.01,3],[0.1,7]"), "280 gal", ""},
             {points("[0.01,3],[0.1,7]"), "320 gal", ""},
             {points("[0.01,3],[0.1,7]"), "240 gal", "300 gal at its shortest period, 0.01 s"},
             {points("[0.02,3],[0.03,3]"), "200 gal", "300 gal at its shortest period, 0.02 s"},
             {points("[0.03,3],[0.1,7]"), "200 gal", ""},  // as on hard rock
             {points("[0.03,3],[0.1,7]"), "125 gal", ""},
             {points("[0.03,3],[0.1,7]"), "115 gal", "300 gal at its shortest period, 0.03 s"},
             {points("[0.02,3],[0.1,7]"), "400 gal", "300 gal at its shortest period, 0.02 s"},
             {points("[0.05,3],[0.1,3]"), "600 gal", ""},  // not known
             {"spectrum='mlit-ch1'", "600 gal", ""},       // of engineering bedrock
             {"points=[[0.01,0.01],[1,0.3]]\nkind='pseudo-velocity'", "200 gal", "628.319 gal at its shortest period"},
             {"points=[[0.01,0.01],[1,0.3]]\nkind='energy-velocity'", "200 gal", ""}}) {
        auto const lines = of_target(target, basis(level));
        EXPECT_TRUE(*said != '\0' ? told(lines, said) : !told(lines, "target spectrum has")) << target << level << said;
    }
    auto const all = of_target(points("[0,3],[0.1,7]"), basis("400 gal"));
    EXPECT_TRUE(told(all, "correct levels.design_basis, or pga, unit or scale of waves.target"));
    EXPECT_FALSE(told(of_target(points("[0,3],[0.1,7]"), "values=['400 gal']\n"), "target spectrum"));
    EXPECT_FALSE(
        told(of_target(points("[0,3],[0.1,7]"), "measure='pgv'\nvalues=[0.4]\ndesign_basis=0.4\n"), "target spectrum"));
}

// Factors are of the motion as it is stated; one printed for 1 g is stated for none.
TEST(Unsound, DesignBasisThatIsAFactorOfTheMotion) {
    auto const lines = [](std::string const& target, char const* factor) {
        return of_target(target, fmt::format("measure='factor'\nvalues=[3]\ndesign_basis={}\n", factor));
    };
    EXPECT_TRUE(told(lines("spectrum='mlit-ch1'", "1.5"), "design basis factor 1.5 (factor 1 is the motion as it is"));
    EXPECT_FALSE(told(lines("spectrum='mlit-ch1'", "1"), "design basis"));
    EXPECT_FALSE(told(lines("spectrum='rg-1.60'", "0.3"), "design basis factor"));
}

}  // namespace
}  // namespace overturn
