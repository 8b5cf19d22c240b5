#include "output/made_by.hpp"

#include <fmt/format.h>

#include "campaign/version.hpp"

namespace overturn::output {

bool is_of_this_program(store::ResultsReader const& file) {
    return file.text("program_version") == program_version() && file.text("sources_sha256") == sources_sha256();
}

std::string maker_of(store::ResultsReader const& file) {
    constexpr std::size_t enough = 12;
    return fmt::format("overturn {} ({}, sources {})", file.text("program_version"), file.text("git_revision"),
                       file.text("sources_sha256").substr(0, enough));
}

std::string why_bits_differ(store::ResultsReader const& file) {
    if (!is_of_this_program(file)) {
        return fmt::format("(the file was made by {}; this is {}). Replay it with that one", maker_of(file),
                           program_identity());
    }
    if (auto const libraries = file.text("library_versions"); libraries != library_versions()) {
        return fmt::format("(this very program made it, with other libraries: {}; here {}). Replay it with those",
                           libraries, library_versions());
    }
    return fmt::format("(this very program made it: {}). Replay it on the kind of machine that made it",
                       file.is_as_written()
                           ? "another kind of machine than " + machine() + " decides last bits"
                           : "it was edited, or another kind of machine than " + machine() + " decides last bits");
}

}  // namespace overturn::output
