// Requirement R-301: a body is stated directly, from parts, at scale or by file.
#include "campaign/body_spec.hpp"

#include <map>
#include <vector>

#include "support/expect_input_error.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::near;

BodySpec body_of(std::string const& keys, std::map<std::string, std::string> contents = {}) {
    InputFiles files(std::move(contents));
    return read_body(config::Table::parse(keys, "b.toml"), files);
}

void refuse(std::string const& keys, std::string const& part) {
    testing::expect_input_error([&] { (void)body_of(keys); }, "b.toml:", part);
}

std::string const block = "mass='12.6 t'\nbase_width='1.36 m'\ncentre_height='1.045 m'\n";

TEST(BodySpec, StatedDirectly) {
    auto const spec = body_of(block + "name='a'\ninertia=6000\nrestitution=0.8\nfriction=0.5\n");

    EXPECT_EQ(spec.name, "a");
    EXPECT_EQ(spec.body.mass_kg(), 12600);
    EXPECT_EQ(spec.body.half_width_m(), 0.68);
    EXPECT_EQ(spec.body.inertia_kgm2(), 6000);
    EXPECT_EQ(spec.body.restitution(), 0.8);
    ASSERT_TRUE(spec.friction);
    EXPECT_EQ(spec.friction->static_coefficient, 0.5);
    EXPECT_EQ(spec.friction->kinetic_coefficient, 0.5);
}

TEST(BodySpec, UniformBlockAndHousner) {
    auto const spec = body_of(block + "inertia='uniform-block'\nrestitution='housner'\n");

    double const sine = std::sin(spec.body.alpha_rad());
    EXPECT_TRUE(near(spec.body.inertia_kgm2(), 12600 * (0.68 * 0.68 + 1.045 * 1.045) / 3, testing::exact_formula));
    EXPECT_TRUE(near(spec.body.restitution(), 1 - 1.5 * sine * sine, testing::exact_formula));
    EXPECT_FALSE(spec.friction);
}

// Cask, pallet and counterweight by the parallel-axis theorem, by hand.
TEST(BodySpec, FromParts) {
    auto const spec = body_of(
        "base_width=3.4\n"
        "[[parts]]\nkind='cylinder'\nmass='117 t'\ndiameter=2.5\nheight=5.4\nbottom=0.35\n"
        "[[parts]]\nkind='box'\nmass='21 t'\nwidth=3.4\nheight=0.35\n"
        "[[parts]]\nkind='point'\nmass='2 t'\nheight=1\n");

    double const m = 140e3;
    double const h = (117e3 * 3.05 + 21e3 * 0.175 + 2e3 * 1) / m;
    double const own = 117e3 * (3 * 1.25 * 1.25 + 5.4 * 5.4) / 12 + 21e3 * (3.4 * 3.4 + 0.35 * 0.35) / 12;
    double const moved = 117e3 * (3.05 - h) * (3.05 - h) + 21e3 * (0.175 - h) * (0.175 - h) + 2e3 * (1 - h) * (1 - h);
    EXPECT_TRUE(near(spec.body.mass_kg(), m, testing::exact_formula));
    EXPECT_TRUE(near(spec.body.centre_height_m(), h, testing::exact_formula));
    EXPECT_TRUE(near(spec.body.inertia_kgm2(), own + moved, testing::exact_formula));
}

//
TEST(BodySpec, SimilarityBothWays) {
    auto const prototype = block + "inertia=6000\n";
    auto const model = body_of(prototype + "[similarity]\ndirection='to-model'\nlength=0.4\n");

    EXPECT_TRUE(near(model.body.half_width_m(), 0.4 * 0.68, testing::exact_formula));
    EXPECT_TRUE(near(model.body.mass_kg(), 12600 * 1.43 * 0.064, testing::exact_formula));
    EXPECT_TRUE(near(model.body.inertia_kgm2(), 6000 * 1.43 * 0.01024, testing::exact_formula));
    EXPECT_TRUE(near(model.body.alpha_rad(), body_of(prototype).body.alpha_rad(), testing::exact_formula));

    auto const back = body_of(fmt::format(
        "mass={}\nbase_width={}\ncentre_height={}\ninertia={}\n"
        "[similarity]\ndirection='to-prototype'\nlength=0.4\n",
        model.body.mass_kg(), 2 * model.body.half_width_m(), model.body.centre_height_m(), model.body.inertia_kgm2()));
    EXPECT_TRUE(near(back.body.mass_kg(), 12600, testing::exact_formula));
    EXPECT_TRUE(near(back.body.half_width_m(), 0.68, testing::exact_formula));
    EXPECT_TRUE(near(back.body.inertia_kgm2(), 6000, testing::exact_formula));
}

TEST(BodySpec, FileWithOverrides) {
    std::map<std::string, std::string> const files{
        {"a.toml", "name='a'\n" + block + "inertia=6000\nrestitution=0.9\nfriction=0.6\n"}};

    auto const plain = body_of("file='a.toml'\n", files);
    auto const changed =
        body_of("file='a.toml'\nname='b'\nrestitution='housner'\nfriction={static=0.5,kinetic=0.4}\n", files);

    EXPECT_EQ(plain.name, "a");
    EXPECT_EQ(plain.body.restitution(), 0.9);
    EXPECT_EQ(plain.friction->static_coefficient, 0.6);
    EXPECT_EQ(changed.name, "b");
    EXPECT_EQ(changed.body.restitution(), changed.body.housner_restitution());
    EXPECT_EQ(changed.friction->kinetic_coefficient, 0.4);
    testing::expect_input_error([&] { (void)body_of("file='a.toml'\nmass=3\n", files); }, "b.toml:2:", "mass");
    testing::expect_input_error([&] { (void)body_of("file='none.toml'\n", files); }, "b.toml:1:", "none.toml");
    testing::expect_input_error(
        [&] {
            (void)body_of("file='x.toml'\n", {{"x.toml", "seed=1\n[waves]\nsource='pulse'\n"}});
        },
        "b.toml:1:", "'x.toml' (a campaign: it states waves");
    testing::expect_input_error(
        [&] {
            (void)body_of("file='x.toml'\n", {{"x.toml", "mass=-1\nbase_width=1\n"}});
        },
        "x.toml:1:");
}

// offset, slope and initial tilt are read, go with the similarity law, and are refused beside what only
// models hold that know nothing of them.
TEST(BodySpec, PlacedOffTheMiddleOnASlopeAndTilted) {
    auto const spec =
        body_of(block + "inertia='uniform-block'\noffset='5 cm'\nslope='0.5 deg'\ninitial_tilt='-1 deg'\n");

    EXPECT_TRUE(near(spec.body.corner(1).alpha_rad, std::atan(0.63 / 1.045) - pi / 360, testing::exact_formula));
    EXPECT_TRUE(near(spec.body.corner(-1).alpha_rad, std::atan(0.73 / 1.045) + pi / 360, testing::exact_formula));
    EXPECT_TRUE(near(spec.body.initial_tilt_rad(), -pi / 180, testing::exact_formula));
    EXPECT_STREQ(spec.planar_key(), "offset");
    auto const model = body_of(block + "inertia='uniform-block'\noffset=0.05\nslope='0.5 deg'\n"
                                       "similarity={direction='to-model', length=0.4}\n");
    EXPECT_TRUE(near(model.body.offset_m(), 0.02, testing::exact_formula));
    EXPECT_TRUE(near(model.body.corner(1).alpha_rad, spec.body.corner(1).alpha_rad, testing::exact_formula));
    EXPECT_EQ(body_of(block + "inertia=6000\nslope=0\n").planar_key(), nullptr);
}

//
TEST(BodySpec, RefusesPlacementsThatNothingHolds) {
    auto const body = block + "inertia='uniform-block'\n";
    refuse(body + "offset='0.7 m'\n", "5:8: offset: offset of 0.7 m");
    refuse(body + "slope='40 deg'\n", "5:7: slope: slope of 40 deg");
    refuse(body + "initial_tilt='34 deg'\n", "5:14: initial_tilt: initial tilt of 34 deg");
    refuse(body + "slope='1 deg'\npad={strength='30 MPa'}\n", "slope beside base or pad");
    refuse(body + "offset='1 cm'\ninertia_z=6000\n", "offset beside inertia_y or inertia_z");
    refuse(body + "slope='5 deg'\nfriction={static=0.3,kinetic=0.08}\n", "friction down to 0.08 on a slope of tan");
    refuse(
        "mass=12600\nbase_width=1.36\ninertia='uniform-block'\ninitial_tilt='20 deg'\n"
        "centre_height={distribution='uniform',low=1,high=2}\n",
        "5:15: centre_height: initial tilt of 20 deg");
}

TEST(BodySpec, RefusesNonsense) {
    refuse("mass=-5\nbase_width=1\ncentre_height=1\ninertia=1\n", "mass: -5 kg");
    refuse("mass='5 m'\nbase_width=1\ncentre_height=1\ninertia=1\n", "unit 'm'");
    refuse(block + "inertia='uniform-blok'\n", "inertia");
    refuse(block + "inertia=6000\nrestitution=1.2\n", "restitution: 1.2");
    refuse(block + "inertia=6000\nrestitution='houzner'\n", "houzner");
    refuse(block + "inertia=6000\nfriction={static=0.4,kinetic=0.5}\n", "Swap them");
    refuse(block + "inertia=6000\nfricton=0.4\n", "Did you mean 'friction'?");
    refuse("mass='12 t'\nbase_width=3\ncentre_height=0.5\ninertia='uniform-block'\n", "so squat");
    refuse(block + "inertia=1e12\n", "a radius of gyration of");
    refuse(block + "inertia=6000\ngravity=1e-6\n", "gravity: 1e-06 m/s2");
    refuse("base_width=1\n[[parts]]\nkind='sphere'\nmass=1\n", "sphere");
    refuse("base_width=1\nmass=3\n[[parts]]\nkind='box'\nmass=1\nwidth=1\nheight=1\n", "mass");
}

}  // namespace
}  // namespace overturn
