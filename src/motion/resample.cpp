#include "motion/resample.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "motion/detail/low_pass.hpp"
#include "motion/intensity.hpp"

namespace overturn {
namespace {

/// \param ratio new step over old
std::vector<double> along_lines(std::vector<double> const& values, double ratio, std::size_t count) {
    std::vector<double> read(values.empty() ? 0 : count);
    for (std::size_t i = 0; i < read.size(); ++i) {
        double const at = static_cast<double>(i) * ratio;
        auto const before = std::min(static_cast<std::size_t>(at), values.size() - 1);
        auto const after = std::min(before + 1, values.size() - 1);
        double const share = at - static_cast<double>(before);
        read[i] = values[before] + share * (values[after] - values[before]);
    }
    return read;
}

void read_coarsely(GroundMotion const& from, double time_step_s, std::size_t count, Resampled& made) {
    auto const read = [&](std::vector<double> const& values) {
        return values.empty() ? values : low_passed(values, from.time_step_s, time_step_s, count);
    };
    made.motion.horizontal_mps2 = read(from.horizontal_mps2);
    made.motion.transverse_mps2 = read(from.transverse_mps2);
    made.motion.vertical_mps2 = read(from.vertical_mps2);
    auto const band = LowPass::for_step(time_step_s);
    made.says = fmt::format(
        "{} s read at {} s behind a low-pass (zero phase, up to {:.4g} Hz kept, 80 dB off from "
        "{:.4g} Hz on), {}",
        from.time_step_s, time_step_s, band.pass_hz, band.stop_hz, changes_text(from, made.motion));
}

/// `ratio` without the rounding of steps such as 0.01 that are no binary fractions.
double cleaned(double ratio) {
    constexpr double rounding = 1e-9;
    double const whole = std::round(ratio);
    double const inverse = std::round(1 / ratio);
    if (std::abs(ratio - whole) <= rounding * ratio) {
        return whole;
    }
    return std::abs(1 / ratio - inverse) <= rounding / ratio ? 1 / inverse : ratio;
}

}  // namespace

Resampled resample(GroundMotion const& motion, double time_step_s, Coarsening coarsening) {
    validate(time_step_s > 0 && std::isfinite(time_step_s), "time step {} s (must be positive and finite). Mend it",
             time_step_s);
    double const ratio = cleaned(time_step_s / motion.time_step_s);
    validate(ratio <= 1 || coarsening == Coarsening::accepted,
             "time step {} s, longer than the record's {} s (what shakes faster than the new grid is lost). "
             "State resample = \"coarser\" if that is meant",
             time_step_s, motion.time_step_s);
    constexpr double slack = 1e-9;
    auto const count =
        1 + static_cast<std::size_t>(std::floor(static_cast<double>(motion.samples() - 1) / ratio + slack));
    validate(count > 1, "time step {} s (longer than the wave). Lower it", time_step_s);
    Resampled made;
    made.motion.time_step_s = time_step_s;
    if (ratio > 1) {
        read_coarsely(motion, time_step_s, count, made);
        return made;
    }
    made.motion.horizontal_mps2 = along_lines(motion.horizontal_mps2, ratio, count);
    made.motion.transverse_mps2 = along_lines(motion.transverse_mps2, ratio, count);
    made.motion.vertical_mps2 = along_lines(motion.vertical_mps2, ratio, count);
    made.changed = ratio != 1 / std::round(1 / ratio);
    made.says = fmt::format("{} s read at {} s along straight lines, {}", motion.time_step_s, time_step_s,
                            made.changed ? changes_text(motion, made.motion) : std::string("PGA kept"));
    return made;
}

}  // namespace overturn
