#pragma once

#include <fmt/format.h>
#include <mpi.h>

#include "core/error.hpp"

namespace overturn::parallel {

inline void check(int code, char const* what) {
    if (code != MPI_SUCCESS) {
        throw SystemError(fmt::format("MPI: {} failed with code {} (see the lines above)", what, code));
    }
}

}  // namespace overturn::parallel
