// Vectors of lanes as numbers: one register or several side by side, so that the machine has work while one waits.
// Lanes never mix, and a product is joined with a sum where fma says so and nowhere else, so every machine gives the
// same bits. Included once per instruction set, so without a #pragma once; after simd/targets.hpp and foreach_target.h.
#if defined(OVERTURN_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERTURN_LANES
#undef OVERTURN_LANES
#else
#define OVERTURN_LANES
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include "simd/lane_values.hpp"

#ifndef OVERTURN_LANES_INLINE
#error "include simd/targets.hpp before <hwy/foreach_target.h>"
#endif

HWY_BEFORE_NAMESPACE();
namespace overturn::simd::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// One, two or four registers. As members, and not halves of halves: GCC copies arrays and nests through memory.
template <class T, int Count> struct Registers;
template <class T> struct Registers<T, 1> { T a; };
template <class T> struct Registers<T, 2> { T a, b; };
template <class T> struct Registers<T, 4> { T a, b, c, d; };

// take(register, its number, ...) for every one.
#define OVERTURN_REGISTERS(take, ...) \
    take(a, 0, __VA_ARGS__);          \
    if constexpr (R > 1) {            \
        take(b, 1, __VA_ARGS__);      \
    }                                 \
    if constexpr (R > 2) {            \
        take(c, 2, __VA_ARGS__);      \
        take(d, 3, __VA_ARGS__);      \
    }
#define OVERTURN_FILL(p, number, with) part.p = with
#define OVERTURN_LOAD(p, number, from) x.part.p = hn::LoadU(D(), (from) + (number)*width)
#define OVERTURN_LOAD_ALIGNED(p, number, from) x.part.p = hn::Load(D(), (from) + (number)*width)
#define OVERTURN_STORE_ALIGNED(p, number, to) hn::Store(part.p, D(), (to) + (number)*width)
#define OVERTURN_STORE(p, number, to) hn::StoreU(part.p, D(), (to) + (number)*width)
#define OVERTURN_UNARY(p, number, operation) x.part.p = operation(a.part.p)
#define OVERTURN_BINARY(p, number, operation) x.part.p = operation(a.part.p, b.part.p)
#define OVERTURN_TERNARY(p, number, operation) c.part.p = operation(a.part.p, b.part.p, c.part.p)

/// Result of a comparison, lane by lane.
template <class D, int R> struct Truth { Registers<hn::Mask<D>, R> part; };

/// `R` registers of Highway's type D. For local variables and what is inlined: a std::vector of lanes, say, would be
/// compiled for the instruction set that every machine has.
template <class D, int R> struct Lanes {
    using Number = hn::TFromD<D>;
    using Mask = Truth<D, R>;
    static constexpr int width = static_cast<int>(hn::MaxLanes(D()));  ///< of a register
    static constexpr int count = R * width;

    Registers<hn::Vec<D>, R> part;

    Lanes() = default;
    // NOLINTNEXTLINE(google-explicit-constructor): constants in formulas
    OVERTURN_LANES_INLINE Lanes(Number x) {
        auto const all = hn::Set(D(), x);
        OVERTURN_REGISTERS(OVERTURN_FILL, all)
    }
    static OVERTURN_LANES_INLINE Lanes load(Number const* from) {
        Lanes x;
        OVERTURN_REGISTERS(OVERTURN_LOAD, from)
        return x;
    }
    OVERTURN_LANES_INLINE void store(Number* to) const { OVERTURN_REGISTERS(OVERTURN_STORE, to) }
    /// The same at a multiple of a register's bytes.
    static OVERTURN_LANES_INLINE Lanes load_aligned(Number const* from) {
        Lanes x;
        OVERTURN_REGISTERS(OVERTURN_LOAD_ALIGNED, from)
        return x;
    }
    OVERTURN_LANES_INLINE void store_aligned(Number* to) const { OVERTURN_REGISTERS(OVERTURN_STORE_ALIGNED, to) }
    [[nodiscard]] OVERTURN_LANES_INLINE Number first() const { return hn::GetLane(part.a); }
};

/// `R` registers of doubles; and one double alone, by the same arithmetic.
template <int R> using Doubles = Lanes<hn::ScalableTag<double>, R>;
using OneDouble = Lanes<hn::CappedTag<double, 1>, 1>;

/// Registers for `sweep_lanes` lanes, but at most so many: a sweep passes over its input once per `count` lanes. What
/// it keeps in registers decides which is fastest; the bits are the same.
template <class Number, int Most>
inline constexpr int sweep_registers = std::min(Most, static_cast<int>(sweep_lanes)
                                                          / Lanes<hn::ScalableTag<Number>, 1>::count);
template <int Most> using SweepDoubles = Lanes<hn::ScalableTag<double>, sweep_registers<double, Most>>;
template <int Most> using SweepFloats = Lanes<hn::ScalableTag<float>, sweep_registers<float, Most>>;

// As AVX's, also of plain doubles: the second where they are equal or not numbers.
#if HWY_TARGET == HWY_SCALAR
template <class V> OVERTURN_LANES_INLINE V least_of(V a, V b) { return a.raw < b.raw ? a : b; }
template <class V> OVERTURN_LANES_INLINE V most_of(V a, V b) { return a.raw > b.raw ? a : b; }
template <class V> OVERTURN_LANES_INLINE V fused(V a, V b, V c) { return V(std::fma(a.raw, b.raw, c.raw)); }
#else
template <class V> OVERTURN_LANES_INLINE V least_of(V a, V b) { return hn::Min(a, b); }
template <class V> OVERTURN_LANES_INLINE V most_of(V a, V b) { return hn::Max(a, b); }
template <class V> OVERTURN_LANES_INLINE V fused(V a, V b, V c) { return hn::MulAdd(a, b, c); }
#endif

// Binary operations of lanes, of lanes with one number for all, and of such a number with lanes.
#define OVERTURN_LANEWISE(name, operation)                                                             \
    template <class D, int R> OVERTURN_LANES_INLINE Lanes<D, R> name(Lanes<D, R> a, Lanes<D, R> b) {   \
        Lanes<D, R> x;                                                                                 \
        OVERTURN_REGISTERS(OVERTURN_BINARY, operation)                                                 \
        return x;                                                                                      \
    }                                                                                                  \
    template <class D, int R> OVERTURN_LANES_INLINE Lanes<D, R> name(Lanes<D, R> a, hn::TFromD<D> b) { \
        return name(a, Lanes<D, R>(b));                                                                \
    }                                                                                                  \
    template <class D, int R> OVERTURN_LANES_INLINE Lanes<D, R> name(hn::TFromD<D> a, Lanes<D, R> b) { \
        return name(Lanes<D, R>(a), b);                                                                \
    }
OVERTURN_LANEWISE(operator+, hn::Add)
OVERTURN_LANEWISE(operator-, hn::Sub)
OVERTURN_LANEWISE(operator*, hn::Mul)
OVERTURN_LANEWISE(operator/, hn::Div)
OVERTURN_LANEWISE(min, least_of)
OVERTURN_LANEWISE(max, most_of)
#undef OVERTURN_LANEWISE

#define OVERTURN_LANEWISE(name, operation)                                            \
    template <class D, int R> OVERTURN_LANES_INLINE Lanes<D, R> name(Lanes<D, R> a) { \
        Lanes<D, R> x;                                                                \
        OVERTURN_REGISTERS(OVERTURN_UNARY, operation)                                 \
        return x;                                                                     \
    }
OVERTURN_LANEWISE(operator-, hn::Neg)
OVERTURN_LANEWISE(abs, hn::Abs)
OVERTURN_LANEWISE(sqrt, hn::Sqrt)
#undef OVERTURN_LANEWISE

#define OVERTURN_LANEWISE(name, operation)                                                             \
    template <class D, int R> OVERTURN_LANES_INLINE Truth<D, R> name(Lanes<D, R> a, Lanes<D, R> b) {   \
        Truth<D, R> x;                                                                                 \
        OVERTURN_REGISTERS(OVERTURN_BINARY, operation)                                                 \
        return x;                                                                                      \
    }                                                                                                  \
    template <class D, int R> OVERTURN_LANES_INLINE Truth<D, R> name(Lanes<D, R> a, hn::TFromD<D> b) { \
        return name(a, Lanes<D, R>(b));                                                                \
    }
OVERTURN_LANEWISE(operator<, hn::Lt)
OVERTURN_LANEWISE(operator<=, hn::Le)
OVERTURN_LANEWISE(operator>, hn::Gt)
OVERTURN_LANEWISE(operator>=, hn::Ge)
#undef OVERTURN_LANEWISE

#define OVERTURN_LANEWISE(name, operation)                                                           \
    template <class D, int R> OVERTURN_LANES_INLINE Truth<D, R> name(Truth<D, R> a, Truth<D, R> b) { \
        Truth<D, R> x;                                                                               \
        OVERTURN_REGISTERS(OVERTURN_BINARY, operation)                                               \
        return x;                                                                                    \
    }
OVERTURN_LANEWISE(operator&, hn::And)
OVERTURN_LANEWISE(operator|, hn::Or)
OVERTURN_LANEWISE(but_not, hn::AndNot)  // of the second what is not in the first: see below
#undef OVERTURN_LANEWISE

/// `a` without `b`.
template <class D, int R> OVERTURN_LANES_INLINE Truth<D, R> without(Truth<D, R> a, Truth<D, R> b) {
    return but_not(b, a);
}

template <class D, int R> OVERTURN_LANES_INLINE Truth<D, R> operator!(Truth<D, R> a) {
    Truth<D, R> x;
    OVERTURN_REGISTERS(OVERTURN_UNARY, hn::Not)
    return x;
}

/// a b + c in one rounding, also where the machine has no instruction for it: bits never depend on the machine.
template <class D, int R> OVERTURN_LANES_INLINE Lanes<D, R> fma(Lanes<D, R> a, Lanes<D, R> b, Lanes<D, R> c) {
    OVERTURN_REGISTERS(OVERTURN_TERNARY, fused)
    return c;
}
template <class D, int R> OVERTURN_LANES_INLINE Lanes<D, R> fma(Lanes<D, R> a, hn::TFromD<D> b, Lanes<D, R> c) {
    return fma(a, Lanes<D, R>(b), c);
}
template <class D, int R> OVERTURN_LANES_INLINE Lanes<D, R> fma(Lanes<D, R> a, Lanes<D, R> b, hn::TFromD<D> c) {
    return fma(a, b, Lanes<D, R>(c));
}
template <class D, int R> OVERTURN_LANES_INLINE Lanes<D, R> fma(Lanes<D, R> a, hn::TFromD<D> b, hn::TFromD<D> c) {
    return fma(a, Lanes<D, R>(b), Lanes<D, R>(c));
}

/// The same by the name under which formulas ask any number for it: doubles round it twice.
template <class D, int R> OVERTURN_LANES_INLINE Lanes<D, R> mul_add(Lanes<D, R> a, Lanes<D, R> b, Lanes<D, R> c) {
    return fma(a, b, c);
}

/// `b` in the lanes where `a` holds, `c` in the others.
template <class D, int R> OVERTURN_LANES_INLINE Lanes<D, R> choose(Truth<D, R> a, Lanes<D, R> b, Lanes<D, R> c) {
    OVERTURN_REGISTERS(OVERTURN_TERNARY, hn::IfThenElse)
    return c;
}

template <class D, int R> OVERTURN_LANES_INLINE bool any(Truth<D, R> a) {
    auto all = a.part.a;
    if constexpr (R > 1) {
        all = hn::Or(all, a.part.b);
    }
    if constexpr (R > 2) {
        all = hn::Or(all, hn::Or(a.part.c, a.part.d));
    }
    return !hn::AllFalse(D(), all);
}

template <class D> OVERTURN_LANES_INLINE std::uint32_t bits_of(hn::Mask<D> mask) {
    std::array<std::uint8_t, 8> bytes{};
    hn::StoreMaskBits(D(), mask, bytes.data());
    return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8U;
}

/// One bit per lane.
template <class D, int R> OVERTURN_LANES_INLINE std::uint32_t bits(Truth<D, R> a) {
    constexpr unsigned width = Lanes<D, R>::width;
    std::uint32_t all = bits_of<D>(a.part.a);
    if constexpr (R > 1) {
        all |= bits_of<D>(a.part.b) << width;
    }
    if constexpr (R > 2) {
        all |= bits_of<D>(a.part.c) << 2 * width | bits_of<D>(a.part.d) << 3 * width;
    }
    return all;
}

template <class D>
OVERTURN_LANES_INLINE void fetch_one(double const* const* samples, hn::Vec<D> index, hn::Vec<D>& here,
                                     hn::Vec<D>& next) {
    constexpr auto width = static_cast<std::size_t>(Lanes<D, 1>::width);
    constexpr double magic = 0x1p52;  // a whole number that is added to it stands in the mantissa as an integer
    std::array<double, width> place;
    std::array<double, width> first;
    std::array<double, width> second;
    hn::StoreU(hn::Add(index, hn::Set(D(), magic)), D(), place.data());
    for (std::size_t lane = 0; lane < width; ++lane) {
        auto const offset = std::bit_cast<std::int64_t>(place[lane]) - std::bit_cast<std::int64_t>(magic);
        first[lane] = samples[lane][offset];
        second[lane] = samples[lane][offset + 1];
    }
    here = hn::LoadU(D(), first.data());
    next = hn::LoadU(D(), second.data());
}

/// Fetches two samples of each lane's own: the one at its index, a whole number below 2^52, and the one after it.
template <class D, int R>
OVERTURN_LANES_INLINE void fetch(double const* const* samples, Lanes<D, R> index, Lanes<D, R>& here,
                                 Lanes<D, R>& next) {
#define OVERTURN_FETCH(p, number, from) \
    fetch_one<D>((from) + (number)*Lanes<D, R>::width, index.part.p, here.part.p, next.part.p)
    OVERTURN_REGISTERS(OVERTURN_FETCH, samples)
#undef OVERTURN_FETCH
}

#undef OVERTURN_REGISTERS
#undef OVERTURN_FILL
#undef OVERTURN_LOAD
#undef OVERTURN_STORE
#undef OVERTURN_LOAD_ALIGNED
#undef OVERTURN_STORE_ALIGNED
#undef OVERTURN_UNARY
#undef OVERTURN_BINARY
#undef OVERTURN_TERNARY

}  // namespace overturn::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
