#include "runner/verify.hpp"

#include <memory>

#include <fmt/ranges.h>

#include "campaign/withheld_inputs.hpp"
#include "cli/collective.hpp"
#include "cli/other_bits.hpp"
#include "cli/verbs.hpp"
#include "core/print_note.hpp"
#include "results/recount.hpp"
#include "results/stored_names.hpp"
#include "runner/root_broadcast.hpp"

namespace overturn::cli {
namespace {

struct VerifyOptions {
    std::string file;
    VerifyWish wish;
    Unverified unverified;
};

std::string counted(Verified const& found) {
    return fmt::format("{} trials, {} waves{}", found.trials, found.waves,
                       found.rare > 0 ? fmt::format(", {} rows of rare events", found.rare) : "");
}

int print_outcome(VerifyOptions const& options, Verified const& found) {
    if (found.all_equal()) {
        fmt::print("{}: {} recomputed, all bit-equal to the stored rows\n", options.file, counted(found));
        return done;
    }
    fmt::print("{}: {} recomputed, NOT all bit-equal: {} trials, {} waves{} differ; first {}\n", options.file,
               counted(found), found.differing_trials, found.differing_waves,
               found.rare > 0 ? fmt::format(", {} rows of rare events", found.differing_rare) : "", found.first);
    store::ResultsReader const file(options.file, options.unverified.trust());
    print_note("overturn: {}: not what this program computes {}\n", options.file, why_bits_differ(file));
    return other_failure;
}

// Columns that nothing is known of are in the file and in no comparison.
void note_unknown(VerifyOptions const& options, store::ResultsReader const& file, CampaignSpec const& spec) {
    if (auto const columns = unknown_columns(file, spec); !columns.empty()) {
        print_note("overturn: {}: not compared, for this program does not know them: {}\n", options.file,
                   fmt::join(columns, ", "));
    }
}

int verify(VerifyOptions const& options, parallel::Communicator const& comm) {
    // One rank holds the file against its seal for all.
    (void)broadcast_from_root(comm, [&] {
        store::ResultsReader const file(options.file, options.unverified.trust());
        return std::string();
    });
    store::ResultsReader const file(options.file, store::Trust::unverified);
    auto input = input_of(file);
    fetch_withheld(input, options.file);
    auto const spec = parse_campaign(input);
    auto const found = verify_rows(file, spec, options.wish, comm);
    return std::stoi(broadcast_from_root(comm, [&] {
        note_unknown(options, file, spec);
        return fmt::format("{}", print_outcome(options, found));
    }));
}

}  // namespace

void add_verify(CommandLine& line) {
    auto verb = line.verb("verify", "recompute rows of a results file, alone or under mpirun, and compare every bit");
    auto options = std::make_shared<VerifyOptions>();
    verb.needs("file", options->file, "results file");
    verb.takes("--sample", options->wish.sample, "so many rows drawn at random; default: all");
    verb.takes("--seed", options->wish.seed, "of that drawing; another one draws other rows");
    options->unverified.offered_by(verb);
    verb.does([options] { return on_all_ranks([&](auto const& comm) { return verify(*options, comm); }); });
}

}  // namespace overturn::cli
