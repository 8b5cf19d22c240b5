#include "output/detail/curve_columns.hpp"

#include <array>
#include <optional>

#include "output/curve_tables.hpp"
#include "output/detail/fit_names.hpp"

namespace overturn::output {
namespace {

using Curve = MeasuredFragility;

// Of a fit with a curve; none without one.
template <class Get> auto if_fitted(Get get) {
    using Value = std::remove_cvref_t<decltype(get(std::declval<FragilityFit const&>()))>;
    auto const wrapped = [get](Curve const& curve) {
        if constexpr (requires(Value v) { v.has_value(); }) {
            return curve.fit.identifiable() ? get(curve.fit) : Value();
        } else {
            return curve.fit.identifiable() ? std::optional<Value>(get(curve.fit)) : std::optional<Value>();
        }
    };
    return wrapped;
}

std::optional<double> positive(double value) { return value > 0 ? std::optional(value) : std::nullopt; }

// The ends of all numbers of a curve by one method.
void add_ends_by(TableOf<Curve>& table, std::string const& method, std::string const& how,
                 std::optional<FragilityFit::Intervals> FragilityFit::*which) {
    auto const ends = [which](Interval FragilityFit::Intervals::*of) {
        return [which, of](Curve const& curve) {
            auto const& all = curve.fit.*which;
            return all ? std::optional((*all).*of) : std::nullopt;
        };
    };
    using I = FragilityFit::Intervals;
    table.add(method + "_median", unit_of_row(), "median " + how, ends(&I::median))
        .add(method + "_beta", "1", "beta " + how, ends(&I::beta))
        .add(method + "_five_percent_point", unit_of_row(), "5 % point " + how, ends(&I::five_percent_point))
        .add(method + "_hclpf", unit_of_row(), "hclpf " + how, [which](Curve const& curve) {
            auto const& all = curve.fit.*which;
            return all ? all->hclpf : std::nullopt;
        });
}

void add_low_points(TableOf<Curve>& table) {
    using Fit = FragilityFit;
    table
        .add("five_percent_point", unit_of_row(), "5 % point", if_fitted([](Fit const& fit) {
                 return fit.five_percent_point() ? std::optional(fit.intervals().five_percent_point) : std::nullopt;
             }))
        .add("five_percent_point", unit_of_row(),
             "estimate, median exp(-1.645 beta); the safe value is five_percent_point_lower; NaN: not identifiable",
             if_fitted([](Fit const& fit) { return fit.five_percent_point(); }))
        .add("hclpf", unit_of_row(), "hclpf, waves resampled where bodies were drawn",
             if_fitted([](Fit const& fit) { return fit.hclpf() ? fit.intervals().hclpf : std::nullopt; }))
        .add("hclpf", unit_of_row(),
             "estimate, median exp(-1.645 (beta_r + beta_u)); the safe value is hclpf_lower; NaN: not identifiable, or "
             "beta_u is not known",
             if_fitted([](Fit const& fit) { return fit.hclpf(); }))
        .add("one_percent_point", unit_of_row(),
             "estimate, median exp(-2.326 sqrt(beta_r^2 + beta_u^2)); NaN: as hclpf",
             if_fitted([](Fit const& fit) { return fit.one_percent_point(); }));
    for (double const confidence : reported_confidences) {
        auto const percent = std::lround(100 * confidence);
        table.add(fmt::format("median_at_{:02}", percent), unit_of_row(),
                  fmt::format("median of the curve of {} % confidence, whose beta is beta_r; NaN: beta_u is not known",
                              percent),
                  if_fitted([confidence](Fit const& fit) { return fit.median_at(confidence); }));
    }
}

}  // namespace

void add_trial_columns(TableOf<Curve>& table, Passing passing) {
    table
        .add("identifiable", "1", "1: the trials determine a lognormal curve",
             [](Curve const& curve) { return curve.fit.identifiable(); })
        .names("flags", "flags of the fit", names_of((1U << fragility_flags) - 1, passing),
               [](Curve const& curve) { return names_of(curve.fit.flags, curve.fit.passing); })
        .add("trials", "1", "trials in the fit", [](Curve const& curve) { return curve.fit.trials; })
        .add(passed_name(passing), "1", "trials of these that exceeded the limit",
             [](Curve const& curve) { return curve.fit.overturned; })
        .add("undecided", "1", "further trials without a verdict",
             [](Curve const& curve) { return curve.fit.undecided; })
        .add("waves", "1", "independent waves; NaN: not known",
             [](Curve const& curve) {
                 bool const known = curve.fit.waves_known == WavesKnown::yes;
                 return positive(known ? static_cast<double>(curve.fit.waves) : 0);
             })
        .add("lowest", unit_of_row(), "lowest intensity of the trials",
             [](Curve const& curve) { return curve.fit.trials > 0 ? std::optional(curve.fit.lowest) : std::nullopt; })
        .add("highest", unit_of_row(), "highest intensity of the trials",
             [](Curve const& curve) { return curve.fit.trials > 0 ? std::optional(curve.fit.highest) : std::nullopt; })
        .add("lowest_proportion", "1",
             "proportion exceeding at the lowest level with an exceedance; NaN: no exceedance",
             [](Curve const& curve) { return positive(curve.fit.lowest_proportion); });
}

void add_curve_columns(TableOf<Curve>& table) {
    using Fit = FragilityFit;
    table
        .add("median", unit_of_row(), "intensity of P = 0.5; NaN: not identifiable",
             if_fitted([](Fit const& fit) { return std::exp(fit.line->log_median()); }))
        .add("median", unit_of_row(), "median", if_fitted([](Fit const& fit) { return fit.intervals().median; }))
        .add("beta", "1", "lognormal standard deviation; NaN: not identifiable",
             if_fitted([](Fit const& fit) { return fit.line->beta(); }))
        .add("beta", "1", "beta", if_fitted([](Fit const& fit) { return fit.intervals().beta; }))
        .category("interval_method", "method of the intervals of median, beta and 5 % point",
                  {"profile-likelihood", "bootstrap-by-waves", "widest"},
                  [](Curve const& curve) {
                      using enum Fit::Method;
                      return std::string(curve.fit.method == bootstrap_by_waves ? "bootstrap-by-waves"
                                         : curve.fit.method == widest           ? "widest"
                                                                                : "profile-likelihood");
                  })
        .add("beta_r", "1", "record-to-record part of beta; equals beta if no body property is uncertain",
             if_fitted([](Fit const& fit) { return fit.beta_r(); }))
        .add("beta_u", "1", "epistemic uncertainty beta_U of the body, sampled and stated; 0: not given",
             if_fitted([](Fit const& fit) { return fit.beta_u; }))
        .add("beta_u_drawn", "1", "the part of beta_u that the fitted beta holds",
             [](Curve const& curve) { return curve.fit.beta_u_drawn; });
    add_low_points(table);
    add_ends_by(table, "profile", "by profile likelihood, trials as independent", &Fit::profile);
    add_ends_by(table, "bootstrap", "by bootstrap over waves; NaN: trials alone at their levels, without waves",
                &Fit::bootstrap);
    table.add("replicates", "1", "replicates of the bootstrap", [](Curve const& curve) { return curve.fit.replicates; })
        .add("replicates_without_curve", "1", "replicates without a curve",
             [](Curve const& curve) { return curve.fit.replicates_without_curve; });
}

void add_check_columns(TableOf<Curve>& table, Passing passing) {
    using Fit = FragilityFit;
    auto const part = [](auto which, auto get) {
        return [which, get](Curve const& curve) {
            auto const& all = curve.fit.*which;
            return all ? std::optional<double>(get(*all)) : std::nullopt;
        };
    };
    auto const goodness = [&](auto get) { return part(&Fit::goodness, get); };
    auto const penalised = [&](auto get) { return part(&Fit::penalised, get); };
    auto const seen = [](std::optional<SeenBound> FragilityFit::*which) {
        return [which](Curve const& curve) { return curve.fit.*which ? &*(curve.fit.*which) : nullptr; };
    };
    table
        .add("deviance", "1", "deviance of the curve from the proportions",
             goodness([](auto const& g) { return g.deviance; }))
        .add("degrees_of_freedom", "1", "of the deviance", goodness([](auto const& g) { return g.degrees_of_freedom; }))
        .add("deviance_p_value", "1", "p value of the deviance, at least 1e-3 if simulated; NaN: too few trials",
             goodness([](auto const& g) { return g.degrees_of_freedom > 0 ? g.p_value : never; }))
        .add("stripe_p_value", "1", "exact p value of the stripe farthest from the curve, times the number of stripes",
             goodness([](auto const& g) { return g.stripe_p_value; }))
        .add("monotone_p_value", "1",
             "p value of the decrease of the proportions, by simulation, at least 1e-3; NaN: they do not decrease",
             [](Curve const& curve) {
                 return curve.fit.trials > 0 && curve.fit.monotone.degrees_of_freedom > 0 ? curve.fit.monotone.p_value
                                                                                          : never;
             })
        .add("isotonic_median", unit_of_row(), "where the isotonic estimate passes 1/2",
             [](Curve const& curve) {
                 return curve.fit.trials > 0 ? std::optional(curve.fit.isotonic_median) : std::nullopt;
             })
        .add("penalised_median", unit_of_row(), "median of Firth's fit of separated outcomes; NaN: none",
             penalised([](auto const& line) { return std::exp(line.log_median()); }))
        .add("penalised_beta", "1", "beta of the penalised fit",
             penalised([](auto const& line) { return line.beta(); }));
    add_seen_columns(table, "bound", "the trials that bound P where all ended the same way", passed_name(passing),
                     seen(&FragilityFit::bound));
    add_seen_columns(table, "pooled", "several stripes together", passed_name(passing), seen(&FragilityFit::pooled));
    table
        .add(
            "rank_area", "1",
            passing == Passing::exceeded
                ? "probability that a trial that exceeded the limit has the larger measure than one that did not (0.5: "
                  "no order, 1: a perfect one); NaN: all trials ended the same way"
                : "probability that a trial that overturned has the larger measure than one that did not (0.5: no "
                  "order, "
                  "1: a perfect one); NaN: all trials ended the same way",
            [](Curve const& curve) { return curve.rank_area; })
        .add("rank_area", "1", "rank_area", [](Curve const& curve) {
            return std::isfinite(curve.rank_area) ? std::optional(curve.rank_interval) : std::nullopt;
        });
}

}  // namespace overturn::output
