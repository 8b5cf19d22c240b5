#include "campaign/output_place.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <thread>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "store/durable.hpp"
#include "store/results_file.hpp"

namespace overturn {
namespace {

void refuse_other(CampaignInput const& begun, CampaignInput const& now, std::string const& place) {
    auto const differences = begun.differences(now);
    validate(differences.empty(), "{}: another campaign ({}). Undo the change, or start anew with another -o", place,
             fmt::join(differences, "; "));
}

// A whole run holds all blocks there could ever be, so that no part can start beside it.
store::BlockRange claimed(Plan const& plan, Part part) {
    return part.is_whole() ? store::BlockRange{0, std::numeric_limits<std::int64_t>::max()} : plan.blocks_of(part);
}

// Two parts may begin at the same time; the campaign that is on record afterwards counts.
void begin(store::ShardFolder const& shards, CampaignInput const& input) {
    shards.begin(input.serialise());
    refuse_other(CampaignInput::deserialise(shards.begun_with()), input, shards.folder().string());
}

// A damaged record is written anew: the blocks themselves tell whose they are.
std::string record_of(store::ShardFolder const& shards) {
    try {
        return shards.begun_with();
    } catch (SystemError const& error) {
        fmt::print(stderr, "{}\n", error.what());
        return {};
    }
}

// Ranks outlive a killed mpirun for some seconds, in which they may finish the file and be at removing the blocks.
bool becomes_free(store::ShardFolder const& shards) {
    constexpr auto pause = std::chrono::milliseconds(50);
    constexpr int most_pauses = 100;
    for (int i = 0; i < most_pauses && store::Claim::held(shards.folder()); ++i) {
        std::this_thread::sleep_for(pause);
    }
    return !store::Claim::held(shards.folder());
}

// Of this very campaign, by the record or, where a kill came after that had gone, by every block itself.
bool are_leftovers(store::ShardFolder const& shards, CampaignInput const& input) {
    if (auto const begun = record_of(shards); !begun.empty()) {
        return CampaignInput::deserialise(begun).sha256() == input.sha256();
    }
    std::vector<std::string> notes;
    (void)shards.committed({0, std::numeric_limits<std::int64_t>::max()}, notes);
    return notes.empty();
}

std::vector<std::int64_t> sound_blocks(store::ShardFolder const& shards, Plan const& plan, Part part) {
    auto const range = plan.blocks_of(part);
    shards.remove_unfinished(range);
    std::vector<std::string> notes;
    auto committed = shards.committed(range, notes);
    for (auto const& note : notes) {
        fmt::print(stderr, "{}\n", note);
    }
    return committed;
}

}  // namespace

void check_complete(std::filesystem::path const& output, CampaignInput const& input, bool claimed) {
    store::ResultsReader const file(output);
    refuse_other({file.text("campaign_name"), file.text("campaign"), {}, {}},
                 {file.text("campaign_name"), input.text, {}, {}}, output.string());
    validate(file.text("input_sha256") == input.sha256(),
             "output {} (made with other settings or input files). Name another with -o", output.string());
    store::ShardFolder const shards(output, input.sha256());
    if (shards.exists() && (claimed || becomes_free(shards)) && are_leftovers(shards, input)) {
        shards.remove();
        fmt::print(stderr, "{}: blocks left over from {} (merged already). Removed\n", shards.folder().string(),
                   output.string());
    }
}

OutputState take_output(std::filesystem::path const& output, store::ShardFolder const& shards,
                        CampaignInput const& input, Plan const& plan, OutputWish const& wish,
                        std::optional<store::Claim>& claim) {
    validate(!std::filesystem::is_directory(output), "output {} (is a folder). Name a file with -o", output.string());
    store::require_writable(output);
    auto const refuse_taken = [&] {
        validate(wish.resume || !std::filesystem::exists(output),
                 "output {} (is there already and would be lost). Remove it, or name another with -o", output.string());
    };
    refuse_taken();
    if (!std::filesystem::exists(output)) {
        claim.emplace(shards.folder(), claimed(plan, wish.part));
    }
    refuse_taken();  // another run may have finished meanwhile
    if (std::filesystem::exists(output)) {
        check_complete(output, input, claim.has_value());
        return {true, {}};
    }
    auto const begun = record_of(shards);
    if (begun.empty()) {
        begin(shards, input);
    } else {
        validate(wish.resume || !wish.part.is_whole(),
                 "{} (an unfinished run lies there). Go on with --resume, or remove it", shards.folder().string());
        refuse_other(CampaignInput::deserialise(begun), input, shards.folder().string());
    }
    auto committed = sound_blocks(shards, plan, wish.part);
    validate(wish.resume || committed.empty(),
             "{}: part {}/{} (has been begun there). Go on with --resume, or remove the folder",
             shards.folder().string(), wish.part.number, wish.part.of);
    if (begun.empty() && committed.empty()) {
        return {};
    }
    if (wish.resume) {
        fmt::print(stderr, "resuming {}: {} of {} blocks are done, {} are left\n", output.string(), committed.size(),
                   plan.blocks_of(wish.part).count(),
                   plan.blocks_of(wish.part).count() - static_cast<std::int64_t>(committed.size()));
    }
    return {false, std::move(committed)};
}

}  // namespace overturn
