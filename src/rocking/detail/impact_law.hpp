/// The law of the base impact: rotation and slip after it, and the friction that it needs.
#pragma once

#include <cmath>

namespace overturn::rocking {

/// The base impact: the block leaves one corner and lands on the other with e times its rate (Housner 1963: angular
/// momentum about the new corner; or a stated e), while the corner's slip changes by a friction-limited impulse.
/// Lengths in units of R.
struct ImpactLaw {
    double sine_alpha, cosine_alpha;  ///< b / R, h / R of the corner that it comes from
    double kappa;                     ///< I_G / (m R^2)
    double restitution;
    double friction_static, friction_kinetic;
    double sine_next;  ///< b of the other corner, over R; sine_alpha unless the corners differ

    /// Kinetic energy over m R^2 for rotation rate w and corner velocity v (over R), before the impact.
    [[nodiscard]] double energy(double w, double v) const { return energy_about(sine_alpha, w, v); }
    /// The same after it.
    [[nodiscard]] double energy_after(double w, double v) const { return energy_about(sine_next, w, v); }
    /// P_z over m R |w| of an impact with restitution e: what the centre's fall and rise sum to, b (1 + e) |w|.
    [[nodiscard]] double impulse(double e) const {
        return sine_next == sine_alpha ? sine_alpha * (1 + e) : sine_alpha + sine_next * e;
    }
    /// |P_x| / P_z of an impact after which the corner sticks, of a corner that did not slip: h (1 - e) / [b (1 + e)].
    [[nodiscard]] double friction_demand() const { return cosine_alpha * (1 - restitution) / impulse(restitution); }

  private:
    // kinetic_energy(across, arm w, w, kappa), but for the order of its sum, which results' last bits keep.
    [[nodiscard]] double energy_about(double arm, double w, double v) const {
        double const across = v + cosine_alpha * w;
        return 0.5 * (across * across + (arm * arm + kappa) * w * w);
    }
};

struct AfterImpact {
    double rotation_rate;  ///< theta' [rad/s]
    double slip_rate;      ///< x' / R [1/s]
};

/// The corner sticks if |P_x| <= mu_s P_z, else it slips on with mu_k, never backwards.
/// \param e the restitution in force
[[nodiscard]] inline AfterImpact after_impact_with(ImpactLaw const& law, double w, double v, double e) {
    double const vertical = law.impulse(e) * std::abs(w);
    double const wanted = v + law.cosine_alpha * w * (1 - e);  // minus the impulse that no slip needs
    if (std::abs(wanted) <= law.friction_static * vertical) {
        return {e * w, 0};
    }
    double const given = law.friction_kinetic * vertical;
    return {e * w, std::abs(wanted) <= given ? 0 : wanted - std::copysign(given, wanted)};
}

/// Impact of a body that rotates at w while its corner slips at v (over R). A stated restitution can ask for more
/// energy than a slipping body brings; then the rebound is lowered to what conserves it: an impact never adds energy.
[[nodiscard]] inline AfterImpact after_impact(ImpactLaw const& law, double w, double v) {
    auto after = after_impact_with(law, w, v, law.restitution);
    double const before = law.energy(w, v);
    if (v == 0 || law.energy_after(after.rotation_rate, after.slip_rate) <= before) {
        return after;
    }
    double low = 0;
    double high = law.restitution;
    constexpr int halvings = 60;  // beyond the 53 bits of a double
    for (int i = 0; i < halvings; ++i) {
        double const middle = 0.5 * (low + high);
        after = after_impact_with(law, w, v, middle);
        (law.energy_after(after.rotation_rate, after.slip_rate) <= before ? low : high) = middle;
    }
    return after_impact_with(law, w, v, low);
}

}  // namespace overturn::rocking
