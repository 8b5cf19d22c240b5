#include "campaign/warnings.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "campaign/plan.hpp"
#include "core/units.hpp"

namespace overturn {
namespace {

using Lines = std::vector<std::string>;

// Of each wave that was measured.
template <class Visit> void each_drift(CampaignSpec const& spec, Visit&& visit) {
    auto const count = spec.source->available() ? spec.wave_count : 0;
    for (std::int64_t wave = 0; wave < count; ++wave) {
        auto const drift = spec.source->drift(static_cast<std::uint64_t>(wave));
        if (!drift) {
            return;
        }
        visit(wave, *drift);
    }
}

void add_drifts(CampaignSpec const& spec, Lines& lines) {
    std::int64_t count = 0;
    std::string first;
    each_drift(spec, [&](std::int64_t wave, Drift const& drift) {
        if (drift.excessive() && count++ == 0) {
            first = fmt::format("record {} {}", wave, drift.text());
        }
    });
    if (count > 0) {
        lines.push_back(
            fmt::format("{}{}: the baseline drifts, and PGV, PGD and long-period energy with it. State "
                        "waves.baseline, for example {{high_pass = \"0.05 Hz\"}}",
                        first, count > 1 ? fmt::format(", and {} more", count - 1) : ""));
    }
}

void add_targets(CampaignSpec const& spec, Lines& lines) {
    auto const judged_to = spec.source->judged_to_s();
    for (auto const& body : spec.bodies) {
        auto const band = rocking_period_band(body.body.radius_m(), spec.measures.radius_unit);
        if (judged_to && ends_inside(*judged_to, band)) {
            lines.push_back(
                fmt::format("waves are compared with their target to {:.3g} s only, and {} rocks at {:.2f} "
                            "s to {:.2f} s: nothing says how they shake it beyond. State the target to "
                            "{:.3g} s, and waves.target.longest no shorter",
                            *judged_to, body.name, band.t0_s, band.t1_s, band.t1_s));
        }
    }
}

void add_first_wave(CampaignSpec const& spec, Lines& lines) {
    constexpr double absurd_mps2 = 10 * g0;
    try {
        Plan const plan(spec);
        auto const wave = spec.source->make(spec.seed, plan.wave_id(0));
        if (double const peak = peak_of(wave.motion.horizontal_mps2); peak > absurd_mps2) {
            lines.push_back(
                fmt::format("wave 0 peaks at {:.4g} g before any scaling (no ground has shaken so). Check the "
                            "unit of its target or amplitude",
                            peak / g0));
        }
    } catch (InputError const&) {
        return;  // its trials will say why
    }
}

}  // namespace

bool ends_inside(double judged_to_s, PeriodBand const& band) {
    constexpr double rounding = 1e-9;
    return judged_to_s < band.t1_s * (1 - rounding);
}

std::vector<std::string> warnings_of(CampaignSpec const& spec) {
    Lines lines;
    add_drifts(spec, lines);
    add_targets(spec, lines);
    add_first_wave(spec, lines);
    return lines;
}

std::vector<std::string> ends_of_records(CampaignSpec const& spec) {
    constexpr std::int64_t most = 20;
    Lines lines;
    each_drift(spec, [&](std::int64_t wave, Drift const& drift) {
        if (wave < most) {
            lines.push_back(
                fmt::format("{}: PGV {:.4g} m/s, PGD {:.4g} m, {}", wave, drift.pgv_mps, drift.pgd_m, drift.text()));
        }
    });
    return lines;
}

}  // namespace overturn
