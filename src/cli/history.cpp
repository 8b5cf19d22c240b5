#include "cli/history.hpp"

#include <system_error>

#include "core/error.hpp"

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

void HistoryFile::begin(std::span<Channel const> channels) {
    for (std::size_t i = 0; i < channels.size(); ++i) {
        file_.print("{}{}", i == 0 ? "" : ",", channels[i].key);
    }
    file_.print("\n");
}

void HistoryFile::at(std::span<double const> values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        file_.print("{}{}", i == 0 ? "" : ",", values[i]);
    }
    file_.print("\n");
}

}  // namespace overturn::cli
