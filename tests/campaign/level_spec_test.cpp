// Requirement R-204: levels are a list or a range in the measure's unit, rising, named where they are special, none
// twice.
#include "campaign/level_spec.hpp"

#include "campaign/rows.hpp"
#include "support/expect_input_error.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::near;

LevelSpec levels_of(std::string const& keys) { return read_levels(config::Table::parse(keys, "c.toml")); }

void refuse(std::string const& keys, std::string const& part) {
    testing::expect_input_error([&] { (void)levels_of(keys); }, "c.toml:", part);
}

std::vector<double> values_of(LevelSpec const& spec) {
    std::vector<double> values;
    for (auto const& level : spec.levels) {
        values.push_back(level.value);
    }
    return values;
}

TEST(Levels, AListInAnyOrderAndUnit) {
    auto const spec = levels_of("measure='pga'\nvalues=['0.5 g','200 gal',3]\n");

    EXPECT_EQ(values_of(spec), (std::vector{2.0, 3.0, 0.5 * g0}));
    EXPECT_EQ(spec.units(), "m/s2");
    EXPECT_FALSE(spec.independent_waves);
    EXPECT_EQ(values_of(levels_of("measure='pgv'\nvalues=['50 kine']\n")), std::vector{0.5});
    EXPECT_EQ(levels_of("measure='factor'\nvalues=[1]\nwaves='independent'\n").units(), "1");
}

// what people read is in the unit that they wrote.
TEST(Levels, AreShownAsTheyWereWritten) {
    auto const text_of = [](std::string const& keys) {
        auto const spec = levels_of(keys);
        return spec.text(spec.levels.back().value);
    };
    EXPECT_EQ(text_of("measure='pga'\nvalues=['200 gal', '600 gal']\n"), "600 gal");
    EXPECT_EQ(text_of("measure='pga'\nvalues={from='0.1 g', to='0.5 g', count=3}\n"), "0.5 g");
    EXPECT_EQ(text_of("measure='pgv'\nvalues=[1]\ndesign_basis='50 kine'\n"), "100 kine");
    EXPECT_EQ(text_of("measure='pga'\nvalues=[2, 6]\n"), "6 m/s2");
    EXPECT_EQ(text_of("measure='factor'\nvalues=[2]\n"), "2");
}

TEST(Levels, MayBeThatOfBothComponentsTogether) {
    auto const spec = levels_of("measure='vector-pga'\nvalues=['300 gal']\n");
    EXPECT_EQ(spec.scale(spec.levels[0], {.pga_mps2 = 1, .vector_pga_mps2 = 1.5}), 2);
    EXPECT_EQ(spec.units(), "m/s2");
    EXPECT_EQ(spec.measure_name(), "vector_pga") << "one name, whether levels or curves are by it";
}

TEST(Levels, ARangeHasEqualStepsOrRatios) {
    auto const linear = levels_of("measure='pga'\nvalues={from='300 gal',to='1500 gal',count=13}\n");
    auto const log = levels_of("measure='pga'\nvalues={from=1,to=8,count=4,spacing='log'}\n");
    auto const single = levels_of("measure='pga'\nvalues={from=1,to=1,count=1}\n");

    ASSERT_EQ(linear.levels.size(), 13U);
    for (std::size_t i = 0; i < 13; ++i) {
        EXPECT_TRUE(near(linear.levels[i].value, 3 + static_cast<double>(i), testing::rounding));
    }
    EXPECT_EQ(linear.levels.back().value, 15);
    ASSERT_EQ(log.levels.size(), 4U);
    EXPECT_TRUE(near(log.levels[1].value, 2, testing::rounding));
    EXPECT_EQ(log.levels[3].value, 8);
    EXPECT_EQ(values_of(single), std::vector{1.0});
}

TEST(Levels, NamedOnesAreRecognisedOrAdded) {
    auto const recognised =
        levels_of("measure='pga'\nvalues={from='300 gal',to='900 gal',count=7}\ndesign_basis='600 gal'\n");
    auto const added = levels_of("measure='pga'\nvalues=[3,9]\ndesign_basis=6\nbeyond_design=[9,12]\n");

    ASSERT_EQ(recognised.levels.size(), 7U);
    EXPECT_EQ(recognised.levels[3].purpose, LevelClass::design_basis);
    EXPECT_EQ(values_of(added), (std::vector{3.0, 6.0, 9.0, 12.0}));
    EXPECT_EQ(values_of(levels_of("measure='pga'\ndesign_basis='600 gal'\n")), std::vector{6.0});
    refuse("measure='pga'\n", "values: missing");
    EXPECT_EQ(added.levels[0].purpose, LevelClass::ordinary);
    EXPECT_EQ(added.levels[1].purpose, LevelClass::design_basis);
    EXPECT_EQ(added.levels[2].purpose, LevelClass::beyond_design);
    EXPECT_EQ(added.levels[3].purpose, LevelClass::beyond_design);
}

TEST(Levels, ScaleBringsTheWaveToTheLevel) {
    WaveRow wave;
    wave.pga_mps2 = 2;
    wave.pgv_mps = 0.5;
    wave.pgd_m = 0.1;
    auto const scale = [&](char const* measure) {
        auto const spec = levels_of(fmt::format("measure='{}'\nvalues=[3]\n", measure));
        return spec.scale(spec.levels[0], wave);
    };

    EXPECT_EQ(scale("pga"), 1.5);
    EXPECT_EQ(scale("pgv"), 6);
    EXPECT_EQ(scale("pgd"), 3 / 0.1);
    EXPECT_EQ(scale("factor"), 3);
    auto const spec = levels_of("measure='pga'\nvalues=[3]\n");
    EXPECT_FALSE(spec.scale(spec.levels[0], {}));
}

TEST(Levels, RefusesNonsense) {
    refuse("measure='pga'\nvalues=[3,4,3]\n", "3 m/s2 twice");
    refuse("measure='pga'\nvalues=[3,'300 gal']\n", "300 gal twice");
    refuse("measure='pga'\nvalues=[]\n", "no level");
    refuse("measure='pga'\nvalues=[0]\n", "values: 0 m/s2");
    refuse("measure='pga'\nvalues=['3 kine']\n", "kine");
    refuse("measure='pgx'\nvalues=[1]\n", "Did you mean 'pga'?");
    refuse("measure='pga'\nvalues={from=1,to=8,count=1}\n", "1 level between two");
    refuse("measure='pga'\nvalues={from=3,to=1,count=4}\n", "Swap them");
    refuse("measure='pga'\nvalues={from=1,to=3,count=4,step=1}\n", "step");
    refuse("measure='pga'\nvalues=[1]\ndesing_basis=2\n", "Did you mean 'design_basis'?");
    refuse("measure='pga'\nvalues=[1]\ndesign_basis=2\nbeyond_design=[2]\n", "2 m/s2 (not above design_basis 2 m/s2)");
}

}  // namespace
}  // namespace overturn
