/// A boundary between values that do not meet a test and those that do.
#pragma once

namespace overturn {

/// The value from which on `beyond` is true, between `low`, where it is not, and `high`, where it is: the upper end of
/// what so many halvings leave of the bracket. The usual number leaves nothing that a double can tell apart.
template <class Test> [[nodiscard]] double boundary(double low, double high, Test const& beyond, int halvings = 60) {
    for (int i = 0; i < halvings; ++i) {
        double const middle = 0.5 * (low + high);
        (beyond(middle) ? high : low) = middle;
    }
    return high;
}

}  // namespace overturn
