#include "generators/detail/axes.hpp"

#include <cmath>
#include <string>

namespace overturn {

AxesRequest read_axes(config::Table const& table) {
    if (!table.has("axes")) {
        return {};
    }
    if (table.kind("axes") == config::Kind::text && table.text(axes_key).find("deg") == std::string::npos
        && table.text(axes_key).find("rad") == std::string::npos) {
        return {table.choice<Axes>(axes_key, axes_names), 0};
    }
    return {Axes::turned, table.number(axes_key)};
}

double principal_angle(GroundMotion const& motion) {
    double along = 0;
    double across = 0;
    double both = 0;
    for (std::size_t i = 0; i < motion.samples(); ++i) {
        double const x = motion.horizontal_mps2[i];
        double const y = motion.transverse_mps2[i];
        along += x * x;
        across += y * y;
        both += x * y;
    }
    return 0.5 * std::atan2(2 * both, along - across);
}

void turn_axes(GroundMotion& motion, double angle_rad) {
    double const c = std::cos(angle_rad);
    double const s = std::sin(angle_rad);
    for (std::size_t i = 0; i < motion.samples(); ++i) {
        double const x = motion.horizontal_mps2[i];
        double const y = motion.transverse_mps2[i];
        motion.horizontal_mps2[i] = c * x + s * y;
        motion.transverse_mps2[i] = c * y - s * x;
    }
}

}  // namespace overturn
