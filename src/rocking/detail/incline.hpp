/// Inclined ground: forces and motions along it and across it, from those along the horizon and the vertical.
#pragma once

#include "rocking/detail/power_series.hpp"

namespace overturn::rocking {

/// The ground falls towards +x. Level unless stated, and then it turns nothing: not a bit.
struct Incline {
    double sine = 0, cosine = 1;  ///< of the slope

    [[nodiscard]] bool level() const { return sine == 0; }
    /// \param side of mirrored quantities; 1 of others
    template <class Number>
    [[nodiscard]] ContactForces<Number> turned(ContactForces<Number> const& from, double side) const {
        return level() ? from : with_slope(from, side);
    }
    /// Largest change of a turned pair where each of the pair changes by one.
    [[nodiscard]] double spread() const { return cosine + std::abs(sine); }
    /// Gravity's share included: it drives along the ground.
    [[nodiscard]] Forcing turned(Forcing const& f, double side) const {
        if (level()) {
            return f;
        }
        auto const [along, across] = with_slope<double>({f.horizontal.start, f.vertical.start}, side);
        auto const [along_slope, across_slope] = with_slope<double>({f.horizontal.slope, f.vertical.slope}, side);
        return {{along, along_slope}, {across, across_slope}};
    }
    /// Shaking in a turned forcing: as if gravity pulled across the ground.
    [[nodiscard]] Forcing shaking_of(Forcing const& turned, double side) const {
        return {{turned.horizontal.start + side * sine, turned.horizontal.slope},
                {turned.vertical.start - cosine + 1, turned.vertical.slope}};
    }

  private:
    template <class Number>
    [[nodiscard]] ContactForces<Number> with_slope(ContactForces<Number> const& from, double side) const {
        return turned_to_ground(from, side * sine, cosine);
    }
};

}  // namespace overturn::rocking
