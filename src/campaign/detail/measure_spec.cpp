#include "campaign/detail/measure_spec.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "campaign/detail/campaign_keys.hpp"
#include "config/suggestion.hpp"
#include "core/error.hpp"

namespace overturn {
namespace {

using config::Table;

void read_sa(Table const& table, MeasureSpec& m) {
    if (table.has("sa_periods")) {
        m.sa_periods_s = table.numbers(measure_keys["sa_periods"]);
        bool const rising = std::ranges::is_sorted(m.sa_periods_s, std::ranges::less_equal{});
        if (m.sa_periods_s.empty() || m.sa_periods_s.size() > most_sa_periods || !rising) {
            table.fail("sa_periods", fmt::format("{} periods (1 to {} that rise). Mend the list", m.sa_periods_s.size(),
                                                 most_sa_periods));
        }
    }
    if (table.has("sa_band")) {
        auto const ends = table.numbers(measure_keys["sa_band"]);
        if (ends.size() != 2 || !(ends[0] < ends[1])) {
            table.fail("sa_band", "not two periods that rise (Sa is averaged from one to the other). Mend it");
        }
        m.sa_band = PeriodBand{ends[0], ends[1]};
    }
}

void read_curves(Table const& table, MeasureSpec& m) {
    if (!table.has("curves")) {
        return;
    }
    table.located("curves", [&] {
        for (auto const& name : table.texts(measure_keys["curves"])) {
            auto const* const measure = config::find_entry<Measure>(curve_measures, name, "measure").value;
            validate(std::ranges::find(m.curves, measure) == m.curves.end(), "'{}' twice. Remove one", name);
            m.curves.push_back(measure);
        }
    });
}

}  // namespace

void measure_levels(config::Table const& root, LevelSpec& levels, MeasureSpec& m) {
    if (levels.measure == measure_named("sa_average") && !m.sa_band) {
        root.child("levels").fail("measure",
                                  "sa-average without measures.sa_band (the periods it is averaged over). "
                                  "State it");
    }
    if (!levels.measure->period) {
        return;
    }
    auto const place = std::ranges::lower_bound(m.sa_periods_s, levels.sa_period_s);
    levels.measure =
        sa_measure(std::min(static_cast<std::size_t>(place - m.sa_periods_s.begin()), most_sa_periods - 1));
    if (place != m.sa_periods_s.end() && *place == levels.sa_period_s) {
        return;
    }
    if (m.sa_periods_s.size() == most_sa_periods) {
        root.child("levels").fail("period", fmt::format("none of the {} measures.sa_periods (no more are measured). "
                                                        "List it among them",
                                                        most_sa_periods));
    }
    m.sa_periods_s.insert(place, levels.sa_period_s);
}

MeasureSpec read_measures(config::Table const& table) {
    MeasureSpec m;
    m.radius_unit = table.choice<RadiusUnit>(measure_keys["radius_unit"], radius_units);
    m.energy = table.boolean(measure_keys["energy"]);
    m.wave_quality = table.boolean(measure_keys["wave_quality"]);
    m.both_radius_units = table.boolean(measure_keys["both_radius_units"]);
    for (auto const* key : {"both_radius_units", "window"}) {
        if (!m.energy && table.has(key)) {
            table.fail(key, "beside energy = false (it defines how energies are measured). Leave it out");
        }
    }
    m.window = table.choice<WindowReading>(measure_keys["window"], window_readings);
    m.movement = {table.number(measure_keys["slid_from"]), table.number(measure_keys["rocked_from"])};
    read_sa(table, m);
    read_curves(table, m);
    table.finish();
    return m;
}

}  // namespace overturn
