#include "cli/say.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include <fmt/format.h>

#include "core/note.hpp"

namespace overturn::cli {
namespace {

bool is_first_rank() {
    static constexpr std::array names{"OMPI_COMM_WORLD_RANK", "PMI_RANK", "PMIX_RANK", "SLURM_PROCID"};
    for (auto const* name : names) {
        if (auto const* rank = std::getenv(name)) {
            return std::string_view(rank) == "0";
        }
    }
    return true;
}

}  // namespace

void say(std::string message) {
    for (char& c : message) {
        c = c == '\n' || c == '\r' ? ' ' : c;
    }
    note("overturn: {}\n", message);
}

void say_once(std::string message) {
    if (is_first_rank()) {
        say(std::move(message));
    }
}

}  // namespace overturn::cli
