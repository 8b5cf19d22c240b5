/// Coulomb friction between base and ground.
#pragma once

namespace overturn {

struct Friction {
    double static_coefficient = 0;
    double kinetic_coefficient = 0;
};

/// Friction from which a slipping corner may jam (Painleve's paradox): 2 sqrt(kappa (1 + kappa)), kappa = I_G/(m R^2);
/// 4/3 for a uniform rectangle. \param inertia_ratio m R^2 / I_O
[[nodiscard]] double painleve_bound(double inertia_ratio);

}  // namespace overturn
