#include <fmt/format.h>

#include "cli/verbs.hpp"
#include "core/error.hpp"
#include "core/print_note.hpp"
#include "output/unknown_names.hpp"
#include "results/recount.hpp"

namespace overturn::cli {
namespace {

void warn_of_absent_columns(store::ResultsReader const& file, std::string const& path) {
    try {
        if (auto const text = output::absent_columns_text(file, parse_campaign(input_of(file))); !text.empty()) {
            print_note("overturn: {}: {}\n", path, text);
        }
    } catch (InputError const&) {  // a campaign that cannot be read is refused where it is needed
    }
}

}  // namespace

bool Unverified::warn_if_edited(store::ResultsReader const& file, std::string const& path) const {
    bool const changed = read_changed && !file.is_as_written();
    if (changed) {
        print_note(
            "overturn: {}: NOT as it was written (edited, damaged or never sealed); read as it is, with --unverified\n",
            path);
    }
    return changed;
}

bool Unverified::warn_if_changed(store::ResultsReader const& file, std::string const& path) const {
    bool const changed = warn_if_edited(file, path);
    if (changed) {
        warn_of_absent_columns(file, path);
    }
    for (auto const& unknown : output::unknown_names_text(file)) {
        print_note("overturn: {}: {} (another program wrote the file)\n", path, unknown);
    }
    return changed;
}

}  // namespace overturn::cli
