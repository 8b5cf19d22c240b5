/// Times as batch systems spell them.
#pragma once

#include <string>

namespace overturn::cli {

/// "50 min", "1h", "90" (s), and Slurm's MM:SS, HH:MM:SS, D-HH, D-HH:MM, D-HH:MM:SS. [s]
/// \throws InputError if it is none of these or not above 0
[[nodiscard]] double parse_walltime(std::string const& text);

}  // namespace overturn::cli
