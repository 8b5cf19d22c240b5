/// Planar rocking, sliding and crushing of a body on compliant points: no event but touch, slip and yield of a point.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "contact/base_layout.hpp"
#include "contact/contact_accuracy.hpp"
#include "model/excitation.hpp"
#include "model/outcome.hpp"

namespace overturn {

/// State at the start: at rest, settled under its weight, unless stated. Anchors stand where the points stood upright.
struct ContactStart {
    double sway_m = 0;  ///< of the centre of gravity
    double rise_m = 0;  ///< of the centre of gravity above its settled height
    double rotation_rad = 0;
    double sway_mps = 0, rise_mps = 0, velocity_radps = 0;
};

/// Quantities of the contact model beside every model's outcome.
struct ContactQuantities {
    double peak_crush_m = never;
    double peak_contact_force_ratio = never;
    double peak_rise_m = never;
    double residual_x_m = never;                           ///< of the base's middle, at the end
    double edge_x_most_m = never, edge_x_least_m = never;  ///< farthest that a corner of the base has reached
    double peak_top_m = never;                             ///< longest way of the axis at twice the height h
    double rotation_most_rad = never, rotation_least_rad = never;
    double restitution = never, corner_share = never, normal_restitution = never;  ///< of the base, as matched
};
template <> [[nodiscard]] Fields const& fields_of<ContactQuantities>();

/// Friction demand and work are not known to this model: NaN. impacts: passages of theta through zero faster than
/// g / (w_v b). contact_lost_s: the first flight. Slip is of the corner that the body leans on. peak_rotation_ratio and
/// response velocity: of the geometry of the points' corners.
struct ContactOutcome : Outcome {
    ContactQuantities extra;
    double crest_rad = 0, trough_rad = 0;  ///< largest and smallest theta
    double end_sway_mps = 0;               ///< x' when it ended
};

/// One instant of a history.
struct ContactInstant {
    double time_s, rotation_rad, velocity_radps, sway_m, sway_mps, rise_m, rise_mps;  ///< rise: z - h
    double contact_force_ratio = 1;  ///< over the weight, at the start of the step before
    double crush_m = 0;              ///< deepest that the pad keeps
    double slip_m = 0;               ///< of the corner that it leans on, from where it stood
};

/// Receives every step's start.
class ContactObserver {
  public:
    virtual void at(ContactInstant const& instant) = 0;

    ContactObserver() = default;
    ContactObserver(ContactObserver const&) = delete;
    ContactObserver& operator=(ContactObserver const&) = delete;
    ContactObserver(ContactObserver&&) = delete;
    ContactObserver& operator=(ContactObserver&&) = delete;
    virtual ~ContactObserver() = default;
};

/// m x'' = sum Fx - m a_x, m z'' = sum Fz - m (g + a_z), I_G theta'' = sum (dz Fx - dx Fz); theta clockwise: a_x > 0
/// tips to theta < 0, as in simulate_rocking. Every point presses by F = k d + damping that grows with the depth (Hunt
/// & Crossley 1975), yields at its strength and keeps the crush, and grips by a spring from an anchor up to mu F
/// (Cundall & Strack 1979). RK4 at a fixed step, a whole number of steps per sample; what points remember is frozen
/// within a step. Overturned at |theta| = pi/2; after the wave the body is followed until it rests. Allocates little,
/// never while it steps.
///
/// \pre quantities are positive; components agree in length
[[nodiscard]] ContactOutcome simulate_contact(ContactBlock const& block, Excitation const& shaking,
                                              ContactAccuracy const& accuracy = {},
                                              std::optional<ContactStart> const& start = {},
                                              ContactObserver* observer = nullptr);

struct ContactTrial {
    ContactBlock const* block = nullptr;  ///< outlives the trial
    Excitation shaking;
};

/// Many trials from rest, side by side in the machine's vector lanes: outcomes[i] is bit-equal to that of trials[i]
/// alone. Trials come in any mixture. \param before_each called before every trial; what it throws ends them all
void simulate_contact(std::span<ContactTrial const> trials, ContactAccuracy const& accuracy,
                      std::span<ContactOutcome> outcomes, std::function<void()> const& before_each = {});

/// Leaning on its corner, or its rim, at this angle, at rest, as deep as its weight presses it, not yet dragged aside.
/// \pre |rotation_rad| < alpha
[[nodiscard]] ContactStart leaning_start(ContactBlock const& block, double rotation_rad);

}  // namespace overturn
