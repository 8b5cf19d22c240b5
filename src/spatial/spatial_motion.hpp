/// Rocking, rolling, sliding, spinning and crushing of a body on compliant points in space, shaken by three components.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>

#include "contact/planar_contact.hpp"
#include "model/excitation.hpp"
#include "model/outcome.hpp"
#include "spatial/spatial_block.hpp"

namespace overturn {

/// State at the start: at rest, settled under its weight, unless stated. Anchors stand where the points stood upright.
struct SpatialStart {
    double x_m = 0, y_m = 0;                         ///< of the centre of gravity
    double rise_m = 0;                               ///< of the centre of gravity above its settled height
    std::array<double, 3> rotation_rad{};            ///< rotation vector
    std::array<double, 3> velocity_mps{};            ///< of the centre of gravity
    std::array<double, 3> angular_velocity_radps{};  ///< about the body's own axes
};

/// Quantities of motion in space beside every model's outcome. Yaw is the turn about the body's axis that is left when
/// its tilt is undone the shortest way; slip as in SpatialOutcome.
struct SpatialQuantities {
    double peak_crush_m = never;
    double peak_contact_force_ratio = never;
    double peak_rise_m = never;
    double yaw_rad = never;
    double peak_yaw_rad = never;
    double slip_path_m = never;
    double residual_x_m = never, residual_y_m = never;  ///< of the base's centre, at the end
    /// Farthest that the circle round the base has reached, from where the axis stood.
    double edge_x_most_m = never, edge_x_least_m = never, edge_y_most_m = never, edge_y_least_m = never;
    double peak_top_m = never;           ///< longest way from its start, in plan, of the axis at twice the height h
    double landing_azimuth_rad = never;  ///< in which the body lies, from x towards y
    double restitution = never, corner_share = never, normal_restitution = never;  ///< of the base, as matched
};
template <> [[nodiscard]] Fields const& fields_of<SpatialQuantities>();

/// Rotation is the tilt: the angle between the body's axis and the vertical. Friction demand and work are not known to
/// this model: NaN. impacts: reversals of the tilt faster than g / (w_v b) and within half a period of the vertical
/// mode, about one axis the passages of theta through zero. contact_lost_s: the first flight. peak_slip_m: longest way
/// from its start of the base, which stands where it leans over its nearest edge. Energy and response velocity, sqrt(2
/// g lift): of the height of the centre of gravity above the body's lowest point, less h; in the rocking plane that is
/// the planar definition up to its peak, and over a corner it may exceed V_Ereq.
struct SpatialOutcome : Outcome {
    SpatialQuantities extra;
    std::array<double, 2> residual_m{};        ///< of the base's centre
    std::array<double, 3> end_velocity_mps{};  ///< of the centre of gravity when it ended
};

/// One instant of a history.
struct SpatialInstant {
    double time_s = 0;
    double x_m = 0, y_m = 0;                ///< of the base's centre
    double rise_m = 0;                      ///< of the centre of gravity above h
    std::array<double, 4> quaternion{};     ///< w, x, y, z: from the body's axes to those of space
    std::array<double, 3> velocity_mps{};   ///< of the centre of gravity
    std::array<double, 3> angular_radps{};  ///< about the body's own axes
    double contact_force_ratio = 0;         ///< over the weight; of the step before in the last instant
    double yaw_rad = 0;
    double crush_m = 0;      ///< deepest that the pad keeps
    double energy_jpkg = 0;  ///< of motion, height and springs, over the mass; none in settled rest

    [[nodiscard]] double tilt_rad() const;
    /// Direction in which the body's top leans, from x towards y [rad].
    [[nodiscard]] double azimuth_rad() const;
    /// The tilt as a rotation vector: about x and about y. About y is the planar theta.
    [[nodiscard]] std::array<double, 2> tilts_rad() const;
};

/// Receives every step's start.
class SpatialObserver {
  public:
    virtual void at(SpatialInstant const& instant) = 0;

    SpatialObserver() = default;
    SpatialObserver(SpatialObserver const&) = delete;
    SpatialObserver& operator=(SpatialObserver const&) = delete;
    SpatialObserver(SpatialObserver&&) = delete;
    SpatialObserver& operator=(SpatialObserver&&) = delete;
    virtual ~SpatialObserver() = default;
};

/// m r'' = sum F - m (a_x, a_y, g + a_z), I w' = sum (X, Y, -h) x R^T F - w x I w about the body's own axes. Points
/// press and grip as those of simulate_contact, friction bounding the length of the horizontal force; RK4 at its step,
/// shorter where inertia is less than a uniform solid's. About one axis and on a square base it is simulate_contact.
/// Overturned at a tilt of pi/2; after the wave the body is followed until it rests. Allocates little, never while
/// it steps.
///
/// \pre quantities are positive; components agree in length
[[nodiscard]] SpatialOutcome simulate_spatial(SpatialBlock const& block, Excitation const& shaking,
                                              ContactAccuracy const& accuracy = {},
                                              std::optional<SpatialStart> const& start = {},
                                              SpatialObserver* observer = nullptr);

struct SpatialTrial {
    SpatialBlock const* block = nullptr;  ///< outlives the trial
    Excitation shaking;
};

/// Many trials from rest, side by side in the machine's vector lanes: outcomes[i] is bit-equal to that of trials[i]
/// alone. Trials come in any mixture. \param before_each called before every trial; what it throws ends them all
void simulate_spatial(std::span<SpatialTrial const> trials, ContactAccuracy const& accuracy,
                      std::span<SpatialOutcome> outcomes, std::function<void()> const& before_each = {});

}  // namespace overturn
