/// Peak tilt of blocks of many sizes under one record: as text, JSON and csv.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "campaign/text_units.hpp"
#include "model/verdict.hpp"
#include "output/json.hpp"

namespace overturn::output {

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
    std::vector<std::string> left_out = {};  ///< what the body's file states and its block has not
    double pga_mps2 = 0;
    TypedUnits units = {};  ///< of texts, and beside SI in JSON
    std::vector<RockingCurve> curves;
};

[[nodiscard]] Json json_of(RockingSpectrum const& spectrum);
/// A row per block.
[[nodiscard]] std::string csv_of(RockingSpectrum const& spectrum);
/// Rotations are rounded up.
[[nodiscard]] std::string text_of(RockingSpectrum const& spectrum);

}  // namespace overturn::output
