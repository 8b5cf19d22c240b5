/// Place of the Python package `overturn`, whose scripts draw figures and pages.
#pragma once

#include <filesystem>

namespace overturn::report {

/// The package's draw.py: installed under the program's own prefix, or beside the program of a build tree, which links
/// to the sources. Found from the program's own place alone: an installation may be moved as a whole, and no variable
/// of the environment leads elsewhere. \throws SystemError if it is not there
[[nodiscard]] std::filesystem::path draw_script();

}  // namespace overturn::report
