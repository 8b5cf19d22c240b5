/// Runs one loop over 16 independent lanes with the widest registers of this machine. Lanes never mix, and a
/// product is joined with a sum where fma says so and nowhere else, so every machine gives the same bits.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>

// Vectors never pass through a call here: all that takes them is inlined.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

namespace overturn::wide {

/// Lanes a kernel sweeps at once; spectra are padded to a multiple of it.
inline constexpr std::size_t lanes = 16;

/// Inlined into each machine's own version of a kernel.
#define OVERTURN_INLINE [[gnu::always_inline]] inline

/// 16 doubles as an array of registers of `Bytes` bytes each.
template <int Bytes> struct Registers {
    using Vector [[gnu::vector_size(Bytes)]] = double;
    static constexpr int count = static_cast<int>(lanes * sizeof(double)) / Bytes;

    Vector at[count];  // NOLINT(modernize-avoid-c-arrays): an array of registers

    OVERTURN_INLINE static void load(Registers& to, double const* from) { std::memcpy(&to.at, from, sizeof to.at); }
    OVERTURN_INLINE static void store(double* to, Registers const& from) { std::memcpy(to, &from.at, sizeof from.at); }
    OVERTURN_INLINE static void clear(Registers& to) {
#pragma GCC unroll 8
        for (int i = 0; i < count; ++i) {
            to.at[i] = Vector{};
        }
    }
};

/// All lanes alike. A subtraction, since adding nothing would lose the sign of a negative zero.
template <class Vector> OVERTURN_INLINE Vector filled(double value) { return value - Vector{}; }

/// a b + c of registers, in one rounding. The wider ones are used only where the machine has the instruction.
template <class Vector> OVERTURN_INLINE Vector fma(Vector const& a, Vector const& b, Vector const& c) {
    if constexpr (sizeof(Vector) > 2 * sizeof(double)) {
        Vector sum = c;
        asm("vfmadd231pd %2, %1, %0" : "+v"(sum) : "v"(a), "vm"(b));  // intrinsics do not go through a template
        return sum;
    } else {
        return Vector{std::fma(a[0], b[0], c[0]), std::fma(a[1], b[1], c[1])};
    }
}
template <class Vector> OVERTURN_INLINE Vector fma(Vector const& a, double b, Vector const& c) {
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
