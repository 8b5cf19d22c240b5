#include "cli/stated_block.hpp"

#include "campaign/warnings.hpp"
#include "cli/scene_files.hpp"
#include "core/error.hpp"
#include "core/units.hpp"

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
    validate(alpha > 0 && alpha < pi / 2, "--alpha {} (must lie between 0 and 90 deg). Mend it", text);
    return alpha;
}

double stated_restitution(double value) {
    validate(value >= 0 && value <= 1,
             "--restitution {} (angular velocity behind an impact over that before it, 0 to 1). Mend it", value);
    return value;
}

BodySpec symmetric_body(std::string const& file, char const* spectrum) {
    auto spec = load_body(file);
    validate(!spec.body.needs_planar_rocking(),
             "{}: slope, offset or initial tilt ({} is of a symmetric body at rest). Leave it out", file, spectrum);
    note_warnings(warnings_of(spec));
    return spec;
}

}  // namespace overturn::cli
