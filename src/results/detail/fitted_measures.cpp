#include "results/detail/fitted_measures.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace overturn {

std::vector<Measure> measures_of(CampaignSpec const& spec) {
    auto const* const own = spec.levels.measure;
    std::vector measures{own->measured == &measuring::always ? own : measure_named("level")};
    for (auto const& entry : intensity_measures) {
        bool const asked = std::ranges::find(spec.measures.curves, &entry) != spec.measures.curves.end();
        if (&entry != own && (asked || (entry.curves == Curves::measured && (*entry.measured)(spec.measures)))) {
            measures.push_back(&entry);
        }
    }
    return measures;
}

std::vector<Measure> held_measures(CampaignSpec const& spec) {
    auto held = measures_of(spec);
    if (held.front() != measure_named("level")) {
        held.push_back(measure_named("level"));
    }
    return held;
}

std::vector<Measure> criteria_of(CampaignSpec const& spec) {
    auto criteria = measures_of(spec);
    std::erase_if(criteria, [&](Measure measure) { return !measure->criterion; });
    return criteria;
}

IntensityUnit printed_unit(std::string const& units, LevelSpec const& levels) {
    return units == levels.units() ? IntensityUnit{levels.shown_units(), levels.stated_unit_si} : IntensityUnit{units};
}

std::string units_of(Measure measure, LevelSpec const& levels) {
    return measure == measure_named("level") ? levels.units() : measure->units();
}

std::string name_of(Measure measure, CampaignSpec const& spec) {
    return measure == measure_named("level") ? spec.levels.measure_name() : std::string(measure->name);
}

std::string title_of(Measure measure, CampaignSpec const& spec) {
    auto const* const shown = measure == measure_named("level") ? spec.levels.measure : measure;
    auto const period = shown->period ? fmt::format("({:g} s)", spec.measures.sa_periods_s.at(*shown->period)) : "";
    return std::string(shown->title) + period;
}

std::string label_of(Measure measure, CampaignSpec const& spec) {
    if (measure->period) {
        return fmt::format("sa({:g} s)", spec.measures.sa_periods_s.at(*measure->period));
    }
    if (measure == measure_named("level")) {
        return spec.levels.measure_label();
    }
    if (measure->other_unit_of.empty()) {
        return name_of(measure, spec);
    }
    return fmt::format("{}(R in {})", measure->other_unit_of, name_of(other(spec.measures.radius_unit)));
}

}  // namespace overturn
