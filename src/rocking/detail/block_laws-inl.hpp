// The laws of the planar block: equation of motion, contact forces, energy. Each stands here once, for any number: a
// double, a power series in time, or vector lanes. Included inside a namespace: by block_laws.hpp for doubles and
// series, by lane_series-inl.hpp once per instruction set; so without a #pragma once, a namespace and includes.
//
// Symbols, mirrored to the corner that the block stands on (side s = +1 or -1), so that both corners share one formula:
//   phi >= 0       rotation off the ground, phi = s theta [rad]
//   alpha, psi     atan(b/h), and alpha - phi: the angle between R and the vertical [rad]; s, c: its sine and cosine
//   R, r           from the corner to the centre of gravity [m], and R / g [s2]
//   p              sqrt(m g R / I_O) [rad/s]; m R^2 / I_O = r p^2 is the inertia ratio, below 1
//   A, Gv          horizontal acceleration of the ground, mirrored, and 1 + its vertical one, over g [-]
// mul_add(a, b, c) is a b + c: rounded once in lanes, twice in doubles.

/// What turns the block back to the ground, over m g R [-]. Equation of motion without slip (Housner 1963, eq. 1, with
/// ground acceleration as in Yim, Chopra & Penzien 1980): phi'' = -p^2 pull, pull = Gv sin psi + A cos psi.
/// Linear in the forcing: with Gv - 1 in place of Gv it is the shaking's share, and -phi' times that its power.
template <class Vertical, class Horizontal, class Number>
OVERTURN_LAW auto pull(Vertical gv, Horizontal a, Number s, Number c) {
    return mul_add(gv, s, a * c);
}
/// The same without vertical motion, Gv = 1.
template <class Horizontal, class Number> OVERTURN_LAW auto pull(Horizontal a, Number s, Number c) { return s + a * c; }

/// What the ground gives to the corner over m g: F along the ground, pointing with the rocking side, and N across it.
template <class Number> struct ContactForces { Number friction, normal; };

/// Newton's law for the centre of gravity while the corner does not slip, mirrored:
/// F = r (cos psi phi'' + sin psi phi'^2) + A, N = r (sin psi phi'' - cos psi phi'^2) + Gv.
/// \param spin phi'^2; with r phi'' and r phi'^2 for acceleration and spin, r is 1
template <class Number, class Forcing>
OVERTURN_LAW ContactForces<Number> contact_forces(Number const& s, Number const& c, Number const& acceleration,
                                                  Number const& spin, double r, Forcing const& a, Forcing const& gv) {
    return {r * (c * acceleration + s * spin) + a, r * (s * acceleration - c * spin) + gv};
}

/// The same with the acceleration that the equation of motion gives: r phi'' = -grip, grip = r p^2 pull.
/// \param spin r phi'^2
template <class Number>
OVERTURN_LAW ContactForces<Number> contact_forces_in_motion(Number s, Number c, Number spin, Number a, Number gv,
                                                            Number grip) {
    return {mul_add(s, spin, a) - c * grip, gv - mul_add(s, grip, c * spin)};
}

/// A pair of components along the horizon and the vertical, turned to along and across ground that falls towards the
/// corner. \param sine of the slope, mirrored
template <class Number, class Angle>
OVERTURN_LAW ContactForces<Number> turned_to_ground(ContactForces<Number> level, Angle sine, Angle cosine) {
    return {mul_add(level.friction, cosine, -(level.normal * sine)),
            mul_add(level.friction, sine, level.normal * cosine)};
}

/// Energy of rocking above rest over m g R: (phi'/p)^2 / 2 + cos psi - cos alpha. \param rate phi' / p
template <class Number> OVERTURN_LAW Number rocking_energy(Number rate, Number potential) {
    return mul_add(0.5 * rate, rate, potential);
}
