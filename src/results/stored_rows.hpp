/// Rows of a results file as they were computed, some at a time.
#pragma once

#include <cstdint>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "campaign/trial.hpp"
#include "response/model_selector.hpp"
#include "store/results_file.hpp"

namespace overturn {

/// Reads trials, waves and what waves measure of each body. A column that the file does not have is unknown.
class StoredRows {
  public:
    /// \param file and `spec` outlive it
    StoredRows(store::ResultsReader const& file, CampaignSpec const& spec);

    [[nodiscard]] std::int64_t wave_count() const { return waves_; }

    [[nodiscard]] TrialRows trials(std::int64_t first, std::int64_t count) const;
    [[nodiscard]] std::vector<WaveRow> waves(std::int64_t first, std::int64_t count) const;
    /// Wave by wave, then body.
    [[nodiscard]] std::vector<MeasureRow> measures(std::int64_t first, std::int64_t count) const;

    /// The columns that the file has of /waves, and of /waves/<body> for each body.
    [[nodiscard]] store::TableSpec const& wave_table() const { return wave_table_; }
    [[nodiscard]] std::vector<store::TableSpec> const& measure_tables() const { return measure_tables_; }

  private:
    store::ResultsReader const& file_;
    ModelSelector selector_;
    std::int64_t trials_, waves_;
    store::TableSpec trial_table_, wave_table_;
    std::vector<store::TableSpec> measure_tables_, own_tables_;
};

}  // namespace overturn
