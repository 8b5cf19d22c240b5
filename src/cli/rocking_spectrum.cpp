#include "cli/rocking_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <utility>

#include "campaign/warnings.hpp"
#include "cli/number_grid.hpp"
#include "cli/stated_block.hpp"
#include "core/error.hpp"
#include "core/parts_of.hpp"
#include "core/units.hpp"
#include "motion/intensity.hpp"
#include "output/record_text.hpp"
#include "rocking/rocking_models.hpp"

namespace overturn::cli {
namespace {

double housner_restitution(double alpha_rad) { return 1 - 1.5 * std::pow(std::sin(alpha_rad), 2); }

std::vector<RockingBlock> stated_blocks(std::string const& alphas, std::optional<double> restitution) {
    std::string_view const stated = alphas.empty() ? "10 deg,15 deg,20 deg" : std::string_view(alphas);
    std::vector<RockingBlock> blocks;
    for (auto const part : parts_of(stated, ',')) {
        double const alpha = stated_alpha(part);
        double const e = restitution ? stated_restitution(*restitution) : housner_restitution(alpha);
        validate(e >= 0,
                 "--alpha {} (Housner's restitution is {:.3g}: such a block does not rock on). State --restitution",
                 part, e);
        blocks.push_back({.alpha_rad = alpha, .restitution = e});
    }
    return blocks;
}

RockingBlock block_of_file(output::RockingSpectrum& spectrum, std::string const& body) {
    auto plane = plane_body(body, "a rocking spectrum");
    spectrum.body = plane.spec.name;
    spectrum.units = plane.spec.units;
    spectrum.left_out = std::move(plane.left_out);
    spectrum.body_period_s = 2 * pi / plane.block.p_radps;
    return plane.block;
}

output::RockingCurve curve_of(RockingBlock block, Excitation const& shaking, std::vector<double> const& periods) {
    std::vector<RockingTrial> trials;
    for (double const period : periods) {
        block.p_radps = 2 * pi / period;
        trials.push_back({block, shaking});
    }
    std::vector<RockingOutcome> outcomes(trials.size());
    simulate_rocking(trials, {}, Slip::ignored, outcomes);
    output::RockingCurve curve{.alpha_rad = block.alpha_rad, .restitution = block.restitution, .points = {}};
    for (std::size_t i = 0; i < periods.size(); ++i) {
        curve.points.push_back({periods[i], outcomes[i].peak_rotation_rad, outcomes[i].verdict});
    }
    return curve;
}

}  // namespace

void RockingSpectrumOptions::offered_by(Verb& verb) {
    verb.takes("--rocking", asked, "largest tilt of blocks of many sizes under the wave; with --alpha, --restitution");
    verb.takes(
        "--rocking-periods", periods,
        "values of 2 pi / p [s]: 1,2,5 or first:last:count; default 1:8:36 (uniform blocks with R = 0.19 to 12 m)");
}

output::RockingSpectrum rocking_spectrum(RockingSpectrumOptions const& options, RecordOptions const& record,
                                         std::string const& alphas, std::optional<double> restitution,
                                         std::string const& body) {
    validate(!record.wave.empty(), "--wave (missing). State the record of the rocking spectrum");
    validate(body.empty() || (alphas.empty() && !restitution),
             "--alpha and --restitution beside --body (it states them). Leave one of them out");
    output::RockingSpectrum spectrum;
    auto const blocks =
        body.empty() ? stated_blocks(alphas, restitution) : std::vector<RockingBlock>{block_of_file(spectrum, body)};
    constexpr double shortest_s = 1e-2;
    constexpr double longest_s = 1e3;
    auto periods =
        number_grid(options.periods.empty() ? "1:8:36" : options.periods, "--rocking-periods", shortest_s, longest_s);
    if (spectrum.body_period_s) {
        periods.push_back(*spectrum.body_period_s);
    }
    std::ranges::sort(periods);
    auto const placed = load_motion(record);
    validate_rocking_plane(placed.direction, {record.wave});
    note_warnings(warnings_of(placed.motion));
    spectrum.record = std::filesystem::path(record.wave).filename().string();
    spectrum.units = output::units_of(placed, spectrum.units);
    spectrum.pga_mps2 = peak_of(placed.motion.horizontal_mps2);
    Excitation const shaking{.horizontal_mps2 = placed.motion.horizontal_mps2,
                             .vertical_mps2 = placed.motion.vertical_mps2,
                             .time_step_s = placed.motion.time_step_s};
    for (auto const& block : blocks) {
        spectrum.curves.push_back(curve_of(block, shaking, periods));
    }
    return spectrum;
}

}  // namespace overturn::cli
