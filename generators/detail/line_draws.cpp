#include "generators/detail/line_draws.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"
#include "generators/detail/log_table.hpp"
#include "simd/stream_words.hpp"
#include "simd/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "generators/detail/line_draws.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes first: it includes this file once per instruction set
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace overturn::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Real = hn::CappedTag<double, simd::counters_together>;
using Word = hn::RebindToUnsigned<Real>;
using Reals = hn::Vec<Real>;
using Words = hn::Vec<Word>;

HWY_INLINE Reals real(double x) { return hn::Set(Real(), x); }

// The upper 53 bits times 2^-53, as RandomStream has it. They are put into the mantissas of 2^84 and 2^52 in two parts.
HWY_INLINE Reals unit(Words bits) {
    auto const with = [](Words part, std::uint64_t exponent) {
        return hn::BitCast(Real(), hn::Or(part, hn::Set(Word(), exponent)));
    };
    auto const upper = with(hn::ShiftRight<43>(bits), 0x4530000000000000U);
    auto const lower = with(hn::And(hn::ShiftRight<11>(bits), hn::Set(Word(), 0xFFFFFFFFU)), 0x4330000000000000U);
    return hn::Mul(hn::Add(hn::Sub(upper, real(0x1p84 + 0x1p52)), lower), real(0x1p-53));
}

HWY_INLINE Reals product_sum(Reals a, Reals b, Reals c) { return hn::Add(hn::Mul(a, b), c); }

struct Rest {
    Reals value, error;  ///< |value + error| <= pi/4
};

// Sine and cosine of such a rest: the polynomials of FreeBSD's msun (Sun Microsystems 1993), in the order of musl.
HWY_INLINE Reals sine_of(Rest x, hn::Mask<Real> exact) {
    auto const z = hn::Mul(x.value, x.value);
    auto const w = hn::Mul(z, z);
    auto const outer =
        hn::Mul(hn::Mul(z, w), product_sum(z, real(1.58969099521155010221e-10), real(-2.50507602534068634195e-08)));
    auto const inner =
        product_sum(z, product_sum(z, real(2.75573137070700676789e-06), real(-1.98412698298579493134e-04)),
                    real(8.33333333332248946124e-03));
    auto const r = hn::Add(inner, outer);
    auto const v = hn::Mul(z, x.value);
    auto const third = real(-1.66666666666666324348e-01);
    auto const plain = hn::Add(x.value, hn::Mul(v, product_sum(z, r, third)));
    auto const half = hn::Sub(hn::Mul(real(0.5), x.error), hn::Mul(v, r));
    auto const corrected = hn::Sub(x.value, hn::Sub(hn::Sub(hn::Mul(z, half), x.error), hn::Mul(v, third)));
    return hn::IfThenElse(exact, plain, corrected);
}

HWY_INLINE Reals cosine_of(Rest x) {
    auto const z = hn::Mul(x.value, x.value);
    auto const w = hn::Mul(z, z);
    auto const low =
        hn::Mul(z, product_sum(z, product_sum(z, real(2.48015872894767294178e-05), real(-1.38888888888741095749e-03)),
                               real(4.16666666666666019037e-02)));
    auto const high =
        product_sum(z, product_sum(z, real(-1.13596475577881948265e-11), real(2.08757232129817482790e-09)),
                    real(-2.75573143513906633035e-07));
    auto const r = hn::Add(low, hn::Mul(hn::Mul(w, w), high));
    auto const half = hn::Mul(real(0.5), z);
    auto const one = hn::Sub(real(1), half);
    auto const small = hn::Add(hn::Sub(hn::Sub(real(1), one), half), hn::Sub(hn::Mul(z, r), hn::Mul(x.value, x.error)));
    return hn::Add(one, small);
}

struct Turn {
    Reals cosine, sine;
    bool close;  ///< to a multiple of pi/2, where more digits of pi are needed
};

// Of an angle between 0 and 2 pi: less n pi/2 (Cody and Waite, pi/2 in 33 bits and the rest), n = 0 to 4 by the upper
// word of the angle.
HWY_INLINE Turn turn_of(Reals angle) {
    auto const upper = hn::ShiftRight<32>(hn::BitCast(Word(), angle));
    auto const word = [](std::uint64_t x) { return hn::Set(Word(), x); };
    auto n = hn::Zero(Word());
    for (std::uint64_t const last : {0x3fe921fbU, 0x4002d97cU, 0x400f6a7aU, 0x4015fdbcU}) {  // odd multiples of pi/4
        auto const beyond = hn::VecFromMask(Word(), hn::Gt(upper, word(last)));
        n = hn::Sub(n, beyond);  // a mask is -1
    }
    auto close = hn::Eq(upper, word(0x3ff921fbU));
    for (std::uint64_t const multiple : {0x400921fbU, 0x4012d97cU, 0x401921fbU}) {
        close = hn::Or(close, hn::Eq(upper, word(multiple)));
    }
    auto const times = hn::Sub(hn::BitCast(Real(), hn::Or(n, word(0x4330000000000000U))), real(0x1p52));
    auto const first = hn::Sub(angle, hn::Mul(times, real(1.57079632673412561417e+00)));
    auto const more = hn::Mul(times, real(6.07710050650619224932e-11));
    auto const value = hn::Sub(first, more);
    Rest const rest{value, hn::Sub(hn::Sub(first, value), more)};
    auto const s = sine_of(rest, hn::RebindMask(Real(), hn::Eq(n, hn::Zero(Word()))));
    auto const c = cosine_of(rest);
    auto const across = hn::RebindMask(Real(), hn::Ne(hn::And(n, word(1)), hn::Zero(Word())));
    auto const sign = [&](Words quarter) { return hn::BitCast(Real(), hn::ShiftLeft<62>(hn::And(quarter, word(2)))); };
    return {hn::Xor(hn::IfThenElse(across, s, c), sign(hn::Add(n, word(1)))),
            hn::Xor(hn::IfThenElse(across, c, s), sign(n)), !hn::AllFalse(Word(), close)};
}

// cos(2 pi u) + i sin(2 pi u) of each word.
void fill_turns(std::span<std::uint64_t const> words, std::complex<double>* turns) {
    constexpr auto lanes = hn::MaxLanes(Real());
    HWY_ALIGN std::array<double, lanes> angles;
    for (std::size_t i = 0; i < words.size(); i += lanes, turns += lanes) {
        auto const angle = hn::Mul(real(2 * pi), unit(hn::LoadU(Word(), words.data() + i)));
        auto const turn = turn_of(angle);
        hn::StoreInterleaved2(turn.cosine, turn.sine, Real(), reinterpret_cast<double*>(turns));
        if (turn.close) {
            hn::Store(angle, Real(), angles.data());
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                turns[lane] = {std::cos(angles[lane]), std::sin(angles[lane])};
            }
        }
    }
}

// In the order of musl's log, where the machine has no fused operation.
HWY_INLINE Reals log_near_one(Reals x) {
    using log_table::near_one;
    auto const r = hn::Sub(x, real(1));
    auto const r2 = hn::Mul(r, r);
    auto const r3 = hn::Mul(r, r2);
    auto const three = [&](std::size_t first, Reals rest) {  // of the powers from this one on, and r^3 times the rest
        auto const two = hn::Add(real(near_one[first]), hn::Mul(r, real(near_one[first + 1])));
        return hn::Add(hn::Add(two, hn::Mul(r2, real(near_one[first + 2]))), hn::Mul(r3, rest));
    };
    auto const y = hn::Mul(r3, three(1, three(4, three(7, real(near_one[10])))));
    auto const upper = hn::Mul(r, real(0x1p27));
    auto const r_high = hn::Sub(hn::Add(r, upper), upper);
    auto const r_low = hn::Sub(r, r_high);
    auto const square = hn::Mul(hn::Mul(r_high, r_high), real(near_one[0]));
    auto const high = hn::Add(r, square);
    auto const low = hn::Add(hn::Sub(r, high), square);
    auto const more = hn::Mul(hn::Mul(real(near_one[0]), r_low), hn::Add(r_high, r));
    return hn::Add(hn::Add(y, hn::Add(low, more)), high);
}

// Of normal numbers below 1.
HWY_INLINE Reals log_of(Reals x) {
    using Whole = hn::RebindToSigned<Real>;
    using namespace log_table;
    constexpr std::uint64_t from = 0x3fe6000000000000;  // 0.6875
    constexpr double near = 1 - 0x1p-4;
    auto const bits = hn::BitCast(Word(), x);
    auto const beyond = hn::Sub(bits, hn::Set(Word(), from));
    auto const k = hn::ConvertTo(Real(), hn::ShiftRight<52>(hn::BitCast(Whole(), beyond)));
    auto const z = hn::BitCast(Real(), hn::Sub(bits, hn::And(beyond, hn::Set(Word(), 0xfffULL << 52U))));
    auto const part_of = hn::And(hn::ShiftRight<45>(beyond), hn::Set(Word(), rows.size() / columns - 1));
    auto const row = hn::BitCast(Whole(), hn::ShiftLeft<2>(part_of));
    auto const column = [&](std::size_t i) { return hn::GatherIndex(Real(), rows.data() + i, row); };
    auto const r = hn::Mul(hn::Sub(hn::Sub(z, column(2)), column(3)), column(0));
    auto const r2 = hn::Mul(r, r);
    auto const w = hn::Add(hn::Mul(k, real(ln2_high)), column(1));
    auto const high = hn::Add(w, r);
    auto const low = hn::Add(hn::Add(hn::Sub(w, high), r), hn::Mul(k, real(ln2_low)));
    auto const last = hn::Add(real(part[3]), hn::Mul(r, real(part[4])));
    auto const inner = hn::Add(hn::Add(real(part[1]), hn::Mul(r, real(part[2]))), hn::Mul(r2, last));
    auto const y = hn::Add(hn::Add(low, hn::Mul(r2, real(part[0]))), hn::Mul(hn::Mul(r, r2), inner));
    auto const value = hn::Add(y, high);
    auto const close = hn::Ge(x, real(near));
    return hn::AllFalse(Real(), close) ? value : hn::IfThenElse(close, log_near_one(x), value);
}

void fill_scatters(std::span<double const> numbers, double* scatters) {
    constexpr auto lanes = hn::MaxLanes(Real());
    auto const sigma = real(std::sqrt(0.5));
    for (std::size_t i = 0; i < numbers.size(); i += lanes) {
        auto const twice = hn::Mul(real(-2), log_of(hn::LoadU(Real(), numbers.data() + i)));
        hn::StoreU(hn::Mul(sigma, hn::Sqrt(twice)), Real(), scatters + i);
    }
}

}  // namespace overturn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overturn {

HWY_EXPORT(fill_turns);
HWY_EXPORT(fill_scatters);

namespace {

constexpr std::size_t together = 8 * simd::words_together;  // lines

// The next number above 0 and below 1, as gsl_rng_uniform_pos has it.
double next_above_zero(simd::StreamWords& words) {
    for (;;) {
        if (auto const number = static_cast<double>(words.next() >> 11U) * 0x1p-53; number > 0) {
            return number;
        }
    }
}

}  // namespace

void turns_of(std::span<std::uint64_t const> words, std::complex<double>* turns) {
    OVERTURN_EXPECT(words.size() % simd::words_together == 0);
    HWY_DYNAMIC_DISPATCH(fill_turns)(words, turns);
}

void scatters_of(std::span<double const> numbers, double* scatters) {
    OVERTURN_EXPECT(numbers.size() % simd::counters_together == 0);
    HWY_DYNAMIC_DISPATCH(fill_scatters)(numbers, scatters);
}

Lines draw_lines(LineStreams const& streams, std::span<double const> amplitude, LineAmplitudes kind) {
    Lines lines(amplitude.size());
    simd::StreamWords scatters(streams.amplitudes);
    bool const gaussian = kind == LineAmplitudes::gaussian;
    std::array<double, together> numbers;
    std::array<double, together> scatter;
    numbers.fill(0.5);
    scatter.fill(1);
    std::array<std::uint64_t, together> words;
    std::array<std::complex<double>, together> turns;
    for (std::size_t first = 1; first < lines.size(); first += together) {
        simd::stream_words(streams.phases, first / 4, words);
        turns_of(words, turns.data());
        auto const count = std::min(together, lines.size() - first);
        if (gaussian) {
            std::generate_n(numbers.begin(), count, [&] { return next_above_zero(scatters); });
            scatters_of(numbers, scatter.data());
        }
        for (std::size_t i = 0; i < count; ++i) {
            double const size = scatter[i] * amplitude[first + i];
            lines[first + i] = {size * turns[i].real(), size * turns[i].imag()};
        }
    }
    return lines;
}

Lines lines_of_normals(std::span<double const> normals, std::span<double const> amplitude, LineAmplitudes kind) {
    Lines lines(amplitude.size());
    for (std::size_t k = 1; k <= normals.size() / 2; ++k) {
        std::complex<double> const z(normals[2 * k - 2], normals[2 * k - 1]);
        lines[k] = amplitude[k] * (kind == LineAmplitudes::gaussian ? z * std::sqrt(0.5) : z / std::abs(z));
    }
    return lines;
}

}  // namespace overturn
#endif
