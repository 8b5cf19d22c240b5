// Requirement R-304: what is not known about a body scatters as stated, by wave and body alone, the same at every
// level.
#include "campaign/scatter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "campaign/block_rows.hpp"
#include "campaign/body_spec.hpp"
#include "campaign/plan.hpp"
#include "campaign/trial.hpp"
#include "support/campaigns.hpp"
#include "support/expect_input_error.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::near;
constexpr auto exact = testing::exact_formula;

std::string const block = "base_width='1.36 m'\ninertia=6000\n";
std::string const certain = block + "mass='12.6 t'\ncentre_height='1.045 m'\n";

BodySpec body_of(std::string const& keys, std::map<std::string, std::string> contents = {}) {
    InputFiles files(std::move(contents));
    return read_body(config::Table::parse(keys, "b.toml"), files);
}

void refuse(std::string const& keys, std::string const& part) {
    testing::expect_input_error([&] { (void)body_of(keys); }, "b.toml:", part);
}

TEST(BodyScatter, IsAPureFunctionOfSeedWaveAndBody) {
    auto const spec = body_of(certain + "restitution={distribution='lognormal',median=0.8,beta=0.1}\n");
    auto const drawn = [&](std::uint64_t seed, std::uint64_t wave, std::uint64_t index) {
        return spec.for_wave({.seed = seed, .wave = wave}, index).body.restitution();
    };

    EXPECT_EQ(drawn(1, 17, 0), drawn(1, 17, 0));
    EXPECT_NE(drawn(1, 17, 0), drawn(2, 17, 0));
    EXPECT_NE(drawn(1, 17, 0), drawn(1, 18, 0));
    EXPECT_NE(drawn(1, 17, 0), drawn(1, 17, 1));
    EXPECT_EQ(spec.body.restitution(), 0.8);
}

// Closed form: cut off at e = 1, where P(z > 2.23) = 0.0129, quantile q of the rest is quantile 0.9871 q of the whole.
TEST(BodyScatter, OfRestitutionNeverGivesEnergy) {
    auto const spec = body_of(certain + "restitution={distribution='lognormal',median=0.8,beta=0.1}\n");
    constexpr std::size_t count = 20001;
    std::vector<double> drawn;
    for (std::size_t wave = 0; wave < count; ++wave) {
        drawn.push_back(spec.for_wave({.seed = 2013, .wave = wave}, 0).body.restitution());
    }
    std::sort(drawn.begin(), drawn.end());

    EXPECT_LE(drawn.back(), 1);
    EXPECT_NEAR(drawn[count / 2], 0.8 * std::exp(0.1 * -0.01613), 0.003);
    EXPECT_NEAR(drawn[count / 20], 0.8 * std::exp(0.1 * -1.6512), 0.004);
}

TEST(BodyScatter, OfZeroIsTheStatedBody) {
    auto const exact = body_of(certain + "restitution=0.8\nfriction=0.5\n");
    auto const fixed = body_of(block
                               + "mass={distribution='fixed',value='12.6 t'}\n"
                                 "centre_height={distribution='normal',mean='1.045 m',deviation='0 m'}\n"
                                 "restitution={distribution='lognormal',median=0.8,beta=0}\n"
                                 "friction={distribution='uniform',low=0.5,high=0.5}\n");
    auto const one = exact.for_wave({.seed = 1, .wave = 2}, 3);
    auto const other = fixed.for_wave({.seed = 1, .wave = 2}, 3);

    EXPECT_EQ(one.body.p_radps(), other.body.p_radps());
    EXPECT_EQ(one.body.alpha_rad(), other.body.alpha_rad());
    EXPECT_EQ(one.body.restitution(), other.body.restitution());
    EXPECT_EQ(one.friction->static_coefficient, other.friction->static_coefficient);
    EXPECT_EQ(one.body.mass_kg(), other.body.mass_kg());
}

// Of what scatters the centre's height alone turns alpha.
TEST(BodyScatter, AlphaIsDrawnWhereTheCentreIs) {
    auto const uniform = [](char const* key, std::string const& ends) {
        return fmt::format("{}={{distribution='uniform',{}}}\n", key, ends);
    };
    EXPECT_FALSE(body_of(certain).draws_alpha());
    EXPECT_FALSE(body_of(block + "centre_height='1 m'\n" + uniform("mass", "low='12 t',high='13 t'")).draws_alpha());
    EXPECT_FALSE(body_of(certain + uniform("restitution", "low=0.7,high=0.9")).draws_alpha());
    EXPECT_TRUE(body_of(block + "mass='12 t'\n" + uniform("centre_height", "low='1 m',high='1.1 m'")).draws_alpha());
}

TEST(BodyScatter, MassKeepsTheRadiusOfGyrationAndFrictionItsRatio) {
    auto const spec = body_of(block
                              + "mass={distribution='normal',mean='12 t',deviation='1 t'}\n"
                                "centre_height={distribution='uniform',low='1 m',high='1.1 m'}\n"
                                "friction={static={distribution='uniform',low=0.3,high=0.7},kinetic_ratio=0.9}\n");
    double lowest = 1;
    double highest = 0;
    for (std::uint64_t wave = 0; wave < 1000; ++wave) {
        auto const [body, friction] = spec.for_wave({.seed = 5, .wave = wave}, 0);
        EXPECT_TRUE(near(body.inertia_kgm2() / body.mass_kg(), 6000.0 / 12000, testing::exact_formula));
        EXPECT_NE(body.mass_kg(), 12000);
        EXPECT_GE(body.centre_height_m(), 1);
        EXPECT_LE(body.centre_height_m(), 1.1);
        EXPECT_TRUE(near(friction->kinetic_coefficient, 0.9 * friction->static_coefficient, testing::exact_formula));
        lowest = std::min(lowest, friction->static_coefficient);
        highest = std::max(highest, friction->static_coefficient);
    }
    EXPECT_LT(lowest, 0.305);
    EXPECT_GT(highest, 0.695);
}

// A drawn prototype goes through the similarity law like a stated one.
TEST(BodyScatter, IsScaledWithTheBody) {
    auto const prototype = "base_width='3.4 m'\ninertia='200000 kg m2'\nmass='138 t'\n";
    auto const model = std::string("similarity={direction='to-model'}\n");
    auto const scatter = std::string("centre_height={distribution='uniform',low='2.5 m',high='2.7 m'}\n");
    DrawnFor const wave{.seed = 3, .wave = 8};

    auto const full = body_of(prototype + scatter).for_wave(wave, 0).body;
    auto const small = body_of(prototype + scatter + model).for_wave(wave, 0).body;

    EXPECT_TRUE(near(small.centre_height_m(), 0.4 * full.centre_height_m(), testing::exact_formula));
}

TEST(BodyScatter, BesideAFileOrPartsOutranksThem) {
    auto const beside = std::string(
        "centre_height={distribution='fixed',value=1.2}\n"
        "mass={distribution='fixed',value='6.3 t'}\n");
    auto const of_file = body_of("file='x.toml'\n" + beside, {{"x.toml", certain}});
    EXPECT_EQ(of_file.body.centre_height_m(), 1.2);
    EXPECT_EQ(of_file.body.mass_kg(), 6300);
    EXPECT_EQ(of_file.body.inertia_kgm2(), 3000);

    auto const of_parts = body_of("base_width=1\n" + beside + "[[parts]]\nkind='box'\nmass=10\nwidth=1\nheight=2\n");
    EXPECT_EQ(of_parts.body.centre_height_m(), 1.2);
    EXPECT_EQ(of_parts.body.mass_kg(), 6300);
}

// Property: one draw lies in each of n equally likely slices, and another seed orders them otherwise.
TEST(BodyScatter, LatinHypercubeFillsEverySliceOnce) {
    constexpr std::uint64_t count = 50;
    auto const slices = [&](std::uint64_t seed, Purpose purpose) {
        std::vector<std::uint64_t> taken;
        for (std::uint64_t place = 0; place < count; ++place) {
            DrawnFor const wave{seed, place, Sampling::latin_hypercube, place, count, 0};
            taken.push_back(static_cast<std::uint64_t>(uniform_for(wave, purpose, 0) * count));
        }
        return taken;
    };
    auto order = slices(1, Purpose::body_scatter);
    EXPECT_NE(order, slices(2, Purpose::body_scatter));
    EXPECT_NE(order, slices(1, Purpose::friction_scatter));
    std::sort(order.begin(), order.end());
    for (std::uint64_t i = 0; i < count; ++i) {
        EXPECT_EQ(order[i], i);
    }
}

// Property: slicing takes the scatter out of a mean of something near linear (here by far more than tenfold).
TEST(BodyScatter, LatinHypercubeSteadiesTheMean) {
    constexpr std::uint64_t count = 64;
    auto const spread = [&](Sampling sampling) {
        double sum = 0;
        for (std::uint64_t seed = 0; seed < 100; ++seed) {
            double mean = 0;
            for (std::uint64_t place = 0; place < count; ++place) {
                mean += uniform_for({seed, place, sampling, place, count, 0}, Purpose::body_scatter, 0) / count;
            }
            sum += (mean - 0.5) * (mean - 0.5);
        }
        return std::sqrt(sum / 100);
    };
    EXPECT_NEAR(spread(Sampling::independent), 1 / std::sqrt(12.0 * count), 0.01);
    EXPECT_LT(spread(Sampling::latin_hypercube), 0.1 * spread(Sampling::independent));
    // Closed form: one uniform draw within each slice of 1 / n leaves the mean 1 / (sqrt(12 n) n); 100 means, so 7 %.
    EXPECT_NEAR(spread(Sampling::latin_hypercube), 1 / (std::sqrt(12.0 * count) * count), 0.25 / (28 * 64));
}

// Property: whatever the quantity, its score states how far out the draw lies in standard deviations, at any scale.
TEST(BodyScatter, ScoresAreStandardNormal) {
    auto const spec = body_of(
        "base_width='3.4 m'\ninertia='200000 kg m2'\nsimilarity={direction='to-model'}\n"
        "mass={distribution='lognormal',median='138 t',beta=0.05}\n"
        "centre_height={distribution='uniform',low='2.5 m',high='2.7 m'}\n"
        "restitution={distribution='normal',mean=0.6,deviation=0.2}\nfriction=0.5\n");
    EXPECT_EQ(spec.scattering(), (std::vector<std::string>{"mass", "centre_height", "restitution"}));
    constexpr int count = 4000;
    std::array<double, 3> sum{};
    std::array<double, 3> squares{};
    for (std::uint64_t wave = 0; wave < count; ++wave) {
        auto const scores = spec.scores(spec.for_wave({.seed = 9, .wave = wave}, 0));
        ASSERT_EQ(scores.size(), 3U);
        auto const again = spec.scores(spec.at_scores(scores));
        for (std::size_t k = 0; k < scores.size(); ++k) {
            EXPECT_NEAR(again[k], scores[k], 1e-9) << "the draw of these scores has other ones";
        }
        for (std::size_t k = 0; k < 3; ++k) {
            sum.at(k) += scores[k] / count;
            squares.at(k) += scores[k] * scores[k] / count;
        }
    }
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(sum.at(k), 0, 4 / std::sqrt(count)) << k;
        EXPECT_NEAR(squares.at(k), 1, 4 * std::sqrt(2.0 / count)) << k;
    }
}

// Closed form: a uniform quantity is its own stream's number, stretched; so that no two quantities share a stream.
TEST(BodyScatter, EveryQuantityHasAStreamOfItsOwn) {
    auto const spec = body_of(block
                              + "mass={distribution='uniform',low='10 t',high='14 t'}\n"
                                "centre_height={distribution='uniform',low='1 m',high='1.1 m'}\n"
                                "restitution={distribution='uniform',low=0.4,high=0.8}\n"
                                "friction={distribution='uniform',low=0.3,high=0.7}\n");
    for (std::uint64_t const index : {0U, 3U}) {
        for (std::uint64_t wave = 0; wave < 20; ++wave) {
            DrawnFor const drawn_for{.seed = 5, .wave = wave};
            auto const share = [&](Purpose purpose, std::uint64_t at) { return uniform_for(drawn_for, purpose, at); };
            auto const [body, friction] = spec.for_wave(drawn_for, index);

            EXPECT_TRUE(near(body.mass_kg(), 10e3 + 4e3 * share(Purpose::body_scatter, 2 * index), exact));
            EXPECT_TRUE(near(body.centre_height_m(), 1 + 0.1 * share(Purpose::body_scatter, 2 * index + 1), exact));
            EXPECT_TRUE(near(body.restitution(), 0.4 + 0.4 * share(Purpose::restitution_scatter, index), exact));
            EXPECT_TRUE(near(friction->static_coefficient, 0.3 + 0.4 * share(Purpose::friction_scatter, index), exact));
        }
    }
}

TEST(BodyScatter, IsStoredWithEveryTrial) {
    auto const spec = testing::campaign_from(
        "[waves]\nsource='harmonic'\namplitude=1\nfrequency=['1 Hz','2 Hz']\ncycles=2\n"
        "[[bodies]]\n"
        + certain
        + "friction={distribution='uniform',low=0.3,high=0.7}\n"
          "restitution={distribution='normal',mean=0.8,deviation=0.1}\n"
          "[scatter]\nsampling='latin-hypercube'\n[levels]\nmeasure='pga'\nvalues=[1,9]\n");
    Plan const plan(spec);
    PhaseSeconds seconds;
    auto const rows = run_block(spec, plan, 0, seconds).trials.rows;
    ASSERT_FALSE(rows.empty());
    auto const drawn = spec.bodies[0].for_wave(plan.drawn_for(spec, 0), 0);
    for (auto const& row : rows) {
        EXPECT_EQ(row.mass_kg, 12600);
        EXPECT_EQ(row.centre_height_m, 1.045);
        EXPECT_EQ(row.restitution, drawn.body.restitution());
        EXPECT_EQ(row.static_friction, drawn.friction->static_coefficient);
        EXPECT_EQ(row.kinetic_friction, drawn.friction->kinetic_coefficient);
    }
}

TEST(BodyScatter, RefusesNonsense) {
    refuse(certain + "restitution={distribution='lognormal',median=0.8,bet=0.1}\n", "Did you mean 'beta'");
    refuse(certain + "restitution={distribution='weibull'}\n", "weibull");
    refuse(certain + "restitution={distribution='normal',mean=1.3,deviation=0.1}\n", "mean: 1.3");
    refuse(certain + "restitution={distribution='normal',mean=0.5,deviation=0.1,low=0.9}\n", "of it lies between");
    refuse(certain + "friction={static={distribution='uniform',low=0.3,high=0.4},kinetic=0.3}\n", "kinetic_ratio");
    refuse(certain + "friction={distribution='lognormal',median=0.6,beta=0.4}\n", "Painleve");
    refuse(certain + "friction={static=0.5,kinetic_ratio=1.1}\n", "kinetic_ratio: 1.1");
    refuse(block + "mass='12.6 t'\ncentre_height={distribution='normal',mean='1 m',deviation='1 g'}\n", "unit 'g'");
    refuse("base_width=1.36\ninertia=3000\nmass='12.6 t'\ncentre_height={distribution='normal',mean=1,deviation=0.5}\n",
           "centre_height: Housner");
}

}  // namespace
}  // namespace overturn
