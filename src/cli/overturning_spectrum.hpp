/// `overturn spectrum --overturning`: which amplitudes of a pulse overturn a body, over its frequency, or which factors
/// on a record do.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/command_line.hpp"
#include "cli/scene_files.hpp"
#include "rocking/overturning_search.hpp"

namespace overturn::cli {

struct OverturningOptions {
    bool asked = false;
    std::string alpha, pulse, phase, ratios, frequencies, output;
    std::optional<double> p, restitution, gamma;
    double highest = 30, step = 0.01;
    bool linearised = false;

    void offered_by(Verb& verb);
    /// Whether anything is stated that has no meaning without `asked`.
    [[nodiscard]] bool states_more() const;
    /// Whether anything is stated that a rocking spectrum does not take.
    [[nodiscard]] bool has_pulse_or_scan() const;
};

/// One frequency of a pulse, or the record.
struct OverturningPoint {
    double frequency_hz = 0;  ///< 0: of a record
    OverturningRanges found;  ///< factors on a peak of 1 m/s2, or on the record
};

struct OverturningSpectrum {
    std::string body, shaking;
    RockingBlock block;
    OverturningScan scan;
    double peak_mps2 = 1;  ///< that a factor of 1 stands for: PGA of the record
    bool of_record = false;
    std::vector<OverturningPoint> points;

    [[nodiscard]] double omega_over_p(OverturningPoint const& point) const;
    [[nodiscard]] double alpha_g_mps2() const { return block.alpha_rad * block.gravity_mps2; }
};

/// \param record used where no pulse is stated \param body a body file; empty: p, alpha and restitution are stated
/// \throws InputError
[[nodiscard]] OverturningSpectrum overturning_spectrum(OverturningOptions const& options, RecordOptions const& record,
                                                       std::string const& body);

[[nodiscard]] nlohmann::ordered_json json_of(OverturningSpectrum const& spectrum);
/// A row per range.
[[nodiscard]] std::string csv_of(OverturningSpectrum const& spectrum);
/// Ends are rounded so that ranges that overturn only grow.
[[nodiscard]] std::string text_of(OverturningSpectrum const& spectrum);

}  // namespace overturn::cli
