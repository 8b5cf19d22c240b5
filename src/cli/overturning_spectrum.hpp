/// `overturn spectrum --overturning`: which amplitudes of a pulse overturn a body, over its frequency, or which factors
/// on a record do.
#pragma once

#include <optional>
#include <string>

#include "cli/command_line.hpp"
#include "cli/scene_files.hpp"
#include "output/overturning_text.hpp"

namespace overturn::cli {

struct OverturningOptions {
    bool asked = false;
    std::string alpha, pulse, phase, ratios, frequencies, output;
    std::optional<double> p, restitution, gamma, highest, step;
    bool linearised = false;

    void offered_by(Verb& verb);
    /// Whether anything is stated that has no meaning without `asked`.
    [[nodiscard]] bool states_more() const;
    /// Whether anything is stated that a rocking spectrum does not take.
    [[nodiscard]] bool has_pulse_or_scan() const;
};

/// \param record used where no pulse is stated \param body a body file; empty: p, alpha and restitution are stated
/// \throws InputError
[[nodiscard]] output::OverturningSpectrum overturning_spectrum(OverturningOptions const& options,
                                                               RecordOptions const& record, std::string const& body);

}  // namespace overturn::cli
