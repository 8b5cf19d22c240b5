// Vectors of lanes as numbers: several registers side by side, so that the machine has work while one of them waits.
// Included once per instruction set, so without a #pragma once; by swing_step-inl.hpp only.
#if defined(OVERTURN_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERTURN_LANES
#undef OVERTURN_LANES
#else
#define OVERTURN_LANES
#endif

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace overturn::rocking::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D, int Registers> struct Truth { std::array<hn::Mask<D>, Registers> part; };

template <class D, int Registers> struct Lanes {
    static constexpr int width = static_cast<int>(hn::MaxLanes(D()));
    static constexpr int count = Registers * width;
    using Mask = Truth<D, Registers>;

    std::array<hn::Vec<D>, Registers> part;

    Lanes() = default;
    // NOLINTNEXTLINE(google-explicit-constructor): constants in formulas
    HWY_INLINE Lanes(double x) {
        for (auto& v : part) {
            v = hn::Set(D(), x);
        }
    }
    static HWY_INLINE Lanes load(double const* from) {
        Lanes x;
        for (int i = 0; i < Registers; ++i) {
            x.part[i] = hn::Load(D(), from + static_cast<std::ptrdiff_t>(i) * width);
        }
        return x;
    }
    HWY_INLINE void store(double* to) const {
        for (int i = 0; i < Registers; ++i) {
            hn::Store(part[i], D(), to + static_cast<std::ptrdiff_t>(i) * width);
        }
    }
    [[nodiscard]] HWY_INLINE double first() const { return hn::GetLane(part[0]); }
};

#define OVERTURN_LANEWISE(name, operation)                                                                             \
    template <class D, int R> HWY_INLINE Lanes<D, R> name(Lanes<D, R> a, Lanes<D, R> b) {                              \
        Lanes<D, R> x;                                                                                                 \
        for (int i = 0; i < R; ++i) {                                                                                  \
            x.part[i] = hn::operation(a.part[i], b.part[i]);                                                           \
        }                                                                                                              \
        return x;                                                                                                      \
    }                                                                                                                  \
    template <class D, int R> HWY_INLINE Lanes<D, R> name(Lanes<D, R> a, double b) { return name(a, Lanes<D, R>(b)); } \
    template <class D, int R> HWY_INLINE Lanes<D, R> name(double a, Lanes<D, R> b) { return name(Lanes<D, R>(a), b); }
OVERTURN_LANEWISE(operator+, Add)
OVERTURN_LANEWISE(operator-, Sub)
OVERTURN_LANEWISE(operator*, Mul)
OVERTURN_LANEWISE(operator/, Div)
OVERTURN_LANEWISE(min, Min)
OVERTURN_LANEWISE(max, Max)
#undef OVERTURN_LANEWISE

#define OVERTURN_LANEWISE(name, operation)                                 \
    template <class D, int R> HWY_INLINE Lanes<D, R> name(Lanes<D, R> a) { \
        Lanes<D, R> x;                                                     \
        for (int i = 0; i < R; ++i) {                                      \
            x.part[i] = hn::operation(a.part[i]);                          \
        }                                                                  \
        return x;                                                          \
    }
OVERTURN_LANEWISE(operator-, Neg)
OVERTURN_LANEWISE(abs, Abs)
OVERTURN_LANEWISE(sqrt, Sqrt)
#undef OVERTURN_LANEWISE

#define OVERTURN_LANEWISE(name, operation)                                                \
    template <class D, int R> HWY_INLINE Truth<D, R> name(Lanes<D, R> a, Lanes<D, R> b) { \
        Truth<D, R> x;                                                                    \
        for (int i = 0; i < R; ++i) {                                                     \
            x.part[i] = hn::operation(a.part[i], b.part[i]);                              \
        }                                                                                 \
        return x;                                                                         \
    }                                                                                     \
    template <class D, int R> HWY_INLINE Truth<D, R> name(Lanes<D, R> a, double b) { return name(a, Lanes<D, R>(b)); }
OVERTURN_LANEWISE(operator<, Lt)
OVERTURN_LANEWISE(operator<=, Le)
OVERTURN_LANEWISE(operator>, Gt)
OVERTURN_LANEWISE(operator>=, Ge)
#undef OVERTURN_LANEWISE

#define OVERTURN_LANEWISE(name, operation)                                                \
    template <class D, int R> HWY_INLINE Truth<D, R> name(Truth<D, R> a, Truth<D, R> b) { \
        Truth<D, R> x;                                                                    \
        for (int i = 0; i < R; ++i) {                                                     \
            x.part[i] = hn::operation(a.part[i], b.part[i]);                              \
        }                                                                                 \
        return x;                                                                         \
    }
OVERTURN_LANEWISE(operator&, And)
OVERTURN_LANEWISE(operator|, Or)
OVERTURN_LANEWISE(but_not, AndNot)  // of the second what is not in the first: see below
#undef OVERTURN_LANEWISE

/// `a` without `b`.
template <class D, int R> HWY_INLINE Truth<D, R> without(Truth<D, R> a, Truth<D, R> b) { return but_not(b, a); }

template <class D, int R> HWY_INLINE Truth<D, R> operator!(Truth<D, R> a) {
    for (auto& m : a.part) {
        m = hn::Not(m);
    }
    return a;
}

/// a b + c in one rounding, also where the machine has no instruction for it: bits never depend on the machine.
template <class D, int R> HWY_INLINE Lanes<D, R> fma(Lanes<D, R> a, Lanes<D, R> b, Lanes<D, R> c) {
    Lanes<D, R> x;
    for (int i = 0; i < R; ++i) {
#if HWY_TARGET == HWY_SCALAR
        x.part[i] = hn::Vec<D>(std::fma(a.part[i].raw, b.part[i].raw, c.part[i].raw));
#else
        x.part[i] = hn::MulAdd(a.part[i], b.part[i], c.part[i]);
#endif
    }
    return x;
}
template <class D, int R> HWY_INLINE Lanes<D, R> fma(Lanes<D, R> a, double b, Lanes<D, R> c) {
    return fma(a, Lanes<D, R>(b), c);
}
template <class D, int R> HWY_INLINE Lanes<D, R> fma(Lanes<D, R> a, Lanes<D, R> b, double c) {
    return fma(a, b, Lanes<D, R>(c));
}
template <class D, int R> HWY_INLINE Lanes<D, R> fma(Lanes<D, R> a, double b, double c) {
    return fma(a, Lanes<D, R>(b), Lanes<D, R>(c));
}

template <class D, int R> HWY_INLINE Lanes<D, R> choose(Truth<D, R> condition, Lanes<D, R> yes, Lanes<D, R> no) {
    for (int i = 0; i < R; ++i) {
        no.part[i] = hn::IfThenElse(condition.part[i], yes.part[i], no.part[i]);
    }
    return no;
}

template <class D, int R> HWY_INLINE bool any(Truth<D, R> a) {
    auto all = a.part[0];
    for (int i = 1; i < R; ++i) {
        all = hn::Or(all, a.part[i]);
    }
    return !hn::AllFalse(D(), all);
}

/// One bit per lane.
template <class D, int R> HWY_INLINE std::uint32_t bits(Truth<D, R> a) {
    std::uint32_t all = 0;
    for (int i = 0; i < R; ++i) {
        std::array<std::uint8_t, 8> part{};
        hn::StoreMaskBits(D(), a.part[i], part.data());
        all |= static_cast<std::uint32_t>(part[0]) << (i * Lanes<D, R>::width);
    }
    return all;
}

/// The sample at each lane's address (a number of doubles) and the one after it.
template <class D, int R> HWY_INLINE void fetch(Lanes<D, R> address, Lanes<D, R>& here, Lanes<D, R>& next) {
    D const d;
    hn::RebindToSigned<D> const di;
    auto const magic =
        hn::Set(d, 4503599627370496.0);  // 2^52: what is added to it stands in the mantissa as an integer
    constexpr int width = Lanes<D, R>::width;
    for (int i = 0; i < R; ++i) {
        auto const at = hn::Sub(hn::BitCast(di, hn::Add(address.part[i], magic)), hn::BitCast(di, magic));
        HWY_ALIGN std::array<std::int64_t, width> from;
        HWY_ALIGN std::array<double, width> first;
        HWY_ALIGN std::array<double, width> second;
        hn::Store(at, di, from.data());
        for (int lane = 0; lane < width; ++lane) {
            // NOLINTNEXTLINE(performance-no-int-to-ptr): addresses travel in the lanes
            auto const* const sample = reinterpret_cast<double const*>(static_cast<std::uintptr_t>(from[lane]) * 8);
            first[lane] = sample[0];
            second[lane] = sample[1];
        }
        here.part[i] = hn::Load(d, first.data());
        next.part[i] = hn::Load(d, second.data());
    }
}

}  // namespace overturn::rocking::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
