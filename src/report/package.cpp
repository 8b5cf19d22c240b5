#include "report/detail/package.hpp"

#include <system_error>

#include <fmt/format.h>

#include "core/error.hpp"

namespace overturn::report {

namespace fs = std::filesystem;

fs::path draw_script() {
    std::error_code error;
    auto const program = fs::read_symlink("/proc/self/exe", error);
    auto const installed = (program.parent_path() / OVERTURN_PACKAGE_PLACE).lexically_normal();
    for (auto const& place : {installed, program.parent_path() / "python"}) {
        if (auto script = place / "overturn" / "draw.py"; fs::is_regular_file(script, error)) {
            return script;
        }
    }
    throw SystemError(fmt::format(
        "{}: no Python package overturn there (it draws figures and pages). Install the program as a whole: "
        "cmake --install BUILD --prefix PREFIX",
        installed.string()));
}

}  // namespace overturn::report
