/// A record as it was read, and its spectra, in words and as JSON.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "campaign/intensity_measure.hpp"
#include "campaign/rocking_band.hpp"
#include "campaign/text_units.hpp"
#include "motion/drift.hpp"
#include "motion/intensity.hpp"
#include "motion/recording.hpp"
#include "output/json.hpp"
#include "output/shown_velocity.hpp"
#include "spectra/response_spectrum.hpp"
#include "spectra/window_energy.hpp"

namespace overturn::output {

/// Name of a measure's column with its unit: "cav_mps".
[[nodiscard]] std::string key_of(IntensityMeasure const& measure);

/// Units for texts on a record: those of the body's file, and where that states no acceleration, the unit of the
/// record's numbers if it has a name. \param body without one: its defaults
[[nodiscard]] TypedUnits units_of(PlacedRecord const& record, TypedUnits const& body = {});

/// Facts of a record as it was read, for `record` of a JSON answer: format, components, unit, time step, samples,
/// duration and changes. A reader of the JSON can check the record by them.
[[nodiscard]] Json record_json(PlacedRecord const& record);

/// What a record offers a body.
struct BodyEnergy {
    PeriodBand band;
    WindowEnergy restarted, running;
    double v_ereq_mps;
};

/// Figures and spectra of a record.
struct RecordSpectra {
    Intensity intensity;
    Drift drift;
    double damping;  ///< of all but v_e0_mps, which is undamped
    ResponseSpectrum response;
    std::vector<double> v_e_mps, v_e0_mps;
    std::optional<BodyEnergy> energy = {};
    TypedUnits units = {};  ///< of texts, and beside SI in JSON
};

[[nodiscard]] Json json_of(PlacedRecord const& record, RecordSpectra const& spectra);
/// \param unit of velocities \param every period of this number has a row
[[nodiscard]] std::string text_of(PlacedRecord const& record, RecordSpectra const& spectra, ShownVelocity const& unit,
                                  std::size_t every);

}  // namespace overturn::output
