#include "cli/named_files.hpp"

#include <system_error>

#include "core/error.hpp"
#include "core/input_files.hpp"
#include "report/cost_page.hpp"
#include "store/durable.hpp"

namespace overturn::cli {

std::string read_named(std::string const& path) { return InputFiles(".").read(path); }

void require_page(std::string const& path) {
    report::check_page_name(path);
    store::require_writable(path);
}

fmt::ostream open_named(std::string const& path) {
    try {
        return fmt::output_file(path);
    } catch (std::system_error const& error) {
        throw InputError(fmt::format("{}: cannot be written ({}). Choose another place", path, error.code().message()));
    }
}

}  // namespace overturn::cli
