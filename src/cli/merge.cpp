#include "runner/merge.hpp"

#include <memory>

#include "cli/velocity_unit.hpp"
#include "cli/verbs.hpp"

namespace overturn::cli {

void add_merge(CommandLine& line) {
    auto verb = line.verb("merge", "make one results file from the parts that run --part left beside it");
    auto path = std::make_shared<std::string>();
    auto unit = std::make_shared<VelocityUnit>();
    verb.needs("file", *path, "results file to make: the -o of the parts");
    unit->offered_by(verb);
    verb.does([path, unit] { return merge_parts(*path, unit->measures()) == MergeEnd::complete ? done : resumable; });
}

}  // namespace overturn::cli
