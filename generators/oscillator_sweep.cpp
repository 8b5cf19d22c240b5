#include "generators/oscillator_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace overturn {
namespace {

struct Sweep {
    std::span<double const> acceleration;
    OscillatorGroup const* group;
    double* blocks;
    double* highest;

    template <int bytes> OVERTURN_INLINE void run() const {
        using Held = wide::Registers<bytes, wide::held_lanes<bytes>>;
        using All = wide::Registers<bytes>;
        switch (group->form) {
            case SweepForm::amplitude:
                amplitude<All>();
                break;
            case SweepForm::samples:
                for (std::size_t lane = 0; lane < wide::lanes; lane += wide::held_lanes<bytes>) {
                    sampled<Held>(lane);
                }
                break;
            case SweepForm::strided:
                group->stride == 2 ? strided<All, 2>() : strided<All, 8>();
        }
    }

    template <class R> OVERTURN_INLINE void sampled(std::size_t lane) const {
        R ahead, behind, now, last, x, before, square, most;
        load_constants(lane, ahead, behind, now, last);
        load_start(lane, x, before);
        R::clear(most);
        auto a0 = wide::filled<typename R::Vector>(0);
        auto a1 = wide::filled<typename R::Vector>(acceleration[0]);
        double* block = blocks + lane;
        for (std::size_t n = 1; n < acceleration.size(); block += SweepBlocks::values) {
            open(block, x, before, square);
            for (std::size_t const end = end_of(n); n < end; ++n) {
                auto const a2 = wide::filled<typename R::Vector>(acceleration[n]);
#pragma GCC unroll 8
                for (int r = 0; r < R::count; ++r) {
                    auto const forced = wide::fma(now.at[r], a1, wide::fma(last.at[r], a0, a2));
                    auto const next = wide::fma(x.at[r], ahead.at[r], wide::fma(before.at[r], behind.at[r], forced));
                    before.at[r] = x.at[r];
                    x.at[r] = next;
                    square.at[r] = wide::max(next * next, square.at[r]);
                }
                a0 = a1;
                a1 = a2;
            }
            close(block, square, most);
        }
        R::store(highest + lane, most);
    }

    template <class R> OVERTURN_INLINE void amplitude() const {
        R cosine, sine, against, real, imaginary, square, most;
        R::load(cosine, group->ahead.data());
        R::load(sine, group->behind.data());
#pragma GCC unroll 8
        for (int r = 0; r < R::count; ++r) {
            against.at[r] = -sine.at[r];
        }
        load_start(0, real, imaginary);
        R::clear(most);
        double* block = blocks;
        double rise = acceleration.size() > 1 ? acceleration[1] - acceleration[0] : 0.0;
        for (std::size_t n = 1; n < acceleration.size(); block += SweepBlocks::values) {
            open(block, real, imaginary, square);
            for (std::size_t const end = end_of(n); n < end; ++n) {
                double const next_rise = n + 1 < acceleration.size() ? acceleration[n + 1] - acceleration[n] : rise;
                auto const jump = wide::filled<typename R::Vector>(next_rise - rise);
#pragma GCC unroll 8
                for (int r = 0; r < R::count; ++r) {
                    auto const re = real.at[r];
                    auto const im = imaginary.at[r];
                    square.at[r] = wide::max(wide::fma(re, re, im * im), square.at[r]);
                    real.at[r] = wide::fma(re, cosine.at[r], im * sine.at[r]);
                    imaginary.at[r] = wide::fma(im, cosine.at[r], wide::fma(re, against.at[r], jump));
                }
                rise = next_rise;
            }
            close(block, square, most);
        }
        R::store(highest, most);
    }

    template <class R, std::size_t stride> OVERTURN_INLINE void strided() const {
        R ahead, behind, now, last, w, d, square, most;
        load_constants(0, ahead, behind, now, last);
        load_start(0, w, d);
        R::clear(most);
        double* block = blocks;
        for (std::size_t n = 1; n < acceleration.size(); block += SweepBlocks::values) {
            open(block, w, d, square);
            std::size_t const end = end_of(n);
            for (; n + stride <= end; n += stride) {
                for (std::size_t i = 0; i + 1 < stride; ++i) {
                    step(ahead, behind, w, d, acceleration[n + i]);
                }
                look(ahead, behind, now, last, w, d, acceleration[n + stride - 1], square);
            }
            for (; n < end; ++n) {
                look(ahead, behind, now, last, w, d, acceleration[n], square);
            }
            close(block, square, most);
        }
        R::store(highest, most);
    }

    // w is that of the sample before.
    template <class R> OVERTURN_INLINE static void step(R const& ahead, R const& behind, R& w, R& d, double a) {
        auto const filled = wide::filled<typename R::Vector>(a);
#pragma GCC unroll 8
        for (int r = 0; r < R::count; ++r) {
            auto const next = wide::fma(d.at[r], ahead.at[r], wide::fma(w.at[r], behind.at[r], filled));
            w.at[r] += d.at[r];
            d.at[r] = next;
        }
    }
    template <class R>
    OVERTURN_INLINE static void look(R const& ahead, R const& behind, R const& now, R const& last, R& w, R& d, double a,
                                     R& square) {
        R const before = w;
        step(ahead, behind, w, d, a);
#pragma GCC unroll 8
        for (int r = 0; r < R::count; ++r) {
            auto const x = wide::fma(w.at[r], now.at[r], wide::fma(before.at[r], last.at[r], d.at[r]));
            square.at[r] = wide::max(x * x, square.at[r]);
        }
    }

    [[nodiscard]] OVERTURN_INLINE std::size_t end_of(std::size_t n) const {
        return std::min(n + SweepBlocks::samples, acceleration.size());
    }
    template <class R>
    OVERTURN_INLINE void load_constants(std::size_t lane, R& ahead, R& behind, R& now, R& last) const {
        R::load(ahead, group->ahead.data() + lane);
        R::load(behind, group->behind.data() + lane);
        R::load(now, group->now.data() + lane);
        R::load(last, group->last.data() + lane);
    }
    template <class R> OVERTURN_INLINE void load_start(std::size_t lane, R& state, R& other) const {
        double const a0 = acceleration[0];
        double const a1 = acceleration.size() > 1 ? acceleration[1] : 0.0;
        R state1, other1;
        R::load(state, group->state_a0.data() + lane);
        R::load(other, group->other_a0.data() + lane);
        R::load(state1, group->state_a1.data() + lane);
        R::load(other1, group->other_a1.data() + lane);
#pragma GCC unroll 8
        for (int r = 0; r < R::count; ++r) {
            state.at[r] = wide::fma(state.at[r], a0, state1.at[r] * a1);
            other.at[r] = wide::fma(other.at[r], a0, other1.at[r] * a1);
        }
    }
    template <class R> OVERTURN_INLINE static void open(double* block, R const& state, R const& other, R& square) {
        R::store(block + wide::lanes, state);
        R::store(block + 2 * wide::lanes, other);
        R::clear(square);
    }
    template <class R> OVERTURN_INLINE static void close(double* block, R const& square, R& most) {
        R::store(block, square);
#pragma GCC unroll 8
        for (int r = 0; r < R::count; ++r) {
            most.at[r] = wide::max(square.at[r], most.at[r]);
        }
    }
};

// Of x[n+1], over that of a[n+1].
double of_a_now(OscillatorStep const& c) { return (c.ya0 - c.vv * c.ya1 + c.yv * c.va1) / c.ya1; }
double of_a_last(OscillatorStep const& c) { return (c.yv * c.va0 - c.vv * c.ya0) / c.ya1; }

}  // namespace

void OscillatorGroup::set(std::size_t lane, double w, double damping, OscillatorStep const& sample,
                          double time_step_s) {
    switch (form) {
        case SweepForm::amplitude:
            set_amplitude(lane, w, damping, time_step_s);
            break;
        case SweepForm::samples:
            set_samples(lane, sample);
            break;
        case SweepForm::strided:
            set_strided(lane, w, damping, sample, time_step_s);
            break;
    }
}

// y'' + 2 zeta w y' + w^2 y = -a with a = a0 + s t: the ground's line is p = (-a + 2 zeta s / w) / w^2, and y - p
// = exp(-zeta w t) (f cos(wd t) + q sin(wd t)), q = ((y - p)' + zeta w f) / wd: f + iq turns back by wd t. Where s
// changes, y and y' do not: f changes by -2 zeta / w^3, q by (1 - 2 zeta^2) / (w^2 wd), both times the change of s. C
// is f + iq over the size of that and turned so that the change is imaginary.
void OscillatorGroup::set_amplitude(std::size_t lane, double w, double damping, double dt) {
    double const wd = w * std::sqrt(1 - damping * damping);
    double const decay = std::exp(-damping * w * dt);
    std::complex<double> const jump(-2 * damping / (w * w * w * dt), (1 - 2 * damping * damping) / (w * w * wd * dt));
    double const size = std::abs(jump);
    auto const turned = jump / std::complex<double>(0, size);
    ahead.at(lane) = decay * std::cos(wd * dt);
    behind.at(lane) = decay * std::sin(wd * dt);
    now.at(lane) = turned.real();
    last.at(lane) = turned.imag();
    unit.at(lane) = size;
    double const f0 = 1 / (w * w) - jump.real(), f1 = jump.real();  // f = -p, over a[0] and a[1]
    double const slope = 1 / (w * w * dt);                          // of -p', over a[1] - a[0]
    auto const c0 = std::complex<double>(f0, (damping * w * f0 - slope) / wd) / (size * turned);
    auto const c1 = std::complex<double>(f1, (damping * w * f1 + slope) / wd) / (size * turned);
    state_a0.at(lane) = c0.real();
    state_a1.at(lane) = c1.real();
    other_a0.at(lane) = c0.imag();
    other_a1.at(lane) = c1.imag();
}

void OscillatorGroup::set_samples(std::size_t lane, OscillatorStep const& c) {
    ahead.at(lane) = c.yy + c.vv;
    behind.at(lane) = c.yv * c.vy - c.yy * c.vv;
    now.at(lane) = of_a_now(c);
    last.at(lane) = of_a_last(c);
    unit.at(lane) = c.ya1;
    // At rest x[0] = 0, and x[-1] is what makes x[1] = a[1] + ya0/ya1 a[0].
    other_a0.at(lane) = (c.ya0 / c.ya1 - now.at(lane)) / behind.at(lane);
}

// With A, B the coefficients of x[n] and x[n-1], and b those of a[n] and a[n-1]: w[n+1] = A w[n] + B w[n-1] + a[n+1],
// x[n+1] = w[n+1] + b1 w[n] + b2 w[n-1]; -B is the decay in a step, 1 - A - B = w^2 times what a steady a holds y at.
void OscillatorGroup::set_strided(std::size_t lane, double w, double damping, OscillatorStep const& c, double dt) {
    double const b1 = of_a_now(c);
    double const b2 = of_a_last(c);
    double const stiffness = -w * w * c.ya1 * (1 + b1 + b2);
    double const decay = std::exp(-2 * damping * w * dt);
    ahead.at(lane) = decay - stiffness;
    behind.at(lane) = -stiffness;
    now.at(lane) = 1 + b1;
    last.at(lane) = b2;
    unit.at(lane) = c.ya1;
    // At rest x[0] = 0 and x[1] = a[1] + ya0/ya1 a[0]: two equations for w[0] and w[-1], over a[0].
    double const a = 1 + decay - stiffness;
    double const y0w0 = 1 - b2 / decay, y0w1 = b1 + b2 * a / decay, y0 = -b2 / decay;
    double const y1w0 = a + b1, y1w1 = b2 - decay, y1 = c.ya0 / c.ya1;
    double const determinant = y0w0 * y1w1 - y0w1 * y1w0;
    double const w0 = (y0 * y1w1 - y0w1 * y1) / determinant;
    double const w1 = (y0w0 * y1 - y0 * y1w0) / determinant;
    state_a0.at(lane) = w1;
    other_a0.at(lane) = w0 - w1;
}

void sweep(OscillatorGroup const& group, std::span<double const> acceleration_mps2, SweepBlocks& blocks) {
    blocks.value.resize((acceleration_mps2.size() + SweepBlocks::samples - 2) / SweepBlocks::samples
                        * SweepBlocks::values);
    wide::dispatch(Sweep{acceleration_mps2, &group, blocks.value.data(), blocks.highest.data()});
}

}  // namespace overturn
