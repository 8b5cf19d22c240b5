#include "cli/campaign_hazard.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/json_values.hpp"
#include "cli/named_files.hpp"
#include "core/error.hpp"
#include "output/frequency_text.hpp"
#include "output/json.hpp"
#include "output/summary_tables.hpp"
#include "results/hazard_frequency.hpp"
#include "results/hazard_table.hpp"

namespace overturn::cli {

std::optional<HazardCurve> hazard_of_campaign(std::string const& path, CampaignInput const& input,
                                              CampaignSpec const& spec) {
    if (path.empty()) {
        return stated_hazard(input, spec.levels);
    }
    validate(!spec.is_grid(),
             "--hazard for waves on a grid of frequencies (no random sample: nothing happens so often a year). "
             "Leave it out");
    return parse_hazard(read_named(path), path, spec.levels);
}

std::vector<BodyFrequency> add_frequencies(std::string const& path, CampaignInput const& input,
                                           CampaignSpec const& spec, Statistics const& statistics,
                                           std::vector<BodyAnalysis> const& analysis, double confidence, Json& data) {
    auto const stated = hazard_of_campaign(path, input, spec);
    if (!stated) {
        return {};
    }
    auto const& hazard = *stated;
    auto frequencies = frequencies_of(spec, statistics, analysis, hazard, confidence);
    data["fit"].update(output::json_of(output::frequency_tables(spec.levels.units(), frequencies, hazard, confidence)));
    data["facts"].push_back(
        {"hazard curve", fmt::format("{}: {}", path.empty() ? input.hazard_file() : path, output::range_text(hazard))});
    auto notes = Json::array();
    for (auto const& remark : hazard.remarks()) {
        notes.push_back(fmt::format("Hazard curve: {}.", remark));
    }
    for (auto const& of : frequencies) {
        for (auto const& note : output::frequency_notes(of, hazard)) {
            notes.push_back(fmt::format("{}: {}.", output::frequency_name(of), note));
        }
    }
    data["frequency_notes"] = std::move(notes);
    return frequencies;
}

}  // namespace overturn::cli
