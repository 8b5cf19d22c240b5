/// `overturn spectrum --rocking`: how far blocks tilt under one record, over their size and slenderness.
#pragma once

#include <optional>
#include <string>

#include "cli/command_line.hpp"
#include "cli/scene_files.hpp"
#include "output/rocking_text.hpp"

namespace overturn::cli {

struct RockingSpectrumOptions {
    bool asked = false;
    std::string periods;  ///< 2 pi / p [s], as number_grid takes them

    void offered_by(Verb& verb);
};

/// Rigid blocks on two corners, in one plane, without slip, at rest (Makris and Konstantinidis 2003).
/// \param alphas "10 deg,15 deg"; empty with a body \param restitution of all; none: 1 - 3/2 sin^2(alpha) (Housner
/// 1963) \param body a body file, or empty \throws InputError
[[nodiscard]] output::RockingSpectrum rocking_spectrum(RockingSpectrumOptions const& options,
                                                       RecordOptions const& record, std::string const& alphas,
                                                       std::optional<double> restitution, std::string const& body);

}  // namespace overturn::cli
