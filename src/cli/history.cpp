#include "cli/history.hpp"

#include <system_error>

#include "campaign/typed_units.hpp"
#include "core/error.hpp"
#include "core/units.hpp"

namespace overturn::cli {
namespace {

fmt::ostream open(std::string const& path) {
    try {
        return fmt::output_file(path);
    } catch (std::system_error const& error) {
        throw InputError(fmt::format("{}: cannot be written ({}). Choose another place", path, error.code().message()));
    }
}

}  // namespace

HistoryFile::HistoryFile(std::string const& path) : file_(open(path)) {}

HistoryFile::HistoryFile(std::string const& path, CampaignSpec const& spec) : HistoryFile(path) {
    for (auto const& [end, dimension] :
         {std::pair{"_m", Dimension::length}, {"_mps", Dimension::velocity}, {"_rad", Dimension::angle}}) {
        if (auto const unit = typed_unit(spec, dimension); unit && unit->symbol != si_symbol(dimension)) {
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
