/// The unit in which people read an intensity, which is SI everywhere else.
#pragma once

#include <string>

#include <fmt/format.h>

namespace overturn {

struct IntensityUnit {
    std::string symbol;  ///< "gal"; "1" or nothing for a pure number
    double si = 1;       ///< SI value of one of it

    [[nodiscard]] double of(double intensity) const { return intensity / si; }
    /// "892 gal", "1.5"
    [[nodiscard]] std::string text(double intensity) const {
        return symbol.empty() || symbol == "1" ? fmt::format("{:.4g}", of(intensity))
                                               : fmt::format("{:.4g} {}", of(intensity), symbol);
    }
};

}  // namespace overturn
