/// Amplitudes of a pulse that overturn a body, over its frequency, or factors on a record that do: as text, JSON and
/// csv.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "campaign/text_units.hpp"
#include "generators/pulse_shape.hpp"
#include "output/json.hpp"
#include "rocking/overturning_search.hpp"

namespace overturn::output {

/// One frequency of a pulse, or the record.
struct OverturningPoint {
    double frequency_hz = 0;  ///< 0: of a record
    OverturningRanges found;  ///< factors on a peak of 1 m/s2, or on the record
};

struct OverturningSpectrum {
    std::string body, shaking;
    std::vector<std::string> left_out = {};     ///< what the body's file states and the block has not
    std::optional<PulseParameters> parameters;  ///< of a pulse that has some
    std::optional<int> half_cycles = {};        ///< of a pulse whose linearised block has a closed form
    RockingBlock block;
    OverturningScan scan;
    double peak_mps2 = 1;  ///< that a factor of 1 stands for: PGA of the record
    bool of_record = false;
    TypedUnits units = {};  ///< of texts, and beside SI in JSON
    std::vector<OverturningPoint> points;

    [[nodiscard]] double omega_over_p(OverturningPoint const& point) const;
    [[nodiscard]] double alpha_g_mps2() const { return block.alpha_rad * block.gravity_mps2; }
};

[[nodiscard]] Json json_of(OverturningSpectrum const& spectrum);
/// A row per range.
[[nodiscard]] std::string csv_of(OverturningSpectrum const& spectrum);
/// Ends are rounded so that ranges that overturn only grow.
[[nodiscard]] std::string text_of(OverturningSpectrum const& spectrum);

}  // namespace overturn::output
