#include <cmath>
#include <string>

#include <fmt/format.h>

#include "core/wrapped.hpp"
#include "cost/study_output.hpp"

namespace overturn::cost {
namespace {

std::string error_text(double value) { return std::isnan(value) ? "-" : fmt::format("{:.1e}", value); }

std::string seconds_text(double seconds) {
    constexpr double milli = 1e-3;
    constexpr double micro = 1e-6;
    return seconds >= milli ? fmt::format("{:.3g} ms", seconds / milli) : fmt::format("{:.3g} us", seconds / micro);
}

std::string flips_text(Measured const& row) {
    return row.trials == 0 ? "-" : fmt::format("{} of {}", row.flips, row.trials);
}

void append_knob(std::string& text, KnobResult const& result) {
    auto const& knob = result.knob;
    text += fmt::format("\n{}: {}\nerror: {}\n", knob.name, knob.title, knob.error);
    text += fmt::format("  {:<17} {:>11} {:>8} {:>8} {:>8} {:>14} {:>9} {:>8}\n", "", "CPU a " + knob.timed, "median",
                        "95 %", "worst", "changed", "P error", "KS");
    for (auto const& row : result.rows) {
        text += fmt::format("{}{} {:<17} {:>11} {:>8} {:>8} {:>8} {:>14} {:>9} {:>8}\n", row.here ? ">" : " ",
                            row.on_front ? "*" : " ", row.setting.label, seconds_text(row.seconds),
                            error_text(row.error.median), error_text(row.error.p95), error_text(row.error.worst),
                            flips_text(row),
                            std::isnan(row.probability_error) ? "-" : fmt::format("{:+.5f}", row.probability_error),
                            std::isnan(row.ks) ? "-" : fmt::format("{:.5f}", row.ks));
    }
    text += wrapped(result.advice);
}

void append_step_error(std::string& text, StepError const& error) {
    text += fmt::format(
        "\nquantities: effect of half the step, and of a motion one last bit smaller (chaos, not error)\n"
        "error: relative, of trials with the same verdict\n"
        "  {:<26} {:>7} {:>8} {:>8} {:>8} {:>8}\n",
        "", "trials", "median", "95 %", "last bit", "95 %");
    for (auto const& quantity : error.quantities) {
        text += fmt::format("  {:<26} {:>7} {:>8} {:>8} {:>8} {:>8}\n", quantity.name, quantity.step.count,
                            error_text(quantity.step.median), error_text(quantity.step.p95),
                            error_text(quantity.rounding.median), error_text(quantity.rounding.p95));
    }
    text += fmt::format("Verdicts that change, of 1000 trials: half the step {:.3g}, a last bit {:.3g}.\n",
                        error.step_flips_per_thousand(), error.rounding_flips_per_thousand());
}

void append_sampling(std::string& text, Study const& study) {
    text += fmt::format(
        "\nwaves: effect of their number\n"
        "error: width of the {:g} % Clopper-Pearson interval of P(overturn), mean of {} stripes\n"
        "  {:>6} {:>11} {:>8} {:>10}\n",
        100 * study.confidence, study.sampling.stripes, "waves", "CPU", "width", "1/sqrt(n)");
    for (auto const& point : study.sampling.subsets) {
        text += fmt::format("  {:>6} {:>11} {:>8.4f} {:>10.4f}\n", point.waves, seconds_text(point.seconds),
                            point.width, point.root_n_width);
    }
    text += fmt::format("Campaign: {} waves, width {:.4f}, {:.3g} s of CPU time.\n", study.campaign_waves,
                        2 * study.sampling.half_width, study.sampling.seconds);
}

void append_rare(std::string& text, RareCost const& rare) {
    text += fmt::format("\nrare: scatter of P(overturn) of {} at factor {:g}, {}\nerror: standard error over P\n",
                        rare.body, rare.amplitude,
                        rare.probability ? fmt::format("P = {:.2e}", *rare.probability) : "not resolved");
    text += fmt::format("  {:<14} {:<20} {:>11} {:>10} {:>7}\n", "", "", "CPU", "waves", "c.o.v.");
    for (auto const& point : rare.points) {
        text += fmt::format("  {:<14} {:<20} {:>11} {:>10} {:>7}  {}\n", name_of(point.method), point.effort,
                            fmt::format("{:.3g} s", point.seconds), point.waves,
                            point.cov > 0 ? fmt::format("{:.3f}", point.cov) : "-", point.reason);
    }
}

}  // namespace

std::string study_text(Study const& study) {
    auto text = study.title + "\n" + wrapped(study.sentence) + wrapped(study.effect) + "\n";
    text += wrapped(fmt::format("sample: {} of {} waves, {} of {} trials; reference: {} per trial", study.waves,
                                study.campaign_waves, study.trials, study.campaign_trials,
                                seconds_text(study.reference_seconds)));
    auto const& rounding = study.rounding;
    text +=
        wrapped(fmt::format("rounding alone: two references differ by {} (median), {} (95 %), {} (worst), and in {} "
                            "of {} verdicts",
                            error_text(rounding.peak.median), error_text(rounding.peak.p95),
                            error_text(rounding.peak.worst), rounding.flips, rounding.trials));
    text += "> value of the campaign   * on the Pareto front: no other value is both faster and more accurate\n";
    append_step_error(text, study.step_error);
    if (study.continuous) {
        text +=
            "\nA round base without points presses all along its rim or face: there is no number of points to vary.\n";
    }
    for (auto const& result : study.knobs) {
        append_knob(text, result);
    }
    if (!study.is_grid) {
        append_sampling(text, study);
    }
    if (study.rare) {
        append_rare(text, *study.rare);
    }
    return text;
}

}  // namespace overturn::cost
