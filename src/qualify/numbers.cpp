#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <gsl/gsl_cdf.h>

#include "campaign/version.hpp"
#include "core/random_stream.hpp"
#include "qualify/known_answers.hpp"
#include "stats/hazard.hpp"
#include "stats/proportion.hpp"
#include "store/sha256.hpp"

namespace overturn::qualify {
namespace {

Check frequency() {
    constexpr double k0 = 1e-4, k = 2.5, median = 1.7, beta = 0.4;
    HazardCurve const power_law({{1e-8, k0 * std::pow(1e-8, -k)}, {1e8, k0 * std::pow(1e8, -k)}});
    double const found = annual_frequency(power_law, {median, beta}).annual;
    double const expected = k0 * std::pow(median, -k) * std::exp(k * k * beta * beta / 2);
    return {"N-02",         "annual frequency under a power-law hazard", "Cornell (1996)", "1/a", found, expected,
            1e-6 * expected};
}

Check random_stream() {
    RandomStream stream(0, 0, Purpose::wave_phase, 0);
    constexpr std::array<std::uint64_t, 4> known{0x09218ebde6c85537U, 0x55941f5266d86105U, 0x4bd25e16282434dcU,
                                                 0xee29ec846bd2e40bU};
    int wrong = 0;
    for (auto const word : known) {
        wrong += stream.bits() != word ? 1 : 0;
    }
    return {"N-03",
            "random words are Threefry4x64-20's",
            "Salmon et al. (2011), known answers",
            "words that differ",
            static_cast<double>(wrong),
            0,
            0};
}

Check hash() {
    bool const right = store::sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
    return {"N-04", "SHA-256 of \"abc\"", "FIPS 180-4", "hashes that differ", right ? 0.0 : 1.0, 0, 0};
}

// Their last bits decide whether two machines give one file.
Check elementary_functions() {
    constexpr char const* known = "8573ba8eb7ec405bc98f8e2b49ebd9a8833d7f16b50c01a62909771a68fb9bda";
    std::vector<double> values;
    for (int i = 1; i <= 4000; ++i) {
        double const x = 1e-3 * i * (1 + 1e-7 * i);
        for (double const value : {std::sin(7 * x), std::cos(7 * x), std::tan(x / 3), std::exp(x - 2), std::log(x),
                                   std::pow(x, 1.7), std::atan2(x, 2 - x)}) {
            values.push_back(value);
        }
    }
    std::string bytes(values.size() * sizeof(double), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    auto const found = store::sha256(bytes);
    Check check{"N-05",
                "28 000 values of sin, cos, tan, exp, log, pow and atan2, to the last bit",
                "musl's libm",
                "hashes that differ",
                found == known ? 0.0 : 1.0,
                0,
                0};
    check.remark = found == known ? "" : "SHA-256 " + found;
    return check;
}

}  // namespace

Checks numbers() {
    constexpr int trials = 40;
    constexpr double confidence = 0.95;
    return {{"N-01", "upper 95 % bound of P after 0 of 40", "Clopper and Pearson (1934)", "1",
             clopper_pearson(0, trials, confidence).upper, 1 - std::pow((1 - confidence) / 2, 1.0 / trials), 1e-12},
            frequency(),
            random_stream(),
            hash(),
            elementary_functions(),
            {"N-06", "97.5 % point of the normal distribution", "tables", "1", gsl_cdf_ugaussian_Pinv(0.975),
             1.959963984540054, 1e-14}};
}

}  // namespace overturn::qualify
