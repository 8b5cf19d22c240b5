#include "campaign/version.hpp"

#include <Eigen/Core>
#include <string_view>

#include <fftw3.h>
#include <fmt/format.h>
#include <git_revision.h>
#include <gsl/gsl_version.h>

#include "store/results_file.hpp"

namespace overturn {

std::string program_version() { return OVERTURN_VERSION; }
std::string git_revision() { return OVERTURN_GIT_REVISION; }
std::string sources_sha256() { return OVERTURN_SOURCES_SHA256; }
std::string program_identity() {
    constexpr std::size_t enough = 12;
    return fmt::format("{} ({}, sources {})", program_version(), git_revision(), sources_sha256().substr(0, enough));
}
std::string machine() {
#if defined(__x86_64__)
    return "x86-64";
#elif defined(__aarch64__)
    return "aarch64";
#elif defined(__powerpc64__)
    return "ppc64";
#elif defined(__riscv)
    return "riscv64";
#else
    return "an unnamed machine";
#endif
}
std::string compiler() {
#if defined(__clang__)
    return "Clang " __clang_version__;
#else
    return "GCC " __VERSION__;
#endif
}
std::string library_versions() {
    std::string_view const fftw(fftw_version);  // fftw-3.3.10-sse2-avx
    return fmt::format("GSL {}, FFTW {}, libm {}, HDF5 {}, Eigen {}.{}.{}, fmt {}", gsl_version,
                       fftw.substr(fftw.find('-') + 1), OVERTURN_LIBM, store::hdf5_version(), EIGEN_WORLD_VERSION,
                       EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION, FMT_VERSION);
}

}  // namespace overturn
