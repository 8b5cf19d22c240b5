#include "runner/merge.hpp"

#include <memory>

#include <fmt/format.h>

#include "cli/collective.hpp"
#include "cli/text_choice.hpp"
#include "cli/verbs.hpp"
#include "cli/walltime.hpp"
#include "core/elapsed.hpp"
#include "core/next_step.hpp"

namespace overturn::cli {

void add_merge(CommandLine& line) {
    auto verb = line.verb("merge", "make one results file from the blocks of run --part or --leave-blocks");
    auto path = std::make_shared<std::string>();
    auto text = std::make_shared<TextChoice>();
    auto packing = std::make_shared<Packing>();
    verb.needs("file", *path, "results file to write: the -o of the parts");
    packing->offered_by(verb);
    text->offered_by(verb);
    verb.does([path, text, packing] {
        NextStep const next(
            fmt::format("merge again: all blocks are kept in {}.parts (to merge elsewhere, move it there)", *path));
        return on_all_ranks([&](parallel::Communicator const& comm) {
            return merge_parts(*path, comm, {packing->layout(), text->options(), seconds_of_job(comm), program_begin()})
                           == MergeEnd::complete
                       ? done
                       : resumable;
        });
    });
}

}  // namespace overturn::cli
