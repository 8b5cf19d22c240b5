#include "spectra/detail/oscillator_sweep.hpp"

#include <algorithm>

#include "simd/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spectra/detail/oscillator_sweep.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes first: it includes this file once per instruction set
#include "simd/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::HWY_NAMESPACE {

// Where a step is a short chain of few numbers, four registers side by side hide its latency; with nine numbers to
// keep, two of each are what sixteen registers nearly hold.
using FewLanes = simd::HWY_NAMESPACE::SweepDoubles<2>;
using ManyLanes = simd::HWY_NAMESPACE::SweepDoubles<4>;

// Some lanes of a group over the wave, from `lane` on.
template <class V> class Sweep {
  public:
    Sweep(OscillatorGroup const& group, std::span<double const> acceleration, SweepTiles& tiles, std::size_t lane)
        : acceleration_(acceleration), lane_(lane), to_(tiles.value.data() + lane) {
        ahead_ = from(group.ahead);
        behind_ = from(group.behind);
        now_ = from(group.now);
        last_ = from(group.last);
        double const a0 = acceleration[0];
        double const a1 = acceleration.size() > 1 ? acceleration[1] : 0.0;
        state_ = fma(from(group.state_a0), a0, from(group.state_a1) * a1);
        other_ = fma(from(group.other_a0), a0, from(group.other_a1) * a1);
    }

    // \return the largest square
    OVERTURN_LANES_INLINE V samples() {
        V const ahead = ahead_;
        V const behind = behind_;
        V const now = now_;
        V const last = last_;
        V x = state_;
        V before = other_;
        V a0 = 0;
        V a1 = acceleration_[0];
        V most = 0;
        for (std::size_t n = 1; n < acceleration_.size();) {
            open(x, before);
            V square = 0;
            for (std::size_t const end = end_of(n); n < end; ++n) {
                V const a2 = acceleration_[n];
                V const forced = fma(now, a1, fma(last, a0, a2));
                V const next = fma(x, ahead, fma(before, behind, forced));
                before = x;
                x = next;
                square = max(next * next, square);
                a0 = a1;
                a1 = a2;
            }
            most = close(square, most);
        }
        return most;
    }

    OVERTURN_LANES_INLINE V amplitude() {
        V const cosine = ahead_;
        V const sine = behind_;
        V const against = -sine;
        V real = state_;
        V imaginary = other_;
        V most = 0;
        double rise = acceleration_.size() > 1 ? acceleration_[1] - acceleration_[0] : 0.0;
        for (std::size_t n = 1; n < acceleration_.size();) {
            open(real, imaginary);
            V square = 0;
            for (std::size_t const end = end_of(n); n < end; ++n) {
                double const next_rise = n + 1 < acceleration_.size() ? acceleration_[n + 1] - acceleration_[n] : rise;
                V const jump = next_rise - rise;
                V const re = real;
                V const im = imaginary;
                square = max(fma(re, re, im * im), square);
                real = fma(re, cosine, im * sine);
                imaginary = fma(im, cosine, fma(re, against, jump));
                rise = next_rise;
            }
            most = close(square, most);
        }
        return most;
    }

    template <std::size_t Stride> OVERTURN_LANES_INLINE V strided() {
        V w = state_;
        V d = other_;
        V most = 0;
        for (std::size_t n = 1; n < acceleration_.size();) {
            open(w, d);
            V square = 0;
            std::size_t const end = end_of(n);
            for (; n + Stride <= end; n += Stride) {
                for (std::size_t i = 0; i + 1 < Stride; ++i) {
                    step(w, d, acceleration_[n + i]);
                }
                square = look(w, d, acceleration_[n + Stride - 1], square);
            }
            for (; n < end; ++n) {
                square = look(w, d, acceleration_[n], square);
            }
            most = close(square, most);
        }
        return most;
    }

  private:
    [[nodiscard]] OVERTURN_LANES_INLINE V from(simd::LaneValues<> const& values) const {
        return V::load(values.data() + lane_);
    }
    [[nodiscard]] OVERTURN_LANES_INLINE std::size_t end_of(std::size_t n) const {
        return std::min(n + SweepTiles::samples, acceleration_.size());
    }
    OVERTURN_LANES_INLINE void open(V state, V other) {
        state.store(to_ + simd::sweep_lanes);
        other.store(to_ + 2 * simd::sweep_lanes);
    }
    [[nodiscard]] OVERTURN_LANES_INLINE V close(V square, V most) {
        square.store(to_);
        to_ += SweepTiles::values;
        return max(square, most);
    }
    // w is that of the sample before.
    OVERTURN_LANES_INLINE void step(V& w, V& d, double a) const {
        V const next = fma(d, ahead_, fma(w, behind_, V(a)));
        w = w + d;
        d = next;
    }
    [[nodiscard]] OVERTURN_LANES_INLINE V look(V& w, V& d, double a, V square) const {
        V const before = w;
        step(w, d, a);
        V const x = fma(w, now_, fma(before, last_, d));
        return max(x * x, square);
    }

    std::span<double const> acceleration_;
    std::size_t lane_;
    double* to_;
    V ahead_, behind_, now_, last_, state_, other_;
};

template <class V, class Take>
void sweep_lanes(OscillatorGroup const& group, std::span<double const> acceleration, SweepTiles& tiles, Take take) {
    for (std::size_t lane = 0; lane < simd::sweep_lanes; lane += V::count) {
        take(Sweep<V>(group, acceleration, tiles, lane)).store(tiles.highest.data() + lane);
    }
}

void sweep_all(OscillatorGroup const& group, std::span<double const> acceleration, SweepTiles& tiles) {
    switch (group.form) {
        case SweepForm::amplitude:
            sweep_lanes<ManyLanes>(group, acceleration, tiles,
                                   [](Sweep<ManyLanes> some) HWY_ATTR { return some.amplitude(); });
            break;
        case SweepForm::samples:
            sweep_lanes<FewLanes>(group, acceleration, tiles,
                                  [](Sweep<FewLanes> some) HWY_ATTR { return some.samples(); });
            break;
        case SweepForm::strided:
            if (group.stride == 2) {
                sweep_lanes<ManyLanes>(group, acceleration, tiles,
                                       [](Sweep<ManyLanes> some) HWY_ATTR { return some.strided<2>(); });
            } else {
                sweep_lanes<ManyLanes>(group, acceleration, tiles,
                                       [](Sweep<ManyLanes> some) HWY_ATTR { return some.strided<8>(); });
            }
            break;
    }
}

}  // namespace overturn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overturn {

HWY_EXPORT(sweep_all);

void sweep(OscillatorGroup const& group, std::span<double const> acceleration_mps2, SweepTiles& tiles) {
    tiles.value.resize((acceleration_mps2.size() + SweepTiles::samples - 2) / SweepTiles::samples * SweepTiles::values);
    HWY_DYNAMIC_DISPATCH(sweep_all)(group, acceleration_mps2, tiles);
}

}  // namespace overturn
#endif
