#include "model/friction.hpp"

#include <cmath>

namespace overturn {

double painleve_bound(double inertia_ratio) {
    double const kappa = 1 / inertia_ratio - 1;
    return 2 * std::sqrt(kappa * (1 + kappa));
}

}  // namespace overturn
