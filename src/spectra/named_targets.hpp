/// Target spectra that standards publish, under the names a campaign calls them.
#pragma once

#include <optional>
#include <span>

#include "config/registry.hpp"
#include "spectra/target_spectrum.hpp"

namespace overturn {

/// What a campaign may choose about a published spectrum.
struct NamedTargetInput {
    double damping = 0.05;           ///< ratio to critical [-]
    std::optional<double> pga_mps2;  ///< peak ground acceleration of spectra that are printed for 1 g [m/s2]
};

using NamedTarget = TargetSpectrum (*)(NamedTargetInput const&);

/// mlit-ch1, -sz1, -ka1, -os1: long-period design waves of the Japanese ministry (MLIT 2016), engineering bedrock, 5 %,
/// to 10 s. rg-1.60: US NRC Regulatory Guide 1.60 rev. 1 (1973), horizontal, 0.5, 2, 5, 7 or 10 %, 0.01 s to 10 s.
/// \throws InputError for a damping that is not tabulated, or a pga where the spectrum has a scale of its own.
[[nodiscard]] std::span<config::Entry<NamedTarget> const> named_targets();

}  // namespace overturn
