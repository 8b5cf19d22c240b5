/// Common part of trials of bodies on points, in the plane and in space, between the steps that lanes take.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "contact/base_layout.hpp"
#include "contact/contact_accuracy.hpp"
#include "contact/rest_gate.hpp"
#include "model/excitation.hpp"
#include "model/run_out.hpp"

namespace overturn::contact {

/// At rest, shaken, then running out. \tparam Derived has fallen, calm (until the next sample), hold,
/// show_sample and wake, and names in shaken_by what its lanes hold of the shaking \tparam Field what its lanes hold of
/// the body: the place in the wave, the steps and the law have the same names
template <class Derived, class Field, class Spot, class Lane> class PointRun {
  public:
    /// On to where lanes can step. \return false once the trial is over
    [[nodiscard]] bool advance();

    /// The lane that holds the trial.
    [[nodiscard]] Lane& lane() { return lane_; }
    [[nodiscard]] Lane const& lane() const { return lane_; }

  protected:
    /// \param block and what the shaking shows outlive this
    PointRun(ContactBlock const& block, Excitation const& shaking) : planar_(block), shaking_(shaking) {
        auto const samples = shaking_.horizontal_mps2.size();
        last_ = samples < 2 || !(shaking_.time_step_s > 0) ? 0 : samples - 1;
    }

    /// A whole number of steps per sample. \param shorter factor on the longest that damping allows \param
    /// least_inertia_m2 over the mass, about the axis over which the body turns easiest
    void fill_steps(ContactAccuracy const& accuracy, double shorter, double least_inertia_m2);
    /// Longest step at which springs and dampers that grip stay stable, over the usual step [-].
    [[nodiscard]] double grip_share(double least_inertia_m2) const;
    void fill_law();
    /// A body that starts moving, or may not be held, is shaken from the first sample.
    void begin_shaken();
    [[nodiscard]] double time_s() const {
        return get(Field::origin) + get(Field::index) * get(Field::time_step) + get(Field::substep) * get(Field::step);
    }
    /// Energy of motion and unbalance over the mass, below which a body may be held at rest [J/kg].
    [[nodiscard]] double quiet_energy() const {
        return quiet_energy_share * planar_.gravity_mps2 * planar_.centre_height_m;
    }
    /// Elastic stretch of the springs of points that hold, under the largest normal force so far [m].
    [[nodiscard]] double elastic_way() const {
        double const most = std::max(get(Field::most_force), planar_.gravity_mps2);
        double const w = planar_.vertical_radps();
        return get(Field::hold) * most / (w * w);
    }
    [[nodiscard]] double deepest_crush() const {
        double deepest = 0;
        for (int i = 0; i < lane_.points; ++i) {
            deepest = std::max(deepest, lane_.at(Spot::crush, i, 0));
        }
        return deepest;
    }
    [[nodiscard]] double get(Field field) const { return lane_.body.at(field, 0); }
    void put(Field field, double value) { lane_.body.at(field, 0) = value; }

    Lane lane_;
    ContactBlock const& planar_;
    Excitation shaking_;
    std::size_t last_ = 0;  ///< sample

  private:
    enum class Phase : std::uint8_t { resting, shaken, running_out };
    // After the wave: nothing shakes, and rest is looked for every so many samples.
    static constexpr std::size_t still_samples = run_out_samples;
    static constexpr std::array<double, still_samples + 1> stillness{};

    [[nodiscard]] Derived& self() { return static_cast<Derived&>(*this); }
    [[nodiscard]] bool run_out(std::size_t index);
    void begin_run_out();

    double longest_step_s_ = 0;
    double run_out_s_ = 0;  // at most
    Phase phase_ = Phase::resting;
};

template <class Derived, class Field, class Spot, class Lane> bool PointRun<Derived, Field, Spot, Lane>::advance() {
    if (self().fallen()) {
        return false;
    }
    auto index = static_cast<std::size_t>(get(Field::index));
    if (phase_ == Phase::running_out) {
        return run_out(index);
    }
    if (phase_ == Phase::shaken && index < last_ && get(Field::steps) > 0) {
        phase_ = Phase::resting;  // lanes stopped before the end: the body is quiet
        self().hold(index);
    }
    if (phase_ == Phase::resting) {
        while (index < last_ && self().calm(index)) {
            ++index;
        }
        put(Field::index, static_cast<double>(index));
        if (index >= last_) {
            return false;
        }
        phase_ = Phase::shaken;
        self().show_sample();
        if (index > 0) {
            self().wake();  // at the first sample shaking comes suddenly: none before it has moved the springs
        }
        return true;
    }
    if (index >= last_) {
        begin_run_out();
        return run_out_s_ > 0;
    }
    return true;
}

template <class Derived, class Field, class Spot, class Lane>
bool PointRun<Derived, Field, Spot, Lane>::run_out(std::size_t index) {
    bool const stopped = index < still_samples;  // lanes stopped before the end: it is quiet
    double const reached = get(Field::origin) + still_samples * get(Field::time_step);
    double const after = reached - static_cast<double>(last_) * shaking_.time_step_s;
    if (stopped || after > run_out_s_) {
        return false;
    }
    put(Field::origin, reached);
    put(Field::index, 0);
    return true;
}

template <class Derived, class Field, class Spot, class Lane>
void PointRun<Derived, Field, Spot, Lane>::begin_run_out() {
    phase_ = Phase::running_out;
    if (last_ == 0) {                      // no wave: free motion
        constexpr double length_s = 0.01;  // in place of a sample: how often, over still_samples, rest is looked for
        double const substeps = std::ceil(length_s / longest_step_s_);
        put(Field::time_step, length_s);
        put(Field::step, length_s / substeps);
        put(Field::substeps, substeps);
        put(Field::inverse_substeps, 1 / substeps);
    }
    put(Field::origin, static_cast<double>(last_) * shaking_.time_step_s);
    put(Field::index, 0);
    put(Field::substep, 0);
    put(Field::last, still_samples);
    lane_.body.samples.fill(stillness.data());
    for (auto const field : Derived::shaken_by) {
        put(field, 0);
    }
    put(Field::quiet_energy, quiet_energy());
}

template <class Derived, class Field, class Spot, class Lane>
void PointRun<Derived, Field, Spot, Lane>::begin_shaken() {
    phase_ = Phase::shaken;
    if (last_ > 0) {
        self().show_sample();
    }
}

template <class Derived, class Field, class Spot, class Lane>
void PointRun<Derived, Field, Spot, Lane>::fill_steps(ContactAccuracy const& accuracy, double shorter,
                                                      double least_inertia_m2) {
    double const y = normal_damping(planar_.pad.normal_restitution);
    static double const usual_damping = normal_damping(Pad{}.normal_restitution);
    longest_step_s_ =
        accuracy.step_ratio / planar_.vertical_radps() * std::min(1.0, usual_damping / std::max(y, usual_damping));
    longest_step_s_ *= std::min(shorter, grip_share(least_inertia_m2));
    run_out_s_ = accuracy.longest_after_s;
    double const dt = shaking_.time_step_s > 0 ? shaking_.time_step_s : longest_step_s_;
    // A longest step that divides the sample but for rounding (some 1e-16 of the quotient, which is below 1e6) is not
    // cut once more.
    constexpr double slack = 1e-9;
    double const substeps = std::max(1.0, std::ceil(dt / longest_step_s_ - slack));
    put(Field::step, dt / substeps);
    put(Field::substeps, substeps);
    put(Field::inverse_substeps, 1 / substeps);
    put(Field::time_step, dt);
    put(Field::last, static_cast<double>(last_));
}

// A push on the base moves it by 1 + h^2 m / I of what it moves the mass. RK4 is stable up to 2.785 of a damping's rate
// and 2.828 of a spring's.
template <class Derived, class Field, class Spot, class Lane>
double PointRun<Derived, Field, Spot, Lane>::grip_share(double least_inertia_m2) const {
    constexpr double stable = 2.7;
    double const h = planar_.centre_height_m;
    double const lever = 1 + h * h / least_inertia_m2;
    double const root = std::sqrt(planar_.pad.tangential_ratio);
    double const fastest = std::max(2 * planar_.pad.tangential_damping * root * lever, root * std::sqrt(lever));
    return stable / (ContactAccuracy{}.step_ratio * fastest);
}

template <class Derived, class Field, class Spot, class Lane> void PointRun<Derived, Field, Spot, Lane>::fill_law() {
    double const w = planar_.vertical_radps();
    double const y = planar_.damping();
    auto const& pad = planar_.pad;
    put(Field::gravity, planar_.gravity_mps2);
    put(Field::stiffness, w * w);
    put(Field::height, planar_.centre_height_m);
    put(Field::friction, planar_.friction);
    put(Field::hold, planar_.friction / pad.tangential_ratio);
    put(Field::tangential_ratio, pad.tangential_ratio);
    put(Field::tangential_damping, 2 * pad.tangential_damping * std::sqrt(pad.tangential_ratio) / w);
    put(Field::damping, y);
    put(Field::most_damping, y / w);
    put(Field::least_approach, planar_.approach_floor_mps());
    put(Field::flexibility, 1 / (pad.tangential_ratio * w * w));
}

}  // namespace overturn::contact
