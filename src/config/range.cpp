#include "config/range.hpp"

#include <cmath>

#include <fmt/format.h>

namespace overturn::config {

bool Range::holds(double value) const {
    bool const above = low_open ? value > low : value >= low;
    bool const below = high_open ? value < high : value <= high;
    return above && below;
}

std::string Range::text() const {
    bool const no_low = std::isinf(low);
    bool const no_high = std::isinf(high);
    if (no_low && no_high) {
        return "any number";
    }
    if (no_high) {
        return fmt::format("{} {}", low_open ? "above" : "at least", low);
    }
    if (no_low) {
        return fmt::format("{} {}", high_open ? "below" : "at most", high);
    }
    if (!low_open && !high_open) {
        return fmt::format("from {} to {}", low, high);
    }
    return fmt::format("{} {}, {} {}", low_open ? "above" : "from", low, high_open ? "below" : "at most", high);
}

}  // namespace overturn::config
