#include <array>
#include <functional>
#include <span>

#include <fmt/ranges.h>

#include "cost/study_output.hpp"
#include "output/results_tables.hpp"
#include "output/write_results.hpp"
#include "results/rare_rows.hpp"
#include "store/results_file.hpp"

namespace overturn::cost {
namespace {

using output::Table;
using output::TableOf;
using std::mem_fn;

// name_count, name_median, name_p95, name_worst.
template <class Row>
void add_spread(TableOf<Row>& table, std::string const& name, std::string const& meaning, Spread Row::*of) {
    auto const part = [&](char const* suffix, char const* what, auto member) {
        table.add(name + suffix, "1", what + meaning, [=](Row const& row) { return (row.*of).*member; });
    };
    part("_count", "number of: ", &Spread::count);
    part("_median", "median of: ", &Spread::median);
    part("_p95", "95 % quantile of: ", &Spread::p95);
    part("_worst", "largest of: ", &Spread::worst);
}

template <class Row> void add_verdicts(TableOf<Row>& table) {
    table.add("trials", "1", "verdicts compared with the reference", mem_fn(&Row::trials))
        .add("flips", "1", "verdicts that differ", mem_fn(&Row::flips))
        .add("overturning_flips", "1", "verdicts that differ between stood, overturned and undecided",
             mem_fn(&Row::overturning_flips))
        .add("probability_error", "1", "P(overturn) over all trials less that of the reference; NaN: no verdicts",
             mem_fn(&Row::probability_error))
        .add("ks_distance", "1", "Kolmogorov-Smirnov distance of peak rotation over alpha; NaN: no verdicts",
             mem_fn(&Row::ks));
}

// Of sampling a grid of waves knows nothing.
template <class Value> auto if_sampled(Value get) {
    return [get](Study const& study) { return study.is_grid ? std::nullopt : std::optional(get(study)); };
}

Table study_table(Study const& study) {
    static constexpr std::array dominates{"sampling", "numerical", "unknown"};
    TableOf<Study> table({.name = "study", .group = "study"}, std::span(&study, 1));
    table.add("title", "1", "title of the campaign", mem_fn(&Study::title))
        .add("waves", "1", "waves of the sample", mem_fn(&Study::waves))
        .add("trials", "1", "trials of the sample", mem_fn(&Study::trials))
        .add("campaign_waves", "1", "waves of the campaign", mem_fn(&Study::campaign_waves))
        .add("campaign_trials", "1", "trials of the campaign", mem_fn(&Study::campaign_trials))
        .add("reference_cpu", "s", "CPU time per trial of the reference", mem_fn(&Study::reference_seconds))
        .add("step_trials", "1",
             "trials at the campaign's steps, at half of them, and under motions a last bit smaller",
             [](Study const& s) { return s.step_error.trials; })
        .add("step_flips", "1", "verdicts that half the step changes",
             [](Study const& s) { return s.step_error.step_flips; })
        .add("last_bit_flips", "1", "verdicts that a last bit of the motion changes",
             [](Study const& s) { return s.step_error.rounding_flips; })
        .add("stripes", "1", "stripes that P(overturn) is a mean of",
             [](Study const& s) { return s.is_grid ? 0 : s.sampling.stripes; })
        .add("confidence", "1", "of its interval", if_sampled(mem_fn(&Study::confidence)))
        .add("probability", "1", "P(overturn), mean over all stripes of the sample",
             if_sampled([](Study const& s) { return s.sampling.probability; }))
        .add("campaign_half_width", "1", "half the width of its interval at the campaign's number of waves",
             if_sampled([](Study const& s) { return s.sampling.half_width; }))
        .add("campaign_cpu", "s", "CPU time of the whole campaign at the sample's pace",
             if_sampled([](Study const& s) { return s.sampling.seconds; }))
        .add("dominates", "1", "which error of P(overturn) decides: sampling, numerical or unknown",
             if_sampled([](Study const& s) {
                 return std::string(dominates.at(static_cast<std::size_t>(s.balance.dominates)));
             }))
        .add("numerical", "1", "numerical error of P(overturn)", [](Study const& s) { return s.balance.numerical; })
        .add("numerical_is_bound", "1", "1: no verdict differs, and it is the upper bound of their share",
             [](Study const& s) { return s.balance.is_bound; })
        .add("sampling", "1", "sampling error of P(overturn): half the width of its interval",
             if_sampled([](Study const& s) { return s.balance.sampling; }))
        .add("factor", "1", "the larger of the two over the smaller; at least that where the numerical one is a bound",
             if_sampled([](Study const& s) { return s.balance.factor; }))
        .add("sentence", "1", "whether the accuracy of the settings suffices", mem_fn(&Study::sentence))
        .add("largest_effect", "1", "which setting matters most, and by how much", mem_fn(&Study::effect));
    return table.take();
}

Table rounding_table(Comparison const& rounding) {
    TableOf<Comparison> table({.name = "rounding", .group = "rounding"}, std::span(&rounding, 1));
    add_spread(table, "error", "relative error of peak rotation between two references that differ in rounding only",
               &Comparison::peak);
    add_verdicts(table);
    return table.take();
}

Table knob_table(std::vector<KnobResult> const& knobs) {
    TableOf<KnobResult> table({.name = "knobs", .group = "knobs"}, knobs);
    table.add("knob", "1", "the knob", [](KnobResult const& k) { return k.knob.name; })
        .add("title", "1", "kind of the part", [](KnobResult const& k) { return k.knob.title; })
        .add("error", "1", "what the error of its settings means", [](KnobResult const& k) { return k.knob.error; })
        .add("timed", "1", "what their CPU time is for", [](KnobResult const& k) { return k.knob.timed; })
        .add("samples", "1", "number of these for every setting", mem_fn(&KnobResult::units))
        .add("floor", "1", "errors up to this size come from rounding", mem_fn(&KnobResult::floor))
        .add("advice", "1", "setting of the campaign, and the effect of the next one", mem_fn(&KnobResult::advice));
    return table.take();
}

Table setting_table(KnobResult const& of) {
    TableOf<Measured> table(
        {.name = "settings", .group = "settings/" + of.knob.name, .constants = {{"knob", of.knob.name}}}, of.rows);
    table.add("setting", "1", "position of the knob", [](Measured const& row) { return row.setting.label; })
        .add("arguments", "1", "what sets it",
             [](Measured const& row) {
                 auto const& set = row.setting.settings;
                 return output::text_or_none(set.empty() ? "" : fmt::format("--set {}", fmt::join(set, " --set ")));
             })
        .add("here", "1", "1: setting of the campaign", mem_fn(&Measured::here))
        .add("on_front", "1", "1: on the Pareto front of cpu and error_p95", mem_fn(&Measured::on_front))
        .add("cpu", "s", "CPU time per " + of.knob.timed + ", best of a few", mem_fn(&Measured::seconds));
    add_spread(table, "error", of.knob.error, &Measured::error);
    add_verdicts(table);
    return table.take();
}

Table step_error_table(StepError const& error) {
    TableOf<QuantityError> table({.name = "step_error", .group = "step_error"}, error.quantities);
    table.add("quantity", "1", "quantity that a limit state may use", mem_fn(&QuantityError::name));
    add_spread(table, "step", "relative difference that half the step makes, of trials that end the same way",
               &QuantityError::step);
    add_spread(table, "last_bit",
               "relative difference that a last bit of the motion makes, of trials that end the same way",
               &QuantityError::rounding);
    return table.take();
}

Table wave_table(Study const& study) {
    TableOf<SubsetPoint> table(
        {.name = "waves", .group = "waves"},
        study.is_grid ? std::span<SubsetPoint const>() : std::span<SubsetPoint const>(study.sampling.subsets));
    table.add("waves", "1", "waves of a part of the sample", mem_fn(&SubsetPoint::waves))
        .add("cpu", "s", "CPU time to make, measure and try them", mem_fn(&SubsetPoint::seconds))
        .add("width", "1", "width of the Clopper-Pearson interval of P(overturn), mean of all stripes",
             mem_fn(&SubsetPoint::width))
        .add("root_n_width", "1", "the last width scaled by 1/sqrt(waves)", mem_fn(&SubsetPoint::root_n_width));
    return table.take();
}

Table rare_table(RareCost const& rare) {
    TableOf<RarePoint> table({.name = "rare",
                              .group = "rare",
                              .constants = {{"body", rare.body},
                                            {"amplitude", rare.amplitude},
                                            {"probability", rare.probability.value_or(not_known)}}},
                             rare.points);
    table
        .category("method", "estimator", rare_method_names(),
                  [](RarePoint const& point) { return name_of(point.method); })
        .add("effort", "1", "what it was given", mem_fn(&RarePoint::effort))
        .add("cpu", "s", "CPU time, all of it", mem_fn(&RarePoint::seconds))
        .add("waves", "1", "waves made", mem_fn(&RarePoint::waves))
        .add("cov", "1", "standard error over probability; NaN: not trusted or not resolved", mem_fn(&RarePoint::cov))
        .add("foretold", "1", "1: by the binomial law, from what one wave takes", mem_fn(&RarePoint::foretold))
        .add("reason", "1", "why there is no scatter",
             [](RarePoint const& point) { return output::text_or_none(point.reason); });
    return table.take();
}

}  // namespace

std::vector<Table> study_tables(Study const& study) {
    std::vector<Table> tables{study_table(study), rounding_table(study.rounding), knob_table(study.knobs)};
    for (auto const& knob : study.knobs) {
        tables.push_back(setting_table(knob));
    }
    tables.push_back(step_error_table(study.step_error));
    tables.push_back(wave_table(study));
    if (study.rare) {
        tables.push_back(rare_table(*study.rare));
    }
    return tables;
}

void write_study(std::filesystem::path const& path, CampaignInput const& input, Study const& study) {
    store::ResultsWriter file(path);
    write_provenance(file, format_name, format_version, input, study.title);
    output::write_tables(file, study_tables(study));
    file.finish();
}

}  // namespace overturn::cost
