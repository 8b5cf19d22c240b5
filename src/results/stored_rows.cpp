#include "results/stored_rows.hpp"

#include <cstddef>
#include <span>
#include <utility>

#include "results/schema.hpp"
#include "results/stored_names.hpp"

namespace overturn {

StoredRows::StoredRows(store::ResultsReader const& file, CampaignSpec const& spec)
    : file_(file),
      selector_(spec.effects, spec.accuracy),
      trials_(file.length("trials/verdict")),
      waves_(file.length("waves/id")),
      trial_table_(stored_trial_table(file, spec)),
      wave_table_(held_in(file, overturn::wave_table(spec))),
      own_tables_(extra_tables(selector_)) {
    for (auto& table : overturn::measure_tables(spec)) {
        measure_tables_.push_back(held_in(file, std::move(table)));
    }
}

TrialRows StoredRows::trials(std::int64_t first, std::int64_t count) const {
    std::size_t const size = count;
    TrialRows trials{std::vector<TrialRow>(size), std::vector<std::byte>(size * selector_.extra_bytes())};
    file_.rows(trial_table_, trials_, first, std::as_writable_bytes(std::span(trials.rows)));
    for (auto const& table : own_tables_) {
        file_.rows(table, trials_, first, trials.extra);
    }
    return trials;
}

std::vector<WaveRow> StoredRows::waves(std::int64_t first, std::int64_t count) const {
    std::vector<WaveRow> waves(count);
    file_.rows(wave_table_, waves_, first, std::as_writable_bytes(std::span(waves)));
    return waves;
}

std::vector<MeasureRow> StoredRows::measures(std::int64_t first, std::int64_t count) const {
    std::vector<MeasureRow> measures(count * measure_tables_.size());
    for (auto const& table : measure_tables_) {
        file_.rows(table, waves_, first, std::as_writable_bytes(std::span(measures)));
    }
    return measures;
}

}  // namespace overturn
