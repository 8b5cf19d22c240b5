#include <algorithm>
#include <functional>
#include <iterator>

#include <fmt/ranges.h>

#include "campaign/version.hpp"
#include "cost/study_output.hpp"
#include "store/results_file.hpp"

namespace overturn::cost {
namespace {

using store::ResultsWriter;

template <class Row, class Value>
void real(ResultsWriter& file, std::string const& group, Field const& spec, std::vector<Row> const& rows,
          Value&& value) {
    std::vector<double> values;
    values.reserve(rows.size());
    for (auto const& row : rows) {
        values.push_back(value(row));
    }
    file.array(group, spec, values);
}

template <class Row, class Value>
void integer(ResultsWriter& file, std::string const& group, Field const& spec, std::vector<Row> const& rows,
             Value&& value) {
    std::vector<std::int64_t> values;
    values.reserve(rows.size());
    for (auto const& row : rows) {
        values.push_back(value(row));
    }
    file.array(group, spec, values);
}

/// The names of a group's rows, as an enumeration. \param column without its categories
void write_names(ResultsWriter& file, std::string const& group, Field column, std::vector<std::string> const& names) {
    std::vector<std::int64_t> numbers;
    for (auto const& name : names) {
        column.categories.push_back({static_cast<std::int64_t>(numbers.size()), name});
        numbers.push_back(static_cast<std::int64_t>(numbers.size()));
    }
    auto const table = file.table({group, sizeof(std::int64_t), {column}}, static_cast<std::int64_t>(numbers.size()));
    file.append(table, std::as_bytes(std::span(numbers)));
}

void write_labels(ResultsWriter& file, std::string const& group, KnobResult const& result) {
    std::vector<std::string> labels;
    for (auto const& row : result.rows) {
        labels.push_back(row.setting.label);
        file.attribute(group, "set " + row.setting.label, fmt::format("{}", fmt::join(row.setting.settings, "\n")));
    }
    write_names(file, group, {"setting", "1", "position of the knob", FieldType::category, 0, {}}, labels);
}

void write_knob(ResultsWriter& file, KnobResult const& result) {
    auto const group = "cost/" + result.knob.name;
    file.attribute(group, "title", result.knob.title);
    file.attribute(group, "error", result.knob.error);
    file.attribute(group, "timed", result.knob.timed);
    file.attribute(group, "advice", result.advice);
    file.attribute(group, "floor", result.floor);
    write_labels(file, group, result);
    auto const& rows = result.rows;
    real(file, group, {"cpu", "s", "CPU time per " + result.knob.timed + ", best of a few"}, rows,
         [](Measured const& row) { return row.seconds; });
    real(file, group, {"error_median", "1", "median of: " + result.knob.error}, rows,
         [](Measured const& row) { return row.error.median; });
    real(file, group, {"error_p95", "1", "95 % quantile of it"}, rows,
         [](Measured const& row) { return row.error.p95; });
    real(file, group, {"error_worst", "1", "largest of it"}, rows, [](Measured const& row) { return row.error.worst; });
    integer(file, group, {"compared", "1", "values behind the error"}, rows,
            [](Measured const& row) { return row.error.count; });
    integer(file, group, {"trials", "1", "verdicts held against the reference"}, rows,
            [](Measured const& row) { return row.trials; });
    integer(file, group, {"flips", "1", "verdicts that differ"}, rows, [](Measured const& row) { return row.flips; });
    integer(file, group, {"overturning_flips", "1", "verdicts that differ between stood, overturned and undecided"},
            rows, [](Measured const& row) { return row.overturning_flips; });
    real(file, group,
         {"probability_error", "1", "P(overturn) over all trials less that of the reference; NaN: no verdicts"}, rows,
         [](Measured const& row) { return row.probability_error; });
    real(file, group, {"ks_distance", "1", "Kolmogorov-Smirnov distance of peak rotation over alpha; NaN: no verdicts"},
         rows, [](Measured const& row) { return row.ks; });
    integer(file, group, {"on_front", "1", "1: on the Pareto front of cpu and error_p95"}, rows,
            [](Measured const& row) { return row.on_front ? 1 : 0; });
    std::vector<std::int64_t> here(rows.size(), 0);
    if (result.knob.here) {
        here[*result.knob.here] = 1;
    }
    file.array(group, {"here", "1", "1: where the campaign stands"}, here);
}

void write_waves(ResultsWriter& file, Study const& study) {
    std::string const group = "cost/waves";
    auto const& points = study.sampling.subsets;
    integer(file, group, {"waves", "1", "waves of a part of the sample"}, points,
            [](SubsetPoint const& point) { return point.waves; });
    real(file, group, {"cpu", "s", "CPU time to make, measure and try them"}, points,
         [](SubsetPoint const& point) { return point.seconds; });
    real(file, group, {"width", "1", "width of the Clopper-Pearson interval of P(overturn), mean of all stripes"},
         points, [](SubsetPoint const& point) { return point.width; });
    real(file, group, {"root_n_width", "1", "the last width scaled by 1/sqrt(waves)"}, points,
         [](SubsetPoint const& point) { return point.root_n_width; });
    file.attribute(group, "confidence", study.confidence);
    file.attribute(group, "campaign_half_width", study.sampling.half_width);
    file.attribute(group, "campaign_cpu", study.sampling.seconds);
    file.attribute("cost", "sentence", study.sentence);
    file.attribute("cost", "numerical", study.balance.numerical);
    file.attribute("cost", "sampling", study.balance.sampling);
}

void write_step_error(ResultsWriter& file, StepError const& error) {
    std::string const group = "cost/step_error";
    file.attribute(group, "trials", error.trials);
    file.attribute(group, "step_flips", error.step_flips);
    file.attribute(group, "rounding_flips", error.rounding_flips);
    auto const& rows = error.quantities;
    if (rows.empty()) {
        return;
    }
    std::vector<std::string> names;
    std::ranges::transform(rows, std::back_inserter(names), [](auto const& row) { return row.name; });
    write_names(file, group, {"quantity", "1", "what a limit state may be set to", FieldType::category, 0, {}}, names);
    integer(file, group, {"compared", "1", "trials that end alike and have the quantity"}, rows,
            [](QuantityError const& row) { return row.step.count; });
    real(file, group, {"step_median", "1", "median of the relative difference that half the step makes"}, rows,
         [](QuantityError const& row) { return row.step.median; });
    real(file, group, {"step_p95", "1", "95 % quantile of it"}, rows,
         [](QuantityError const& row) { return row.step.p95; });
    real(file, group, {"rounding_median", "1", "median of the relative difference that a last bit of the motion makes"},
         rows, [](QuantityError const& row) { return row.rounding.median; });
    real(file, group, {"rounding_p95", "1", "95 % quantile of it"}, rows,
         [](QuantityError const& row) { return row.rounding.p95; });
}

void write_rare(ResultsWriter& file, RareCost const& rare) {
    std::string const group = "cost/rare";
    auto const& points = rare.points;
    integer(file, group, {"method", "1", "0 crude, 1 subset, 2 pulse-mixture"}, points,
            [](RarePoint const& point) { return static_cast<std::int64_t>(point.method); });
    real(file, group, {"cpu", "s", "CPU time, all of it"}, points,
         [](RarePoint const& point) { return point.seconds; });
    integer(file, group, {"waves", "1", "waves made"}, points, [](RarePoint const& point) { return point.waves; });
    real(file, group, {"cov", "1", "standard error over probability; 0: not trusted or not resolved"}, points,
         [](RarePoint const& point) { return point.cov; });
    integer(file, group, {"foretold", "1", "1: by the binomial law, from what one wave takes"}, points,
            [](RarePoint const& point) { return point.foretold ? 1 : 0; });
    file.attribute(group, "body", rare.body);
    file.attribute(group, "amplitude", rare.amplitude);
    file.attribute(group, "probability", rare.probability.value_or(not_known));
}

}  // namespace

void write_study(std::filesystem::path const& path, CampaignInput const& input, Study const& study) {
    ResultsWriter file(path);
    file.attribute("format", format_name);
    file.attribute("format_version", format_version);
    file.attribute("program_version", program_version());
    file.attribute("git_revision", git_revision());
    file.attribute("sources_sha256", sources_sha256());
    file.attribute("library_versions", library_versions());
    file.attribute("title", study.title);
    file.attribute("campaign", input.text);
    file.attribute("settings", fmt::format("{}", fmt::join(input.settings, "\n")));
    file.attribute("input_sha256", input.sha256());
    file.attribute("waves", study.waves);
    file.attribute("trials", study.trials);
    for (auto const& result : study.knobs) {
        write_knob(file, result);
    }
    write_step_error(file, study.step_error);
    write_waves(file, study);
    if (study.rare) {
        write_rare(file, *study.rare);
    }
    file.finish();
}

}  // namespace overturn::cost
