/// A trial's history as a csv file.
#pragma once

#include <string>

#include <fmt/os.h>

#include "model/history.hpp"

namespace overturn::cli {

/// Writes a line of the channels' names, then one per instant. \throws InputError if the file cannot be made
class HistoryFile : public Observer {
  public:
    explicit HistoryFile(std::string const& path);
    void begin(std::span<Channel const> channels) override;
    void at(std::span<double const> values) override;

  private:
    fmt::ostream file_;
};

}  // namespace overturn::cli
