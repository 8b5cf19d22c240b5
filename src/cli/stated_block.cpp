#include "cli/stated_block.hpp"

#include <cmath>

#include "campaign/warnings.hpp"
#include "cli/scene_files.hpp"
#include "contact/matching.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "rocking/rocking_models.hpp"

namespace overturn::cli {

double stated_angle(std::string_view text, char const* option) {
    try {
        return parse_quantity(text, Dimension::angle);
    } catch (InputError const& error) {
        throw InputError(fmt::format("{} {}", option, error.what()));
    }
}

double stated_alpha(std::string_view text) {
    double const alpha = stated_angle(text, "--alpha");
    validate(alpha > 0 && alpha < pi / 2,
             "--alpha {} (read as {:.4g} deg; it must lie between 0 and 90). Mend it or its unit", text,
             alpha * 180 / pi);
    return alpha;
}

double stated_restitution(double value) {
    validate(value >= 0 && value <= 1,
             "--restitution {} (angular velocity behind an impact over that before it, 0 to 1). Mend it", value);
    return value;
}

PlaneBody plane_body(std::string const& file, char const* spectrum) {
    auto const spec = load_body(file);
    validate(!spec.body.needs_planar_rocking(),
             "{}: slope, offset or initial tilt ({} is of a symmetric body at rest). Leave it out", file, spectrum);
    note_warnings(warnings_of(spec));
    PlaneBody plane{spec, block_of(spec.body), {}};
    if (spec.friction) {
        bool const slides_first = spec.friction->static_coefficient < std::tan(spec.body.alpha_rad());
        plane.left_out.push_back(fmt::format("{}: its friction {:g}{}", spec.name, spec.friction->static_coefficient,
                                             slides_first ? ", with which it slides before it rocks" : ""));
    }
    if (spec.footing.stated) {
        std::string own;
        if (spec.footing.base.shape != BaseShape::polygon && !spec.footing.pad.match_restitution) {
            plane.block.restitution = matched_footing(spec.body, spec.footing).restitution;
            own = fmt::format(", but for the restitution {:.4f} that they give it", plane.block.restitution);
        }
        plane.left_out.push_back(fmt::format("{}: its base and pad{}", spec.name, own));
    }
    return plane;
}

}  // namespace overturn::cli
