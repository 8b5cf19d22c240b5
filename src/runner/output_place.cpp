#include "runner/output_place.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <set>
#include <thread>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "campaign/block_rows.hpp"
#include "campaign/withheld_inputs.hpp"
#include "core/print_note.hpp"
#include "results/recount.hpp"
#include "runner/detail/extension.hpp"
#include "runner/merge.hpp"
#include "runner/root_broadcast.hpp"
#include "store/durable.hpp"
#include "store/kept_blocks.hpp"
#include "store/results_file.hpp"

namespace overturn {
namespace {

void refuse_other(CampaignInput const& begun, CampaignInput const& now, std::string const& place) {
    auto const differences = begun.differences(now);
    validate(differences.empty(), "{}: another campaign ({}). Undo the change, or start anew with another -o", place,
             fmt::join(differences, "; "));
}

// A whole run holds all blocks there could ever be, so that no part can start beside it.
store::BlockRange blocks_of(Plan const& plan, Part part) {
    return part.is_whole() ? store::BlockRange{0, std::numeric_limits<std::int64_t>::max()} : plan.blocks_of(part);
}

// Two parts may begin at the same time; the campaign that is on record afterwards counts.
void begin(store::ShardFolder const& shards, CampaignInput const& input) {
    shards.begin(input.serialise());
    refuse_other(CampaignInput::deserialise(shards.begun_with()), input, shards.folder().string());
}

// What an unfinished run was begun with; nothing if there is none.
std::optional<CampaignInput> begun_there(store::ShardFolder const& shards) {
    auto const record = shards.begun_with();
    return record.empty() ? std::nullopt : std::optional(CampaignInput::deserialise(record));
}

// A damaged record is written anew, since the blocks name their campaign; but never by chance, and never over others'.
std::optional<CampaignInput> sound_record(store::ShardFolder const& shards, CampaignInput const& input, bool resume) {
    try {
        return begun_there(shards);
    } catch (SystemError const& error) {
        validate(resume, "{}", error.what());
        validate(
            !shards.holds_foreign_blocks(),
            "{}: blocks of another campaign or program (and the record that would name it is damaged). Choose another "
            "place with -o",
            shards.folder().string());
        print_note("{}: the damaged record is written anew\n", shards.folder().string());
        shards.begin_again(input.serialise());
        return input;
    }
}

// Ranks outlive a killed mpirun for some seconds, in which they may finish the file and be at removing the blocks.
bool becomes_free(store::ShardFolder const& shards) {
    constexpr auto pause = std::chrono::milliseconds(50);
    constexpr int most_pauses = 100;
    for (int i = 0; i < most_pauses && store::BlockLock::held(shards.folder()); ++i) {
        std::this_thread::sleep_for(pause);
    }
    return !store::BlockLock::held(shards.folder());
}

// Of this very campaign and program, by the record or, where a kill came after that had gone, by every block itself.
bool are_leftovers(store::ShardFolder const& shards, CampaignInput const& input) {
    try {
        if (auto const begun = begun_there(shards)) {
            return begun->block_key() == input.block_key();
        }
    } catch (SystemError const&) {
        return false;
    }
    std::vector<std::string> notes;
    (void)shards.committed({0, std::numeric_limits<std::int64_t>::max()}, notes);
    return notes.empty();
}

// A larger campaign of which some blocks are there, beside the file whose rows it takes.
std::optional<CampaignInput> unfinished_extension(store::ShardFolder const& shards, CampaignInput const& made_from) {
    try {
        auto begun = begun_there(shards);
        bool const is_other = begun && begun->block_key() != made_from.block_key();
        return is_other && made_from.differences_of_rows(*begun).empty() ? std::move(begun) : std::nullopt;
    } catch (SystemError const&) {
        return std::nullopt;  // a damaged record
    }
}

std::vector<std::int64_t> committed_in(store::ShardFolder const& shards, Plan const& plan, store::BlockRange range,
                                       std::vector<std::string>& notes) {
    return shards.committed(range, notes, [&](std::int64_t block) { return BlockRows::packed_size(plan, block); });
}

// Whether it is as it was written is asked by can_be_extended and check_complete.
bool is_same_campaign(std::filesystem::path const& output, CampaignInput const& input) {
    store::ResultsReader const file(output, store::Trust::unverified);
    return file.text("input_sha256") == input.sha256()
           && file.text("campaign_name") == std::filesystem::path(input.name).filename().string();
}

// Short files are laid out in neither way.
bool is_laid_out(std::filesystem::path const& output, store::Layout layout) {
    return store::ResultsReader(output, store::Trust::unverified).layout() == layout;
}

// A whole run keeps what it can use of one that was begun with another campaign. \return whether there is such a thing
bool take_over(store::ShardFolder const& shards, CampaignInput const& begun, CampaignInput const& input,
               OutputRequest const& request) {
    if (!request.part.is_whole()) {
        refuse_other(begun, input, shards.folder().string());
        return false;
    }
    if (request.extend && begun.block_key() != input.block_key() && !shards.holds_blocks() && shards.aside().empty()) {
        shards.begin_again(input.serialise());  // it was stopped before its first block
        return true;
    }
    if (can_take_over(shards, begun, input, request.shrink)) {
        shards.set_aside(begun.block_key());
        shards.begin_again(input.serialise());
        return true;
    }
    return false;
}

}  // namespace

std::vector<std::int64_t> sound_blocks(store::ShardFolder const& shards, Plan const& plan, store::BlockRange range) {
    std::vector<std::string> notes;
    auto committed = committed_in(shards, plan, range, notes);
    for (auto const& note : notes) {
        write_note(note + "\n");
    }
    return committed;
}

void take_rows(AcceptedWaves& waves, Plan const& drawn, store::ShardFolder const& shards,
               std::vector<std::int64_t> const& blocks) {
    for (auto const block : blocks) {
        if (waves.needs_rows()) {
            waves.take(block, BlockRows::unpack(shards.read(block), drawn, drawn.waves_of_block(block).count).waves);
        } else {
            waves.take(block);
        }
    }
}

void warn_of_little_space(std::filesystem::path const& output, Plan const& plan, Part part,
                          std::vector<std::int64_t> const& committed) {
    constexpr double page = 4096;       // what a file is rounded up to
    constexpr double overhead = 400e3;  // groups, attributes and statistics of a small campaign
    double left = 0;
    double all = overhead;
    auto const range = plan.blocks_of(part);
    for (auto block = range.first; block < range.last; ++block) {
        auto const bytes = static_cast<double>(BlockRows::packed_size(plan, block));
        all += bytes;
        left += std::ranges::binary_search(committed, block) ? 0 : page * std::ceil(bytes / page);
    }
    double const needed = left + (part.is_whole() ? all : 0);
    std::error_code error;
    auto const space = std::filesystem::space(output.has_parent_path() ? output.parent_path() : ".", error);
    constexpr double mega = 1e6;
    if (!error && static_cast<double>(space.available) < needed) {
        print_note(
            "warning: {}: {:.1f} MB are free there, blocks and the merged file need about {:.1f} MB. Free space now, "
            "or "
            "go on with --resume when the disk is full\n",
            output.string(), static_cast<double>(space.available) / mega, needed / mega);
    }
}

bool check_complete(std::filesystem::path const& output, CampaignInput const& input, bool locked) {
    store::ResultsReader const file(output);
    auto const made_from = input_of(file);
    bool const only_more = made_from.differences_of_rows(input).empty();
    validate(only_more || made_from.differences(input).empty(),
             "{}: another campaign ({}). Undo the change, or start anew with another -o", output.string(),
             fmt::join(made_from.differences(input), "; "));
    validate(has_withheld(input) || file.text("input_sha256") == input.sha256(),
             "output {} (made {}, or with other input files). {} with -o", output.string(),
             only_more ? "with other waves, levels, bodies, limits, statistics or title" : "with other settings",
             only_more ? "Use --extend, which keeps its rows, or name another" : "Name another");
    store::ShardFolder const shards(output, input.block_key());
    if (!shards.exists() || !(locked || becomes_free(shards))) {
        return false;
    }
    auto const larger = unfinished_extension(shards, made_from);
    if (larger) {
        print_note("{}: an extension of {} is not complete, {} blocks of it are done. Go on with: {}\n",
                   shards.folder().string(), output.string(), store::blocks_beside(output),
                   resume_command(*larger, output, "--extend"));
    } else if (are_leftovers(shards, input)) {
        shards.remove();
        print_note("{}: blocks left over (merged already). Removed\n", shards.folder().string());
    } else {
        print_note("{}: what lies there is not of this file. Left alone\n", shards.folder().string());
    }
    return larger.has_value();
}

OutputState lock_output(std::filesystem::path const& output, store::ShardFolder const& shards,
                        CampaignInput const& input, Plan const& plan, OutputRequest const& request,
                        std::optional<store::BlockLock>& lock) {
    validate(!std::filesystem::is_directory(output), "output {} (is a folder). {}", output.string(),
             store::advice_beside_blocks(output, "Name a file with -o"));
    validate(!std::filesystem::exists(output) || std::filesystem::is_regular_file(output),
             "output {} (is no file that could hold results). {}", output.string(),
             store::advice_beside_blocks(output, "Name another with -o"));
    bool const extendable = request.extend && can_be_extended(output, input, request.shrink);
    bool const packs = extendable && request.pack && is_laid_out(output, store::Layout::plain);
    bool const extends = extendable && (packs || !is_same_campaign(output, input));
    auto const refuse_taken = [&] {
        if (request.resume || !std::filesystem::exists(output)) {
            return;
        }
        auto const blocks = store::blocks_beside(output);
        validate(blocks == 0,
                 "output {} (exists already and would be lost; beside it {}.parts holds {} finished blocks of a run). "
                 "See overturn status {}, or name another with -o",
                 output.string(), output.string(), blocks, output.string());
        throw InputError(fmt::format("output {} (exists already and would be lost). Remove it, or name another with -o",
                                     output.string()));
    };
    refuse_taken();
    if (extends || !std::filesystem::exists(output)) {
        store::require_writable(output);
        lock.emplace(shards.folder(), blocks_of(plan, request.part));
    }
    refuse_taken();  // another run may have finished meanwhile
    if (std::filesystem::exists(output) && (!extends || (!packs && is_same_campaign(output, input)))) {
        (void)check_complete(output, input, lock.has_value());
        return {.complete = true, .packed = request.pack && !is_laid_out(output, store::Layout::plain)};
    }
    auto const begun = sound_record(shards, input, request.resume);
    bool taken_over = false;
    if (!begun) {
        validate(request.resume || !shards.holds_blocks() || begun_there(shards),
                 "{} (blocks of an unfinished run lie there). Go on with --resume, or remove it",
                 shards.folder().string());
        if (request.extend && !extendable && !shards.holds_blocks()) {
            print_note("{}: nothing is there that could be extended: the campaign begins anew\n", output.string());
        }
        begin(shards, input);
    } else {
        validate(request.resume || !request.part.is_whole(),
                 "{} (an unfinished run lies there). Go on with --resume, or remove it", shards.folder().string());
        taken_over = take_over(shards, *begun, input, request);
    }
    shards.remove_unfinished(plan.blocks_of(request.part));
    bool const keeps = request.part.is_whole() && (extends || !shards.aside().empty());
    bool const stays_packed = extends && is_laid_out(output, store::Layout::packed);
    return {.begun = begun.has_value() && !taken_over, .packed = stays_packed, .keeps = keeps};
}

void require_shared(store::ShardFolder const& shards, std::string const& key, parallel::Communicator const& comm) {
    auto const record = shards.begun_with();
    bool const seen = !record.empty() && CampaignInput::deserialise(record).block_key() == key;
    if (comm.largest(seen ? 0 : 1) == 0) {
        return;
    }
    std::string blind;
    for (auto const& host : comm.gather(seen ? "" : comm.host())) {
        blind = blind.empty() ? host : blind;
    }
    comm.broadcast(blind);
    throw InputError(
        fmt::format("{} (not seen from {}: every rank writes its own blocks). Choose an output that all "
                    "nodes share",
                    shards.folder().string(), blind));
}

std::vector<std::int64_t> take_blocks(std::filesystem::path const& output, store::ShardFolder const& shards,
                                      Plan const& plan, OutputRequest const& request, bool begun,
                                      parallel::Communicator const& comm) {
    auto const range = plan.blocks_of(request.part);
    auto const place = [&](int rank) { return range.first + range.count() * rank / comm.size(); };
    std::vector<std::string> notes;
    nlohmann::json mine;
    try {
        mine["blocks"] = committed_in(shards, plan, {place(comm.rank()), place(comm.rank() + 1)}, notes);
        mine["notes"] = notes;
    } catch (SystemError const& error) {
        mine["error"] = error.what();
    }
    auto const of_ranks = comm.gather(mine.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
    return nlohmann::json::parse(
               broadcast_from_root(comm,
                                   [&] {
                                       std::vector<std::int64_t> committed;
                                       std::set<std::string> reported;  // what is foreign is seen by several
                                       for (auto const& text : of_ranks) {
                                           auto const found = nlohmann::json::parse(text);
                                           if (found.contains("error")) {
                                               throw SystemError(found.at("error").get<std::string>());
                                           }
                                           for (auto const& block : found.at("blocks")) {
                                               committed.push_back(block.get<std::int64_t>());
                                           }
                                           for (auto const& line : found.at("notes")) {
                                               reported.insert(line.get<std::string>());
                                           }
                                       }
                                       for (auto const& line : reported) {
                                           write_note(line + "\n");
                                       }
                                       validate(request.resume || committed.empty(),
                                                "{}: part {}/{} (has been begun there). Go on with --resume",
                                                shards.folder().string(), request.part.number, request.part.of);
                                       if (request.resume && (begun || !committed.empty())) {
                                           print_note("resuming {}: {} of {} blocks are done, {} are left\n",
                                                      output.string(), committed.size(), range.count(),
                                                      range.count() - std::ssize(committed));
                                       }
                                       warn_of_little_space(output, plan, request.part, committed);
                                       return nlohmann::json(committed).dump();
                                   }))
        .get<std::vector<std::int64_t>>();
}

}  // namespace overturn
