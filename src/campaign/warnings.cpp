#include "campaign/warnings.hpp"

#include <algorithm>

#include <fmt/format.h>

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

}  // namespace

std::vector<std::string> warnings_of(CampaignSpec const& spec) {
    Lines lines;
    add_drifts(spec, lines);
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
