#include "contact/detail/contact_run.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace overturn::contact {
namespace {

// After the wave: nothing shakes, and energy is looked at every so many samples.
constexpr std::size_t still_samples = 8;
constexpr std::array<double, still_samples + 1> stillness{};

}  // namespace

ContactRun::ContactRun(ContactBlock const& block, Excitation const& shaking, ContactAccuracy const& accuracy,
                       std::optional<ContactStart> const& start)
    : block_(block), shaking_(shaking), from_rest_(!start) {
    auto const samples = shaking_.horizontal_mps2.size();
    last_ = samples < 2 || !(shaking_.time_step_s > 0) ? 0 : samples - 1;
    OVERTURN_EXPECT(block_.points.size() >= 2 && block_.points.size() <= most_points);
    lane_.points = static_cast<int>(block_.points.size());
    fill_trial(accuracy);
    fill_points();
    place(start.value_or(ContactStart{}));
    if (!accuracy.rest_gate || !from_rest_) {
        phase_ = Phase::shaken;
        if (last_ > 0) {
            show_sample();
        }
    }
}

bool ContactRun::advance() {
    if (!(std::abs(get(Pressing::rotation)) < pi / 2)) {
        return false;
    }
    auto index = static_cast<std::size_t>(get(Pressing::index));
    if (phase_ == Phase::running_out) {
        bool const stopped = index < still_samples;  // lanes stopped before the end: it is quiet
        double const reached = get(Pressing::origin) + still_samples * get(Pressing::time_step);
        double const after = reached - static_cast<double>(last_) * shaking_.time_step_s;
        if (stopped || decided() || after > run_out_s_) {
            return false;
        }
        put(Pressing::origin, reached);
        put(Pressing::index, 0);
        return true;
    }
    if (phase_ == Phase::shaken && index < last_ && get(Pressing::steps) > 0) {
        phase_ = Phase::resting;  // lanes found it quiet
        held_across_ = across(index);
        held_up_ = up(index);
    }
    if (phase_ == Phase::resting) {
        while (index < last_ && calm(index)) {
            ++index;
        }
        put(Pressing::index, static_cast<double>(index));
        if (index >= last_) {
            return false;
        }
        wake();
        return true;
    }
    if (index >= last_) {
        begin_run_out();
        return run_out_s_ > 0;
    }
    return true;
}

// Weak enough until the next sample for the base to stay together and in place.
bool ContactRun::calm(std::size_t sample) const {
    double const strongest = std::max(std::abs(across(sample)), std::abs(across(sample + 1)));
    double const weight = block_.gravity_mps2 + std::min(up(sample), up(sample + 1));
    return strongest <= get(Pressing::rest_ratio) * weight;
}

double ContactRun::across(std::size_t sample) const { return shaking_.horizontal_mps2[sample] * shaking_.scale; }
double ContactRun::up(std::size_t sample) const {
    return shaking_.vertical_mps2.empty() ? 0 : shaking_.vertical_mps2[sample] * shaking_.scale;
}

void ContactRun::show_sample() {
    auto const index = static_cast<std::size_t>(get(Pressing::index));
    put(Pressing::horizontal, across(index));
    put(Pressing::horizontal_change, across(index + 1) - across(index));
    put(Pressing::vertical, up(index));
    put(Pressing::vertical_change, up(index + 1) - up(index));
    put(Pressing::substep, 0);
}

// The shaking grew while the body was held: it stands where springs that still touch have let it sink, sway and lean.
void ContactRun::wake() {
    phase_ = Phase::shaken;
    show_sample();
    if (get(Pressing::index) == 0) {
        return;  // whatever the first sample holds comes suddenly
    }
    double stiffness = 0;
    double first = 0;
    double second = 0;
    double const base = get(Pressing::rise) + block_.centre_height_m * (1 - get(Pressing::cosine));
    for (int i = 0; i < lane_.points; ++i) {
        double const x = lane_.at(Spot::offset, i, 0);
        double const k = lane_.at(Spot::stiffness, i, 0);
        bool const touches = get(Pressing::sine) * x - base - lane_.at(Spot::crush, i, 0) > 0;
        stiffness += touches ? k : 0;
        first += touches ? k * x : 0;
        second += touches ? k * x * x : 0;
    }
    double const h = block_.centre_height_m;
    double const lean = second - first * first / stiffness - h * (block_.gravity_mps2 + held_up_);
    if (!(stiffness > 0) || !(lean > 0)) {
        return;
    }
    auto const yielding = [&](double push, double lift) {
        double const turn = -h * push / lean;
        return std::array{turn, (turn * first - lift) / stiffness,
                          h * turn - push / (stiffness * block_.pad.tangential_ratio)};
    };
    auto const [turn, rise, sway] =
        yielding(get(Pressing::horizontal) - held_across_, get(Pressing::vertical) - held_up_);
    double const rate = 1 / shaking_.time_step_s;
    auto const [spin, rise_speed, sway_speed] =
        yielding(get(Pressing::horizontal_change) * rate, get(Pressing::vertical_change) * rate);
    turn_to(get(Pressing::rotation) + turn);
    put(Pressing::rise, get(Pressing::rise) + rise);
    put(Pressing::sway, get(Pressing::sway) + sway);
    put(Pressing::spin, spin);
    put(Pressing::rise_speed, rise_speed);
    put(Pressing::sway_speed, sway_speed);
}

void ContactRun::begin_run_out() {
    phase_ = Phase::running_out;
    if (last_ == 0) {  // no wave: free motion
        double const length = 0.01;
        double const substeps = std::ceil(length / longest_step_s_);
        put(Pressing::time_step, length);
        put(Pressing::step, length / substeps);
        put(Pressing::substeps, substeps);
        put(Pressing::inverse_substeps, 1 / substeps);
    }
    put(Pressing::origin, static_cast<double>(last_) * shaking_.time_step_s);
    put(Pressing::index, 0);
    put(Pressing::last, still_samples);
    lane_.body.at(PressWave::horizontal, 0) = stillness.data();
    lane_.body.at(PressWave::vertical, 0) = stillness.data();
    for (auto const field : {Pressing::horizontal, Pressing::horizontal_change, Pressing::vertical,
                             Pressing::vertical_change, Pressing::substep}) {
        put(field, 0);
    }
    put(Pressing::quiet_energy, quiet_energy());
}

// A body that can neither fall nor swing higher than it did. One that has slipped may slip on: it is followed until
// it rests.
bool ContactRun::decided() const {
    if (slipped()) {
        return false;
    }
    double const b = block_.half_width_m;
    double const h = block_.centre_height_m;
    double const radius = std::hypot(b, h);
    double const alpha = std::atan2(b, h);
    constexpr double safe = 0.99;  // soft corners lower the top by a few settlements; crushed ones by what is gone
    double const energy = mechanical_energy() / (block_.gravity_mps2 * radius) + deepest_crush() / radius;
    if (energy > safe * (1 - std::cos(alpha)) || std::abs(get(Pressing::rotation)) >= alpha) {
        return false;
    }
    double const turning = alpha - std::acos(std::min(1.0, energy + std::cos(alpha)));
    return turning <= std::max(get(Pressing::crest), -get(Pressing::trough));
}

}  // namespace overturn::contact
