/// History of a trial, instant by instant.
#pragma once

#include <span>
#include <string_view>

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

}  // namespace overturn
