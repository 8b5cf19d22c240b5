#include "output/overturning_text.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/outward.hpp"
#include "core/units.hpp"
#include "core/wrapped.hpp"
#include "output/detail/left_out.hpp"
#include "rocking/closed_forms.hpp"

namespace overturn::output {
namespace {

constexpr int digits = 5;

bool falls(Fate fate) { return fate == Fate::after_impact || fate == Fate::without_impact; }

bool leaves_the_ground(OverturningPoint const& point) {
    return std::ranges::any_of(point.found.ranges,
                               [](FateRange const& range) { return range.fate == Fate::undecided; });
}

std::string words_of(Fate fate) {
    std::string words = name_of(fate);
    for (auto& c : words) {
        c = c == '-' ? ' ' : c;
    }
    return words;
}

Json ranges_json(OverturningSpectrum const& spectrum, OverturningPoint const& point) {
    auto ranges = Json::array();
    for (auto const& range : point.found.ranges) {
        double const from = range.from * spectrum.peak_mps2;
        double const to = range.to * spectrum.peak_mps2;
        Json one{{"fate", name_of(range.fate)},
                 {"from_mps2", from},
                 {"to_mps2", to},
                 {"from_over_alpha_g", from / spectrum.alpha_g_mps2()},
                 {"to_over_alpha_g", to / spectrum.alpha_g_mps2()},
                 {"stated",
                  {{"from", stated_json(from, spectrum.units.acceleration)},
                   {"to", stated_json(to, spectrum.units.acceleration)}}}};
        if (spectrum.of_record) {
            one["from_factor"] = range.from;
            one["to_factor"] = range.to;
        }
        ranges.push_back(std::move(one));
    }
    return ranges;
}

std::string parameters_text(OverturningSpectrum const& spectrum) {
    return spectrum.parameters ? fmt::format(" (gamma {:g}, phase {:g} deg)", spectrum.parameters->gamma,
                                             spectrum.parameters->phase_rad * 180 / pi)
                               : "";
}

std::string head_of(OverturningSpectrum const& spectrum) {
    auto const& block = spectrum.block;
    bool const linear = spectrum.scan.accuracy.restoring == Restoring::linear;
    return fmt::format(
               "{} under {}{}: {}rigid block on two corners, in one plane, without slip\n"
               "alpha {:.5g} deg, p {:.5g} rad/s, e {:.5g}; alpha g = {:.5g} {}\n",
               spectrum.body, spectrum.shaking, parameters_text(spectrum), linear ? "linearised " : "",
               block.alpha_rad * 180 / pi, block.p_radps, block.restitution,
               spectrum.units.acceleration.of(spectrum.alpha_g_mps2()), spectrum.units.acceleration.symbol)
           + left_out_text(spectrum.left_out);
}

// What is seen of the ranges in so many digits: one that stands, and is too narrow for them, is not.
std::vector<FateRange> seen_of(OverturningRanges const& found, double per) {
    std::vector<FateRange> seen;
    for (auto const& range : found.ranges) {
        double const from = rounded_up(range.from / per, digits);
        double const to = falls(range.fate) ? rounded_up(range.to / per, digits) : rounded_down(range.to / per, digits);
        if (range.fate == Fate::stands && !seen.empty() && to <= from) {
            continue;
        }
        if (!seen.empty() && seen.back().fate == range.fate) {
            seen.back().to = to;
        } else {
            seen.push_back({range.fate, from, to});
        }
    }
    return seen;
}

// "stands to 3.0323; overturns with impact to 6.7431; stands to 7.493; ...", in the unit of `per`.
std::string ranges_text(OverturningRanges const& found, double per) {
    std::vector<std::string> parts;
    for (auto const& range : seen_of(found, per)) {
        parts.push_back(fmt::format("{} to {:g}", words_of(range.fate), range.to));
    }
    return parts.empty() ? "nothing uplifts it" : fmt::format("{} (end of the scan)", fmt::join(parts, "; "));
}

std::string least_text(OverturningRanges const& found, double per) {
    double const least = found.overturning();
    bool const known = std::isfinite(least) && least == found.stands_to();
    return fmt::format("{}{:g}", known ? "" : "> ", rounded_down(found.stands_to() / per, digits));
}

}  // namespace

double OverturningSpectrum::omega_over_p(OverturningPoint const& point) const {
    return 2 * pi * point.frequency_hz / block.p_radps;
}

Json json_of(OverturningSpectrum const& spectrum) {
    auto points = Json::array();
    for (auto const& point : spectrum.points) {
        double const least = point.found.overturning() * spectrum.peak_mps2;
        double const uplift = point.found.uplift * spectrum.peak_mps2;
        Json one;
        if (!spectrum.of_record) {
            one["omega_over_p"] = spectrum.omega_over_p(point);
            one["frequency_hz"] = point.frequency_hz;
            one["period_s"] = 1 / point.frequency_hz;
        }
        one["uplift_mps2"] = json_of(Cell(uplift));
        double const stands = point.found.stands_to() * spectrum.peak_mps2;
        one["stands_to_mps2"] = json_of(Cell(stands));
        one["overturning_mps2"] = json_of(Cell(least));
        one["overturning_over_alpha_g"] = json_of(Cell(least / spectrum.alpha_g_mps2()));
        if (spectrum.half_cycles) {
            one["closed_form_over_alpha_g"] = sine_without_impact(spectrum.omega_over_p(point), *spectrum.half_cycles);
        }
        auto const& unit = spectrum.units.acceleration;
        one["stated"] = {{"uplift", stated_json(uplift, unit)},
                         {"stands_to", stated_json(stands, unit)},
                         {"overturning", stated_json(least, unit)}};
        one["ranges"] = ranges_json(spectrum, point);
        points.push_back(std::move(one));
    }
    Json json{{"body", spectrum.body}, {"shaking", spectrum.shaking}};
    if (spectrum.parameters) {
        json["gamma"] = spectrum.parameters->gamma;
        json["phase_rad"] = spectrum.parameters->phase_rad;
    }
    json["stated"]["alpha_g"] = stated_json(spectrum.alpha_g_mps2(), spectrum.units.acceleration);
    if (spectrum.of_record) {
        json["pga_mps2"] = spectrum.peak_mps2;
        json["stated"]["pga"] = stated_json(spectrum.peak_mps2, spectrum.units.acceleration);
    }
    json["left_out"] = spectrum.left_out;
    json["alpha_rad"] = spectrum.block.alpha_rad;
    json["p_radps"] = spectrum.block.p_radps;
    json["restitution"] = spectrum.block.restitution;
    json["alpha_g_mps2"] = spectrum.alpha_g_mps2();
    json["linearised"] = spectrum.scan.accuracy.restoring == Restoring::linear;
    json["scan"] = {{"highest_over_uplift", spectrum.scan.highest},
                    {"step", spectrum.scan.step},
                    {"precision", spectrum.scan.precision}};
    json["points"] = std::move(points);
    return json;
}

std::string csv_of(OverturningSpectrum const& spectrum) {
    std::string csv = spectrum.of_record ? "from_factor,to_factor" : "omega_over_p,frequency_hz,period_s";
    csv += ",fate,from_mps2,to_mps2,from_over_alpha_g,to_over_alpha_g\n";
    auto const out = std::back_inserter(csv);
    for (auto const& point : spectrum.points) {
        for (auto const& range : point.found.ranges) {
            double const from = range.from * spectrum.peak_mps2;
            double const to = range.to * spectrum.peak_mps2;
            if (spectrum.of_record) {
                fmt::format_to(out, "{},{}", range.from, range.to);
            } else {
                fmt::format_to(out, "{},{},{}", spectrum.omega_over_p(point), point.frequency_hz,
                               1 / point.frequency_hz);
            }
            fmt::format_to(out, ",{},{},{},{},{}\n", name_of(range.fate), from, to, from / spectrum.alpha_g_mps2(),
                           to / spectrum.alpha_g_mps2());
        }
    }
    return csv;
}

std::string text_of(OverturningSpectrum const& spectrum) {
    auto text = head_of(spectrum);
    auto const out = std::back_inserter(text);
    double const alpha_g = spectrum.alpha_g_mps2();
    auto const& unit = spectrum.units.acceleration;
    if (spectrum.of_record) {
        auto const& found = spectrum.points.front().found;
        fmt::format_to(out, "overturns from {} times the record on (PGA {:.5g} {}), uplifts from {:.5g} on\n{}",
                       least_text(found, 1), unit.of(spectrum.peak_mps2), unit.symbol, found.uplift,
                       wrapped(ranges_text(found, 1), 2));
    } else {
        fmt::format_to(out, "{:>8} {:>9} {:>9} {:>10} {:>8}  amplitudes over alpha g\n{:>8} {:>9} {:>9} {:>10} {:>8}\n",
                       "omega/p", "f", "uplifts", "overturns", "over", "", "Hz", unit.symbol, unit.symbol, "alpha g");
        for (auto const& point : spectrum.points) {
            auto const& found = point.found;
            auto const numbers = fmt::format("{:>8.4g} {:>9.4g} {:>9.5g} {:>10} {:>8}  ", spectrum.omega_over_p(point),
                                             point.frequency_hz, unit.of(found.uplift), least_text(found, unit.si),
                                             least_text(found, alpha_g));
            text += wrapped(ranges_text(found, alpha_g), numbers.size(), line_width, numbers);
        }
    }
    if (std::ranges::any_of(spectrum.points, &leaves_the_ground)) {
        text += "undecided: the body leaves the ground before it has tipped over\n";
    }
    fmt::format_to(out, "tried to {:g} times the amplitude of uplift; ranges narrower than {:g} % may be missed\n",
                   spectrum.scan.highest, 100 * spectrum.scan.step);
    return text;
}

}  // namespace overturn::output
