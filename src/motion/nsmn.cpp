#include "core/units.hpp"
#include "motion/detail/record_readers.hpp"

namespace overturn {

// National Strong Motion Network of Turkey (AFAD): 17 lines "KEY : value", then three columns under their names.
constinit TableFormat const nsmn_table{.marks = {"strong ground motion records of tur", "sampling interval", "n-s"},
                                       .unit_mps2 = gal_mps2};

}  // namespace overturn
