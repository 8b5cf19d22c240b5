#include "output/trial_text.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/typed_units.hpp"
#include "campaign/verdict_text.hpp"
#include "response/registry.hpp"

namespace overturn::output {

std::string trial_text(CampaignSpec const& spec, TrialRow const& row, std::int64_t trial, std::int64_t wave) {
    auto text = fmt::format("trial {}: wave number {} (id {}), body {}, {} {}\n", trial, wave, row.wave,
                            spec.bodies[row.body].name, spec.levels.measure_name(), spec.levels.text(row.amplitude));
    if (std::isnan(row.peak_rotation_rad)) {
        return text + fmt::format("verdict {} ({})\n", entry_of(row.verdict).name, entry_of(row.failure).summary);
    }
    auto const when = std::isnan(row.time_of_peak_s) ? std::string() : fmt::format(" at {:.3f} s", row.time_of_peak_s);
    auto const unit = typed_units(spec).slip;
    auto const slip = row.peak_slip_m > 0 ? fmt::format("peak slip {:.4g} {}, ", row.peak_slip_m / unit.si, unit.symbol)
                                          : std::string();
    return text
           + fmt::format("verdict {}{}, peak rotation {:.6g} rad = {:.4g} deg ({:.4f} alpha){}, {}{} impacts\n",
                         entry_of(row.verdict).name, at_rest_text(row, spec.measures.movement, unit),
                         row.peak_rotation_rad, row.peak_rotation_rad * 180 / pi, row.peak_rotation_ratio, when, slip,
                         row.impacts);
}

std::string trial_title(CampaignSpec const& spec, TrialRow const& row, std::int64_t trial, std::int64_t wave,
                        std::string const& words, std::string const& record) {
    return fmt::format("{}, trial {}{}: wave {}{} at {}, {}", spec.bodies[row.body].name, trial,
                       words.empty() ? "" : " (" + words + ")", wave, record.empty() ? "" : ", " + record,
                       spec.levels.text(row.amplitude), entry_of(row.verdict).name);
}

std::string difference_text(std::vector<std::string> const& different) {
    return different.empty() ? "bit-equal to the stored row\n"
                             : fmt::format("NOT bit-equal to the stored row: {} differ\n", fmt::join(different, ", "));
}

}  // namespace overturn::output
