/// A power spectral density stated by points, as sites have them.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/table.hpp"
#include "core/input_files.hpp"

namespace overturn {

/// One-sided: straight lines between the points, nothing below the first and beyond the last.
class PointDensity {
  public:
    /// \param points frequency [Hz] and power density, in any unit: only its shape counts
    /// \throws InputError unless there are two at least, frequencies rise from 0 or above, no density is negative and
    /// some is positive
    explicit PointDensity(std::vector<std::pair<double, double>> points);

    [[nodiscard]] double at(double frequency_hz) const;
    /// Over all frequencies, exactly [unit of the density times Hz].
    [[nodiscard]] double integral_hz() const;
    [[nodiscard]] double first_hz() const { return points_.front().first; }
    [[nodiscard]] double last_hz() const { return points_.back().first; }

  private:
    std::vector<std::pair<double, double>> points_;
};

/// Its keys: points, or a file of two columns.
extern config::KeyTable const point_density_table;

/// \throws InputError at the key
[[nodiscard]] PointDensity read_point_density(config::Table const& table, InputFiles& files);

}  // namespace overturn
