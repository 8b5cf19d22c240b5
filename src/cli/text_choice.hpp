/// Options for the sections of results that run, merge and fit print.
#pragma once

#include <string>
#include <vector>

#include <fmt/ranges.h>

#include "cli/velocity_unit.hpp"
#include "config/suggestion.hpp"
#include "core/error.hpp"
#include "core/parts_of.hpp"
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
        suggest();
        return {.sections = output::read_sections(sections), .full = full, .velocities = unit.measures()};
    }

  private:
    // What was probably meant, before all that there are.
    void suggest() const {
        auto const names = output::section_names();
        std::vector<std::string> const known(names.begin(), names.end());
        for (auto const part : parts_of(sections, ',')) {
            auto const near = config::nearest_name(part, known);
            validate(part.empty() || near.empty() || near == part,
                     "--section '{}' (no such section). Did you mean '{}'? The last line of overturn fit FILE lists "
                     "those of a file",
                     part, near);
        }
    }
};

}  // namespace overturn::cli
