/// State of a trial of planar rocking.
#pragma once

#include <cstddef>

#include "rocking/detail/rocking_events.hpp"

namespace overturn::rocking {

/// rest: full base contact, at rest. slide: full contact, slipping. rock: on one corner, stuck. slip_rock: both.
enum class Mode { rest, slide, rock, slip_rock };

/// The motion, mirrored to the corner that the block stands on, or would rise on.
struct State {
    Mode mode = Mode::rest;
    double side = 1;   ///< the corner: at +x (1) or at -x (-1)
    double phi = 0;    ///< side * theta >= 0 [rad]
    double omega = 0;  ///< phi' [rad/s]
    double slip_m = 0, slip_velocity_mps = 0;
    double slip_sign = 0;
    bool slipped = false;                    ///< at some time
    StartRoot start_root = StartRoot::none;  ///< kind of the zero of phi here: at a step's start it is no event
};

/// Place in the wave, beside the time within its sample.
struct Progress {
    std::size_t sample = 0;  ///< the interval from this one to the next
    int steps_here = 0;      ///< within it
};

}  // namespace overturn::rocking
