// Logarithm, exponential, sine and cosine of registers of doubles, by multiplication and addition alone: the same bits
// on every instruction set, unlike those of the C library. Included once per instruction set.
#if defined(OVERTURN_RARE_FUNCTIONS) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERTURN_RARE_FUNCTIONS
#undef OVERTURN_RARE_FUNCTIONS
#else
#define OVERTURN_RARE_FUNCTIONS
#endif

#include <array>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace overturn::rare::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Real = hn::ScalableTag<double>;
using Word = hn::ScalableTag<std::uint64_t>;
using Reals = hn::Vec<Real>;
using Words = hn::Vec<Word>;

inline constexpr std::uint64_t bits_of_one = 0x3FF0000000000000U;
inline constexpr std::uint64_t bits_of_half = 0x3FE0000000000000U;
inline constexpr std::uint64_t mantissa_bits = 0x000FFFFFFFFFFFFFU;
inline constexpr double whole_number = 0x1.8p52;  // a number that is added to it is rounded to a whole one

HWY_INLINE Reals real(double x) { return hn::Set(Real(), x); }

// c[0] + x (c[1] + x (c[2] + ...)).
template <std::size_t N> HWY_INLINE Reals series(Reals x, std::array<double, N> const& c) {
    auto sum = real(c[N - 1]);
    for (std::size_t i = N - 1; i-- > 0;) {
        sum = hn::Add(hn::Mul(sum, x), real(c[i]));
    }
    return sum;
}

/// Logarithm of numbers in (0, 1]: x = 2^e m, m in [sqrt(1/2), sqrt 2), log m = 2 artanh((m - 1)/(m + 1)), whose series
/// is cut where its next term is below 2e-17 of the first.
HWY_INLINE Reals log_of(Reals x) {
    auto const word = hn::BitCast(Word(), x);
    // The exponent's bits, put into the mantissa of 2^52, are its value.
    auto const biased = hn::BitCast(Real(), hn::Or(hn::ShiftRight<52>(word), hn::Set(Word(), 0x4330000000000000U)));
    auto exponent = hn::Sub(biased, real(0x1p52 + 1022));
    auto m = hn::BitCast(Real(), hn::Or(hn::And(word, hn::Set(Word(), mantissa_bits)), hn::Set(Word(), bits_of_half)));
    auto const low = hn::Lt(m, real(0.70710678118654752440));
    m = hn::IfThenElse(low, hn::Add(m, m), m);
    exponent = hn::IfThenElse(low, hn::Sub(exponent, real(1)), exponent);
    auto const s = hn::Div(hn::Sub(m, real(1)), hn::Add(m, real(1)));
    auto const z = hn::Mul(s, s);
    static constexpr std::array odd{2.0,      2.0 / 3,  2.0 / 5,  2.0 / 7,  2.0 / 9,
                                    2.0 / 11, 2.0 / 13, 2.0 / 15, 2.0 / 17, 2.0 / 19};
    return hn::Add(hn::Mul(exponent, real(0.69314718055994530942)), hn::Mul(s, series(z, odd)));
}

/// Exponential of numbers in [-700, 700]: 2^k exp(r), |r| <= log(2)/2, whose series is cut where its next term is below
/// 1e-17.
HWY_INLINE Reals exp_of(Reals x) {
    auto const shifted = hn::Add(hn::Mul(x, real(1.44269504088896340736)), real(whole_number));
    auto const k = hn::Sub(shifted, real(whole_number));
    // log 2 in two parts: the first has so few bits that its product with k is exact.
    auto const r = hn::Sub(hn::Sub(x, hn::Mul(k, real(0x1.62e42fefa38p-1))), hn::Mul(k, real(0x1.ef35793c7673p-45)));
    static constexpr std::array factorials{
        1.0,        1.0,         1.0 / 2,      1.0 / 6,       1.0 / 24,       1.0 / 120,       1.0 / 720,
        1.0 / 5040, 1.0 / 40320, 1.0 / 362880, 1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800};
    auto const power = hn::BitCast(
        Real(), hn::ShiftLeft<52>(hn::Add(hn::BitCast(Word(), shifted), hn::Set(Word(), std::uint64_t{1023}))));
    return hn::Mul(series(r, factorials), power);
}

struct Turn {
    Reals cosine, sine;
};

/// Sine and cosine of 2 pi v, v in [0, 1]: by quarters of a turn, the rest in [-pi/4, pi/4].
HWY_INLINE Turn turn_of(Reals v) {
    auto const shifted = hn::Add(hn::Mul(v, real(4)), real(whole_number));
    auto const quarter = hn::BitCast(Word(), shifted);
    auto const rest = hn::Sub(v, hn::Mul(hn::Sub(shifted, real(whole_number)), real(0.25)));
    auto const a = hn::Mul(rest, real(6.28318530717958647693));
    auto const z = hn::Mul(a, a);
    static constexpr std::array odd{1.0,          -1.0 / 6,        1.0 / 120,          -1.0 / 5040,
                                    1.0 / 362880, -1.0 / 39916800, 1.0 / 6227020800.0, -1.0 / 1307674368000.0};
    static constexpr std::array even{1.0,
                                     -1.0 / 2,
                                     1.0 / 24,
                                     -1.0 / 720,
                                     1.0 / 40320,
                                     -1.0 / 3628800,
                                     1.0 / 479001600.0,
                                     -1.0 / 87178291200.0,
                                     1.0 / 20922789888000.0};
    auto const s = hn::Mul(a, series(z, odd));
    auto const c = series(z, even);
    auto const swaps = hn::Eq(hn::And(quarter, hn::Set(Word(), std::uint64_t{1})), hn::Set(Word(), std::uint64_t{1}));
    auto const across = hn::RebindMask(Real(), swaps);
    auto const sign_of = [](Words bit) { return hn::BitCast(Real(), hn::ShiftLeft<62>(bit)); };
    auto const two = hn::Set(Word(), std::uint64_t{2});
    // sine: minus in quarters 2 and 3; cosine: minus in 1 and 2.
    auto const sine_sign = sign_of(hn::And(quarter, two));
    auto const cosine_sign = sign_of(hn::And(hn::Add(quarter, hn::Set(Word(), std::uint64_t{1})), two));
    return {hn::Xor(hn::IfThenElse(across, s, c), cosine_sign), hn::Xor(hn::IfThenElse(across, c, s), sine_sign)};
}

}  // namespace overturn::rare::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
