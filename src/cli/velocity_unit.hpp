/// The option that says in which unit figures and tables show velocities.
#pragma once

#include "cli/command_line.hpp"
#include "output/shown_velocity.hpp"

namespace overturn::cli {

struct VelocityUnit : output::ShownVelocity {
    void offered_by(Verb& verb) {
        verb.takes("--velocities", symbol, "unit of velocities in figures and tables: kine, m/s");
    }
};

}  // namespace overturn::cli
