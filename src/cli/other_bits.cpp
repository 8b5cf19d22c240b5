#include "cli/other_bits.hpp"

#include <fmt/format.h>

#include "campaign/version.hpp"

namespace overturn::cli {

std::string why_bits_differ(store::ResultsReader const& file) {
    auto const version = file.text("program_version");
    auto const revision = file.text("git_revision");
    if (version != program_version() || revision != git_revision()) {
        return fmt::format("(the file was made by overturn {}, revision {}; this is {}). Replay it with that one",
                           version, revision, program_identity());
    }
    if (auto const libraries = file.text("library_versions"); libraries != library_versions()) {
        return fmt::format("(this very program made it, with other libraries: {}; here {}). Replay it with those",
                           libraries, library_versions());
    }
    return fmt::format("(this very program made it: {}). Replay it on the machine that made it",
                       file.is_sealed() ? "another kind of processor or another libm decides last bits"
                                        : "it was edited, or another kind of processor decides last bits");
}

}  // namespace overturn::cli
