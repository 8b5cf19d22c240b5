/// `overturn spectrum --rocking`: how far blocks tilt under one record, over their size and slenderness.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/command_line.hpp"
#include "cli/scene_files.hpp"
#include "model/verdict.hpp"

namespace overturn::cli {

struct RockingSpectrumOptions {
    bool asked = false;
    std::string periods;  ///< 2 pi / p [s], as number_grid takes them

    void offered_by(Verb& verb);
};

/// Blocks of one slenderness and restitution.
struct RockingCurve {
    double alpha_rad = 0, restitution = 1;
    struct Point {
        double period_s = 0;           ///< 2 pi / p
        double peak_rotation_rad = 0;  ///< of one that neither overturned nor left the ground
        Verdict verdict = Verdict::at_rest;
    };
    std::vector<Point> points;
};

struct RockingSpectrum {
    std::string body, record;  ///< body: empty where angles are stated
    std::optional<double> body_period_s = {};
    double pga_mps2 = 0;
    std::vector<RockingCurve> curves;
};

/// Rigid blocks on two corners, in one plane, without slip, at rest (Makris and Konstantinidis 2003).
/// \param alphas "10 deg,15 deg"; empty with a body \param restitution of all; none: 1 - 3/2 sin^2(alpha) (Housner
/// 1963) \param body a body file, or empty \throws InputError
[[nodiscard]] RockingSpectrum rocking_spectrum(RockingSpectrumOptions const& options, RecordOptions const& record,
                                               std::string const& alphas, std::optional<double> restitution,
                                               std::string const& body);

[[nodiscard]] nlohmann::ordered_json json_of(RockingSpectrum const& spectrum);
/// A row per block.
[[nodiscard]] std::string csv_of(RockingSpectrum const& spectrum);
/// Rotations are rounded up.
[[nodiscard]] std::string text_of(RockingSpectrum const& spectrum);

}  // namespace overturn::cli
