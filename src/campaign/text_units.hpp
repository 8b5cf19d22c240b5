/// Units in which texts and tables show numbers.
#pragma once

#include "stats/intensity_unit.hpp"

namespace overturn {

/// Units for texts and tables; where the input states none, the values here.
struct TypedUnits {
    IntensityUnit mass{"t", 1e3};
    IntensityUnit length{"m", 1};  ///< of bodies
    /// Of slip and distances: mm instead of m or km, inches instead of feet, so that small values keep their digits.
    IntensityUnit slip{"mm", 1e-3};
    IntensityUnit acceleration{"m/s2", 1};
    IntensityUnit velocity{"m/s", 1};
    IntensityUnit pressure{"MPa", 1e6};
};

}  // namespace overturn
