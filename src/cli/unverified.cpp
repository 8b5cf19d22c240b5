#include <fmt/format.h>

#include "cli/verbs.hpp"
#include "core/note.hpp"

namespace overturn::cli {

bool Unverified::told_of(store::ResultsReader const& file, std::string const& path) const {
    bool const changed = wished && !file.is_as_written();
    if (changed) {
        note(
            "overturn: {}: NOT as it was written (edited, damaged or never sealed); read as it is, with --unverified\n",
            path);
    }
    return changed;
}

}  // namespace overturn::cli
