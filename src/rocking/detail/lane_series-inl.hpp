// Rocking on one corner as a power series over one step: what it leads to, and where it ends. Included once per
// instruction set, so without a #pragma once; by lane_bounds-inl.hpp only.
#if defined(OVERTURN_LANE_SERIES) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERTURN_LANE_SERIES
#undef OVERTURN_LANE_SERIES
#else
#define OVERTURN_LANE_SERIES
#endif

#include <algorithm>

#include "rocking/detail/lane_step.hpp"
#include "simd/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::rocking::HWY_NAMESPACE {

// The laws for vector lanes: see block_laws.hpp, which includes the same text for doubles.
#define OVERTURN_LAW [[nodiscard]] OVERTURN_LANES_INLINE
#include "rocking/detail/block_laws-inl.hpp"
#undef OVERTURN_LAW

// Of every sum the newest terms come last: they are what the next ones wait for.
template <class V> OVERTURN_LANES_INLINE V mul_add(Linear<V> f, Term<V> x, V sum) {
    return fma(f.start, x.now, fma(f.slope, x.before, sum));
}

template <class V, int Stride, bool Vertical> class LaneSeries {
  public:
    using M = typename V::Mask;

    LaneSeries(double* values, double const* const* samples) : values_(values), samples_(samples) {}

  protected:
    static constexpr int order = LaneStep::order;
    static constexpr int trig = order - 1;  // terms of sine and cosine that phi needs

    // Forcing over the step, over g and mirrored.
    struct Forcing {
        V start, change, end;
    };
    struct Series {
        std::array<V, order> rate;  // phi' length
        std::array<V, trig> s, c;
    };
    // What the step leads to, if nothing happens on the way.
    struct Target {
        V phi, speed, s, c;
    };

    struct Turned {
        V s, c;
    };
    struct Zero {
        V share;
        M found;  // else the search has not come to its end
    };

    OVERTURN_LANES_INLINE V get(RockingField f) const {
        return V::load_aligned(values_ + static_cast<std::ptrdiff_t>(f) * Stride);
    }
    OVERTURN_LANES_INLINE void put(RockingField f, V v) {
        v.store_aligned(values_ + static_cast<std::ptrdiff_t>(f) * Stride);
    }

    OVERTURN_LANES_INLINE Forcing forcing(RockingWave wave, V scale, V index, V into) const;
    OVERTURN_LANES_INLINE Series expand(V length, V w, Forcing const& a, Forcing const& g) const;
    OVERTURN_LANES_INLINE Target target(Series const& x) const;
    OVERTURN_LANES_INLINE Zero first_zero(Series const& x, M started) const;
    OVERTURN_LANES_INLINE Zero turning(Series const& x) const;
    OVERTURN_LANES_INLINE V gain(V u, Series const& x) const;
    OVERTURN_LANES_INLINE Turned turned(Series const& x, V gain) const;
    static OVERTURN_LANES_INLINE V falling_root(V c0, V c1, V c2);
    template <std::size_t N> static OVERTURN_LANES_INLINE V at(V u, std::array<V, N> const& c);

  private:
    double* values_;
    double const* const* samples_;
};

template <class V, int Stride, bool Vertical>
OVERTURN_LANES_INLINE auto LaneSeries<V, Stride, Vertical>::forcing(RockingWave wave, V scale, V index, V into) const
    -> Forcing {
    V here;
    V next;
    fetch(samples_ + static_cast<std::ptrdiff_t>(wave) * Stride, index, here, next);
    V const a = scale * here;
    V const end = scale * next;
    V const rise = end - a;
    return {fma(rise, into, a), fma(-rise, into, rise), end};
}

// phi'' = -w pull, psi' = -phi', in the share of the step; w = (p length)^2, which the forcing takes up.
template <class V, int Stride, bool Vertical>
OVERTURN_LANES_INLINE auto LaneSeries<V, Stride, Vertical>::expand(V length, V w, Forcing const& a,
                                                                   Forcing const& g) const -> Series {
    Series x;
    x.rate[0] = get(RockingField::omega) * length;
    x.s[0] = get(RockingField::sine);
    x.c[0] = get(RockingField::cosine);
    x.s[1] = -(x.rate[0] * x.c[0]);
    x.c[1] = x.rate[0] * x.s[0];
    Linear<V> const across{w * a.start, w * a.change};
    Linear<V> const down{Vertical ? w * g.start : w, w * g.change};
    x.rate[1] = -pull_in_other_order(down.start, across.start, x.s[0], x.c[0]);
#pragma GCC unroll 16
    for (int k = 1; k < trig; ++k) {
        Term<V> const s{x.s[k], x.s[k - 1]};
        Term<V> const c{x.c[k], x.c[k - 1]};
        V const back = Vertical ? pull(down, across, s, c) : pull(down.start, across, s.now, c);
        x.rate[k + 1] = back * (-1.0 / (k + 1));
        if (k + 1 == trig) {
            break;
        }
        V sine = x.rate[1] * x.c[k - 1];
        V cosine = x.rate[1] * x.s[k - 1];
#pragma GCC unroll 16
        for (int j = 2; j <= k; ++j) {
            sine = fma(x.rate[j], x.c[k - j], sine);
            cosine = fma(x.rate[j], x.s[k - j], cosine);
        }
        sine = fma(x.rate[0], x.c[k], sine);
        cosine = fma(x.rate[0], x.s[k], cosine);
        x.s[k + 1] = sine * (-1.0 / (k + 1));
        x.c[k + 1] = cosine * (1.0 / (k + 1));
    }
    return x;
}

// psi turns by minus what phi gains; its sine and cosine turn with it. Exact to rounding up to most_arc.
template <class V, int Stride, bool Vertical>
OVERTURN_LANES_INLINE auto LaneSeries<V, Stride, Vertical>::turned(Series const& x, V gain) const -> Turned {
    V const t2 = gain * gain;
    V const sine_tail = fma(fma(t2, -1.0 / 5040, 1.0 / 120), t2, -1.0 / 6);
    V const cosine_tail = fma(fma(fma(t2, 1.0 / 40320, -1.0 / 720), t2, 1.0 / 24), t2, -0.5);
    V const sine = fma(sine_tail * t2, gain, gain);
    V const drop = cosine_tail * t2;  // cos - 1
    return {x.s[0] + fma(x.s[0], drop, -(x.c[0] * sine)), x.c[0] + fma(x.c[0], drop, x.s[0] * sine)};
}

template <class V, int Stride, bool Vertical>
OVERTURN_LANES_INLINE auto LaneSeries<V, Stride, Vertical>::target(Series const& x) const -> Target {
    auto const& r = x.rate;
    V late = r[4] * (1.0 / 5);
    V speed = r[order - 2] + r[order - 1];
#pragma GCC unroll 16
    for (int k = 5; k < order; ++k) {
        late = fma(r[k], 1.0 / (k + 1), late);
    }
#pragma GCC unroll 16
    for (int k = order - 4; k >= 0; k -= 2) {
        speed = (r[k] + r[k + 1]) + speed;
    }
    V const gain = fma(r[1], 0.5, r[0]) + (fma(r[3], 0.25, r[2] * (1.0 / 3)) + late);
    auto const [s, c] = turned(x, gain);
    return {get(RockingField::phi) + gain, speed, s, c};
}

// What phi has gained at a share of the step.
template <class V, int Stride, bool Vertical>
OVERTURN_LANES_INLINE V LaneSeries<V, Stride, Vertical>::gain(V u, Series const& x) const {
    std::array<V, order> c;
#pragma GCC unroll 16
    for (int k = 0; k < order; ++k) {
        c[k] = x.rate[k] * (1.0 / (k + 1));
    }
    return at(u, c) * u;
}

// Where c0 + c1 u + c2 u^2 falls through zero.
template <class V, int Stride, bool Vertical>
OVERTURN_LANES_INLINE V LaneSeries<V, Stride, Vertical>::falling_root(V c0, V c1, V c2) {
    return (c0 + c0) / (sqrt(max(c1 * c1 - 4.0 * c0 * c2, 0)) - c1);
}

// sum c[k] u^k in two chains, of even and of odd powers: in a single one every step would wait for the one before.
template <class V, int Stride, bool Vertical>
template <std::size_t N>
OVERTURN_LANES_INLINE V LaneSeries<V, Stride, Vertical>::at(V u, std::array<V, N> const& c) {
    static_assert(N >= 2);
    constexpr int top = static_cast<int>(N) - 1;
    V const u2 = u * u;
    V even = c[top - top % 2];
    V odd = c[top - 1 + top % 2];
#pragma GCC unroll 16
    for (int k = top - 2; k >= 0; --k) {
        V& sum = k % 2 == 0 ? even : odd;
        sum = fma(sum, u2, c[k]);
    }
    return fma(odd, u, even);
}

// Where phi turns from rising to falling, as a share of the step.
template <class V, int Stride, bool Vertical>
OVERTURN_LANES_INLINE auto LaneSeries<V, Stride, Vertical>::turning(Series const& x) const -> Zero {
    std::array<V, order - 1> slope;
#pragma GCC unroll 16
    for (int k = 1; k < order; ++k) {
        slope[k - 1] = x.rate[k] * static_cast<double>(k);
    }
    V u = falling_root(x.rate[0], x.rate[1], x.rate[2]);
    u = u - at(u, x.rate) / at(u, slope);
    V const last = at(u, x.rate) / at(u, slope);
    // phi is flat here: an error of the instant enters squared.
    constexpr double small = 1e-5;
    return {u - last, abs(last) <= small * u};
}

// Where phi falls to zero, as a share of the step: from its parabola, by Newton's steps. A zero at the start is
// divided out first.
template <class V, int Stride, bool Vertical>
OVERTURN_LANES_INLINE auto LaneSeries<V, Stride, Vertical>::first_zero(Series const& x, M started) const -> Zero {
    std::array<V, order + 1> c;
    c[0] = choose(started, x.rate[0], get(RockingField::phi));
#pragma GCC unroll 16
    for (int k = 1; k < order; ++k) {
        c[k] = choose(started, x.rate[k] * (1.0 / (k + 1)), x.rate[k - 1] * (1.0 / k));
    }
    c[order] = choose(started, V(0), x.rate[order - 1] * (1.0 / order));
    std::array<V, order> slope;
#pragma GCC unroll 16
    for (int k = 1; k <= order; ++k) {
        slope[k - 1] = c[k] * static_cast<double>(k);
    }
    constexpr int leading = 6;  // terms that bring the parabola's root close enough
    std::array<V, leading> lead;
    std::array<V, leading - 1> lead_slope;
    std::copy_n(c.begin(), leading, lead.begin());
    std::copy_n(slope.begin(), leading - 1, lead_slope.begin());
    V u = falling_root(c[0], c[1], c[2]);
    u = u - at(u, lead) / at(u, lead_slope);
    u = u - at(u, c) / at(u, slope);
    V const last = at(u, c) / at(u, slope);
    // Newton's error squares itself: after a step this small it is rounding.
    constexpr double small = 1e-7;
    return {u - last, abs(last) <= small * u};
}

}  // namespace overturn::rocking::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
