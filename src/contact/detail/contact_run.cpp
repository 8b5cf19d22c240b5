#include "contact/detail/contact_run.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace overturn::contact {
ContactRun::ContactRun(ContactBlock const& block, Excitation const& shaking, ContactAccuracy const& accuracy,
                       std::optional<ContactStart> const& start)
    : Base(block, shaking) {
    OVERTURN_EXPECT(planar_.points.size() >= 2 && planar_.points.size() <= most_points);
    lane_.points = static_cast<int>(planar_.points.size());
    lane_.of_rim = planar_.of_rim;
    fill_trial(accuracy);
    fill_points();
    place(start.value_or(ContactStart{}));
    if (!accuracy.rest_gate || start) {
        begin_shaken();
    }
}

bool ContactRun::fallen() const { return !(std::abs(get(ContactField::rotation)) < pi / 2); }

void ContactRun::hold(std::size_t sample) {
    held_across_ = across(sample);
    held_up_ = up(sample);
}

// Weak enough until the next sample for the base to stay together and in place.
bool ContactRun::calm(std::size_t sample) const {
    double const strongest = std::max(std::abs(across(sample)), std::abs(across(sample + 1)));
    double const weight = planar_.gravity_mps2 + std::min(up(sample), up(sample + 1));
    return strongest <= get(ContactField::rest_ratio) * weight;
}

double ContactRun::across(std::size_t sample) const { return shaking_.horizontal_mps2[sample] * shaking_.scale; }
double ContactRun::up(std::size_t sample) const {
    return shaking_.vertical_mps2.empty() ? 0 : shaking_.vertical_mps2[sample] * shaking_.scale;
}

void ContactRun::show_sample() {
    auto const index = static_cast<std::size_t>(get(ContactField::index));
    put(ContactField::horizontal, across(index));
    put(ContactField::horizontal_change, across(index + 1) - across(index));
    put(ContactField::vertical, up(index));
    put(ContactField::vertical_change, up(index + 1) - up(index));
    put(ContactField::substep, 0);
}

// While the body was held the shaking grew. It starts to move from where that shaking has let the springs sink, sway
// and lean, and as fast as the shaking changes.
void ContactRun::wake() {
    double stiffness = 0;
    double first = 0;
    double second = 0;
    double const base = get(ContactField::rise) + planar_.centre_height_m * (1 - get(ContactField::cosine));
    for (int i = 0; i < lane_.points; ++i) {
        double const x = lane_.at(Spot::offset, i, 0);
        double const k = lane_.at(Spot::stiffness, i, 0);
        bool const touches = get(ContactField::sine) * x - base - lane_.at(Spot::crush, i, 0) > 0;
        stiffness += touches ? k : 0;
        first += touches ? k * x : 0;
        second += touches ? k * x * x : 0;
    }
    double const h = planar_.centre_height_m;
    double const lean = second - first * first / stiffness - h * (planar_.gravity_mps2 + held_up_);
    if (!(stiffness > 0) || !(lean > 0)) {
        return;
    }
    auto const yielding = [&](double push, double lift) {
        double const turn = -h * push / lean;
        return std::array{turn, (turn * first - lift) / stiffness,
                          h * turn - push / (stiffness * planar_.pad.tangential_ratio)};
    };
    auto const [turn, rise, sway] =
        yielding(get(ContactField::horizontal) - held_across_, get(ContactField::vertical) - held_up_);
    double const rate = 1 / shaking_.time_step_s;
    auto const [spin, rise_speed, sway_speed] =
        yielding(get(ContactField::horizontal_change) * rate, get(ContactField::vertical_change) * rate);
    turn_to(get(ContactField::rotation) + turn);
    put(ContactField::rise, get(ContactField::rise) + rise);
    put(ContactField::sway, get(ContactField::sway) + sway);
    put(ContactField::spin, spin);
    put(ContactField::rise_speed, rise_speed);
    put(ContactField::sway_speed, sway_speed);
}

}  // namespace overturn::contact
