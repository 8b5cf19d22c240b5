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

/// Moment that turns the block back to the ground, over m g R [-]. Equation of motion without slip (Housner 1963, eq.
/// 1, with ground acceleration as in Yim, Chopra & Penzien 1980): phi'' = -p^2 pull, pull = Gv sin psi + A cos psi.
/// Linear in the forcing: with Gv - 1 in place of Gv it is the shaking's share, and -phi' times that its power.
template <class Vertical, class Horizontal, class Sine, class Cosine>
OVERTURN_LAW auto pull(Vertical gv, Horizontal a, Sine s, Cosine c) {
    return mul_add(gv, s, a * c);
}
/// The same sum with the roles of its products exchanged. In lanes mul_add rounds only the product that it is given as
/// a sum: the two differ in the last bit, and results keep the one that each place has had from the start.
template <class Number> OVERTURN_LAW Number pull_in_other_order(Number gv, Number a, Number s, Number c) {
    return mul_add(a, c, gv * s);
}
/// The same without vertical motion, Gv = 1.
template <class Horizontal, class Number> OVERTURN_LAW auto pull(Horizontal a, Number s, Number c) { return s + a * c; }

/// Forces of the ground on the corner over m g: F along the ground, pointing with the rocking side, and N across it.
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

/// Kinetic energy over the mass, of a centre of gravity with these velocities and a rotation about it.
/// \param kappa I_G / (m R^2) \param spin R theta', as a velocity like the others
template <class Number> OVERTURN_LAW Number kinetic_energy(Number across, Number up, Number spin, Number kappa) {
    return 0.5 * (across * across + up * up + kappa * spin * spin);
}

/// Angular deceleration of a block that has just left the ground: -phi'' at phi = 0, p^2 cos alpha (Gv tan alpha + A).
template <class Number>
OVERTURN_LAW Number deceleration_at_ground(Number p, Number cosine_alpha, Number uplift_ratio, Number gv, Number a) {
    return p * p * cosine_alpha * (gv * uplift_ratio + a);
}

/// Duration of the bouncing that starts with a rate phi', under constant forcing: impacts accumulate at a finite time.
/// A small half cycle lasts 2 rate / deceleration. The next one, over the other corner, starts with e times the rate
/// and so on: a geometric series. \param e, next_e restitution on leaving this corner and the other one
template <class Number>
OVERTURN_LAW Number bouncing_time(Number rate, Number deceleration, Number next_deceleration, Number e, Number next_e) {
    return 2 * rate * (1 / deceleration + e / next_deceleration) / (1 - e * next_e);
}
/// An upper bound of it for equal corners, over rate / hold, where hold = Gv tan alpha - |A| is what holds the block on
/// the corner that holds it least: both decelerations are at least p^2 cos alpha hold.
template <class Number> OVERTURN_LAW Number longest_bouncing(Number p, Number cosine_alpha, Number e) {
    return 2 / ((1 - e) * p * p * cosine_alpha);
}

/// A quantity that is linear over a step: where it starts, and its change per unit of time, which is the step itself in
/// lanes.
template <class Number> struct Linear {
    Number start, slope;

    [[nodiscard]] Number at(Number t) const { return start + slope * t; }
    [[nodiscard]] Linear operator-(Number c) const { return {start - c, slope}; }
};

/// The k-th coefficient of a series and the one before: the number that the laws take where a series is worked out term
/// by term, with a Linear as its forcing.
template <class Number> struct Term { Number now, before; };
template <class Number> OVERTURN_LAW Number operator*(Linear<Number> f, Term<Number> x) {
    return mul_add(f.start, x.now, f.slope * x.before);
}
