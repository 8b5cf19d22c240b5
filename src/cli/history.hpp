/// A trial's history as a csv file.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/os.h>

#include "campaign/campaign_spec.hpp"
#include "model/history.hpp"
#include "stats/intensity_unit.hpp"

namespace overturn::cli {

/// Writes a line of the channels' names, then one per instant: SI, and behind it again what the campaign states in
/// other units, with a heading such as "slip [in]". \throws InputError if the file cannot be made
class HistoryFile : public Observer {
  public:
    explicit HistoryFile(std::string const& path);
    HistoryFile(std::string const& path, CampaignSpec const& spec);
    void begin(std::span<Channel const> channels) override;
    void at(std::span<double const> values) override;

  private:
    fmt::ostream file_;
    std::vector<std::pair<std::string, IntensityUnit>> typed_;          ///< by the end of a channel's key: "_m"
    std::vector<std::pair<std::size_t, IntensityUnit>> repeated_ = {};  ///< channels that come again in their unit
};

}  // namespace overturn::cli
