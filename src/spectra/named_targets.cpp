#include "spectra/named_targets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/units.hpp"

namespace overturn {
namespace {

// The notice prints Sa in cm/s2.
TargetSpectrum mlit(std::string name, NamedTargetInput const& input, std::vector<TargetBranch> branches_gal) {
    validate(input.damping == 0.05, "damping {} of '{}' (defined for 0.05 only). Set damping = 0.05 or give a table",
             input.damping, name);
    validate(!input.pga_mps2, "pga of '{}' (it has a scale of its own). Use scale instead", name);
    constexpr double gal = 0.01;
    for (auto& branch : branches_gal) {
        branch.constant *= gal;
        branch.slope *= gal;
        branch.inverse *= gal;
    }
    return {std::move(name), input.damping, 0, std::move(branches_gal)};
}

TargetSpectrum mlit_ch1(NamedTargetInput const& input) {
    return mlit("mlit-ch1", input,
                {{.to_s = 0.16, .constant = 320, .slope = 3000},
                 {.to_s = 1.28, .constant = 800},
                 {.to_s = 4, .inverse = 1024},
                 {.to_s = 8, .constant = -128, .inverse = 1536},
                 {.to_s = 10, .inverse = 512}});
}

TargetSpectrum mlit_sz1(NamedTargetInput const& input) {
    return mlit("mlit-sz1", input,
                {{.to_s = 0.16, .constant = 320, .slope = 3000},
                 {.to_s = 1.28, .constant = 800},
                 {.to_s = 3.5, .inverse = 1024},
                 {.to_s = 5.5, .constant = -256, .inverse = 1920},
                 {.to_s = 10, .inverse = 512}});
}

TargetSpectrum mlit_ka1(NamedTargetInput const& input) {
    return mlit("mlit-ka1", input,
                {{.to_s = 0.16, .constant = 51.2, .slope = 480},
                 {.to_s = 2, .constant = 128},
                 {.to_s = 4, .inverse = 256},
                 {.to_s = 6, .constant = 128, .inverse = -256},
                 {.to_s = 8, .inverse = 512},
                 {.to_s = 10, .constant = -64, .inverse = 1024}});
}

TargetSpectrum mlit_os1(NamedTargetInput const& input) {
    return mlit("mlit-os1", input,
                {{.to_s = 0.16, .constant = 256, .slope = 2400},
                 {.to_s = 1.1, .constant = 640},
                 {.to_s = 3, .inverse = 704},
                 {.to_s = 5, .constant = 160, .inverse = 224},
                 {.to_s = 7.5, .inverse = 1024},
                 {.to_s = 10, .constant = -204.8, .inverse = 2560}});
}

TargetSpectrum mlit_sz2(NamedTargetInput const& input) {
    return mlit("mlit-sz2", input,
                {{.to_s = 0.16, .constant = 320, .slope = 3000},
                 {.to_s = 0.96, .constant = 800},
                 {.to_s = 3.5, .inverse = 768},
                 {.to_s = 5, .constant = -256, .inverse = 1664},
                 {.to_s = 10, .inverse = 384}});
}

TargetSpectrum mlit_sz3(NamedTargetInput const& input) {
    return mlit("mlit-sz3", input,
                {{.to_s = 0.16, .constant = 320, .slope = 3000},
                 {.to_s = 0.64, .constant = 800},
                 {.to_s = 3.5, .inverse = 512},
                 {.to_s = 4.5, .constant = -256, .inverse = 1408},
                 {.to_s = 10, .inverse = 256}});
}

TargetSpectrum mlit_ch2(NamedTargetInput const& input) {
    return mlit("mlit-ch2", input,
                {{.to_s = 0.16, .constant = 320, .slope = 3000},
                 {.to_s = 0.96, .constant = 800},
                 {.to_s = 3.5, .inverse = 768},
                 {.to_s = 6.5, .constant = -128, .inverse = 1216},
                 {.to_s = 10, .inverse = 384}});
}

TargetSpectrum mlit_os2(NamedTargetInput const& input) {
    return mlit("mlit-os2", input,
                {{.to_s = 0.16, .constant = 256, .slope = 2400},
                 {.to_s = 0.9, .constant = 640},
                 {.to_s = 3, .inverse = 576},
                 {.to_s = 4.5, .constant = 128, .inverse = 192},
                 {.to_s = 7, .inverse = 768},
                 {.to_s = 9, .constant = -128, .inverse = 1664}});
}

// Tables I and II: amplification at 9 Hz and at the corner (2.5 Hz horizontal, 3.5 Hz vertical) of the horizontal
// ground acceleration, and at 0.25 Hz of the horizontal ground displacement.
struct Amplification {
    double damping, at_9, at_corner, at_0_25;
};
constexpr std::array horizontal_amplifications{
    Amplification{0.005, 4.96, 5.95, 3.20}, Amplification{0.02, 3.54, 4.25, 2.50},
    Amplification{0.05, 2.61, 3.13, 2.05}, Amplification{0.07, 2.27, 2.72, 1.88},
    Amplification{0.10, 1.90, 2.28, 1.70}};
constexpr std::array vertical_amplifications{
    Amplification{0.005, 4.96, 5.67, 2.13}, Amplification{0.02, 3.54, 4.05, 1.67},
    Amplification{0.05, 2.61, 2.98, 1.37}, Amplification{0.07, 2.27, 2.59, 1.25},
    Amplification{0.10, 1.90, 2.17, 1.13}};

TargetSpectrum rg_1_60(std::string name, NamedTargetInput const& input, std::span<Amplification const> rows,
                       double corner_hz) {
    auto const row = std::find_if(rows.begin(), rows.end(),
                                  [&](Amplification const& a) { return std::abs(a.damping - input.damping) < 1e-9; });
    validate(row != rows.end(), "damping {} of '{}' (tabulated: 0.005, 0.02, 0.05, 0.07, 0.1). Use one", input.damping,
             name);
    double const pga = input.pga_mps2.value_or(g0);
    constexpr double displacement_per_g = 36 * 0.0254;  // 36 inches for 1 g
    double const w = 2 * pi * 0.25;
    double const at_4s = w * w * row->at_0_25 * displacement_per_g * pga / g0;
    std::array<std::pair<double, double>, 6> const points{{{0.01, pga},
                                                           {1 / 33.0, pga},
                                                           {1 / 9.0, row->at_9 * pga},
                                                           {1 / corner_hz, row->at_corner * pga},
                                                           {4.0, at_4s},
                                                           {10.0, at_4s * 0.16}}};
    return TargetSpectrum::from_points(std::move(name), input.damping, TargetKind::acceleration, points);
}

TargetSpectrum rg_1_60_horizontal(NamedTargetInput const& input) {
    return rg_1_60("rg-1.60", input, horizontal_amplifications, 2.5);
}

TargetSpectrum rg_1_60_vertical(NamedTargetInput const& input) {
    return rg_1_60("rg-1.60-vertical", input, vertical_amplifications, 3.5);
}

}  // namespace

std::span<config::Entry<NamedTarget> const> named_targets() {
    static constexpr std::array entries{
        config::Entry<NamedTarget>{"mlit-ch1", "MLIT 2016 long-period wave, Chukyo area 1, 5 %", &mlit_ch1},
        config::Entry<NamedTarget>{"mlit-ch2", "MLIT 2016 long-period wave, Chukyo area 2, 5 %", &mlit_ch2},
        config::Entry<NamedTarget>{"mlit-sz1", "MLIT 2016 long-period wave, Shizuoka area 1, 5 %", &mlit_sz1},
        config::Entry<NamedTarget>{"mlit-sz2", "MLIT 2016 long-period wave, Shizuoka area 2, 5 %", &mlit_sz2},
        config::Entry<NamedTarget>{"mlit-sz3", "MLIT 2016 long-period wave, Shizuoka area 3, 5 %", &mlit_sz3},
        config::Entry<NamedTarget>{"mlit-ka1", "MLIT 2016 long-period wave, Kanto area 1, 5 %", &mlit_ka1},
        config::Entry<NamedTarget>{"mlit-os1", "MLIT 2016 long-period wave, Osaka area 1, 5 %", &mlit_os1},
        config::Entry<NamedTarget>{
            "mlit-os2",
            "MLIT 2016 long-period wave, Osaka area 2, 5 %, to 9 s only (its last branch, CH3 and "
            "OS3 could not be consulted)",
            &mlit_os2},
        config::Entry<NamedTarget>{"rg-1.60", "US NRC Regulatory Guide 1.60 rev. 1, horizontal, pga 1 g",
                                   &rg_1_60_horizontal},
        config::Entry<NamedTarget>{"rg-1.60-vertical",
                                   "US NRC Regulatory Guide 1.60 rev. 1, vertical, for a horizontal pga of 1 g",
                                   &rg_1_60_vertical},
    };
    return entries;
}

bool is_scaled_by_pga(std::string_view name) { return name == "rg-1.60" || name == "rg-1.60-vertical"; }

}  // namespace overturn
