#include "runner/merge.hpp"

#include <memory>

#include "cli/verbs.hpp"

namespace overturn::cli {

void add_merge(CommandLine& line) {
    auto verb = line.verb("merge", "make one results file from the parts that run --part left beside it");
    auto path = std::make_shared<std::string>();
    verb.needs("file", *path, "results file to make: the -o of the parts");
    verb.does([path] { return merge_parts(*path) == MergeEnd::complete ? done : resumable; });
}

}  // namespace overturn::cli
