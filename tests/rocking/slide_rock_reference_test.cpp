// Requirement R-502: slide-rocking agrees with a reference that shares nothing with it: a Runge-Kutta method of order 8
// on the un-mirrored equations, events by bisection, the impact law from its impulses.
#include <array>
#include <cstring>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <gtest/gtest.h>

#include "support/long_period_wave.hpp"
#include "support/sliding_blocks.hpp"

namespace overturn {
namespace {

using State = std::array<double, 4>;  ///< x, v, theta, omega

struct Extremes {
    double rotation = 0, slip = 0, residual = 0;
    std::array<double, 2> reached{};  ///< largest rotation about the corner at +x and at -x
    int impacts = 0, slips = 0, slipping_impacts = 0;
    bool overturned = false;
};

/// The reference. Lengths in metres, forces per mass; `side` is the sign of theta's corner, `way` that of the slip.
class Reference {
  public:
    Reference(RockingBlock const& block, std::vector<double> const& horizontal, std::vector<double> const& vertical,
              double dt, double scale)
        : g_(block.gravity_mps2),
          slope_(block.lopsided ? block.lopsided->slope_rad : 0),
          corners_{corner_of(block, 0), corner_of(block, 1)},
          own_inertia_(corners_[0].own_inertia),
          p_(block.p_radps),
          mu_s_(block.friction_static),
          mu_k_(block.friction_kinetic),
          horizontal_(horizontal),
          vertical_(vertical),
          dt_(dt),
          scale_(scale),
          step_(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, 4)) {
        stand_on(1);
    }
    Reference(Reference const&) = delete;
    Reference& operator=(Reference const&) = delete;
    Reference(Reference&&) = delete;
    Reference& operator=(Reference&&) = delete;
    ~Reference() { gsl_odeiv2_step_free(step_); }

    Extremes run(double tilt = 0) {
        if (tilt != 0) {
            stand_on(tilt < 0 ? -1 : 1);
            mode_ = Mode::rock;
            y_[2] = tilt;
            seen_.rotation = std::abs(tilt);
            seen_.reached[tilt < 0 ? 1 : 0] = std::abs(tilt);
        }
        constexpr int parts = 8;  // steps of a sample: what is shorter than one can be missed, 1 ms of slip
        double const h = dt_ / parts;
        auto const calm = static_cast<std::size_t>(20 / dt_);
        for (std::size_t i = 0; i + 1 < horizontal_.size() + calm && !seen_.overturned; ++i) {
            load(i);
            for (int k = 0; k < parts && !seen_.overturned; ++k) {
                through(k * h, k + 1 == parts ? dt_ : (k + 1) * h);
            }
        }
        seen_.residual = y_[0];
        return seen_;
    }

  private:
    enum class Mode { rest, slide, rock, slip_rock };

    /// In the ground's own frame, on which gravity leans where it is inclined.
    struct Corner {
        double radius, alpha, half_width, height, own_inertia, e;
    };
    static Corner corner_of(RockingBlock const& block, std::size_t which) {
        RockingCorner const alone{block.alpha_rad, block.alpha_rad, block.p_radps, block.restitution,
                                  block.inertia_ratio};
        auto const c = block.lopsided ? block.lopsided->corners.at(which) : alone;
        double const radius = c.inertia_ratio * block.gravity_mps2 / (c.p_radps * c.p_radps);
        return {radius,
                c.base_angle_rad,
                radius * std::sin(c.base_angle_rad),
                radius * std::cos(c.base_angle_rad),
                radius * radius * (1 / c.inertia_ratio - 1),
                c.restitution};
    }
    [[nodiscard]] Corner const& at(double side) const { return corners_[side < 0 ? 1 : 0]; }
    void stand_on(double side) {
        side_ = side;
        auto const& c = at(side);
        radius_ = c.radius;
        alpha_ = c.alpha;
        half_width_ = c.half_width;
        height_ = c.height;
        e_ = c.e;
    }

    void load(std::size_t i) {
        std::size_t const n = horizontal_.size();
        auto const at = [&](std::vector<double> const& wave, std::size_t k) {
            return wave.empty() || i + 1 >= n ? 0.0 : scale_ * wave[k];
        };
        auto const along = [&](double a, double g) { return std::cos(slope_) * a - std::sin(slope_) * g; };
        auto const across = [&](double a, double g) { return std::sin(slope_) * a + std::cos(slope_) * g; };
        double const a = at(horizontal_, i);
        double const b = at(horizontal_, i + 1);
        double const g = g_ + at(vertical_, i);
        double const h = g_ + at(vertical_, i + 1);
        a0_ = along(a, g);
        a_rate_ = (along(b, h) - a0_) / dt_;
        g0_ = across(a, g);
        g_rate_ = (across(b, h) - g0_) / dt_;
    }
    [[nodiscard]] double a(double t) const { return a0_ + a_rate_ * t; }
    [[nodiscard]] double gv(double t) const { return g0_ + g_rate_ * t; }

    struct Forces {
        double rotation, slip, friction, normal;  ///< theta'', x'', F/m, N/m
    };
    [[nodiscard]] Forces forces(double t, State const& y) const {
        double const s = side_;
        double const psi = alpha_ - s * y[2];
        double const sine = std::sin(psi);
        double const cosine = std::cos(psi);
        double const spin = y[3] * y[3];
        if (mode_ == Mode::slide) {
            double const friction = -mu_k_ * way_ * gv(t);
            return {0, friction - a(t), friction, gv(t)};
        }
        if (mode_ == Mode::rock) {
            double const inertia = own_inertia_ + radius_ * radius_;
            double const turn = -radius_ * (s * gv(t) * sine + a(t) * cosine) / inertia;
            return {turn, 0, radius_ * cosine * turn + s * radius_ * sine * spin + a(t),
                    s * radius_ * sine * turn - radius_ * cosine * spin + gv(t)};
        }
        double const lever = s * sine - mu_k_ * way_ * cosine;
        double const turn = -radius_ * lever * (gv(t) - radius_ * cosine * spin)
                            / (own_inertia_ + radius_ * radius_ * s * sine * lever);
        double const normal = s * radius_ * sine * turn - radius_ * cosine * spin + gv(t);
        double const friction = -mu_k_ * way_ * normal;
        return {turn, friction - a(t) - radius_ * cosine * turn - s * radius_ * sine * spin, friction, normal};
    }
    static int rates(double t, double const y[], double f[], void* self) {
        State state{};
        std::memcpy(state.data(), y, sizeof state);
        auto const force = static_cast<Reference*>(self)->forces(t, state);
        f[0] = y[1];
        f[1] = force.slip;
        f[2] = y[3];
        f[3] = force.rotation;
        return GSL_SUCCESS;
    }
    [[nodiscard]] State after(double t, double h) {
        State y = y_;
        if (h <= 0 || mode_ == Mode::rest) {
            return y;
        }
        State error{};
        gsl_odeiv2_system const system{&rates, nullptr, 4, this};
        gsl_odeiv2_step_reset(step_);
        gsl_odeiv2_step_apply(step_, t, h, y.data(), error.data(), nullptr, nullptr, &system);
        if (mode_ == Mode::rock) {
            y[0] = y_[0];
            y[1] = 0;
        }
        return y;
    }

    [[nodiscard]] double tips(double side) const { return at(side).half_width / at(side).height; }
    /// What must stay positive in this mode.
    [[nodiscard]] bool allowed(double t, State const& y) const {
        switch (mode_) {
            case Mode::rest:
                return std::abs(a(t)) <= gv(t) * std::min(mu_s_, tips(a(t) > 0 ? -1 : 1));
            case Mode::slide:
                return way_ * y[1] >= 0;
            case Mode::rock: {
                auto const f = forces(t, y);
                return side_ * y[2] >= 0 && std::abs(f.friction) <= mu_s_ * f.normal && std::abs(y[2]) < 0.5 * pi;
            }
            case Mode::slip_rock:
                return side_ * y[2] >= 0 && way_ * y[1] >= 0 && std::abs(y[2]) < 0.5 * pi;
        }
        return false;
    }

    void through(double t, double end) {
        for (int events = 0; t < end && !seen_.overturned; ++events) {
            ASSERT_LT(events, 10000);
            double good = 0;
            double bad = end - t;
            auto next = after(t, bad);
            if (allowed(end, next)) {
                note(t, bad, next);
                y_ = next;
                return;
            }
            for (int i = 0; i < 80 && bad - good > 1e-17; ++i) {
                double const middle = 0.5 * (good + bad);
                next = after(t, middle);
                (allowed(t + middle, next) ? good : bad) = middle;
            }
            auto const state = after(t, good);
            auto const past = after(t, bad);
            note(t, good, state);
            y_ = state;
            t += bad;
            event(t, past);
        }
    }

    /// Peaks, the rotation's inside the step included.
    void note(double t, double h, State const& next) {
        seen_.slip = std::max(seen_.slip, std::abs(next[0]));
        seen_.rotation = std::max(seen_.rotation, std::abs(next[2]));
        auto& reached = seen_.reached[side_ < 0 ? 1 : 0];
        reached = std::max(reached, std::abs(next[2]));
        if (side_ * y_[3] > 0 && side_ * next[3] < 0) {
            double lo = 0;
            double hi = h;
            for (int i = 0; i < 60; ++i) {
                double const middle = 0.5 * (lo + hi);
                (side_ * after(t, middle)[3] > 0 ? lo : hi) = middle;
            }
            double const turned = std::abs(after(t, lo)[2]);
            seen_.rotation = std::max(seen_.rotation, turned);
            reached = std::max(reached, turned);
        }
    }

    void event(double t, State const& past) {
        switch (mode_) {
            case Mode::rest:
                leave_rest(t);
                return;
            case Mode::slide:
                y_[1] = 0;
                mode_ = Mode::rest;
                if (!allowed(t, y_)) {
                    leave_rest(t);
                }
                return;
            case Mode::rock:
                if (side_ * past[2] < 0) {
                    impact(t);
                } else if (std::abs(past[2]) >= 0.5 * pi) {
                    seen_.overturned = true;
                } else {
                    start_slip(t, past);
                }
                return;
            case Mode::slip_rock:
                if (side_ * past[2] < 0) {
                    impact(t);
                } else if (std::abs(past[2]) >= 0.5 * pi) {
                    seen_.overturned = true;
                } else {
                    y_[1] = 0;
                    mode_ = Mode::rock;
                    auto const f = forces(t, y_);
                    if (std::abs(f.friction) > mu_s_ * f.normal) {
                        start_slip(t, y_);
                    }
                }
                return;
        }
    }

    void leave_rest(double t) {
        if (mu_s_ < tips(a(t) > 0 ? -1 : 1)) {
            mode_ = Mode::slide;
            way_ = a(t) > 0 ? -1 : 1;
            ++seen_.slips;
            return;
        }
        stand_on(a(t) > 0 ? -1 : 1);
        y_[2] = 0;
        y_[3] = 0;
        mode_ = Mode::rock;
        auto const f = forces(t, y_);
        if (std::abs(f.friction) > mu_s_ * f.normal) {
            start_slip(t, y_);
            if (mu_k_ <= half_width_ / height_) {  // too smooth to tip a base that slides flat
                mode_ = Mode::slide;
            }
        }
    }

    void start_slip(double t, State const& y) {
        way_ = forces(t, y).friction > 0 ? -1 : 1;
        mode_ = Mode::slip_rock;
        ++seen_.slips;
    }

    [[nodiscard]] double kinetic(double v, double omega, double half_width) const {
        double const across = v + height_ * omega;
        return 0.5 * (across * across + half_width * half_width * omega * omega + own_inertia_ * omega * omega);
    }
    /// Slip velocity after an impact with restitution e.
    [[nodiscard]] double slip_after(double v, double omega, double e) const {
        double const vertical = (half_width_ + at(-side_).half_width * e) * std::abs(omega);
        double const horizontal = height_ * e * omega - (v + height_ * omega);
        if (std::abs(horizontal) <= mu_s_ * vertical) {
            return 0;
        }
        double const start = v + height_ * omega * (1 - e);
        double const after = start - mu_k_ * (start > 0 ? 1 : -1) * vertical;
        return after * start < 0 ? 0 : after;
    }
    void impact(double t) {
        double const omega = y_[3];
        double e = e_;
        double const before = kinetic(y_[1], omega, half_width_);
        double const other = at(-side_).half_width;
        if (y_[1] != 0 && kinetic(slip_after(y_[1], omega, e), e * omega, other) > before) {
            double lo = 0;
            for (double hi = e; hi - lo > 1e-16;) {
                e = 0.5 * (lo + hi);
                (kinetic(slip_after(y_[1], omega, e), e * omega, other) > before ? hi : lo) = e;
            }
        }
        y_[1] = slip_after(y_[1], omega, e);
        y_[2] = 0;
        y_[3] = e * omega;
        stand_on(-side_);
        ++seen_.impacts;
        mode_ = Mode::rock;
        if (y_[1] != 0) {
            mode_ = Mode::slip_rock;
            way_ = y_[1] > 0 ? 1 : -1;
            ++seen_.slipping_impacts;
        }
        constexpr double still = 1e-12;
        if (std::abs(y_[3]) < still * p_) {
            y_[3] = 0;
            if (std::abs(y_[1]) < still * p_ * radius_) {
                y_[1] = 0;
                mode_ = Mode::rest;
                if (!allowed(t, y_)) {
                    leave_rest(t);
                }
            } else if (mu_k_ > tips(way_)) {
                stand_on(way_);
            } else {
                mode_ = Mode::slide;
            }
        } else if (mode_ == Mode::rock) {
            auto const f = forces(t, y_);
            if (std::abs(f.friction) > mu_s_ * f.normal) {
                start_slip(t, y_);
            }
        }
    }

    double g_, slope_;
    std::array<Corner, 2> corners_;
    double own_inertia_, p_, mu_s_, mu_k_;
    double radius_ = 0, alpha_ = 0, half_width_ = 0, height_ = 0, e_ = 0;  ///< of the corner in hand
    std::vector<double> const& horizontal_;
    std::vector<double> const& vertical_;
    double dt_, scale_;
    gsl_odeiv2_step* step_;
    double a0_ = 0, a_rate_ = 0, g0_ = 0, g_rate_ = 0;
    State y_{};
    Mode mode_ = Mode::rest;
    double side_ = 1, way_ = 1;
    Extremes seen_;
};

struct Case {
    char const* name;
    double friction_over_tips, kinetic_over_static, level, vertical_share;
    int wave;
};

class SlideRock : public ::testing::TestWithParam<Case> {};

TEST_P(SlideRock, AgreesWithAnIndependentIntegration) {
    auto const& c = GetParam();
    double const mu = c.friction_over_tips * testing::type_a_tips;
    auto const block = testing::type_a(mu, c.kinetic_over_static * mu);
    auto const horizontal = testing::short_wave(c.wave);
    auto vertical = c.vertical_share > 0 ? testing::short_wave(c.wave + 50) : std::vector<double>{};
    for (double& value : vertical) {
        value *= c.vertical_share;
    }
    auto shaking = testing::shaking_of(horizontal, 0.02, c.level);
    shaking.vertical_mps2 = vertical;

    auto const out = testing::simulate_slipping(block, shaking);
    auto const reference = Reference(block, horizontal, vertical, 0.02, c.level).run();

    EXPECT_EQ(out.verdict == Verdict::overturned, reference.overturned);
    EXPECT_GT(reference.slips + reference.slipping_impacts, 0);
    EXPECT_GT(reference.rotation, 1e-5);
    EXPECT_GT(reference.impacts, 0);
    EXPECT_NEAR(out.peak_rotation_rad, reference.rotation, 1e-8 * reference.rotation);
    EXPECT_NEAR(out.peak_slip_m, reference.slip, 1e-8 * reference.slip);
    EXPECT_NEAR(out.residual_slip_m, reference.residual, 1e-8 * reference.slip);
    RecordProperty("slips", reference.slips);
    RecordProperty("impacts", reference.impacts);
    RecordProperty("slipping_impacts", reference.slipping_impacts);
}

INSTANTIATE_TEST_SUITE_P(
    Waves, SlideRock,
    ::testing::Values(Case{"near_the_edge", 1.02, 0.9, 9, 0, 1}, Case{"one_friction", 1.01, 1, 9, 0, 0},
                      Case{"stuck_impacts", 1.02, 1, 8, 0.4, 0}, Case{"slipping_impacts", 1.05, 0.85, 8, 0.4, 0},
                      Case{"ten_metres", 1.1, 0.85, 14, 0.4, 0}, Case{"lower_kinetic", 1.05, 0.95, 9, 0, 0}),
    [](auto const& info) { return info.param.name; });

struct Lean {
    char const* name;
    double offset_m, slope_rad, tilt_rad;
    double friction, kinetic_over_static, level, vertical_share;
    int wave;
};

class SlideRockLopsided : public ::testing::TestWithParam<Lean> {};

// an offset, a slope and an initial tilt in every mode, slip included. The reference works in the inclined
// ground's own frame, the program's rocking in that of gravity.
TEST_P(SlideRockLopsided, AgreesWithAnIndependentIntegration) {
    auto const& c = GetParam();
    auto const block = testing::lopsided_a(c.offset_m, c.slope_rad, c.friction, c.kinetic_over_static * c.friction);
    auto const horizontal = testing::short_wave(c.wave);
    auto vertical = c.vertical_share > 0 ? testing::short_wave(c.wave + 50) : std::vector<double>{};
    for (double& value : vertical) {
        value *= c.vertical_share;
    }
    auto shaking = testing::shaking_of(horizontal, 0.02, c.level);
    shaking.vertical_mps2 = vertical;

    auto const out = testing::simulate_slipping(block, shaking, nullptr, {.rotation_rad = c.tilt_rad});
    auto const reference = Reference(block, horizontal, vertical, 0.02, c.level).run(c.tilt_rad);

    EXPECT_EQ(out.verdict == Verdict::overturned, reference.overturned);
    EXPECT_GT(reference.impacts + reference.slips, 1);
    EXPECT_NEAR(out.peak_slip_m, reference.slip, 1e-8 * std::max(reference.slip, 1e-3));
    EXPECT_NEAR(out.residual_slip_m, reference.residual, 1e-8 * std::max(reference.slip, 1e-3));
    auto const lean = [&](double side) {
        double const alpha = block.lopsided ? block.lopsided->corners[side < 0 ? 1 : 0].alpha_rad : block.alpha_rad;
        return reference.reached[side < 0 ? 1 : 0] / alpha;
    };
    EXPECT_NEAR(out.peak_reach_rad / block.alpha_rad, std::max(lean(1), lean(-1)), 1e-8 * std::max(lean(1), lean(-1)));
    RecordProperty("slips", reference.slips);
    RecordProperty("impacts", reference.impacts);
}

INSTANTIATE_TEST_SUITE_P(Waves, SlideRockLopsided,
                         ::testing::Values(Lean{"offset_stuck", 0.1, 0, 0, 1.2, 1, 8, 0, 1},
                                           Lean{"slope_stuck", 0, 0.02, 0, 1.2, 1, 7, 0.4, 1},
                                           Lean{"tilt_stuck", 0, 0, -0.2, 1.2, 1, 3, 0, 2},
                                           Lean{"offset_slips", -0.04, 0, 0, 0.66, 0.9, 8, 0, 0},
                                           Lean{"slope_slips", 0, 0.02, 0, 0.665, 0.9, 8, 0.4, 0},
                                           Lean{"slope_slides", 0, 0.03, 0, 0.4, 0.9, 6, 0, 3},
                                           Lean{"all_slip", 0.02, -0.015, 0.15, 0.68, 0.95, 8, 0.3, 1}),
                         [](auto const& info) { return info.param.name; });

}  // namespace
}  // namespace overturn
