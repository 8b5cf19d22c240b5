#include "model/trial.hpp"

namespace overturn {

Excitation planar_excitation(Trial const& trial) {
    auto shaking = trial.excitation;
    shaking.transverse_mps2 = {};
    if (!has(trial.simulated, Effect::vertical)) {
        shaking.vertical_mps2 = {};
    }
    return shaking;
}

}  // namespace overturn
