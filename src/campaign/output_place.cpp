#include "campaign/output_place.hpp"

#include <algorithm>

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

}  // namespace

OutputState take_output(std::filesystem::path const& output, store::ShardFolder const& shards,
                        CampaignInput const& input, Plan const& plan, bool resume) {
    OutputState state;
    validate(!std::filesystem::is_directory(output), "output {} (is a folder). Name a file with -o", output.string());
    store::require_writable(output);
    if (std::filesystem::exists(output)) {
        validate(resume, "output {} (is there already and would be lost). Remove it, or name another with -o",
                 output.string());
        store::ResultsReader const file(output);
        refuse_other({file.text("campaign_name"), file.text("campaign"), {}, {}},
                     {file.text("campaign_name"), input.text, {}, {}}, output.string());
        validate(file.text("input_sha256") == input.sha256(),
                 "output {} (made with other settings or input files). Name another with -o", output.string());
        state.complete = true;
        return state;
    }
    if (!shards.exists() || shards.begun_with().empty()) {
        shards.begin(input.serialise());
        return state;
    }
    validate(resume, "{} (an unfinished run lies there). Go on with --resume, or remove it", shards.folder().string());
    refuse_other(CampaignInput::deserialise(shards.begun_with()), input, shards.folder().string());
    std::vector<std::string> notes;
    state.committed = shards.committed(notes);
    std::erase_if(state.committed, [&](std::int64_t block) { return block >= plan.blocks(); });
    for (auto const& note : notes) {
        fmt::print(stderr, "{}\n", note);
    }
    fmt::print(stderr, "resuming {}: {} of {} blocks are done, {} are left\n", output.string(), state.committed.size(),
               plan.blocks(), plan.blocks() - static_cast<std::int64_t>(state.committed.size()));
    return state;
}

}  // namespace overturn
