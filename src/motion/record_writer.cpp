#include "motion/record_writer.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/units.hpp"

namespace overturn {

std::string at2_text(std::span<double const> acceleration_mps2, double time_step_s, std::string_view identity,
                     std::string_view component) {
    constexpr std::size_t per_line = 5;
    std::string title(identity);
    std::replace(title.begin(), title.end(), '\n', ' ');
    auto text = fmt::format(
        "ACCELEROGRAM IN THE LAYOUT OF PEER AT2\n{}, {}\nACCELERATION TIME SERIES IN UNITS OF G\n"
        "NPTS= {}, DT= {} SEC\n",
        title, component, acceleration_mps2.size(), time_step_s);
    for (std::size_t i = 0; i < acceleration_mps2.size(); ++i) {
        bool const last = i % per_line == per_line - 1 || i + 1 == acceleration_mps2.size();
        text += fmt::format("{:15.7E}{}", acceleration_mps2[i] / g0, last ? "\n" : "");
    }
    return text;
}

std::string csv_text(GroundMotion const& motion) {
    std::string text = "time_s,ax_mps2";
    text += motion.transverse_mps2.empty() ? "" : ",ay_mps2";
    text += motion.vertical_mps2.empty() ? "\n" : ",az_mps2\n";
    for (std::size_t i = 0; i < motion.samples(); ++i) {
        text += fmt::format("{},{}", static_cast<double>(i) * motion.time_step_s, motion.horizontal_mps2[i]);
        if (!motion.transverse_mps2.empty()) {
            text += fmt::format(",{}", motion.transverse_mps2[i]);
        }
        if (!motion.vertical_mps2.empty()) {
            text += fmt::format(",{}", motion.vertical_mps2[i]);
        }
        text += '\n';
    }
    return text;
}

}  // namespace overturn
