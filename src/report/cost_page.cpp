#include "report/cost_page.hpp"

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "report/detail/study_page.hpp"

namespace overturn::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr char const* short_form = "{:.1e}";

std::string time_at(Json const& row, char const* key) {
    auto const seconds = row.at(key).get<double>();
    constexpr double milli = 1e-3;
    constexpr double micro = 1e-6;
    return seconds >= 1       ? fmt::format("{:.3g} s", seconds)
           : seconds >= milli ? fmt::format("{:.3g} ms", seconds / milli)
                              : fmt::format("{:.3g} &micro;s", seconds / micro);
}

std::string figure_of(char const* kind, Json const& data) {
    return study_figure("cost_figure.py", {{"kind", kind}, {"data", data}},
                        data.is_object() && data.contains("knob") ? text_at(data, "title") : kind);
}

std::string row_of(Json const& row) {
    auto const trials = count_at(row, "trials");
    auto const* const kind = row.at("here").get<bool>() ? "here" : row.at("on_front").get<bool>() ? "front" : "plain";
    return table_row({text_at(row, "setting"), time_at(row, "cpu_s"), number_at(row, "error_median", short_form),
                      number_at(row, "error_p95", short_form), number_at(row, "error_worst", short_form),
                      trials == 0 ? "&ndash;" : fmt::format("{} of {}", count_at(row, "flips"), trials),
                      number_at(row, "probability_error", "{:+.4f}"), number_at(row, "ks_distance", "{:.4f}")},
                     kind, text_at(row, "arguments"));
}

std::string section_of(Json const& knob, Json const& all_settings) {
    Json data = knob;
    auto& settings = data["settings"] = Json::array();
    std::string rows;
    for (auto const& row : all_settings) {
        if (row.at("knob") == knob.at("knob")) {
            settings.push_back(row);
            rows += row_of(row);
        }
    }
    auto const timed = text_at(knob, "timed");
    return fmt::format("<section id=\"{}\"><header><h2>{}</h2><p>{}</p></header>\n", text_at(knob, "knob"),
                       text_at(knob, "title"), text_at(knob, "advice"))
           + figure_of("knob", data)
           + last_table(
               "settings: " + text_at(knob, "title"),
               {"setting", "CPU per " + timed, "median", "95 %", "worst", "changed", "P error", "KS"}, rows,
               fmt::format("Error: {}. {} {}s per row.", text_at(knob, "error"), count_at(knob, "samples"), timed));
}

std::string step_section(Json const& study, Json const& quantities) {
    std::string rows;
    for (auto const& row : quantities) {
        rows += table_row({text_at(row, "quantity"), fmt::format("{}", count_at(row, "step_count")),
                           number_at(row, "step_median", short_form), number_at(row, "step_p95", short_form),
                           number_at(row, "last_bit_median", short_form), number_at(row, "last_bit_p95", short_form)});
    }
    return "<section id=\"step-error\" style=\"grid-template-columns: minmax(0, 1fr)\"><header><h2>Effect of the step "
           "on "
           "each quantity</h2></header>\n"
           + last_table(
               "effect of the step",
               {"quantity", "trials", "half the step, median", "95 %", "last bit, median", "95 %"}, rows,
               fmt::format(
                   "Relative differences in trials with the same verdict: with half the campaign's step, and under a "
                   "motion one last bit smaller (chaos, not error). Verdicts that change, of {} trials: half the step "
                   "{}, a last bit {}.",
                   count_at(study, "step_trials"), count_at(study, "step_flips"), count_at(study, "last_bit_flips")));
}

std::string waves_section(Json const& study, Json const& parts) {
    std::string rows;
    for (auto const& row : parts) {
        rows += table_row({fmt::format("{}", count_at(row, "waves")), time_at(row, "cpu_s"),
                           number_at(row, "width", "{:.4f}"), number_at(row, "root_n_width", "{:.4f}")});
    }
    rows += table_row({fmt::format("{}", count_at(study, "campaign_waves")), time_at(study, "campaign_cpu_s"),
                       fmt::format("{:.4f}", 2 * study.at("campaign_half_width").get<double>()), "&ndash;"},
                      "here");
    return "<section id=\"waves\"><header><h2>Number of waves</h2></header>\n"
           + figure_of("waves", {{"study", study}, {"waves", parts}})
           + last_table("number of waves", {"waves", "CPU", "width", "1/&radic;n"}, rows,
                        fmt::format("Width of the {:g} % Clopper-Pearson interval of P(overturn), mean of {} stripes; "
                                    "the campaign's row is predicted from the sample.",
                                    100 * study.at("confidence").get<double>(), count_at(study, "stripes")));
}

std::string rare_section(Json const& points) {
    std::string rows;
    for (auto const& row : points) {
        rows += table_row({text_at(row, "method"), text_at(row, "effort"), time_at(row, "cpu_s"),
                           fmt::format("{}", count_at(row, "waves")), number_at(row, "cov", "{:.3f}"),
                           text_at(row, "reason")});
    }
    auto const& rare = points.at(0);
    return fmt::format(
               "<section id=\"rare\"><header><h2>Rare events</h2><p>Scatter of P(overturn) of {} at factor "
               "{}{}.</p></header>\n",
               text_at(rare, "body"), number_at(rare, "amplitude", "{:g}"),
               rare.at("probability").is_null() ? "" : number_at(rare, "probability", ", P = {:.2e}"))
           + figure_of("rare", points)
           + last_table(
               "rare events", {"method", "effort", "CPU", "waves", "c.o.v.", "remark"}, rows,
               "Crude Monte Carlo is predicted by the binomial law and the time of one wave; the others were run.");
}

}  // namespace

void check_page_name(std::filesystem::path const& output) {
    validate(output.extension() == ".html", "{}: not the name of a page (its ending says the kind). End it in .html",
             output.string());
}

std::string cost_page(Json const& tables) {
    auto const& study = tables.at("study").at(0);
    auto const& rounding = tables.at("rounding").at(0);
    auto page = study_head("What accuracy costs", study) + "<p class=\"answer\">" + text_at(study, "sentence") + " "
                + text_at(study, "largest_effect") + "</p>\n";
    bool const sampled = !tables.at("waves").empty();
    page += sampled ? "<div style=\"max-width:44rem\">" + figure_of("balance", study) + "</div>\n" : "";
    page += fmt::format(
        "<p class=\"quiet\">Sample: {} of {} trials, {} waves spread over the campaign. Every value of a setting runs "
        "on "
        "the same waves. Errors are differences from a reference of {} per trial. A second reference, which differs in "
        "rounding alone, differs by {} (95 %) and in {} verdicts: smaller errors cannot be seen.</p>\n"
        "<p class=\"quiet\">Figures: a diamond is the value of the campaign. Full dots on a dashed line are the Pareto "
        "front: no other value is both faster and more accurate. Differences within 15 % are not counted. A dot is the "
        "95 % quantile of the error; its bar reaches from the median to the worst.</p>\n"
        "<p class=\"quiet\">Tables: peak rotations are compared where the body rocks in both. Rocking is chaotic near "
        "overturning, so histories are not compared. KS is the Kolmogorov-Smirnov distance of the distributions of "
        "peak "
        "rotation; one trial changes it by 1/n. Point at a row to see the setting.</p>\n",
        count_at(study, "trials"), count_at(study, "campaign_trials"), count_at(study, "waves"),
        time_at(study, "reference_cpu_s"), number_at(rounding, "error_p95", short_form), count_at(rounding, "flips"));
    page += step_section(study, tables.at("step_error"));
    for (auto const& knob : tables.at("knobs")) {
        page += section_of(knob, tables.at("settings"));
    }
    page += sampled ? waves_section(study, tables.at("waves")) : "";
    page += tables.contains("rare") ? rare_section(tables.at("rare")) : "";
    return page + "</main></body></html>\n";
}

}  // namespace overturn::report
