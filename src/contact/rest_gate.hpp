/// Conditions under which a quiet body on points may be held at rest, in the plane and in space: each share is of the
/// value that would move it. All are empirical: how results change with each was not measured. A test in space compares
/// held bodies with followed ones: they end the same way, with peaks within 1e-3 (tests/spatial/reference_test.cpp).
#pragma once

namespace overturn::contact {

/// A body that leans less than this, as the sine of its lean over sin(alpha), may rest. More could be a balance near
/// the critical angle, which is as quiet and may yet fall.
inline constexpr double upright_share = 0.1;
inline constexpr double upright_share_squared = 0.01;

/// Energy of motion and of unbalanced forces below which a body may rest, over m g h.
inline constexpr double quiet_energy_share = 1e-9;

/// Share of the |a| / gv at which the base, pushed slowly, would begin to part from the ground. The rest is left for
/// its swing beyond the place where it would stand still. In space parting_ratio gives that value.
inline constexpr double parting_share = 0.75;
/// The same of any bed in the plane, of b / h: a flat one begins to part at a third of that, every other one later.
inline constexpr double bed_parting_share = parting_share / 3;
/// The same of two corners in the plane, which part at b / h itself.
inline constexpr double corner_parting_share = 0.9;

/// Share of mu: points slip one by one, the one that bears least first.
inline constexpr double friction_share = 0.5;

}  // namespace overturn::contact
