#include "results/few_waves.hpp"

#include <span>

#include "results/recount.hpp"
#include "results/stored_names.hpp"

namespace overturn {

bool are_few_records(CampaignSpec const& spec, std::int64_t waves) {
    constexpr std::int64_t most = 12;
    return waves <= most && !spec.source->name(0).empty();
}

bool are_too_few_records(CampaignSpec const& spec, std::int64_t waves) {
    return are_few_records(spec, waves) && spec.source->about().shared.among(waves) < least_records;
}

std::optional<FragilityState> no_sample(CampaignSpec const& spec, std::int64_t waves) {
    return spec.is_grid()                     ? std::optional(FragilityState::grid)
           : are_too_few_records(spec, waves) ? std::optional(FragilityState::few_records)
                                              : std::nullopt;
}

std::vector<TrialRow> trials_of_few_waves(CampaignSpec const& spec, store::ResultsReader const& file) {
    if (!are_few_records(spec, plan_in(file, spec).waves())) {
        return {};
    }
    std::vector<TrialRow> rows(file.integers("trials/wave").size());
    file.rows(stored_trial_table(file, spec), rows.size(), 0, std::as_writable_bytes(std::span(rows)));
    return rows;
}

}  // namespace overturn
