/// Options for the sections of results that run, merge and fit print.
#pragma once

#include <string>

#include <fmt/ranges.h>

#include "cli/velocity_unit.hpp"
#include "output/sections.hpp"

namespace overturn::cli {

struct TextChoice {
    std::string sections;
    bool full = false;
    VelocityUnit unit;

    void offered_by(Verb& verb) {
        verb.takes("--full", full, "also print all sections below the answer");
        verb.takes("--section", sections,
                   "also print these sections below the answer, e.g. stripes,curves; sections: "
                       + fmt::format("{}", fmt::join(output::section_names(), ", ")));
        unit.offered_by(verb);
    }
    /// \throws InputError
    [[nodiscard]] output::TextOptions options() const {
        return {.sections = output::read_sections(sections), .full = full, .velocities = unit.measures()};
    }
};

}  // namespace overturn::cli
