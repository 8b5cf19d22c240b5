// Requirement R-301: parts add up by the parallel-axis theorem, however the body is cut into them.
#include "body/parts.hpp"

#include <vector>

#include "body/similarity.hpp"
#include "support/expect_input_error.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::exact_formula;
using testing::expect_input_error;
using testing::near;

BodyInput assembled(std::vector<BodyPart> const& parts, double base_width_m = 1.0) {
    return assemble(parts, base_width_m);
}

TEST(Parts, OneBoxIsTheUniformRectangle) {
    auto const body = assembled({Box{.mass_kg = 300, .width_m = 1.0, .height_m = 4.0}});

    EXPECT_EQ(body.mass_kg, 300);
    EXPECT_EQ(body.half_width_m, 0.5);
    EXPECT_EQ(body.centre_height_m, 2.0);
    EXPECT_TRUE(near(body.inertia_kgm2, 300 * (0.5 * 0.5 + 2.0 * 2.0) / 3, exact_formula));
    EXPECT_FALSE(body.restitution);
}

TEST(Parts, CuttingABodyChangesNothing) {
    auto const whole_box = assembled({Box{300, 1.0, 4.0, 0.5}});
    auto const cut_box = assembled({Box{100, 1.0, 4.0 / 3, 0.5}, Box{200, 1.0, 8.0 / 3, 0.5 + 4.0 / 3}});
    EXPECT_TRUE(near(cut_box.centre_height_m, whole_box.centre_height_m, exact_formula));
    EXPECT_TRUE(near(cut_box.inertia_kgm2, whole_box.inertia_kgm2, exact_formula));

    auto const whole_cylinder = assembled({Cylinder{600, 0.7, 3.0, 0.2}});
    auto const cut_cylinder = assembled({Cylinder{200, 0.7, 1.0, 0.2}, Cylinder{400, 0.7, 2.0, 1.2}});
    EXPECT_TRUE(near(cut_cylinder.inertia_kgm2, whole_cylinder.inertia_kgm2, exact_formula));
    EXPECT_TRUE(near(whole_cylinder.inertia_kgm2, 600 * (3 * 0.49 + 9) / 12, exact_formula));
}

TEST(Parts, PointMassesHaveArmsOnly) {
    auto const body = assembled({PointMass{1, 0.0}, PointMass{3, 4.0}});

    EXPECT_EQ(body.centre_height_m, 3.0);
    EXPECT_EQ(body.inertia_kgm2, 12.0);
    expect_input_error([] { (void)RigidBody(assembled({PointMass{1, 2.0}})); }, "moment of inertia");
}

/// campaigns/bodies/cask_prototype.toml. Masses and the pallet's plan as published; the cask's sizes and the pallet's
/// thickness are assumed.
BodyInput cask_on_pallet() { return assembled({Cylinder{117e3, 1.25, 5.4, 0.35}, Box{21e3, 3.4, 0.35, 0.0}}, 3.4); }

TEST(Parts, CaskOnPalletHasTheKnownNumbers) {
    RigidBody const prototype(cask_on_pallet());

    EXPECT_NEAR(prototype.mass_kg(), 138e3, 1e-6);
    EXPECT_NEAR(prototype.centre_height_m(), 2.61, 0.005);
    EXPECT_NEAR(prototype.alpha_rad() * 180 / pi, 33.1, 0.05);
    EXPECT_NEAR(prototype.limit_velocity_mps(), 3.15, 0.005);
    EXPECT_NEAR(prototype.uplift_acceleration_mps2(), 6.38, 0.005);
}

/// campaigns/bodies/type_a_model.toml but for its inertia, which is a uniform block's there.
TEST(Parts, ItsModelIsTypeA) {
    RigidBody const model(model_of(cask_on_pallet(), SimilarityLaw{}));

    EXPECT_NEAR(model.mass_kg(), 12.6e3, 50);
    EXPECT_NEAR(2 * model.half_width_m(), 1.36, 1e-12);
    EXPECT_NEAR(model.centre_height_m(), 1.045, 1e-4);
    EXPECT_NEAR(model.limit_velocity_mps(), 1.99, 0.005);
    EXPECT_NEAR(model.uplift_acceleration_mps2(), 6.38, 0.005);
}

TEST(Parts, WrongFiguresAreRefusedWithTheirPart) {
    expect_input_error([] { (void)assembled({}); }, "no part");
    expect_input_error([] { (void)assembled({PointMass{1, 1}}, 0); }, "base width");
    expect_input_error([] { (void)assembled({PointMass{1, 1}, Box{1, 1, -1, 0}}); }, "part 2: height of -1 m");
    expect_input_error([] { (void)assembled({Box{1, 0, 1, 0}}); }, "part 1: width");
    expect_input_error([] { (void)assembled({Cylinder{1, 0, 1, 0}}); }, "part 1: radius");
    expect_input_error([] { (void)assembled({Cylinder{0, 1, 1, 0}}); }, "part 1: mass");
    expect_input_error([] { (void)assembled({Box{1, 1, 1, -0.1}}); }, "part 1: bottom height", "below the base");
}

}  // namespace
}  // namespace overturn
