#include "campaign/merge.hpp"

#include <memory>

#include "cli/verbs.hpp"

namespace overturn::cli {

void add_merge(CLI::App& app, Action& action) {
    auto* verb = app.add_subcommand("merge", "make one results file from the parts that run --part left beside it");
    auto path = std::make_shared<std::string>();
    verb->add_option("file", *path, "results file to make: the -o of the parts")->required();
    verb->callback(
        [path, &action] { action = [path] { return merge_parts(*path) == MergeEnd::complete ? done : resumable; }; });
}

}  // namespace overturn::cli
