/// Runs one loop over 16 independent lanes with the widest registers of this machine. Lanes never mix, and a
/// product is joined with a sum where fma says so and nowhere else, so every machine gives the same bits.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>
#include <type_traits>

// Vectors never pass through a call here: all that takes them is inlined.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

namespace overturn::wide {

/// Lanes a kernel sweeps at once; spectra are padded to a multiple of it.
inline constexpr std::size_t lanes = 16;

/// Inlined into each machine's own version of a kernel.
#define OVERTURN_INLINE [[gnu::always_inline]] inline

/// `Lanes` numbers as an array of registers of `Bytes` bytes each.
template <int Bytes, std::size_t Lanes = lanes, class Real = double> struct Registers {
    using Vector [[gnu::vector_size(Bytes)]] = Real;
    static constexpr int count = static_cast<int>(Lanes * sizeof(Real)) / Bytes;
    static constexpr std::ptrdiff_t per_register = Lanes / count;

    Vector at[count];  // NOLINT(modernize-avoid-c-arrays): an array of registers

    // One register at a time: the compiler copies more at once through memory, in narrower pieces.
    OVERTURN_INLINE static void load(Registers& to, Real const* from) {
#pragma GCC unroll 8
        for (int i = 0; i < count; ++i) {
            std::memcpy(&to.at[i], from + i * per_register, Bytes);
        }
    }
    OVERTURN_INLINE static void store(Real* to, Registers const& from) {
#pragma GCC unroll 8
        for (int i = 0; i < count; ++i) {
            std::memcpy(to + i * per_register, &from.at[i], Bytes);
        }
    }
    OVERTURN_INLINE static void clear(Registers& to) {
#pragma GCC unroll 8
        for (int i = 0; i < count; ++i) {
            to.at[i] = Vector{};
        }
    }
};

/// As many lanes as a recursion with three states and its constants keeps in registers of `Bytes` bytes, of which there
/// are 16, or 32 of the widest.
template <int Bytes> inline constexpr std::size_t held_lanes = Bytes == 64 ? lanes : lanes / 2;

/// The type of a register's lanes.
template <class Vector> using Lane = std::remove_cvref_t<decltype(Vector{}[0])>;

template <class Vector> inline constexpr bool broad = sizeof(Vector) > 16;  ///< of a machine with AVX2 at least

/// All lanes alike.
template <class Vector> OVERTURN_INLINE Vector filled(Lane<Vector> value) {
    Vector all;
    if constexpr (broad<Vector> && sizeof(value) == sizeof(double)) {
        asm("vbroadcastsd %1, %0" : "=v"(all) : "xm"(value));  // what the compiler makes of loops takes four
    } else if constexpr (broad<Vector>) {
        asm("vbroadcastss %1, %0" : "=v"(all) : "xm"(value));
    } else {
#pragma GCC unroll 4
        for (std::size_t i = 0; i < sizeof(Vector) / sizeof(value); ++i) {
            all[i] = value;
        }
    }
    return all;
}

/// a b + c of registers, in one rounding. The wider ones are used only where the machine has the instruction.
template <class Vector> OVERTURN_INLINE Vector fma(Vector const& a, Vector const& b, Vector const& c) {
    Vector sum = c;
    if constexpr (broad<Vector> && sizeof(Lane<Vector>) == sizeof(double)) {
        asm("vfmadd231pd %2, %1, %0" : "+v"(sum) : "v"(a), "vm"(b));  // intrinsics do not go through a template
    } else if constexpr (broad<Vector>) {
        asm("vfmadd231ps %2, %1, %0" : "+v"(sum) : "v"(a), "vm"(b));
    } else {
#pragma GCC unroll 4
        for (std::size_t i = 0; i < sizeof(Vector) / sizeof(sum[0]); ++i) {
            sum[i] = std::fma(a[i], b[i], c[i]);
        }
    }
    return sum;
}
template <class Vector> OVERTURN_INLINE Vector fma(Vector const& a, Lane<Vector> b, Vector const& c) {
    return fma(filled<Vector>(b), a, c);
}

template <class Vector> OVERTURN_INLINE Vector max(Vector const& a, Vector const& b) { return a > b ? a : b; }

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
template <class Kernel> [[gnu::target("avx512f")]] void run_avx512(Kernel const& kernel) { kernel.template run<64>(); }
template <class Kernel> [[gnu::target("avx2,fma")]] void run_avx2(Kernel const& kernel) { kernel.template run<32>(); }
#endif

/// Calls kernel.run<Bytes>(), an OVERTURN_INLINE member, with the register width of this machine.
template <class Kernel> void dispatch(Kernel const& kernel) {
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
    if (__builtin_cpu_supports("avx512f") != 0) {
        run_avx512(kernel);
        return;
    }
    if (__builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0) {
        run_avx2(kernel);
        return;
    }
#endif
    kernel.template run<16>();
}

}  // namespace overturn::wide
