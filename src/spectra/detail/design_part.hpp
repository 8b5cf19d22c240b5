/// One spectrum of several that a file holds, as the user names it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace overturn {

/// Place of the spectrum called `part` among `names`; part empty: the only one.
/// \param what the names are, for messages: "spectra" \throws InputError, naming all
[[nodiscard]] std::size_t part_among(std::vector<std::string> const& names, std::string const& part,
                                     std::string_view what, Location const& where);

/// One ordinate of a table with a period or a frequency and several ordinates beside it, under their names: a table of
/// two columns, each row on its line of the file. \param part its name, with the unit in brackets or without
/// \return nothing where names stand over two columns, or over none \throws InputError at rows of another length, and
/// as part_among does
[[nodiscard]] std::optional<std::string> table_of_one_ordinate(std::string_view content, std::string const& name,
                                                               std::string const& part);

}  // namespace overturn
