#include "cli/scene_files.hpp"

#include <filesystem>

#include "core/input_files.hpp"
#include "core/units.hpp"
#include "motion/record.hpp"

namespace overturn::cli {

GroundMotion load_motion(std::string const& path, std::string const& unit, std::string const& time_step) {
    InputFiles files(".");
    RecordRequest request{.name = path};
    if (!unit.empty()) {
        request.unit_mps2 = unit_factor(unit, Dimension::acceleration);
    }
    if (!time_step.empty()) {
        request.time_step_s = parse_quantity(time_step, Dimension::time);
    }
    return read_record(files.read(path), request);
}

BodySpec load_body(std::string const& path) {
    InputFiles files(".");
    auto const table = config::Table::parse(files.read(path), path);
    return read_body(table, files);
}

}  // namespace overturn::cli
