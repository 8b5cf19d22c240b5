/// Content of a record file: named components of one station, and their placement into a GroundMotion.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "config/registry.hpp"
#include "core/error.hpp"
#include "motion/component_name.hpp"
#include "motion/ground_motion.hpp"

namespace overturn {

struct RecordComponent {
    std::string name;  ///< as the file calls it; empty if it does not
    Direction direction = Direction::unknown;
    std::vector<double> acceleration_mps2;  ///< [m/s2]
};

/// One file. Components may differ in length by what their provider cut off.
struct Recording {
    double time_step_s = 0;  ///< [s]
    std::vector<RecordComponent> components;
    double unit_mps2 = 0;                      ///< what one unit of the file's numbers was taken for [m/s2]
    std::string format = {};                   ///< as which it was read: a name of record_formats()
    std::vector<std::string> statements = {};  ///< what the file's text says and is used: "line 3: gal"
    std::vector<std::string> unread = {};      ///< its lines of text that are not understood
    bool in_borehole = false;                  ///< as it says: not at the surface
};

/// Components of a file that become part of the motion.
enum class ComponentChoice {
    file,        ///< all that the file holds
    horizontal,  ///< one horizontal component only
    station      ///< all that the files of the same station beside it hold
};

/// The choices under the names users write.
[[nodiscard]] std::span<config::Entry<ComponentChoice> const> component_choices();

/// A motion and one line on what went where: "NS, transverse EW, vertical UD, cut to 3250 samples".
struct PlacedRecord {
    GroundMotion motion;
    std::string says;
    Direction direction = Direction::unknown;  ///< of what lies in the rocking plane
    std::vector<std::string> components = {};  ///< their names: horizontal, transverse, vertical, as far as present
    std::string format = {};                   ///< as which the file was read
    double unit_mps2 = 0;                      ///< what one unit of its numbers was taken for [m/s2]
    std::vector<std::string> statements = {};  ///< as those of Recording
    std::vector<std::string> unread = {};
    bool in_borehole = false;  ///< as its file says

    /// "knet, NS, gal, 0.01 s, 6000 samples, 59.99 s": what a reader can be checked by.
    [[nodiscard]] std::string read_as() const;
};

/// The other sign, for what is recorded downwards.
void turn(std::vector<double>& acceleration_mps2);

/// Places the first horizontal component (or the one called `first`) into the rocking plane, the other horizontal one
/// across it and the vertical one upwards, turning its sign if it is recorded downwards. A single component goes into
/// the rocking plane whatever its direction (a spectrum may be asked of it): see validate_rocking_plane. Components are
/// cut to the shortest, which the line then says. \throws InputError at `where` if it is not clear which component is
/// which, or if `first` is the vertical one of several that are all to be placed
[[nodiscard]] PlacedRecord place(Recording recording, std::string_view first, ComponentChoice choice,
                                 Location const& where);

/// Before a body is rocked. \throws InputError at `where` if what lies in the rocking plane was recorded vertically.
void validate_rocking_plane(Direction direction, Location const& where);

}  // namespace overturn
