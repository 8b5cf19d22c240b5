/// Target spectra that standards publish, under the names a campaign calls them.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "config/registry.hpp"
#include "spectra/target_spectrum.hpp"

namespace overturn {

/// A campaign's choices for a published spectrum.
struct NamedTargetInput {
    double damping = 0.05;           ///< ratio to critical [-]
    std::optional<double> pga_mps2;  ///< peak ground acceleration of spectra that are printed for 1 g [m/s2]
};

using NamedTarget = TargetSpectrum (*)(NamedTargetInput const&);

/// mlit-ka1, -sz1 to -sz3, -ch1, -ch2, -os1, -os2: long-period design waves of the Japanese ministry (MLIT, notice
/// Kokujushi 1111 of 2016, annex 2, appendix 2: Sa of ten areas at the free surface of engineering bedrock), 5 %, to
/// 10 s; os2 ends at 9 s, since its last branch could not be consulted, and ch3 and os3 are missing for that reason.
/// rg-1.60, rg-1.60-vertical: US NRC Regulatory Guide 1.60 rev. 1 (1973), tables I and II, 0.5, 2, 5, 7 or 10 %, 0.01 s
/// to 10 s; pga is the horizontal one for both.
/// \throws InputError for a damping that is not tabulated, or a pga where the spectrum has a scale of its own.
[[nodiscard]] std::span<config::Entry<NamedTarget> const> named_targets();

/// Is the spectrum of that name printed for a peak ground acceleration of 1 g, to be scaled by pga?
[[nodiscard]] bool is_scaled_by_pga(std::string_view name);

}  // namespace overturn
