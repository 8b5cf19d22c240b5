#include "spectra/detail/oscillator_sweep.hpp"

#include <algorithm>
#include <array>

#include "simd/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spectra/detail/oscillator_sweep.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes first: it includes this file once per instruction set
#include "simd/lanes-inl.hpp"
#include "spectra/detail/side_by_side-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::HWY_NAMESPACE {

// Where a step is a short chain of few numbers, four registers side by side hide its latency; with nine numbers to
// keep, two of each are what sixteen registers nearly hold.
using FewLanes = simd::HWY_NAMESPACE::SweepDoubles<2>;
using ManyLanes = simd::HWY_NAMESPACE::SweepDoubles<4>;

// Some lanes of a group, from `lane` on.
template <class V> class OneGroup {
  public:
    OneGroup(OscillatorGroup const& group, SweepTiles& tiles, std::size_t lane)
        : group_(group), lane_(lane), to_(tiles.value.data() + lane), highest_(tiles.highest.data() + lane) {}

    [[nodiscard]] OVERTURN_LANES_INLINE V of(simd::LaneValues<> OscillatorGroup::*values) const {
        return V::load((group_.*values).data() + lane_);
    }
    OVERTURN_LANES_INLINE void put(std::size_t row, V values) { values.store(to_ + row * simd::sweep_lanes); }
    OVERTURN_LANES_INLINE void next_tile() { to_ += SweepTiles::values; }
    OVERTURN_LANES_INLINE void end(V highest) { highest.store(highest_); }

  private:
    OscillatorGroup const& group_;
    std::size_t lane_;
    double* to_;
    double* highest_;
};

// All lanes of two groups.
class TwoGroups {
  public:
    TwoGroups(std::array<OscillatorGroup const*, 2> groups, std::array<SweepTiles, 2>& tiles)
        : groups_(groups), tiles_(tiles), to_(tiles[0].value.data()), others_to_(tiles[1].value.data()) {}

    [[nodiscard]] OVERTURN_LANES_INLINE TwoGroupsLanes of(simd::LaneValues<> OscillatorGroup::*values) const {
        return load_two(groups_[0]->*values, groups_[1]->*values);
    }
    OVERTURN_LANES_INLINE void put(std::size_t row, TwoGroupsLanes values) {
        store_two(values, to_ + row * simd::sweep_lanes, others_to_ + row * simd::sweep_lanes);
    }
    OVERTURN_LANES_INLINE void next_tile() {
        to_ += SweepTiles::values;
        others_to_ += SweepTiles::values;
    }
    OVERTURN_LANES_INLINE void end(TwoGroupsLanes highest) {
        store_two(highest, tiles_[0].highest.data(), tiles_[1].highest.data());
    }

  private:
    std::array<OscillatorGroup const*, 2> groups_;
    std::array<SweepTiles, 2>& tiles_;
    double* to_;
    double* others_to_;
};

// Some lanes over the wave.
template <class V, class Groups> class Sweep {
  public:
    Sweep(Groups groups, std::span<double const> acceleration) : acceleration_(acceleration), groups_(groups) {
        ahead_ = groups.of(&OscillatorGroup::ahead);
        behind_ = groups.of(&OscillatorGroup::behind);
        now_ = groups.of(&OscillatorGroup::now);
        last_ = groups.of(&OscillatorGroup::last);
        double const a0 = acceleration[0];
        double const a1 = acceleration.size() > 1 ? acceleration[1] : 0.0;
        state_ = fma(groups.of(&OscillatorGroup::state_a0), a0, groups.of(&OscillatorGroup::state_a1) * a1);
        other_ = fma(groups.of(&OscillatorGroup::other_a0), a0, groups.of(&OscillatorGroup::other_a1) * a1);
    }

    OVERTURN_LANES_INLINE void samples() {
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
        groups_.end(most);
    }

    OVERTURN_LANES_INLINE void amplitude() {
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
        groups_.end(most);
    }

    template <std::size_t Stride> OVERTURN_LANES_INLINE void strided() {
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
        groups_.end(most);
    }

  private:
    [[nodiscard]] OVERTURN_LANES_INLINE std::size_t end_of(std::size_t n) const {
        return std::min(n + SweepTiles::samples, acceleration_.size());
    }
    OVERTURN_LANES_INLINE void open(V state, V other) {
        groups_.put(1, state);
        groups_.put(2, other);
    }
    [[nodiscard]] OVERTURN_LANES_INLINE V close(V square, V most) {
        groups_.put(0, square);
        groups_.next_tile();
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
    Groups groups_;
    V ahead_, behind_, now_, last_, state_, other_;
};

template <class V, class Take>
void sweep_lanes(OscillatorGroup const& group, std::span<double const> acceleration, SweepTiles& tiles, Take take) {
    for (std::size_t lane = 0; lane < simd::sweep_lanes; lane += V::count) {
        take(Sweep<V, OneGroup<V>>(OneGroup<V>(group, tiles, lane), acceleration));
    }
}

void sweep_all(OscillatorGroup const& group, std::span<double const> acceleration, SweepTiles& tiles) {
    switch (group.form) {
        case SweepForm::amplitude:
            sweep_lanes<ManyLanes>(group, acceleration, tiles, [](auto some) HWY_ATTR { some.amplitude(); });
            break;
        case SweepForm::samples:
            sweep_lanes<FewLanes>(group, acceleration, tiles, [](auto some) HWY_ATTR { some.samples(); });
            break;
        case SweepForm::strided:
            if (group.stride == 2) {
                sweep_lanes<ManyLanes>(group, acceleration, tiles,
                                       [](auto some) HWY_ATTR { some.template strided<2>(); });
            } else {
                sweep_lanes<ManyLanes>(group, acceleration, tiles,
                                       [](auto some) HWY_ATTR { some.template strided<8>(); });
            }
            break;
    }
}

bool wins_by_pairs() { return pairs_win; }

void sweep_pair(std::array<OscillatorGroup const*, 2> groups, std::span<double const> acceleration,
                std::array<SweepTiles, 2>& tiles) {
    if constexpr (pairs_win) {
        Sweep<TwoGroupsLanes, TwoGroups> both(TwoGroups(groups, tiles), acceleration);
        if (groups[0]->form == SweepForm::amplitude) {
            both.amplitude();
        } else if (groups[0]->stride == 2) {
            both.strided<2>();
        } else {
            both.strided<8>();
        }
    } else {
        sweep_all(*groups[0], acceleration, tiles[0]);
        sweep_all(*groups[1], acceleration, tiles[1]);
    }
}

}  // namespace overturn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overturn {
namespace {

HWY_EXPORT(sweep_all);
HWY_EXPORT(sweep_pair);
HWY_EXPORT(wins_by_pairs);

void make_room(std::size_t samples, SweepTiles& tiles) {
    tiles.value.resize((samples + SweepTiles::samples - 2) / SweepTiles::samples * SweepTiles::values);
}

}  // namespace

void sweep(OscillatorGroup const& group, std::span<double const> acceleration_mps2, SweepTiles& tiles) {
    make_room(acceleration_mps2.size(), tiles);
    HWY_DYNAMIC_DISPATCH(sweep_all)(group, acceleration_mps2, tiles);
}

void sweep(std::array<OscillatorGroup const*, 2> groups, std::span<double const> acceleration_mps2,
           std::array<SweepTiles, 2>& tiles) {
    make_room(acceleration_mps2.size(), tiles[0]);
    make_room(acceleration_mps2.size(), tiles[1]);
    HWY_DYNAMIC_DISPATCH(sweep_pair)(groups, acceleration_mps2, tiles);
}

bool go_side_by_side(OscillatorGroup const& one, OscillatorGroup const& other) {
    return one.form != SweepForm::samples && one.form == other.form && one.stride == other.stride
           && HWY_DYNAMIC_DISPATCH(wins_by_pairs)();
}

}  // namespace overturn
#endif
