#include "cli/history.hpp"

#include <system_error>

#include "core/error.hpp"

namespace overturn::cli {
namespace {

fmt::ostream open(std::string const& path) {
    try {
        return fmt::output_file(path);
    } catch (std::system_error const& error) {
        throw InputError(fmt::format("{}: cannot be written ({}). Choose another place", path, error.code().message()));
    }
}

}  // namespace

HistoryFile::HistoryFile(std::string const& path) : file_(open(path)) {
    file_.print(
        "time_s,rotation_rad,velocity_radps,friction_over_weight,contact_force_over_weight,slip_m,slip_velocity_mps\n");
}

void HistoryFile::at(RockingInstant const& i) {
    file_.print("{},{},{},{},{},{},{}\n", i.time_s, i.rotation_rad, i.velocity_radps, i.friction_ratio,
                i.contact_force_ratio, i.slip_m, i.slip_velocity_mps);
}

}  // namespace overturn::cli
