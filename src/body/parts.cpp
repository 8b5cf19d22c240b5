#include "body/parts.hpp"

#include <cmath>

#include "core/error.hpp"

namespace overturn {
namespace {

struct Lump {
    double mass_kg, height_m, inertia_kgm2;
};

/// Checks the figures of one part and reduces it to a lump.
class Lumping {
  public:
    explicit Lumping(std::size_t number) : number_(number) {}

    Lump operator()(Cylinder const& part) const {
        check(part.mass_kg, part.height_m, part.bottom_height_m);
        positive(part.radius_m, "radius", "m");
        double const r = part.radius_m;
        double const h = part.height_m;
        return {part.mass_kg, part.bottom_height_m + h / 2, part.mass_kg * (3 * r * r + h * h) / 12};
    }

    Lump operator()(Box const& part) const {
        check(part.mass_kg, part.height_m, part.bottom_height_m);
        positive(part.width_m, "width", "m");
        double const w = part.width_m;
        double const h = part.height_m;
        return {part.mass_kg, part.bottom_height_m + h / 2, part.mass_kg * (w * w + h * h) / 12};
    }

    Lump operator()(PointMass const& part) const {
        positive(part.mass_kg, "mass", "kg");
        not_below_base(part.height_m, "height");
        return {part.mass_kg, part.height_m, 0};
    }

  private:
    void check(double mass_kg, double height_m, double bottom_height_m) const {
        positive(mass_kg, "mass", "kg");
        positive(height_m, "height", "m");
        not_below_base(bottom_height_m, "bottom height");
    }

    void positive(double value, char const* what, char const* unit) const {
        validate(value > 0 && std::isfinite(value), "part {}: {} of {} {} (must be positive and finite). State it",
                 number_, what, value, unit);
    }

    void not_below_base(double value, char const* what) const {
        validate(value >= 0 && std::isfinite(value),
                 "part {}: {} of {} m (nothing reaches below the base). Count heights from the base upwards", number_,
                 what, value);
    }

    std::size_t number_;
};

}  // namespace

BodyInput assemble(std::span<BodyPart const> parts, double base_width_m) {
    validate(!parts.empty(), "no part (a body needs mass). State at least one part");
    validate(base_width_m > 0 && std::isfinite(base_width_m),
             "base width of {} m (must be positive and finite). State the width of the base", base_width_m);
    double mass = 0;
    double moment = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        auto const lump = std::visit(Lumping(i + 1), parts[i]);
        mass += lump.mass_kg;
        moment += lump.mass_kg * lump.height_m;
    }
    double const centre = moment / mass;
    double inertia = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        auto const lump = std::visit(Lumping(i + 1), parts[i]);
        double const arm = lump.height_m - centre;
        inertia += lump.inertia_kgm2 + lump.mass_kg * arm * arm;
    }
    return {.mass_kg = mass, .half_width_m = base_width_m / 2, .centre_height_m = centre, .inertia_kgm2 = inertia};
}

}  // namespace overturn
