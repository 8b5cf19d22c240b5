#include "runner/verify.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fmt/ranges.h>

#include "campaign/version.hpp"
#include "campaign/withheld_inputs.hpp"
#include "cli/collective.hpp"
#include "cli/verbs.hpp"
#include "core/print_note.hpp"
#include "output/json.hpp"
#include "output/made_by.hpp"
#include "output/record_page.hpp"
#include "report/cost_page.hpp"
#include "results/recount.hpp"
#include "results/stored_names.hpp"
#include "runner/root_broadcast.hpp"
#include "store/durable.hpp"
#include "store/seal.hpp"

namespace overturn::cli {
namespace {

struct VerifyOptions {
    std::string file;
    VerifyWish wish;
    Unverified unverified;
    bool json = false;
    std::optional<std::string> page;
    std::string date;
};

std::string counted(Verified const& found) {
    return fmt::format("{} trials, {} waves{}", found.trials, found.waves,
                       found.rare > 0 ? fmt::format(", {} rows of rare events", found.rare) : "");
}

std::string differing(Verified const& found) {
    return fmt::format("{} trials, {} waves{} differ; first {}", found.differing_trials, found.differing_waves,
                       found.rare > 0 ? fmt::format(", {} rows of rare events", found.differing_rare) : "",
                       found.first);
}

// Columns that stand in no comparison, and why.
constexpr std::array<std::pair<char const*, char const*>, 2> not_compared{
    {{"unknown_columns", "for this program does not know them"},
     {"absent_columns", "for the file does not have them"}}};

// Some of a list of the record, so many that a line holds them.
std::string listed(output::Json const& json, char const* key) {
    constexpr std::size_t most = 12;
    auto const all = json.at(key).get<std::vector<std::string>>();
    auto const shown = std::span(all).first(std::min(most, all.size()));
    return fmt::format("{}{}", fmt::join(shown, ", "),
                       all.size() > most ? fmt::format(" and {} more", all.size() - most) : "");
}

// What is filed of it.
output::Json json_of(VerifyOptions const& options, store::ResultsReader const& file, CampaignSpec const& spec,
                     Verified const& found, int ranks) {
    auto const& sample = options.wish.sample;
    return {{"passed", found.all_equal()},
            {"file", options.file},
            {"sha256", store::sealed_digest(options.file)},
            {"made_by", output::maker_of(file)},
            {"program", program_identity()},
            {"machine", machine()},
            {"ranks", ranks},
            {"date", options.date},
            {"sample", sample ? output::Json(*sample) : output::Json(nullptr)},
            {"seed", sample ? output::Json(options.wish.seed) : output::Json(nullptr)},
            {"trials", found.trials},
            {"waves", found.waves},
            {"rare", found.rare},
            {"differing_trials", found.differing_trials},
            {"differing_waves", found.differing_waves},
            {"differing_rare", found.differing_rare},
            {"first", found.first},
            {"unknown_columns", unknown_columns(file, spec)},
            {"absent_columns", absent_columns(file, spec)}};
}

std::string page_of(output::Json const& json) {
    auto const text = [&](char const* key) { return json.at(key).get<std::string>(); };
    auto const number = [&](char const* key) { return json.at(key).get<std::int64_t>(); };
    bool const passed = json.at("passed").get<bool>();
    output::RecordPage page{
        .title = passed ? "Verification: all rows are bit-equal" : "Verification: rows DIFFER",
        .facts = {{"file", text("file")},
                  {"SHA-256", text("sha256")},
                  {"made by", text("made_by")},
                  {"recomputed by", "overturn " + text("program")},
                  {"machine", text("machine")},
                  {"ranks", fmt::format("{}", number("ranks"))},
                  {"rows", json.at("sample").is_null()
                               ? "all"
                               : fmt::format("{} drawn at random, seed {}", number("sample"), number("seed"))}},
        .head = {"", "rows of", "recomputed", "differ"},
        .rows = {}};
    if (!text("date").empty()) {
        page.facts.insert(page.facts.begin(), {"date", text("date")});
    }
    if (!passed) {
        page.facts.emplace_back("first that differs", text("first"));
    }
    for (auto const& [key, what] : not_compared) {
        if (auto const columns = listed(json, key); !columns.empty()) {
            page.facts.emplace_back(fmt::format("not compared, {}", what), columns);
        }
    }
    for (auto const* of : {"trials", "waves", "rare"}) {
        auto const differ = number((std::string("differing_") + of).c_str());
        page.rows.push_back(
            {{differ == 0 ? "PASS" : "FAIL", of, fmt::format("{}", number(of)), fmt::format("{}", differ)},
             differ == 0});
    }
    return output::html_of(page);
}

int print_outcome(VerifyOptions const& options, store::ResultsReader const& file, CampaignSpec const& spec,
                  Verified const& found, int ranks) {
    auto const json = json_of(options, file, spec, found, ranks);
    for (auto const& [key, what] : not_compared) {
        if (auto const columns = listed(json, key); !columns.empty()) {
            print_note("overturn: {}: not compared, {}: {}\n", options.file, what, columns);
        }
    }
    if (options.page) {
        auto const page = page_of(json);
        store::write_durably(*options.page, std::as_bytes(std::span(page)));
    }
    if (options.json) {
        fmt::print("{}\n", json.dump(2));
    } else if (found.all_equal()) {
        fmt::print("{}: {} recomputed, all bit-equal to the stored rows{}\n", options.file, counted(found),
                   json.at("absent_columns").empty() ? "" : ", in the columns that the file has");
    } else {
        fmt::print("{}: {} recomputed, NOT all bit-equal: {}\n", options.file, counted(found), differing(found));
    }
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
            report::check_page_name(*options.page);
            store::require_writable(*options.page);
        }
        store::ResultsReader const file(options.file, options.unverified.trust());
        return std::string();
    });
    store::ResultsReader const file(options.file, store::Trust::unverified);
    auto input = input_of(file);
    fetch_withheld(input, options.file);
    auto const spec = parse_campaign(input);
    auto const found = verify_rows(file, spec, options.wish, comm);
    return std::stoi(broadcast_from_root(
        comm, [&] { return fmt::format("{}", print_outcome(options, file, spec, found, comm.size())); }));
}

}  // namespace

void add_verify(CommandLine& line) {
    auto verb = line.verb("verify", "recompute rows of a results file, alone or under mpirun, and compare every bit");
    auto options = std::make_shared<VerifyOptions>();
    verb.needs("file", options->file, "results file");
    verb.takes("--sample", options->wish.sample, "so many rows drawn at random; default: all");
    verb.takes("--seed", options->wish.seed, "of that drawing; another one draws other rows");
    options->unverified.offered_by(verb);
    verb.takes("--json", options->json, "for scripts, and to be filed");
    verb.takes("--html", options->page, "write a page that needs no network");
    verb.takes("--date", options->date, "that the record shall bear, as you write it; default: none");
    verb.does([options] { return on_all_ranks([&](auto const& comm) { return verify(*options, comm); }); });
}

}  // namespace overturn::cli
