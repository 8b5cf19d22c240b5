/// Full base contact: rest, the instant it ends, and sliding. Part of rocking_integrator.hpp.
#pragma once

#include "rocking/detail/rocking_integrator.hpp"

namespace overturn::rocking {

// On to the first sample in which the block could move: most of most waves is passed here, whole chunks at a time.
template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::skip_rest() {
    std::size_t const n = shaking_.horizontal_mps2.size();
    double const k = shaking_.scale / block_.gravity_mps2;
    double most = 0;
    double least = 1;
    // For the strongest and the lightest of one sample or of many: a ratio that holds there holds for all of them.
    auto const holds = [&](double strongest, double lightest) {
        double const a = std::abs(k * strongest);
        double const gv = Vertical ? 1 + k * lightest : 1;
        if (a > gv * corner_.hold_ratio || !(gv > 0)) {
            return false;
        }
        if (double const ratio = Vertical ? a / gv : a; ratio > most) {
            most = ratio;
        }
        least = std::min(least, gv);
        return true;
    };
    auto const sample_holds = [&](std::size_t i) {
        return holds(shaking_.horizontal_mps2[i], Vertical ? shaking_.vertical_mps2[i] : 0);
    };
    // Of a chunk with a vertical component the bound is not the maximum: it may set no record.
    auto const chunk_holds = [&](ChunkExtremes::Chunk const& chunk) {
        double const lowest = k > 0 ? chunk.lowest : chunk.highest;
        bool const exact =
            !Vertical
            || std::abs(k * chunk.strongest) <= (1 + k * lowest) * std::max(most, log_.outcome().friction_demand);
        return exact && holds(chunk.strongest, lowest);
    };
    if (lopsided_) {
        skip_lopsided_rest();
        return;
    }
    if (index_ + 1 < n && sample_holds(index_)) {
        for (++index_; index_ < n;) {
            auto const* const chunk = shaking_.chunks != nullptr ? shaking_.chunks->at(index_) : nullptr;
            if (chunk != nullptr && chunk_holds(*chunk)) {
                index_ += ChunkExtremes::samples;
            } else if (sample_holds(index_)) {
                ++index_;
            } else {
                break;
            }
        }
        --index_;
    }
    log_.raise_demand(most);
    log_.lower_contact(least);
}

// The same where towards one side less holds it than towards the other.
template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::skip_lopsided_rest() {
    std::size_t const n = shaking_.horizontal_mps2.size();
    double const k = shaking_.scale / block_.gravity_mps2;
    auto const holds = [&](std::size_t i) {
        double const a = k * shaking_.horizontal_mps2[i];
        double const gv = Vertical ? 1 + k * shaking_.vertical_mps2[i] : 1;
        if (!(gv > 0) || std::abs(a) > gv * tipped_by(a).hold_ratio) {
            return false;
        }
        auto const [friction, normal] = turned(a, gv, 1);
        log_.watch_forces(friction, normal);
        return true;
    };
    if (index_ + 1 < n && holds(index_)) {
        for (++index_; index_ < n && holds(index_);) {
            ++index_;
        }
        --index_;
    }
}

// At rest |a| <= gv hold_ratio; both sides are linear in time, so the instant at which rest ends is exact.
template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::rest() {
    double const tau = sample_.tau_s;
    double const a = sample_.horizontal(tau);
    double const gv = sample_.vertical(tau);
    auto const here = turned(a, gv, 1);
    log_.lower_contact(here.normal);
    show(here.friction, here.normal);
    if (!(gv > 0)) {
        lose_contact(true);
        return;
    }
    if (std::abs(a) > gv * tipped_by(a).hold_ratio) {
        leave_rest(tau, a);
        return;
    }
    log_.watch_forces(here.friction, here.normal);
    double const end = sample_.length_s;
    double const a_end = sample_.horizontal(end);
    double const gv_end = sample_.vertical(end);
    double const hold = gv * tipped_by(a_end).hold_ratio;
    double const hold_end = gv_end * tipped_by(a_end).hold_ratio;
    if (std::abs(a_end) > hold_end) {
        double const sign = a_end < 0 ? -1.0 : 1.0;
        double const below = hold - sign * a;
        double const above = sign * a_end - hold_end;
        leave_rest(std::min(end, tau + (end - tau) * (below / (below + above))), a_end);
        return;
    }
    sample_.tau_s = end;
    auto const there = turned(a_end, gv_end, 1);
    log_.watch_forces(there.friction, there.normal);
    if (!(gv_end > 0)) {
        lose_contact(true);
    }
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::leave_rest(double tau, double acceleration) {
    sample_.tau_s = tau;
    if constexpr (limited) {
        if (block_.friction_static
            <= tipped_by(acceleration).base_ratio) {  // equal: both limits are passed, and such a slip cannot tip
            if constexpr (slipping) {
                mode_ = Mode::slide;
                sigma_ = acceleration > 0 ? -1.0 : 1.0;
                v_mps_ = 0;
                slipped_ = true;
                log_.raise_demand(block_.friction_static);
            } else {
                log_.end_at_slip();
            }
            return;
        }
    }
    lift(acceleration);
}

template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::lift(double acceleration) {
    mode_ = Mode::rock;
    stand_on(acceleration > 0 ? -1.0 : 1.0);
    phi_ = 0;
    omega_ = 0;
    start_root_ = StartRoot::twofold;
}

// x'' = -a - mu_k sigma gv: a cubic, exact. Friction below tan(alpha) cannot tip a sliding base.
template <int Order, class Restoring, bool Vertical, Slip Friction>
void Integrator<Order, Restoring, Vertical, Friction>::slide() {
    if constexpr (slipping) {
        double const g = block_.gravity_mps2;
        double const drag = block_.friction_kinetic * sigma_;
        auto const forcing = forcing_of_ground(1);
        auto const shaking = shaking_of(forcing, 1);
        double const gv = forcing.vertical;
        log_.lower_contact(gv);
        show(-drag * gv, gv);
        if (!(gv > 0)) {
            lose_contact(true);
            return;
        }
        ++log_.outcome().steps;
        double pull = -forcing.horizontal - drag * gv;
        if (v_mps_ == 0 && sigma_ * pull < 0) {
            pull = 0;  // sliding starts where this is zero or drives it, whatever rounding says
        }
        std::array<double, 3> velocity{v_mps_, g * pull,
                                       -0.5 * g * (forcing.horizontal_slope + drag * forcing.vertical_slope)};
        std::array<double, 3> forwards = velocity;
        for (double& c : forwards) {
            c *= sigma_;
        }
        auto const root = v_mps_ == 0 ? StartRoot::simple : StartRoot::none;
        double end = sample_.left();
        double const stop = first_fall_through_zero(forwards, end, root);
        end = stop >= 0 ? stop : end;
        bool lost = false;
        if (Vertical || lopsided_) {
            std::array<double, 2> const weight{gv, forcing.vertical_slope};
            if (evaluate(weight, end) <= 0) {
                end = root_between(weight, 0.0, end);
                lost = true;
            }
        }
        std::array<double, 3> const weight{gv, forcing.vertical_slope, 0};
        std::array<double, 3> const push{-shaking.horizontal, -shaking.horizontal_slope, 0};
        auto& energy = log_.outcome().energy;
        std::array<double, 4> power{};
        std::array<double, 4> loss{};
        for (int k = 0; k < 4; ++k) {
            for (int j = std::max(0, k - 2); j <= std::min(k, 2); ++j) {
                power[k] += g * velocity[j] * push[k - j];
                loss[k] += g * drag * velocity[j] * weight[k - j];
            }
        }
        energy.input += integral(power, end);
        energy.friction_work += integral(loss, end);
        x_m_ += integral(velocity, end);
        log_.raise_slip(x_m_);
        sample_.advance(end, lost || stop >= 0);
        if (lost) {
            v_mps_ = evaluate(velocity, end);
            lose_contact(true);
        } else if (stop >= 0) {
            v_mps_ = 0;
            mode_ = Mode::rest;
        } else {
            v_mps_ = evaluate(velocity, end);
        }
    }
}

}  // namespace overturn::rocking
