/// Inclined ground: forces and motions along it and across it, from those along the horizon and the vertical.
#pragma once

#include "rocking/detail/contact_series.hpp"

namespace overturn::rocking {

/// The ground falls towards +x. Level unless stated, and then it turns nothing: not a bit.
struct Incline {
    double sine = 0, cosine = 1;  ///< of the slope

    struct Pair {
        double along, across;
    };
    /// \param side of mirrored quantities; 1 of others
    [[nodiscard]] Pair turned(double horizontal, double vertical, double side) const {
        double const s = side * sine;
        return {cosine * horizontal - s * vertical, s * horizontal + cosine * vertical};
    }
    /// What a turned pair may change by, at most, where each of the pair changes by one.
    [[nodiscard]] double spread() const { return cosine + std::abs(sine); }
    /// Gravity's share included: it drives along the ground.
    [[nodiscard]] Forcing turned(Forcing const& f, double side) const {
        auto const now = turned(f.horizontal, f.vertical, side);
        auto const slope = turned(f.horizontal_slope, f.vertical_slope, side);
        return {now.along, slope.along, now.across, slope.across};
    }
    /// What of a turned forcing is shaking: as if gravity pulled across the ground.
    [[nodiscard]] Forcing shaking_of(Forcing const& turned, double side) const {
        return {turned.horizontal + side * sine, turned.horizontal_slope, turned.vertical - cosine + 1,
                turned.vertical_slope};
    }
    template <int Order> void turn(ContactSeries<Order>& contact, double side) const {
        if (sine == 0) {
            return;
        }
        for (std::size_t k = 0; k < contact.normal.size(); ++k) {
            auto const [along, across] = turned(contact.friction[k], contact.normal[k], side);
            contact.friction[k] = along;
            contact.normal[k] = across;
        }
    }
};

}  // namespace overturn::rocking
