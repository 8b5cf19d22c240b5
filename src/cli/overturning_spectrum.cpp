#include "cli/overturning_spectrum.hpp"

#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/ranges.h>

#include "body/rigid_body.hpp"
#include "campaign/warnings.hpp"
#include "cli/number_grid.hpp"
#include "cli/stated_block.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "generators/pulse_shape.hpp"
#include "motion/intensity.hpp"
#include "output/record_text.hpp"
#include "rocking/rocking_models.hpp"

namespace overturn::cli {
namespace {

constexpr int samples_per_period = 2000;  // chords miss a sine by 1.2e-6 of its peak at most; jumps are jumps
constexpr double default_highest = 30;
constexpr double default_step = 0.01;

RockingBlock stated_block(OverturningOptions const& options) {
    validate(options.p.has_value() && !options.alpha.empty() && options.restitution.has_value(),
             "--overturning (no body). State --body, or all of --p, --alpha and --restitution");
    double const alpha = stated_alpha(options.alpha);
    validate(*options.p > 0 && std::isfinite(*options.p), "--p {} (rad/s, above 0). Mend it", *options.p);
    return {.alpha_rad = alpha, .p_radps = *options.p, .restitution = stated_restitution(*options.restitution)};
}

void take_body(output::OverturningSpectrum& spectrum, OverturningOptions const& options, std::string const& body) {
    if (body.empty()) {
        spectrum.block = stated_block(options);
        spectrum.body = "stated block";
        return;
    }
    validate(!options.p && options.alpha.empty() && !options.restitution,
             "--p, --alpha and --restitution beside --body (it states them). Leave one of them out");
    auto plane = plane_body(body, "an overturning spectrum");
    spectrum.block = plane.block;
    spectrum.body = plane.spec.name;
    spectrum.units = plane.spec.units;
    spectrum.left_out = std::move(plane.left_out);
}

PulseParameters stated_parameters(OverturningOptions const& options) {
    constexpr double longest = 100;
    PulseParameters const stated{*options.gamma, stated_angle(options.phase, "--phase")};
    validate(stated.gamma > 1 && stated.gamma <= longest,
             "--gamma {} (periods that the pulse lasts, above 1, to {}). Mend it", stated.gamma, longest);
    return stated;
}

void sweep(output::OverturningSpectrum& spectrum, OverturningOptions const& options) {
    auto const& shape_entry = config::find_entry(pulse_shapes(), options.pulse, "--pulse");
    bool const parametric = options.pulse == parametric_pulse;
    validate(parametric == (options.gamma.has_value() && !options.phase.empty())
                 && (parametric || (!options.gamma && options.phase.empty())),
             "--gamma and --phase (both are stated for --pulse {}, and for no other pulse). Mend it", parametric_pulse);
    PulseParameters parameters;
    if (parametric) {
        parameters = stated_parameters(options);
        spectrum.parameters = parameters;
    }
    validate(options.ratios.empty() || options.frequencies.empty(),
             "--ratios beside --frequencies (both say which). Leave one of them out");
    auto const shape = shape_entry.value(parameters);
    double const hz_per_ratio = spectrum.block.p_radps / (2 * pi);
    bool const in_hz = !options.frequencies.empty();
    double const unit = in_hz ? hz_per_ratio : 1;
    constexpr double least_ratio = 1e-4;  // beyond these a pulse is a step, or a push of no length
    constexpr double most_ratio = 1e4;
    std::string const ratios = options.ratios.empty() ? "0.5:10:40" : options.ratios;
    auto const grid = number_grid(in_hz ? options.frequencies : ratios, in_hz ? "--frequencies" : "--ratios",
                                  least_ratio * unit, most_ratio * unit);
    spectrum.shaking = options.pulse;
    if (options.linearised && options.pulse.ends_with("-sine")) {
        spectrum.half_cycles = options.pulse == "one-sine" ? 2 : 1;
    }
    for (double const value : grid) {
        double const frequency = in_hz ? value : value * hz_per_ratio;
        auto const pulse = sample_pulse_alone(shape, 1 / frequency, 1 / frequency / samples_per_period);
        Excitation const shaking{.horizontal_mps2 = pulse.values, .time_step_s = pulse.time_step_s};
        spectrum.points.push_back({frequency, overturning_ranges(spectrum.block, shaking, spectrum.scan)});
    }
}

void scale_record(output::OverturningSpectrum& spectrum, OverturningOptions const& options,
                  RecordOptions const& record) {
    validate(options.ratios.empty() && options.frequencies.empty() && !options.gamma && options.phase.empty(),
             "--ratios, --frequencies, --gamma or --phase (they are of pulses). State --pulse in place of --wave");
    auto const placed = load_motion(record);
    validate_rocking_plane(placed.direction, {record.wave});
    auto const& motion = placed.motion;
    note_warnings(warnings_of(motion));
    spectrum.of_record = true;
    spectrum.units = output::units_of(placed, spectrum.units);
    spectrum.shaking = std::filesystem::path(record.wave).filename().string();
    spectrum.peak_mps2 = peak_of(motion.horizontal_mps2);
    Excitation const shaking{.horizontal_mps2 = motion.horizontal_mps2,
                             .vertical_mps2 = motion.vertical_mps2,
                             .time_step_s = motion.time_step_s};
    spectrum.points.push_back({0, overturning_ranges(spectrum.block, shaking, spectrum.scan)});
}

}  // namespace

void OverturningOptions::offered_by(Verb& verb) {
    verb.takes("--overturning", asked, "find every amplitude of a pulse, or factor on the wave, that overturns a body");
    verb.takes("--pulse", pulse,
               fmt::format("with --overturning: {}", fmt::join(config::names_of(pulse_shapes()), ", ")));
    verb.takes("--p", p, "frequency parameter of the block [rad/s], in place of --body");
    verb.takes("--alpha", alpha, "critical angle of the block, e.g. \"14 deg\"");
    verb.takes("--restitution", restitution, "coefficient of restitution of the block");
    verb.takes("--ratios", ratios,
               "omega/p of the pulse, omega = 2 pi / its period: 1,2,5 or first:last:count; default 0.5:10:40");
    verb.takes("--frequencies", frequencies, "frequencies of the pulse in Hz, in place of --ratios");
    verb.takes("--gamma", gamma, "gamma of the pulse mavroeidis-papageorgiou");
    verb.takes("--phase", phase, "phase of the pulse mavroeidis-papageorgiou, e.g. \"90 deg\"");
    verb.takes("--highest", highest,
               fmt::format("largest amplitude of the scan, over the amplitude of uplift; default {}", default_highest));
    verb.takes("--step", step,
               fmt::format("step of the scan: ratio of successive amplitudes minus 1; default {}", default_step));
    verb.takes("--linearised", linearised, "use the linearised block, as in the literature");
    verb.takes("-o,--output", output, "with --overturning or --rocking: write the result as csv");
}

bool OverturningOptions::states_more() const { return has_pulse_or_scan() || restitution || !(alpha + output).empty(); }

bool OverturningOptions::has_pulse_or_scan() const {
    return p || gamma || highest || step || linearised || !(pulse + phase + ratios + frequencies).empty();
}

output::OverturningSpectrum overturning_spectrum(OverturningOptions const& options, RecordOptions const& record,
                                                 std::string const& body) {
    validate(options.pulse.empty() != record.wave.empty(), "--overturning (of one pulse or one wave). State {}",
             options.pulse.empty() ? "--pulse or --wave" : "one of them");
    constexpr double finest = 1e-5;
    double const highest = options.highest.value_or(default_highest);
    double const step = options.step.value_or(default_step);
    validate(highest > 1 && highest <= 1e4, "--highest {} (above 1, to 10000). Mend it", highest);
    validate(step >= finest && step <= 1, "--step {} ({} to 1). Mend it", step, finest);
    validate(options.pulse.empty() || !record.says_how_to_read(),
             "--unit, --time-step and the like beside --pulse (they are of a record). Leave them out");
    output::OverturningSpectrum spectrum;
    spectrum.scan = {.highest = highest,
                     .step = step,
                     .accuracy = {.restoring = options.linearised ? Restoring::linear : Restoring::nonlinear}};
    take_body(spectrum, options, body);
    if (options.pulse.empty()) {
        scale_record(spectrum, options, record);
    } else {
        sweep(spectrum, options);
    }
    return spectrum;
}

}  // namespace overturn::cli
