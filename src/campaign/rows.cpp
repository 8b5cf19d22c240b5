#include "campaign/rows.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace overturn {

namespace {

// One field per place of an array.
template <auto Member>
void add_each(Fields& fields, std::string const& name, std::string const& units,
              std::vector<std::string> const& descriptions) {
    for (std::size_t i = 0; i < descriptions.size(); ++i) {
        fields.push_back({fmt::format("{}_{}", name, i + 1), units, descriptions[i], FieldType::real,
                          offset_of<Member>() + i * sizeof(double)});
    }
}

// A column of a measure, whose unit and meaning are those of the registry.
template <auto Member> Field column_of(std::string_view name, std::string_view of = "") {
    auto const* const measure = measure_named(name);
    return field<Member>(std::string(name), measure->units(), fmt::format("{}{}", measure->meaning, of));
}

// One field per measure that has a column, under the measure's name.
template <auto Member> void add_measures(Fields& fields, bool (IntensityMeasure::*has)() const, std::string_view of) {
    std::size_t place = 0;
    for (auto const& entry : intensity_measures) {
        if ((entry.*has)()) {
            fields.push_back({std::string(entry.name), entry.units(), fmt::format("{}{}", entry.meaning, of),
                              FieldType::real, offset_of<Member>() + place++ * sizeof(double)});
        }
    }
}

// How a further component follows its target.
template <auto Member> void add_match(Fields& fields, std::string const& component) {
    auto const add = [&](char const* name, char const* units, char const* what, std::size_t offset) {
        fields.push_back({fmt::format("{}_match_{}", component, name), units,
                          fmt::format("{} of the {} component", what, component), FieldType::real,
                          offset_of<Member>() + offset});
    };
    using C = ComponentMatch;
    add("lowest_ratio", "1", "min of computed / target", offset_of<&C::lowest_ratio>());
    add("lowest_period", "s", "where it is lowest:", offset_of<&C::lowest_period_s>());
    add("highest_ratio", "1", "max of computed / target", offset_of<&C::highest_ratio>());
    add("highest_period", "s", "where it is highest:", offset_of<&C::highest_period_s>());
    add("longest_below", "1", "largest number of adjacent periods below the target, 100 per decade,",
        offset_of<&C::longest_below>());
    add("longest_below_to", "s", "the longest of these periods", offset_of<&C::longest_below_to_s>());
    add("si_ratio", "1", "spectral intensity over that of the target", offset_of<&C::si_ratio>());
    add("ratio_cov", "1", "coefficient of variation of computed / target", offset_of<&C::ratio_cov>());
    add("mean_ratio", "1", "mean of computed / target", offset_of<&C::mean_ratio>());
}

std::vector<std::string> at_reported_periods(std::string_view what) {
    std::vector<std::string> descriptions;
    descriptions.reserve(epsilon_periods_s.size());
    for (double const period : epsilon_periods_s) {
        descriptions.push_back(fmt::format("{} at {:g} s (a period as the target states it)", what, period));
    }
    return descriptions;
}

Fields fields_of_waves() {
    using W = WaveRow;
    Fields fields{
        field<&W::id>("id", "1", "identity of the wave in every random stream").always(),
        field<&W::failed>("failed", "1", "1: the wave could not be made").always(),
        field<&W::duration_s>("duration", "s", "time from the first to the last sample"),
        column_of<&W::pga_mps2>("pga"),
        column_of<&W::pgv_mps>("pgv"),
        column_of<&W::pgd_m>("pgd"),
        field<&W::arias_mps>("arias", "m/s", "Arias intensity of the horizontal component"),
        field<&W::transverse_pga_mps2>("transverse_pga", "m/s2",
                                       "peak acceleration of the other horizontal component; 0: none"),
        field<&W::vertical_pga_mps2>("vertical_pga", "m/s2", "peak vertical acceleration; 0: none"),
        column_of<&W::vector_pga_mps2>("vector_pga"),
        field<&W::matched>("matched", "1", "1: matched to a target spectrum"),
        field<&W::match_iterations>("match_iterations", "1", "iterations of the match"),
        field<&W::match_mean_misfit>("match_mean_misfit", "1", "mean |computed / target - 1|"),
        field<&W::match_max_misfit>("match_max_misfit", "1", "max |computed / target - 1|"),
        field<&W::match_max_misfit_period_s>("match_max_misfit_period", "s", "where it lies"),
        field<&W::match_mean_ratio>("match_mean_ratio", "1", "mean of computed / target"),
        field<&W::match_ratio_cov>("match_ratio_cov", "1", "coefficient of variation of computed / target"),
        field<&W::match_long_mean_misfit>("match_long_mean_misfit", "1",
                                          "mean misfit over the long periods, 1 s and above"),
        field<&W::match_long_max_misfit>("match_long_max_misfit", "1",
                                         "max misfit over the long periods, 1 s and above"),
        field<&W::match_lowest_ratio>("match_lowest_ratio", "1", "min of computed / target"),
        field<&W::match_highest_ratio>("match_highest_ratio", "1", "max of computed / target"),
        field<&W::match_lowest_period_s>("match_lowest_period", "s", "where the min of computed / target lies"),
        field<&W::match_highest_period_s>("match_highest_period", "s", "where the max of computed / target lies"),
        field<&W::match_longest_below_to_s>("match_longest_below_to", "s",
                                            "longest of the adjacent periods below the target"),
        field<&W::match_longest_below>("match_longest_below", "1",
                                       "largest number of adjacent periods below the target, 100 per decade"),
        field<&W::match_worst_decade>("match_worst_decade", "1", "largest mean misfit over any decade of periods"),
        field<&W::si_ratio>("si_ratio", "1",
                            "spectral intensity over that of the target, 0.1 s to 2.5 s; NaN: not covered"),
        field<&W::psd_lowest_ratio>(
            "psd_lowest_ratio", "1",
            "min of power spectral density over the one that fits the target, 20 % windows, 0.3 to 24 Hz"),
        field<&W::psd_lowest_hz>("psd_lowest_frequency", "Hz", "where it lies"),
        field<&W::transverse_match_mean_misfit>("transverse_match_mean_misfit", "1",
                                                "mean misfit of the other horizontal component"),
        field<&W::transverse_match_worst_decade>("transverse_match_worst_decade", "1",
                                                 "its largest mean misfit over any decade of periods"),
        field<&W::vertical_match_mean_misfit>("vertical_match_mean_misfit", "1",
                                              "mean misfit of the vertical component"),
        field<&W::vertical_match_worst_decade>("vertical_match_worst_decade", "1",
                                               "its largest mean misfit over any decade of periods"),
        field<&W::duration_5_75_s>("duration_5_75", "s", "time from 5 % to 75 % of the Arias integral"),
        field<&W::duration_5_95_s>("duration_5_95", "s", "time from 5 % to 95 % of the Arias integral"),
        field<&W::residual_velocity_mps>("residual_velocity", "m/s", "horizontal velocity at the end"),
        field<&W::residual_displacement_m>("residual_displacement", "m", "horizontal displacement at the end"),
        field<&W::correlation>("correlation", "1",
                               "coefficient of the two components that are correlated most; 0: just one"),
        field<&W::turned_rad>("turned", "rad",
                              "angle from the recorded horizontal axis to the one used, towards the transverse one"),
        category<&W::accepted>("accepted", "does it meet waves.acceptance?", numbered({"no", "yes", "not-asked"})),
        field<&W::acceptance_failures>("acceptance_failures", "1",
                                       "bit mask of clauses not met, from bit 0: time step, duration, judged to, "
                                       "lowest ratio, adjacent below, highest ratio, SI ratio, cov of the ratio, error "
                                       "of the mean, worst decade, end velocity, component correlation, rocking band"),
        field<&W::horizontal_failures>("horizontal_failures", "1",
                                       "those of them that the horizontal component's spectrum does not meet"),
        field<&W::transverse_failures>("transverse_failures", "1",
                                       "those of them that the transverse component's spectrum does not meet"),
        field<&W::vertical_failures>("vertical_failures", "1",
                                     "those of them that the vertical component's spectrum does not meet"),
        field<&W::target>("target", "1", "number of the drawn target; several waves may share it"),
        field<&W::event>("event", "1", "number of the event whose between-event term the wave's target uses"),
        column_of<&W::sa_average_mps2>("sa_average")};
    add_match<&W::transverse_match>(fields, "transverse");
    add_match<&W::vertical_match>(fields, "vertical");
    add_each<&W::epsilon>(fields, "epsilon", "1",
                          at_reported_periods("standard deviations of the drawn target above the median"));
    add_each<&W::epsilon_between>(fields, "epsilon_between", "1",
                                  at_reported_periods("part of the event, in between-event standard deviations,"));
    add_each<&W::epsilon_within>(
        fields, "epsilon_within", "1",
        at_reported_periods("part of the target within its event, in within-event standard deviations,"));
    add_measures<&W::measured>(fields, &IntensityMeasure::has_wave_column, "");
    add_each<&W::sa_mps2>(fields, "sa", "m/s2", std::vector<std::string>(most_sa_periods, "pseudo-acceleration"));
    return fields;
}

}  // namespace

bool is_match_figure(std::string_view column) {
    return column.find("match_") != std::string_view::npos || column.starts_with("band_") || column == "si_ratio"
           || column.starts_with("psd_lowest");
}

template <> Fields const& fields_of<WaveRow>() {
    static Fields const fields = fields_of_waves();
    return fields;
}

template <> Fields const& fields_of<MeasureRow>() {
    using M = MeasureRow;
    static Fields const fields{
        column_of<&M::ou_v_e_mps>("ou_v_e", ", of the unscaled wave"),
        column_of<&M::v_wes_max_mps>("v_wes", ", of the unscaled wave"),
        field<&M::v_wes_time_s>("v_wes_time", "s", "time of this maximum"),
        field<&M::band_mean_misfit>("band_mean_misfit", "1", "mean |computed / target - 1| over [T0, T1] of the body"),
        field<&M::band_max_misfit>("band_max_misfit", "1", "max of it over [T0, T1]"),
        field<&M::band_mean_ratio>("band_mean_ratio", "1", "mean of computed / target over [T0, T1]"),
        field<&M::band_ratio_cov>("band_ratio_cov", "1", "coefficient of variation of computed / target over [T0, T1]"),
        column_of<&M::other_unit_ou_v_e_mps>("ou_v_e_other_unit"),
        column_of<&M::other_unit_v_wes_max_mps>("v_wes_other_unit")};
    return fields;
}

template <> Fields const& fields_of<TrialRow>() {
    using T = TrialRow;
    static auto const fields = [] {
        Fields all{
            field<&T::wave>("wave", "1", "id of the wave, as in /waves/id").always(),
            field<&T::body>("body", "1", "the body, numbered in the campaign's order from 0").always(),
            field<&T::level>("level", "1", "number of the level, rising from 0").always(),
            field<&T::amplitude>("amplitude", "1", "value of the level (attribute level_measure of the file)").always(),
            field<&T::scale>("scale", "1", "factor on the wave that brings it to the level"),
            field<&T::mass_kg>("mass", "kg", "mass as drawn for the wave"),
            field<&T::centre_height_m>("centre_height", "m", "height of the centre of gravity as drawn for the wave"),
            field<&T::restitution>("restitution", "1",
                                   "ratio of angular velocities after and before an impact, as drawn for the wave"),
            field<&T::static_friction>("static_friction", "1",
                                       "static coefficient as drawn for the wave; NaN: no slip"),
            field<&T::kinetic_friction>("kinetic_friction", "1",
                                        "kinetic coefficient as drawn for the wave; NaN: no slip"),
            column_of<&T::v_wes_mps>("v_wes", ", at this level"),
            column_of<&T::ou_v_e_mps>("ou_v_e", ", at this level"),
            field<&T::v_ereq_mps>("v_ereq", "m/s", "limit velocity sqrt(2 g (R - h)) of the body"),
            field<&T::v_wes_safe>("v_wes_safe", "1", "1: predicted safe, V_WES < V_Ereq").if_absent(unknown_category),
            field<&T::ou_v_e_safe>("ou_v_e_safe", "1", "1: predicted safe, ouV_E < V_Ereq").if_absent(unknown_category),
            field<&T::least_clearance_m>("least_clearance", "m",
                                         "least distance left to the next cask or wall, slip and tilt together; below "
                                         "0: it may touch"),
            field<&T::edge_margin_m>("edge_margin", "m",
                                     "least distance left between base and edge of the pad; below 0: it may leave it")};
        add_measures<&T::measured>(all, &IntensityMeasure::has_trial_column, ", at this level");
        auto const response = fields_of_base<TrialRow, Response>();
        all.insert(all.end(), response.begin(), response.end());
        return all;
    }();
    return fields;
}

}  // namespace overturn
