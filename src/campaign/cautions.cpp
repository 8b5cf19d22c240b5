#include "campaign/cautions.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>

#include <fmt/format.h>

#include "campaign/detail/loose_parts.hpp"
#include "campaign/detail/measured_drifts.hpp"
#include "campaign/detail/scaled_records.hpp"
#include "campaign/moves_in_space.hpp"
#include "campaign/rocking_band.hpp"
#include "campaign/warnings.hpp"
#include "core/error.hpp"
#include "core/outward.hpp"
#include "core/texts_of.hpp"

namespace overturn {
namespace {

using Lines = std::vector<std::string>;

// The largest acceleration of the ground, where levels state it: of a single component.
std::optional<double> reached_mps2(CampaignSpec const& spec, BodySpec const& body) {
    bool const stated = spec.levels.measure == measure_named("pga") && body.axes == 1 && !spec.levels.levels.empty();
    return stated ? std::optional(spec.levels.levels.back().value) : std::nullopt;
}

void add_bodies(CampaignSpec const& spec, Lines& lines) {
    auto const judged = spec.source->about().compared_periods;
    for (auto const& body : spec.bodies) {
        for (auto const& line : loose_parts_in_short(body, reached_mps2(spec, body))) {
            lines.push_back(fmt::format("{}: {}", body.name, line));
        }
        if (may_move_in_space(spec, body) && !body.stated_footing.stated) {
            lines.push_back(
                fmt::format("{}: computed on a square base, because no shape was stated; on a round base "
                            "it overturns at lower levels",
                            body.name));
        }
        auto const band = rocking_band(body.body, spec.measures.radius_unit);
        if (judged && ends_inside(*judged, band)) {
            lines.push_back(
                fmt::format("{}: it rocks at {:.2f} s to {:.2f} s, but waves follow their target from "
                            "{:.3g} s to {:.3g} s only",
                            body.name, band.t0_s, band.t1_s, judged->from_s, judged->to_s));
        }
    }
}

std::int64_t drifting_records(CampaignSpec const& spec) {
    std::int64_t count = 0;
    each_drift(spec, [&](std::int64_t /*wave*/, Drift const& drift) { count += drift.any_excessive() ? 1 : 0; });
    return count;
}

// "1 of 3 records drifts, 1 is scaled by more than 5 (up to 5.41)"
void add_records(CampaignSpec const& spec, Lines& lines) {
    auto const& source = *spec.source;
    if (!source.about().available || source.about().measured.empty()) {
        return;
    }
    auto const drifting = drifting_records(spec);
    ScaledRecords scaled;
    try {
        scaled = scaled_records(spec);
    } catch (InputError const&) {
        lines.push_back(fmt::format(
            "whether records drift or are scaled by more than {:g} is not known here: they are withheld", most_scaled));
        return;
    }
    auto const of_all = [&](std::int64_t count) {
        return fmt::format("{} of {}", count, count_text(spec.wave_count, "record"));
    };
    std::string text;
    if (drifting > 0) {
        text = fmt::format("{} drift{}", of_all(drifting), drifting == 1 ? "s" : "");
    }
    if (scaled.count > 0) {
        text += fmt::format("{} {} scaled by more than {:g}, up to {:.3g}",
                            text.empty() ? of_all(scaled.count) : fmt::format(", {}", scaled.count),
                            scaled.count == 1 ? "is" : "are", most_scaled, rounded_up(scaled.most));
    }
    if (!text.empty()) {
        lines.push_back(text + ": long-period motion, slip and tilt may be theirs (overturn plan names them)");
    }
}

}  // namespace

std::vector<std::string> cautions_of(CampaignSpec const& spec) {
    Lines lines;
    add_bodies(spec, lines);
    add_records(spec, lines);
    return lines;
}

}  // namespace overturn
