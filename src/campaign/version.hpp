/// What made a results file: this program and the libraries whose numbers go into it.
#pragma once

#include <string>

namespace overturn {

[[nodiscard]] std::string program_version();
[[nodiscard]] std::string git_revision();
/// "0.1.0 (f46588f980a6)"
[[nodiscard]] std::string program_identity();
/// "GSL 2.7.1, HDF5 1.10.8, ..."
[[nodiscard]] std::string library_versions();

}  // namespace overturn
