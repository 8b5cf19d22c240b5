#include "campaign/version.hpp"

#include <Eigen/Core>

#include <fmt/format.h>
#include <git_revision.h>
#include <gsl/gsl_version.h>

#include "store/results_file.hpp"

namespace overturn {

std::string program_version() { return OVERTURN_VERSION; }
std::string git_revision() { return OVERTURN_GIT_REVISION; }
std::string program_identity() { return fmt::format("{} ({})", program_version(), git_revision()); }
std::string library_versions() {
    return fmt::format("GSL {}, HDF5 {}, Eigen {}.{}.{}, fmt {}", gsl_version, store::hdf5_version(),
                       EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION, FMT_VERSION);
}

}  // namespace overturn
