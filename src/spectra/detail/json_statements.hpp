/// Keys and values beside a spectrum in JSON, as the lines of text that a table would have above it.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "spectra/target_spectrum.hpp"

namespace overturn {

/// The key's words in lower case, one blank between: "dampingRatio" is "damping ratio".
[[nodiscard]] std::string words_of_key(std::string_view key);

/// Does the name of a spectrum say more than that it is one: "verticalSpectrum", "floor", "displacement_spectrum"?
[[nodiscard]] bool tells_of_spectrum(std::string_view words);

struct JsonStatement {
    std::string text;  ///< "units: g", "damping 0.02", "component: vertical"; empty: no statement on the spectrum
    std::string period_unit;  ///< "ms", where it says that
};

/// \param keys that lead to `value` from what holds the spectrum, the innermost last \param value no object
/// \param kind of the ordinates: units of other quantities are not theirs
[[nodiscard]] JsonStatement json_statement(std::span<std::string const> keys, nlohmann::ordered_json const& value,
                                           TargetKind kind);

}  // namespace overturn
