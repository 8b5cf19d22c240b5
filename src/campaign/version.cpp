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
std::string program_identity() { return fmt::format("{} ({})", program_version(), git_revision()); }
std::string library_versions() {
    std::string_view const fftw(fftw_version);  // fftw-3.3.10-sse2-avx
    return fmt::format("GSL {}, FFTW {}, HDF5 {}, Eigen {}.{}.{}, fmt {}", gsl_version, fftw.substr(fftw.find('-') + 1),
                       store::hdf5_version(), EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION,
                       FMT_VERSION);
}

}  // namespace overturn
