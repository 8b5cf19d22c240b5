/// History of a trial, instant by instant.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>

#include "core/units.hpp"

namespace overturn {

/// One quantity of a history.
struct Channel {
    std::string_view key;  ///< with its unit: "rotation_rad"
};

/// Receives a trial as it runs: first the channels (ModelTraits), then instants in order of time, both sides of every
/// impact.
class Observer {
  public:
    virtual void begin(std::span<Channel const> channels) = 0;
    /// \param values one for each channel
    virtual void at(std::span<double const> values) = 0;

    Observer() = default;
    Observer(Observer const&) = delete;
    Observer& operator=(Observer const&) = delete;
    Observer(Observer&&) = delete;
    Observer& operator=(Observer&&) = delete;
    virtual ~Observer() = default;
};

/// Shows the steps of a falling body up to the instant at which it lies: of the step that passes a tilt of 90 degrees,
/// what lies between its ends by linear interpolation. \tparam Row array of a step's values
template <class Row> class UntilItLies {
  public:
    UntilItLies(Observer& observer, std::size_t tilt) : observer_(observer), tilt_(tilt) {}

    void at(Row row) {
        double const tilt = std::abs(row[tilt_]);
        if (double const before = std::abs(before_[tilt_]); tilt > pi / 2 && before < pi / 2) {
            double const share = (pi / 2 - before) / (tilt - before);
            for (std::size_t i = 0; i < row.size(); ++i) {
                row[i] = before_[i] + share * (row[i] - before_[i]);
            }
        }
        before_ = row;
        observer_.at(row);
    }

  private:
    Observer& observer_;
    std::size_t tilt_;
    Row before_{};
};

}  // namespace overturn
