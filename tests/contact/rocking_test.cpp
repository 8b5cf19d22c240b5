// Requirement R-602: a body on a compliant base tips, rocks and loses energy as the rigid one does in the limit of
// stiff corners, and departs from it by what compliance makes of it.
#include <cmath>

#include <gtest/gtest.h>

#include "contact/cases.hpp"
#include "contact/matching.hpp"
#include "support/sliding_blocks.hpp"

namespace overturn {
namespace {

using testing::body_a;
using testing::body_b;
using testing::ContactHistory;
using testing::flat_bed;
using testing::on_corners;
using testing::shaken;

// Raised slowly to a level that is then held: does it fall?
bool tips(ContactBlock const& block, double level_mps2) {
    constexpr double step_s = 0.01;
    constexpr std::size_t rise = 4000;
    std::vector<double> wave(rise + 1000, level_mps2);
    for (std::size_t i = 0; i < rise; ++i) {
        double const share = static_cast<double>(i) / rise;
        wave[i] = level_mps2 * share * share * (3 - 2 * share);
    }
    return shaken(block, wave, step_s, {.longest_after_s = 0}).verdict == Verdict::overturned;
}

double tipping_level(ContactBlock const& block) {
    double low = 0.6 * g0;
    double high = 0.66 * g0;
    while (high - low > 2e-6 * g0) {
        double const level = (low + high) / 2;
        (tips(block, level) ? high : low) = level;
    }
    return high / g0;
}

// Its corners give way, so its centre of gravity moves towards the edge; stiffer ones less.
TEST(ContactRocking, CornersTipAtTheStaticThreshold) {
    struct Case {
        double frequency_hz, level;
    };
    for (auto const& [frequency, level] : {Case{49, 0.650473}, {98, 0.650661}, {400, 0.650715}}) {
        auto const reached = tipping_level(on_corners(body_a(), 0.8, {.vertical_frequency_hz = frequency}));
        EXPECT_NEAR(reached, level, 1e-4) << frequency;
        RecordProperty("level", std::to_string(reached));
    }
}

// The static pivot of a flat bed lies inboard until only the corner's point bears: it carries the weight g / (w_v^2
// k/K) deep, and its neighbour parts at the lean s of that depth over their distance. There the push that the body
// withstands is largest: tan(alpha - lean).
TEST(ContactRocking, AFlatBedTipsEarlier) {
    for (double const frequency : {98, 400}) {
        auto const block =
            contact_block(body_a(), flat_bed(), {.vertical_frequency_hz = frequency}, Friction{0.8, 0.8});
        double const depth = block.settlement_m() / block.points.front().stiffness_share;
        double const lean = std::asin(depth / (block.points[1].offset_m - block.points[0].offset_m));
        EXPECT_NEAR(tipping_level(block), std::tan(body_a().alpha_rad() - lean), 1e-4) << frequency;
    }
    EXPECT_NEAR(tipping_level(contact_block(body_a(), flat_bed(), {.vertical_frequency_hz = 400}, Friction{0.8, 0.8})),
                0.65026, 1e-3);
}

// Of the rigid body from this angle: int d theta / theta', by Gauss's rule for the square root's end.
double rigid_quarter_s(RigidBody const& body, double rotation_rad) {
    double const alpha = body.alpha_rad();
    constexpr int steps = 2000;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {  // theta = theta0 (1 - u^2), midpoint rule in u
        auto const at = [&](double u) {
            double const theta = rotation_rad * (1 - u * u);
            double const fallen = rotation_rad - theta;
            double const gain = 2 * std::sin(alpha - (theta + rotation_rad) / 2) * std::sin(fallen / 2);  // cos - cos
            return 2 * rotation_rad * u / (body.p_radps() * std::sqrt(2 * gain));
        };
        double const left = static_cast<double>(i) / steps;
        double const node = 0.5 / std::sqrt(3.0) / steps;
        double const middle = left + 0.5 / steps;
        sum += (at(middle - node) + at(middle + node)) / (2 * steps);
    }
    return sum;
}

double quarter_s(RigidBody const& body, double frequency_hz) {
    auto const block = on_corners(body, firm_grip, {.vertical_frequency_hz = frequency_hz});
    ContactHistory history;
    static_cast<void>(shaken(block, testing::constant(0, 2), 0.5, {.step_ratio = 0.03}, &history,
                             leaning_start(block, 0.3 * body.alpha_rad())));
    return history.zero_of(&ContactInstant::rotation_rad, &ContactInstant::velocity_radps);
}

// Softness shortens free rocking, a quarter as much per doubling of the frequency.
TEST(ContactRocking, QuarterPeriodNearsTheRigidOne) {
    for (auto const& [body, rigid, at_98] :
         {std::tuple{body_a(), 0.3746117, -5.06e-5}, {body_b(), 0.3550159, -6.03e-5}}) {
        double const reference = rigid_quarter_s(body, 0.3 * body.alpha_rad());
        EXPECT_NEAR(reference, rigid, 5e-8);
        for (double const doublings : {-1, 0, 1, 3}) {
            double const deviation = quarter_s(body, 98 * std::exp2(doublings)) / reference - 1;
            double const expected = at_98 * std::exp2(-2 * doublings);
            EXPECT_NEAR(deviation / expected, 1, 0.02) << doublings << " " << deviation;
        }
    }
}

//
TEST(ContactRocking, RestitutionEmergesFromTheBase) {
    EXPECT_NEAR(emergent_restitution(body_a(), {}, {}), 0.5964, 0.003);
    EXPECT_NEAR(emergent_restitution(body_b(), {}, {}), 0.7701, 0.003);
}

// whichever corner parts from the ground first, it is noticed at the same instant.
TEST(ContactRocking, UpliftIsSeenAtEitherCorner) {
    std::vector<double> ramp;
    for (int i = 0; i <= 400; ++i) {
        ramp.push_back(0.02 * i);
    }
    auto const block = on_corners(body_a(), 0.8);
    auto const one = shaken(block, ramp, 0.01);
    auto const other = shaken(block, testing::mirrored(ramp), 0.01);
    double const rigid = 0.5 * body_a().uplift_acceleration_mps2();  // 2 m/s2 a second
    EXPECT_NEAR(one.first_uplift_s, rigid, 0.01 * rigid);
    EXPECT_EQ(one.first_uplift_s, other.first_uplift_s);
}

}  // namespace
}  // namespace overturn
