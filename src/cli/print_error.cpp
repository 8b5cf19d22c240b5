#include "cli/print_error.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <string_view>

#include <fmt/format.h>

#include "cli/command_line.hpp"
#include "config/faults.hpp"
#include "core/error.hpp"
#include "core/next_step.hpp"
#include "core/print_note.hpp"
#include "core/text_width.hpp"

namespace overturn::cli {

bool is_first_rank() {
    static constexpr std::array names{"OMPI_COMM_WORLD_RANK", "PMI_RANK", "PMIX_RANK", "SLURM_PROCID"};
    for (auto const* name : names) {
        if (auto const* rank = std::getenv(name)) {
            return std::string_view(rank) == "0";
        }
    }
    return true;
}

namespace {

void print_one(std::string message) {
    for (char& c : message) {
        c = c == '\n' || c == '\r' ? ' ' : c;
    }
    constexpr std::size_t longest = 1000;
    constexpr std::size_t end = 300;  // what to do stands there
    if (text_width(message) > longest) {
        message = fmt::format("{} [...] {}", text_head(message, longest - end), text_tail(message, end));
    }
    write_line("overturn: " + message);
}

}  // namespace

void print_error(std::string const& message) {
    constexpr std::size_t most = 30;
    auto const faults = config::faults_of(message);
    for (std::size_t i = 0; i < std::min(faults.size(), most); ++i) {
        print_one(faults[i]);
    }
    if (faults.size() > most) {
        print_note("overturn: and {} more\n", faults.size() - most);
    }
}

Failure current_failure() {
    try {
        throw;
    } catch (InputError const& error) {
        return {error.what(), bad_input};
    } catch (std::filesystem::filesystem_error const& error) {
        return {fmt::format("{}: cannot be looked at ({}). Name another place", error.path1().string(),
                            error.code().message()),
                bad_input};
    } catch (std::bad_alloc const&) {
        return {
            fmt::format("out of memory (a limit of the batch system or of ulimit -v, or too many ranks on a node?). "
                        "Allow more, or start fewer ranks a node, then {}",
                        next_step()),
            other_failure};
    } catch (std::exception const& error) {
        return {error.what(), other_failure};
    }
}

void print_error_once(std::string const& message) {
    if (is_first_rank()) {
        print_error(message);
    }
}

}  // namespace overturn::cli
