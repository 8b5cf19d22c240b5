/// Identity of the program that made a results file, and of the libraries whose numbers go into it.
#pragma once

#include <string>

namespace overturn {

[[nodiscard]] std::string program_version();
[[nodiscard]] std::string git_revision();
/// SHA-256 over all that was compiled, whether git knows it or not.
[[nodiscard]] std::string sources_sha256();
/// "1.0.0 (f46588f980a6, sources 1b2c3d4e5f60)": equal for equal sources only.
[[nodiscard]] std::string program_identity();
/// Kind of machine, which decides the last bits: "x86-64", whatever its CPU can do (the test portable/cpus), "aarch64",
/// ...
[[nodiscard]] std::string machine();
/// "GCC 12.2.0"
[[nodiscard]] std::string compiler();
/// "GSL 2.7.1, HDF5 1.10.8, ..."
[[nodiscard]] std::string library_versions();

}  // namespace overturn
