#include "cli/history.hpp"

#include "campaign/typed_units.hpp"
#include "cli/named_files.hpp"
#include "core/units.hpp"

namespace overturn::cli {

HistoryFile::HistoryFile(std::string const& path) : file_(open_named(path)) {}

HistoryFile::HistoryFile(std::string const& path, CampaignSpec const& spec) : HistoryFile(path) {
    for (auto const& [end, dimension] :
         {std::pair{"_m", Dimension::length}, {"_mps", Dimension::velocity}, {"_rad", Dimension::angle}}) {
        if (auto const unit = unit_of_columns(spec, dimension); unit && unit->symbol != si_symbol(dimension)) {
            typed_.emplace_back(end, *unit);
        }
    }
}

void HistoryFile::begin(std::span<Channel const> channels) {
    for (std::size_t i = 0; i < channels.size(); ++i) {
        file_.print("{}{}", i == 0 ? "" : ",", channels[i].key);
        for (auto const& [end, unit] : typed_) {
            if (channels[i].key.ends_with(end)) {
                repeated_.emplace_back(i, unit);
            }
        }
    }
    for (auto const& [i, unit] : repeated_) {
        auto const key = channels[i].key;
        file_.print(",{} [{}]", key.substr(0, key.rfind('_')), unit.symbol);
    }
    file_.print("\n");
}

void HistoryFile::at(std::span<double const> values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        file_.print("{}{}", i == 0 ? "" : ",", values[i]);
    }
    for (auto const& [i, unit] : repeated_) {
        file_.print(",{}", unit.of(values[i]));
    }
    file_.print("\n");
}

}  // namespace overturn::cli
