#include "results/detail/fitted_measures.hpp"

#include <fmt/format.h>

namespace overturn {

std::vector<FragilityMeasure> measures_of(CampaignSpec const& spec) {
    using enum FragilityMeasure;
    std::vector<FragilityMeasure> measures;
    switch (spec.levels.measure) {
        case LevelMeasure::pga:
            measures = {pga, pgv};
            break;
        case LevelMeasure::pgv:
            measures = {pgv, pga};
            break;
        default:
            measures = {level, pga, pgv};
    }
    if (spec.measures.sa_band && spec.levels.measure != LevelMeasure::sa_average) {
        measures.push_back(sa_average);
    }
    for (std::size_t i = 0; i < spec.measures.sa_periods_s.size(); ++i) {
        if (spec.levels.measure != LevelMeasure::sa || spec.measures.sa_periods_s[i] != spec.levels.sa_period_s) {
            measures.push_back(sa_measure(i));
        }
    }
    if (spec.measures.energy) {
        measures.insert(measures.end(), {v_wes, ou_v_e, v_wes_ratio});
    }
    if (spec.measures.both_radius_units) {
        measures.insert(measures.end(), {v_wes_other_unit, ou_v_e_other_unit});
    }
    return measures;
}

std::vector<FragilityMeasure> criteria_of(CampaignSpec const& spec) {
    using enum FragilityMeasure;
    if (!spec.measures.energy) {
        return {};
    }
    if (spec.measures.both_radius_units) {
        return {v_wes, ou_v_e, v_wes_other_unit, ou_v_e_other_unit};
    }
    return {v_wes, ou_v_e};
}

IntensityUnit printed_unit(std::string const& units, LevelSpec const& levels) {
    return units == levels.units() ? IntensityUnit{levels.shown_units(), levels.stated_unit_si} : IntensityUnit{units};
}

std::string units_of(FragilityMeasure measure, LevelSpec const& levels) {
    if (sa_place(measure)) {
        return "m/s2";
    }
    switch (measure) {
        case FragilityMeasure::pga:
        case FragilityMeasure::sa_average:
            return "m/s2";
        case FragilityMeasure::v_wes_ratio:
            return "1";
        case FragilityMeasure::level:
            return levels.units();
        default:
            return "m/s";
    }
}

std::string name_of(FragilityMeasure measure, CampaignSpec const& spec) {
    return measure == FragilityMeasure::level ? spec.levels.measure_name()
                                              : fragility_measure_names()[static_cast<std::size_t>(measure)];
}

std::string label_of(FragilityMeasure measure, CampaignSpec const& spec) {
    if (auto const place = sa_place(measure)) {
        return fmt::format("sa({:g} s)", spec.measures.sa_periods_s[*place]);
    }
    if (measure == FragilityMeasure::level) {
        return spec.levels.measure_label();
    }
    if (!is_other_unit(measure)) {
        return name_of(measure, spec);
    }
    return fmt::format("{}(R in {})", name_of(in_any_unit(measure), spec), name_of(other(spec.measures.radius_unit)));
}

}  // namespace overturn
