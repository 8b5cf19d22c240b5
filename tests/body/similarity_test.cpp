// Requirement R-303: model and prototype rock by the similarity law, and scaling forth and back changes
// nothing.
#include "body/similarity.hpp"

#include "support/expect_input_error.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::exact_formula;
using testing::expect_input_error;
using testing::near;
using testing::rounding;

BodyInput const prototype{
    .mass_kg = 138e3, .half_width_m = 1.7, .centre_height_m = 2.61, .inertia_kgm2 = 4e5, .restitution = 0.8};

TEST(Similarity, TableFollowsFromItsOwnFactors) {
    SimilarityLaw const law;
    EXPECT_NEAR(law.mass(), 0.0915, 5e-5);
    EXPECT_NEAR(law.inertia(), 0.0146, 5e-5);
    EXPECT_NEAR(law.stiffness(), 0.220, 5e-4);
    EXPECT_NEAR(law.force(), 0.0897, 5e-5);
    EXPECT_NEAR(law.time(), 0.632, 5e-4);
    EXPECT_EQ(law.velocity(), law.time());
    EXPECT_TRUE(near(law.frequency() * law.time(), 1, rounding));
    for (double const one : {law.acceleration(), law.angle(), law.friction()}) {
        EXPECT_EQ(one, 1);
    }
}

TEST(Similarity, RatiosAgreeWithEachOther) {
    SimilarityLaw const law{.length = 0.3, .mass_factor = 1.2, .stiffness_factor = 0.7};
    EXPECT_TRUE(near(law.velocity() / law.time(), law.acceleration(), exact_formula));
    EXPECT_TRUE(near(law.velocity() * law.time(), law.length, exact_formula));
    EXPECT_TRUE(near(law.mass() * law.length * law.length, law.inertia(), exact_formula));
    EXPECT_TRUE(near(law.force(), law.velocity() * std::sqrt(law.mass() * law.stiffness()), exact_formula));
}

TEST(Similarity, ForthAndBackChangesNothing) {
    SimilarityLaw const law;
    auto const back = prototype_of(model_of(prototype, law), law);

    EXPECT_TRUE(near(back.mass_kg, prototype.mass_kg, rounding));
    EXPECT_TRUE(near(back.half_width_m, prototype.half_width_m, rounding));
    EXPECT_TRUE(near(back.centre_height_m, prototype.centre_height_m, rounding));
    EXPECT_TRUE(near(back.inertia_kgm2, prototype.inertia_kgm2, rounding));
    EXPECT_EQ(back.restitution, prototype.restitution);
    EXPECT_EQ(back.gravity_mps2, prototype.gravity_mps2);
}

TEST(Similarity, ModelRocksAsThePrototypeDoes) {
    SimilarityLaw const law;
    RigidBody const large(prototype);
    RigidBody const small(model_of(prototype, law));

    EXPECT_TRUE(near(small.alpha_rad(), large.alpha_rad(), exact_formula));
    EXPECT_TRUE(near(small.housner_restitution(), large.housner_restitution(), exact_formula));
    EXPECT_TRUE(near(small.p_radps(), large.p_radps() * law.frequency(), exact_formula));
    EXPECT_TRUE(near(small.limit_velocity_mps(), large.limit_velocity_mps() * law.velocity(), exact_formula));
    EXPECT_TRUE(near(small.uplift_acceleration_mps2(), large.uplift_acceleration_mps2(), exact_formula));
    EXPECT_NEAR(small.limit_velocity_mps(), 1.99, 0.005);  // type A
    EXPECT_NEAR(small.mass_kg(), 12.6e3, 0.05e3);
}

TEST(Similarity, RatiosThatAreNonePositiveAreRefused) {
    for (double const wrong : {0.0, -0.4, std::nan("")}) {
        expect_input_error([&] { (void)model_of(prototype, {.length = wrong}); }, "length ratio");
        expect_input_error([&] { (void)prototype_of(prototype, {.mass_factor = wrong}); }, "mass factor");
    }
}

}  // namespace
}  // namespace overturn
