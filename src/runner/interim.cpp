#include "runner/interim.hpp"

#include <utility>
#include <vector>

#include "campaign/accepted_waves.hpp"
#include "campaign/block_rows.hpp"
#include "campaign/plan.hpp"
#include "core/error.hpp"
#include "results/recount.hpp"
#include "runner/merge.hpp"
#include "runner/output_place.hpp"
#include "store/results_file.hpp"
#include "store/shards.hpp"

namespace overturn {

bool is_finished(std::filesystem::path const& output) {
    if (!std::filesystem::exists(output)) {
        return false;
    }
    auto const record = store::ShardFolder(output, "").begun_with();
    store::ResultsReader const file(output, store::Trust::unverified);
    return record.empty() || CampaignInput::deserialise(record).block_key() == input_of(file).block_key();
}

Interim interim_results(std::filesystem::path const& output) {
    auto input = begun_campaign(output);
    auto spec = std::make_unique<CampaignSpec>(parse_campaign(input));
    Plan const plan(*spec);
    store::ShardFolder const shards(output, input.block_key());
    auto const& acceptance = spec->source->about().acceptance;
    Statistics statistics(*spec);
    std::int64_t blocks = 0;
    std::int64_t counted = 0;
    for (auto const block : sound_blocks(shards, plan, {0, plan.blocks()})) {
        auto const [first, count] = plan.waves_of_block(block);
        auto rows = BlockRows::unpack(shards.read(block), plan, count);
        std::vector<std::int64_t> tried;
        for (std::int64_t w = 0; w < count; ++w) {
            if (is_tried(acceptance, rows.waves[w])) {
                tried.push_back(first + w);
            } else {
                statistics.add_refused(rows.waves[w]);
            }
        }
        counted += std::ssize(tried);
        auto const chosen = plan.chosen(std::move(tried), plan.count());
        statistics.add(rows_of_chosen(std::move(rows), plan, block, chosen));
        ++blocks;
    }
    validate(counted > 0, "{}: nothing to fit yet (no wave of the run is complete). Try again later", output.string());
    return {std::move(input),
            std::move(spec),
            std::move(statistics),
            blocks,
            acceptance.refuses() ? std::nullopt : std::optional(plan.blocks()),
            counted,
            plan.asked()};
}

}  // namespace overturn
