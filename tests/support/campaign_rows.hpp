/// All rows of a campaign, block after block; of waves that are held to a rule as many as are asked for.
#pragma once

#include "campaign/block_rows.hpp"
#include "campaign/trial.hpp"

namespace overturn::testing {

[[nodiscard]] inline BlockRows rows_of(CampaignSpec const& spec) {
    auto const plan = Plan(spec).without_refusals();
    PhaseSeconds seconds;
    BlockRows all;
    auto const append = [](auto& rows, auto const& more) { rows.insert(rows.end(), more.begin(), more.end()); };
    for (std::int64_t block = 0; block < plan.blocks(); ++block) {
        auto const rows = run_block(spec, plan, block, seconds);
        append(all.waves, rows.waves);
        append(all.measures, rows.measures);
        append(all.trials.rows, rows.trials.rows);
        append(all.trials.extra, rows.trials.extra);
    }
    return all;
}

}  // namespace overturn::testing
