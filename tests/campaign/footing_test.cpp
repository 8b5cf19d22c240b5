// Requirement R-603: base and pad of a body file mean what they say, scale with the body, and are refused at their key
// where nothing can stand on them or rock as stated.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "campaign/body_spec.hpp"
#include "campaign/warnings.hpp"
#include "support/expect_input_error.hpp"

namespace overturn {
namespace {

BodySpec read(std::string const& more) {
    InputFiles files(".");
    return read_body(config::Table::parse("mass='12.6 t'\nbase_width='1.36 m'\ncentre_height='1.045 m'\n"
                                          "inertia='uniform-block'\n"
                                              + more,
                                          "body.toml"),
                     files);
}

TEST(Footing, WithoutAWordIsASquareOnItsCorners) {
    auto const footing = read("").footing;
    EXPECT_FALSE(footing.stated);
    EXPECT_EQ(footing.base.shape, BaseShape::square);
    EXPECT_EQ(footing.base.corner_share, 1);
    EXPECT_EQ(footing.base.points, 15);
    EXPECT_EQ(footing.pad.vertical_frequency_hz, 98);
    EXPECT_EQ(footing.pad.normal_restitution, 0.25);
    EXPECT_FALSE(footing.pad.strength_pa.has_value());
    EXPECT_TRUE(footing.pad.match_restitution);
}

TEST(Footing, EveryKeyIsRead) {
    auto const footing = read(
                             "base={shape='square', bedding=0.4, points=21}\n"
                             "pad={vertical_frequency='67 Hz', normal_restitution=0.5, strength='30 MPa', "
                             "match_restitution=false, tangential_ratio=0.7, tangential_damping=0.2}\n"
                             "inertia_y='5 t m2'\ninertia_z='4 t m2'\n")
                             .footing;
    EXPECT_TRUE(footing.stated);
    EXPECT_EQ(footing.base.corner_share, 0.4);
    EXPECT_EQ(footing.base.points, 21);
    EXPECT_EQ(footing.pad.vertical_frequency_hz, 67);
    EXPECT_EQ(footing.pad.normal_restitution, 0.5);
    EXPECT_EQ(footing.pad.strength_pa, 30e6);
    EXPECT_FALSE(footing.pad.match_restitution);
    EXPECT_EQ(footing.pad.tangential_ratio, 0.7);
    EXPECT_EQ(footing.pad.tangential_damping, 0.2);
    EXPECT_EQ(footing.inertia_across_kgm2, 5e3);
    EXPECT_EQ(footing.inertia_vertical_kgm2, 4e3);
    EXPECT_EQ(read("base={shape='round'}\n").footing.base.points, 0) << "a rim without corners";
    EXPECT_FALSE(read("base={shape='round'}\n").footing.base.is_disc());
    auto const ring = read("base={shape='round', bedding='flat', inner_diameter='1 m'}\n").footing;
    EXPECT_TRUE(ring.base.is_disc());
    EXPECT_EQ(ring.base.inner_radius_m, 0.5);
    EXPECT_FALSE(ring.pad.match_restitution) << "it has a restitution of its own";
    EXPECT_EQ(read("base={shape='round', bedding='flat'}\n").footing.base.inner_radius_m, 0);
    EXPECT_FALSE(read("base={bedding='flat'}\n").footing.base.corner_share.has_value());
    EXPECT_EQ(read("base={bedding='corners'}\n").footing.base.corner_share, 1);
    auto const polygon =
        read("base={shape='polygon', corners=[[0.68,0.68],[-0.68,0.68],[-0.68,-0.68],[0.68,-0.68]]}\n");
    ASSERT_EQ(polygon.footing.base.corners_m.size(), 4U);
    EXPECT_EQ(polygon.footing.base.corners_m[1][0], -0.68);
}

// A bed of its own has a restitution of its own: Housner's, which nobody stated, does not tune it.
// A key of base or pad beside a file outranks that key of the file, and no other; another shape is another base.
TEST(Footing, KeysBesideAFileOutrankItsOwnOneByOne) {
    auto const beside = [](std::string const& keys) {
        InputFiles files(std::map<std::string, std::string>{
            {"a.toml",
             "mass='12.6 t'\nbase_width='1.36 m'\ncentre_height='1.045 m'\ninertia='uniform-block'\n"
             "base={shape='round', bedding='flat', inner_diameter='0.5 m'}\n"
             "pad={vertical_frequency='67 Hz', tangential_ratio=0.7, match_restitution=false}\n"}});
        return read_body(config::Table::parse("file='a.toml'\n" + keys, "b.toml"), files).footing;
    };
    auto const soft = beside("pad={vertical_frequency='49 Hz'}\n");
    EXPECT_EQ(soft.pad.vertical_frequency_hz, 49);
    EXPECT_EQ(soft.pad.tangential_ratio, 0.7);
    EXPECT_FALSE(soft.pad.match_restitution);
    EXPECT_EQ(soft.base.inner_radius_m, 0.25);

    auto const narrow = beside("base={inner_diameter='1.2 m'}\n").base;
    EXPECT_TRUE(narrow.is_disc());
    EXPECT_EQ(narrow.inner_radius_m, 0.6);
    auto const rim = beside("base={bedding='corners'}\n").base;
    EXPECT_TRUE(rim.continuous());
    EXPECT_FALSE(rim.is_disc());
    EXPECT_EQ(rim.inner_radius_m, 0);
    EXPECT_EQ(beside("base={bedding='flat'}\n").base.inner_radius_m, 0.25) << "the same bedding";
    EXPECT_EQ(beside("base={shape='round'}\n").base.inner_radius_m, 0.25) << "the same shape";
    auto const points = beside("base={bedding='corners', points=64}\npad={strength='30 MPa'}\n");
    EXPECT_EQ(points.base.points, 64);
    EXPECT_EQ(points.pad.strength_pa, 30e6);
    EXPECT_EQ(points.pad.vertical_frequency_hz, 67);

    auto const square = beside("base={shape='square'}\n");
    EXPECT_TRUE(square.base.on_corners());
    EXPECT_EQ(square.base.points, 15);
    EXPECT_EQ(square.pad.vertical_frequency_hz, 67);
    testing::expect_input_error([&] { (void)beside("base={points=64}\n"); }, "b.toml:2:", "without points");
}

// Results files before format 5 keep what they computed: there a table beside a file left nothing of the file's.
TEST(Footing, ATableBesideAFileLeftNothingBeforeFormat5) {
    auto const beside = [](bool old) {
        InputFiles files(std::map<std::string, std::string>{
            {"a.toml",
             "mass='12.6 t'\nbase_width='1.36 m'\ncentre_height='1.045 m'\ninertia='uniform-block'\n"
             "base={bedding='flat', points=21}\npad={vertical_frequency='67 Hz', strength='30 MPa'}\n"}});
        files.read_as_before_format_5(old);
        return read_body(
                   config::Table::parse("file='a.toml'\nbase={bedding=0.5}\npad={tangential_ratio=0.7}\n", "b.toml"),
                   files)
            .footing;
    };
    EXPECT_EQ(beside(true).base.points, 11);
    EXPECT_EQ(beside(true).pad.vertical_frequency_hz, 98);
    EXPECT_FALSE(beside(true).pad.strength_pa);
    EXPECT_EQ(beside(false).base.points, 21);
    EXPECT_EQ(beside(false).pad.vertical_frequency_hz, 67);
    EXPECT_EQ(beside(false).pad.strength_pa, 30e6);
}

// A key that does nothing is warned of.
TEST(Footing, AMatchWithoutARestitutionIsWarnedOf) {
    auto const warned = [](std::string const& keys) {
        auto const lines = warnings_of(read(keys));
        return std::ranges::any_of(
            lines, [](auto const& line) { return line.find("pad.match_restitution") != std::string::npos; });
    };
    EXPECT_TRUE(warned("base={shape='round'}\npad={match_restitution=true}\n"));
    EXPECT_TRUE(warned("base={bedding='flat'}\npad={match_restitution=true}\n"));
    EXPECT_FALSE(warned("base={shape='round'}\n"));
    EXPECT_FALSE(warned("base={shape='round'}\npad={match_restitution=false}\n"));
    EXPECT_FALSE(warned("restitution=0.72\nbase={shape='round'}\npad={match_restitution=true}\n"));
    EXPECT_FALSE(warned("pad={match_restitution=true}\n")) << "corners are matched to Housner's";
}

TEST(Footing, OnlyAStatedRestitutionTunesABed) {
    EXPECT_FALSE(read("base={bedding='flat'}\n").footing.pad.match_restitution);
    EXPECT_FALSE(read("base={bedding='flat'}\nrestitution='housner'\n").footing.pad.match_restitution);
    EXPECT_TRUE(read("base={bedding='flat'}\nrestitution=0.8\n").footing.pad.match_restitution);
    EXPECT_TRUE(read("pad={vertical_frequency='67 Hz'}\n").footing.pad.match_restitution);
    auto const yields = read("base={shape='round'}\npad={strength='30 MPa'}\n").footing;
    EXPECT_EQ(yields.base.points, 64);
    auto const finer = read("base={shape='round', points=128}\npad={strength='30 MPa'}\n").footing;
    EXPECT_EQ(finer.base.points, 128);
    EXPECT_EQ(finer.matched->restitution, yields.matched->restitution) << "a plane takes 64 at most";
    EXPECT_FALSE(yields.pad.match_restitution) << "a rim keeps its own where the pad yields under it";
    EXPECT_TRUE(
        read("restitution=0.72\nbase={shape='round'}\npad={strength='30 MPa'}\n").footing.pad.match_restitution);
    EXPECT_FALSE(read("base={shape='round', points=64}\n").footing.pad.match_restitution) << "nor do its samples";
    EXPECT_TRUE(read("restitution=0.8\nbase={shape='round', points=64}\n").footing.pad.match_restitution);
}

//
TEST(Footing, GoesWithTheSimilarityLaw) {
    auto const footing = read(
                             "pad={vertical_frequency='67 Hz', strength='30 MPa'}\n"
                             "base={shape='polygon', corners=[[0.68,0.68],[-0.68,0.68],[-0.68,-0.68],[0.68,-0.68]]}\n"
                             "inertia_z='4 t m2'\nsimilarity={direction='to-model'}\n")
                             .footing;
    EXPECT_NEAR(footing.pad.vertical_frequency_hz, 67 / std::sqrt(0.4), 1e-12);
    EXPECT_NEAR(read("base={shape='round', bedding='flat', inner_diameter='1 m'}\nsimilarity={direction='to-model'}\n")
                    .footing.base.inner_radius_m,
                0.2, 1e-15);
    EXPECT_EQ(footing.pad.strength_pa, 30e6);
    EXPECT_NEAR(footing.base.corners_m[0][0], 0.272, 1e-15);
    EXPECT_NEAR(*footing.inertia_vertical_kgm2, 4e3 * 1.43 * std::pow(0.4, 5), 1e-10);
}

TEST(Footing, WhatCannotStandIsRefusedAtItsKey) {
    auto const refused = [](std::string const& more, auto... parts) {
        testing::expect_input_error([&] { (void)read(more); }, "body.toml:5:", parts...);
    };
    refused("base={bedding=0}\n", "bedding");
    refused("base={bedding=0.05}\n", "share");
    refused("base={bedding='soft'}\n", "soft", "corners");
    refused("base={shape='oval'}\n", "oval", "round");
    refused("base={points=1}\n", "points");
    refused("base={points=42}\n", "points", "2 to 41");
    refused("base={shape='round', points=12}\n", "16 to 256");
    refused("base={shape='round', bedding=0.5}\n", "bedding", "rim (corners) or evenly (flat)");
    refused("base={shape='round', bedding='flat', points=32}\n", "points", "without points");
    refused("base={shape='round', inner_diameter='1 m'}\n", "inner_diameter", "bedding = \"flat\"");
    refused("base={bedding='flat', inner_diameter='1 m'}\n", "inner_diameter", "only a round base");
    refused("base={shape='round', bedding='flat', inner_diameter='1.36 m'}\n", "nothing is left that bears");
    refused("base={shape='round', bedding='flat'}\npad={strength='30 MPa'}\n", "disc or ring", "strength",
            "flat square base");
    refused("base={shape='polygon', bedding='flat', corners=[[0.68,0.68],[-0.68,0.68],[-0.68,-0.68],[0.68,-0.68]]}\n",
            "bedding", "polygon");
    refused("base={shape='round', points=18}\n", "multiple of 4");
    refused("base={shape='round', points=260}\n", "2 to 256");
    refused("base={width=3}\n", "width");
    refused("base={shape='polygon'}\n", "corners");
    refused("base={shape='polygon', corners=[[0.68,0.68],[-0.68,0.68]]}\n", "2 corners");
    testing::expect_input_error(
        [&] { (void)read("base={shape='polygon', corners=[[0.7,0.7],[-0.7,0.7],[-0.7,-0.7],[0.7,-0.7]]}\n"); },
        "body.toml:2:", "base_width", "0.7 m");
    refused("pad={strength='0 MPa'}\n", "strength");
    refused("pad={strength='30 kg'}\n", "MPa");
    refused("pad={strength=30}\n", "weight", "30 MPa");
    refused("pad={vertical_frequency='1 Hz'}\n", "so slender a body upright");
    refused("pad={vertical_frequency='1.2 Hz'}\n", "pad", "upright");
    refused("restitution=0.5\nbase={shape='polygon', corners=[[0.68,0.68],[-0.68,0.68],[-0.68,-0.68],[0.68,-0.68]]}\n",
            "polygon", "normal_restitution");
    refused("pad={normal_restitution=0}\n", "normal_restitution");
    refused("pad={vertical_frequency=1e6}\n", "vertical_frequency", "10000");
    refused("pad={tangential_damping=1e9}\n", "tangential_damping", "100");
    refused("restitution=0.3\npad={strength='30 MPa'}\n", "restitution", "0.5687");
    EXPECT_NO_THROW((void)read("restitution=0.3\n")) << "nobody asked for a pad";
    EXPECT_NO_THROW((void)read("pad={strength='30 MPa'}\n")) << "Housner's is met as nearly as can be";
}

}  // namespace
}  // namespace overturn
