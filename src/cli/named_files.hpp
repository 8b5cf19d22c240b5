/// Files that a user names on the command line.
#pragma once

#include <string>

#include <fmt/os.h>

namespace overturn::cli {

/// Its content. \throws InputError if there is no such file or it cannot be read
[[nodiscard]] std::string read_named(std::string const& path);

/// Before any work: is it the name of a page, and can it be written? \throws InputError
void require_page(std::string const& path);

/// To be written as it comes. \throws InputError if it cannot be made
[[nodiscard]] fmt::ostream open_named(std::string const& path);

}  // namespace overturn::cli
