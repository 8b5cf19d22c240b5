/// Design spectra as the web services of the USGS answer them (ASCE 7, AASHTO): JSON.
#pragma once

#include <string>
#include <string_view>

namespace overturn {

/// Does the text begin as a JSON object does?
[[nodiscard]] bool is_json(std::string_view content);

/// One spectrum of the object as a table "T (s),Sa (g)" (without a unit where no document of the USGS is named, which
/// states ordinates in g). Spectra are arrays `periods` and `ordinates` side by side, or an array of pairs whose name
/// holds "spectrum". \param part its name; empty: the only one
/// \throws InputError at what is no JSON, without a spectrum, without that part, or with several and no part
[[nodiscard]] std::string table_of_design_json(std::string_view content, std::string const& name,
                                               std::string const& part);

}  // namespace overturn
