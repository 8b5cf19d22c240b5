#include "results/fragility_schema.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

#include <fmt/ranges.h>

#include "core/error.hpp"
#include "results/analysis.hpp"

namespace overturn {
namespace {

constexpr char const* units_column = "measure_units";
constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr Interval no_interval{none, none};

// One measure's fit as it is stored; every field is 8 bytes.
struct FragilityRow {
    std::int64_t measure = 0, units = 0, state = 0, identifiable = 0, flags = 0, method = 0;
    double median = none, beta = none, five_percent_point = none, hclpf = none, one_percent_point = none;
    double beta_r = none, beta_u = none;
    std::array<double, told_confidences.size()> median_at{none, none, none};
    Interval median_interval = no_interval, beta_interval = no_interval;
    Interval five_percent_interval = no_interval, hclpf_interval = no_interval;
    Interval profile_median = no_interval, profile_beta = no_interval;
    Interval bootstrap_median = no_interval, bootstrap_beta = no_interval;
    double deviance = none, p_value = none, stripe_p_value = none, monotone_p_value = none;
    Interval isotonic_median = no_interval;
    double penalised_median = none, penalised_beta = none;
    double lowest = none, highest = none, rank_area = none;
};

FragilityRow row_of(MeasuredFragility const& measured) {
    auto const& fit = measured.fit;
    FragilityRow row;
    row.measure = static_cast<std::int64_t>(measured.measure);
    row.state = static_cast<std::int64_t>(fit.state);
    row.identifiable = fit.identifiable() ? 1 : 0;
    row.flags = fit.flags;
    row.method = static_cast<std::int64_t>(fit.method);
    if (fit.identifiable()) {
        row.median = std::exp(fit.line->log_median());
        row.beta = fit.line->beta();
        row.five_percent_point = fit.five_percent_point().value_or(none);
        row.hclpf = fit.hclpf().value_or(none);
        row.one_percent_point = fit.one_percent_point().value_or(none);
        for (std::size_t i = 0; i < told_confidences.size(); ++i) {
            row.median_at.at(i) = fit.median_at(told_confidences.at(i)).value_or(none);
        }
        row.beta_r = fit.beta_r();
        row.beta_u = fit.beta_u;
        row.median_interval = fit.intervals().median;
        row.beta_interval = fit.intervals().beta;
        row.five_percent_interval = fit.five_percent_point() ? fit.intervals().five_percent_point : no_interval;
        row.hclpf_interval = fit.hclpf() ? fit.intervals().hclpf.value_or(no_interval) : no_interval;
        row.profile_median = fit.profile->median;
        row.profile_beta = fit.profile->beta;
        row.bootstrap_median = fit.bootstrap->median;
        row.bootstrap_beta = fit.bootstrap->beta;
        row.stripe_p_value = fit.goodness->stripe_p_value;
        row.deviance = fit.goodness->deviance;
        row.p_value = fit.goodness->degrees_of_freedom > 0 ? fit.goodness->p_value : none;
    }
    if (fit.penalised) {
        row.penalised_median = std::exp(fit.penalised->log_median());
        row.penalised_beta = fit.penalised->beta();
    }
    if (fit.trials > 0) {
        row.monotone_p_value = fit.monotone.degrees_of_freedom > 0 ? fit.monotone.p_value : none;
        row.isotonic_median = fit.isotonic_median;
        row.lowest = fit.lowest;
        row.highest = fit.highest;
    }
    row.rank_area = measured.rank_area;
    return row;
}

struct Columns {
    store::TableSpec spec;

    void add(std::string const& name, std::string const& units, std::string const& description, std::size_t offset,
             FieldType type = FieldType::real, std::vector<std::string> categories = {}) {
        spec.columns.push_back({name, units, description, type, offset, numbered(std::move(categories))});
    }
    void add_ends(std::string const& name, std::string const& units, std::string const& what, std::size_t offset) {
        add(name + "_lower", units, what + ", lower end", offset + offsetof(Interval, lower));
        add(name + "_upper", units, what + ", upper end; infinite: open", offset + offsetof(Interval, upper));
    }
};

#define OVERTURN_AT(field) offsetof(FragilityRow, field)

// The units of the measures, each once.
std::vector<std::string> units_of(std::vector<MeasuredFragility> const& fits) {
    std::vector<std::string> units;
    for (auto const& measured : fits) {
        if (std::ranges::find(units, measured.units) == units.end()) {
            units.push_back(measured.units);
        }
    }
    return units;
}

// The unit of every row in their order, "m/s2; m/s; m/s; 1": of columns whose rows are of different measures.
std::string units_by_row(std::vector<MeasuredFragility> const& fits) {
    std::vector<std::string> units;
    std::ranges::transform(fits, std::back_inserter(units), &MeasuredFragility::units);
    return fmt::format("{}", fmt::join(units, "; "));
}

void add_kinds(Columns& columns, Passing passing, std::vector<std::string> const& units) {
    std::vector<std::string> states;
    for (std::int64_t s = 0; s <= static_cast<std::int64_t>(FragilityState::undecided); ++s) {
        states.push_back(name_of(static_cast<FragilityState>(s), passing));
    }
    columns.add("measure", "1", "intensity measure; level: the file's level_measure", OVERTURN_AT(measure),
                FieldType::category, fragility_measure_names());
    columns.add(units_column, "1",
                "unit of the measure, and in this row of every column that names this one in units_from",
                OVERTURN_AT(units), FieldType::category, units);
    columns.add("state", "1", "why there is a curve or none", OVERTURN_AT(state), FieldType::category, states);
    columns.add("identifiable", "1", "1: the trials hold a lognormal curve", OVERTURN_AT(identifiable),
                FieldType::integer);
    columns.add("flags", "1", "bit mask; the attribute flag_names names the bits from 0", OVERTURN_AT(flags),
                FieldType::integer);
    columns.add("interval_method", "1", "where median, beta and the 5 % point have their ends from",
                OVERTURN_AT(method), FieldType::category, {"profile-likelihood", "bootstrap-by-waves"});
}

store::TableSpec fragility_columns(std::string const& group, Passing passing, std::vector<std::string> const& units,
                                   std::string const& by_row) {
    std::string const own;  // marks columns whose rows are of different measures
    Columns columns{{group, sizeof(FragilityRow), {}, "measure"}};
    add_kinds(columns, passing, units);
    columns.add("median", own, "intensity of P = 0.5; NaN: not identifiable", OVERTURN_AT(median));
    columns.add("beta", "1", "lognormal standard deviation; NaN: not identifiable", OVERTURN_AT(beta));
    columns.add("beta_r", "1", "part of it that waves make; all of it where nothing was drawn", OVERTURN_AT(beta_r));
    columns.add("beta_u", "1", "part of it that the draws of the body make; 0 where nothing was drawn",
                OVERTURN_AT(beta_u));
    columns.add("five_percent_point", own, "median exp(-1.645 beta); NaN: not identifiable, or contradicted",
                OVERTURN_AT(five_percent_point));
    columns.add("hclpf", own, "median exp(-1.645 (beta_r + beta_u)); NaN: not identifiable, or no beta_u was drawn",
                OVERTURN_AT(hclpf));
    columns.add("one_percent_point", own, "median exp(-2.326 sqrt(beta_r^2 + beta_u^2)); NaN: as hclpf",
                OVERTURN_AT(one_percent_point));
    for (std::size_t i = 0; i < told_confidences.size(); ++i) {
        auto const percent = std::lround(100 * told_confidences.at(i));
        columns.add(fmt::format("median_at_{:02}", percent), own,
                    fmt::format("median of the curve of {} % confidence, its beta is beta_r; NaN: no beta_u", percent),
                    OVERTURN_AT(median_at) + i * sizeof(double));
    }
    columns.add_ends("median", own, "median", OVERTURN_AT(median_interval));
    columns.add_ends("beta", "1", "beta", OVERTURN_AT(beta_interval));
    columns.add_ends("five_percent_point", own, "5 % point", OVERTURN_AT(five_percent_interval));
    columns.add_ends("hclpf", own, "hclpf, waves resampled where bodies were drawn", OVERTURN_AT(hclpf_interval));
    columns.add_ends("profile_median", own, "median by profile likelihood, trials as independent",
                     OVERTURN_AT(profile_median));
    columns.add_ends("profile_beta", "1", "beta by profile likelihood, trials as independent",
                     OVERTURN_AT(profile_beta));
    columns.add_ends("bootstrap_median", own, "median, waves resampled", OVERTURN_AT(bootstrap_median));
    columns.add_ends("bootstrap_beta", "1", "beta, waves resampled", OVERTURN_AT(bootstrap_beta));
    columns.add("deviance", "1", "of the curve from the proportions", OVERTURN_AT(deviance));
    columns.add("deviance_p_value", "1", "chance of so large a deviance; NaN: nothing to judge by",
                OVERTURN_AT(p_value));
    columns.add("stripe_p_value", "1", "exact tail of the stripe farthest from the curve, times their number",
                OVERTURN_AT(stripe_p_value));
    columns.add("monotone_p_value", "1", "chance of proportions that fall as much", OVERTURN_AT(monotone_p_value));
    columns.add_ends("isotonic_median", own, "where the isotonic estimate passes 1/2", OVERTURN_AT(isotonic_median));
    columns.add("penalised_median", own, "Firth's fit of separated outcomes; NaN: none", OVERTURN_AT(penalised_median));
    columns.add("penalised_beta", "1", "Firth's fit of separated outcomes; NaN: none", OVERTURN_AT(penalised_beta));
    columns.add("lowest", own, "lowest intensity that was tried", OVERTURN_AT(lowest));
    columns.add("highest", own, "highest intensity that was tried", OVERTURN_AT(highest));
    columns.add("rank_area", "1",
                passing == Passing::exceeded
                    ? "chance that what exceeded the limit has the larger measure; NaN: all did alike"
                    : "chance that what overturned has the larger measure; NaN: all ended alike",
                OVERTURN_AT(rank_area));
    for (auto& column : columns.spec.columns) {
        if (column.units == own) {
            column.units = by_row;
            columns.spec.notes.push_back({column.name, "units_from", units_column});
        }
    }
    return columns.spec;
}

std::vector<FragilityRow> rows_of(std::vector<MeasuredFragility> const& fits) {
    std::vector<FragilityRow> rows;
    rows.reserve(fits.size());
    auto const units = units_of(fits);
    for (auto const& measured : fits) {
        rows.push_back(row_of(measured));
        rows.back().units = std::distance(units.begin(), std::ranges::find(units, measured.units));
    }
    return rows;
}

store::TableSpec table_of(std::string const& group, std::vector<MeasuredFragility> const& fits) {
    auto const& first = fits.front().fit;
    return fragility_columns(group, first.passing, units_of(fits), units_by_row(fits));
}

double relative_difference(double a, double b) {
    if (a == b || (std::isnan(a) && std::isnan(b))) {
        return 0;
    }
    auto const difference = std::abs(a - b) / std::max(std::abs(a), std::abs(b));
    return std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
}

}  // namespace

void write_fragility(store::ResultsWriter& file, std::string const& group, std::vector<MeasuredFragility> const& fits,
                     double confidence) {
    OVERTURN_EXPECT(!fits.empty());
    auto const rows = rows_of(fits);
    auto const passing = fits.front().fit.passing;
    auto const table = file.table(table_of(group, fits), static_cast<std::int64_t>(rows.size()));
    file.append(table, std::as_bytes(std::span(rows)));
    file.attribute(group, "confidence", confidence);
    file.attribute(group, "flag_names",
                   fmt::format("{}", fmt::join(names_of((1U << fragility_flags) - 1, passing), " ")));
}

RefitDifference refit_difference(store::ResultsReader const& file, std::string const& group,
                                 std::vector<MeasuredFragility> const& fits) {
    auto const again = rows_of(fits);
    auto table = table_of(group, fits);
    // Files of an earlier format hold fewer columns.
    std::erase_if(table.columns, [&](Field const& column) { return !file.has(group + "/" + column.name); });
    std::erase_if(table.notes, [&](auto const& note) { return !file.has(group + "/" + note.column); });
    std::vector<FragilityRow> stored(again.size());
    file.rows(table, static_cast<std::int64_t>(stored.size()), 0, std::as_writable_bytes(std::span(stored)));
    RefitDifference largest;
    for (auto const& column : table.columns) {
        for (std::size_t r = 0; r < again.size(); ++r) {
            auto const a = bytes_of(stored[r]);
            auto const b = bytes_of(again[r]);
            auto const difference =
                column.type == FieldType::real ? relative_difference(real_at(a, column), real_at(b, column))
                : integer_at(a, column) == integer_at(b, column) ? 0
                                                                 : std::numeric_limits<double>::infinity();
            if (difference > largest.relative) {
                largest = {difference, group + "/" + column.name};
            }
        }
    }
    return largest;
}

}  // namespace overturn
