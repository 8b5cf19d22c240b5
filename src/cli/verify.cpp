#include "runner/verify.hpp"

#include <memory>
#include <optional>

#include <fmt/format.h>

#include "campaign/withheld_inputs.hpp"
#include "cli/collective.hpp"
#include "cli/named_files.hpp"
#include "cli/verbs.hpp"
#include "core/print_note.hpp"
#include "output/json.hpp"
#include "output/made_by.hpp"
#include "output/verified_text.hpp"
#include "results/recount.hpp"
#include "runner/root_broadcast.hpp"
#include "store/durable.hpp"

namespace overturn::cli {
namespace {

struct VerifyOptions {
    std::string file;
    VerifyRequest rows;
    Unverified unverified;
    bool json = false;
    std::optional<std::string> page;
    std::string date;
};

int print_outcome(VerifyOptions const& options, store::ResultsReader const& file, CampaignSpec const& spec,
                  Verified const& found, int ranks) {
    output::Verification const of{.file = options.file,
                                  .date = options.date,
                                  .sample = options.rows.sample,
                                  .seed = options.rows.seed,
                                  .ranks = ranks};
    auto const json = output::verified_json(of, file, spec, found);
    for (auto const& line : output::not_compared(json)) {
        print_note("overturn: {}: {}\n", options.file, line);
    }
    if (options.page) {
        store::write_durably(*options.page, output::verified_page(json));
    }
    fmt::print("{}", options.json ? json.dump(2) + "\n" : output::verified_text(of, found, json));
    if (found.all_equal()) {
        return done;
    }
    print_note("overturn: {}: not what this program computes {}\n", options.file, output::why_bits_differ(file));
    return other_failure;
}

int verify(VerifyOptions const& options, parallel::Communicator const& comm) {
    // One rank holds the file against its seal for all, and sees that the record can be written before hours are spent.
    (void)broadcast_from_root(comm, [&] {
        if (options.page) {
            require_page(*options.page);
        }
        store::ResultsReader const file(options.file, options.unverified.trust());
        return std::string();
    });
    store::ResultsReader const file(options.file, store::Trust::unverified);
    auto input = input_of(file);
    fetch_withheld(input, options.file);
    auto const spec = parse_campaign(input);
    auto const found = verify_rows(file, spec, options.rows, comm);
    return std::stoi(broadcast_from_root(
        comm, [&] { return fmt::format("{}", print_outcome(options, file, spec, found, comm.size())); }));
}

}  // namespace

void add_verify(CommandLine& line) {
    auto verb = line.verb("verify", "recompute the rows of a results file and compare every bit");
    auto options = std::make_shared<VerifyOptions>();
    verb.needs("file", options->file, "results file");
    verb.takes("--sample", options->rows.sample, "recompute this number of rows, drawn at random; default: all");
    verb.takes("--seed", options->rows.seed, "seed of that draw; another seed draws other rows");
    options->unverified.offered_by(verb);
    verb.takes("--json", options->json, "print the record as JSON, to be filed or read by scripts");
    verb.takes("--html", options->page, "write the record as a page (no network needed)");
    verb.takes("--date", options->date, "date printed on the record, exactly as given; default: none");
    verb.does([options] { return on_all_ranks([&](auto const& comm) { return verify(*options, comm); }); });
}

}  // namespace overturn::cli
