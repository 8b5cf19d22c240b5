/// A trial's history as a csv file.
#pragma once

#include <string>

#include <fmt/os.h>

#include "rocking/planar_rocking.hpp"

namespace overturn::cli {

/// Writes one line per instant. \throws InputError if the file cannot be made
class HistoryFile : public RockingObserver {
  public:
    explicit HistoryFile(std::string const& path);
    void at(RockingInstant const& instant) override;

  private:
    fmt::ostream file_;
};

}  // namespace overturn::cli
