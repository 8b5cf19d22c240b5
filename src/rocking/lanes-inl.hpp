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

// One register or two side by side. As members: copies of arrays would go through memory.
template <class T, int Count> struct Registers;
template <class T> struct Registers<T, 1> { T a; };
template <class T> struct Registers<T, 2> { T a, b; };

template <class D, int R> struct Truth { Registers<hn::Mask<D>, R> part; };

template <class D, int R> struct Lanes {
    static constexpr int width = static_cast<int>(hn::MaxLanes(D()));
    static constexpr int count = R * width;
    using Mask = Truth<D, R>;

    Registers<hn::Vec<D>, R> part;

    Lanes() = default;
    // NOLINTNEXTLINE(google-explicit-constructor): constants in formulas
    HWY_INLINE Lanes(double x) {
        part.a = hn::Set(D(), x);
        if constexpr (R == 2) {
            part.b = part.a;
        }
    }
    static HWY_INLINE Lanes load(double const* from) {
        Lanes x;
        x.part.a = hn::Load(D(), from);
        if constexpr (R == 2) {
            x.part.b = hn::Load(D(), from + width);
        }
        return x;
    }
    HWY_INLINE void store(double* to) const {
        hn::Store(part.a, D(), to);
        if constexpr (R == 2) {
            hn::Store(part.b, D(), to + width);
        }
    }
    [[nodiscard]] HWY_INLINE double first() const { return hn::GetLane(part.a); }
};

#define OVERTURN_LANEWISE(name, operation)                                                                             \
    template <class D, int R> HWY_INLINE Lanes<D, R> name(Lanes<D, R> a, Lanes<D, R> b) {                              \
        Lanes<D, R> x;                                                                                                 \
        x.part.a = hn::operation(a.part.a, b.part.a);                                                                  \
        if constexpr (R == 2) {                                                                                        \
            x.part.b = hn::operation(a.part.b, b.part.b);                                                              \
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
        x.part.a = hn::operation(a.part.a);                                \
        if constexpr (R == 2) {                                            \
            x.part.b = hn::operation(a.part.b);                            \
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
        x.part.a = hn::operation(a.part.a, b.part.a);                                     \
        if constexpr (R == 2) {                                                           \
            x.part.b = hn::operation(a.part.b, b.part.b);                                 \
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
        x.part.a = hn::operation(a.part.a, b.part.a);                                     \
        if constexpr (R == 2) {                                                           \
            x.part.b = hn::operation(a.part.b, b.part.b);                                 \
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
    a.part.a = hn::Not(a.part.a);
    if constexpr (R == 2) {
        a.part.b = hn::Not(a.part.b);
    }
    return a;
}

/// a b + c in one rounding, also where the machine has no instruction for it: bits never depend on the machine.
template <class D, int R> HWY_INLINE Lanes<D, R> fma(Lanes<D, R> a, Lanes<D, R> b, Lanes<D, R> c) {
    Lanes<D, R> x;
#if HWY_TARGET == HWY_SCALAR
    x.part.a = hn::Vec<D>(std::fma(a.part.a.raw, b.part.a.raw, c.part.a.raw));
    if constexpr (R == 2) {
        x.part.b = hn::Vec<D>(std::fma(a.part.b.raw, b.part.b.raw, c.part.b.raw));
    }
#else
    x.part.a = hn::MulAdd(a.part.a, b.part.a, c.part.a);
    if constexpr (R == 2) {
        x.part.b = hn::MulAdd(a.part.b, b.part.b, c.part.b);
    }
#endif
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
    no.part.a = hn::IfThenElse(condition.part.a, yes.part.a, no.part.a);
    if constexpr (R == 2) {
        no.part.b = hn::IfThenElse(condition.part.b, yes.part.b, no.part.b);
    }
    return no;
}

template <class D, int R> HWY_INLINE bool any(Truth<D, R> a) {
    auto all = a.part.a;
    if constexpr (R == 2) {
        all = hn::Or(all, a.part.b);
    }
    return !hn::AllFalse(D(), all);
}

/// One bit per lane.
template <class D, int R> HWY_INLINE std::uint32_t bits(Truth<D, R> a) {
    auto const of = [](hn::Mask<D> m) HWY_ATTR {
        std::array<std::uint8_t, 8> bytes{};
        hn::StoreMaskBits(D(), m, bytes.data());
        return static_cast<std::uint32_t>(bytes[0]);
    };
    if constexpr (R == 2) {
        return of(a.part.a) | of(a.part.b) << Lanes<D, R>::width;
    }
    return of(a.part.a);
}

/// The sample at each lane's address (a number of doubles) and the one after it.
template <class D> HWY_INLINE void fetch_one(hn::Vec<D> address, hn::Vec<D>& here, hn::Vec<D>& next) {
    D const d;
    hn::RebindToSigned<D> const di;
    auto const magic =
        hn::Set(d, 4503599627370496.0);  // 2^52: what is added to it stands in the mantissa as an integer
    constexpr int width = static_cast<int>(hn::MaxLanes(D()));
    auto const at = hn::Sub(hn::BitCast(di, hn::Add(address, magic)), hn::BitCast(di, magic));
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
    here = hn::Load(d, first.data());
    next = hn::Load(d, second.data());
}
template <class D, int R> HWY_INLINE void fetch(Lanes<D, R> address, Lanes<D, R>& here, Lanes<D, R>& next) {
    fetch_one<D>(address.part.a, here.part.a, next.part.a);
    if constexpr (R == 2) {
        fetch_one<D>(address.part.b, here.part.b, next.part.b);
    }
}

}  // namespace overturn::rocking::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
