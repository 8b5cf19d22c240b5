#include "report/cost_page.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "report/detail/study_page.hpp"

namespace overturn::report {
namespace {

using Json = nlohmann::ordered_json;

std::string number(Json const& value, char const* unknown = "&ndash;") {
    return value.is_null() ? unknown : fmt::format("{:.1e}", value.get<double>());
}

std::string time_text(double seconds) {
    constexpr double milli = 1e-3;
    constexpr double micro = 1e-6;
    return seconds >= 1       ? fmt::format("{:.3g} s", seconds)
           : seconds >= milli ? fmt::format("{:.3g} ms", seconds / milli)
                              : fmt::format("{:.3g} &micro;s", seconds / micro);
}

std::string figure_of(char const* kind, Json const& data) {
    return study_figure("cost_figure.py", {{"kind", kind}, {"data", data}});
}

std::string row_of(Json const& row) {
    auto const text = [&](char const* key) { return escaped(row.at(key).get<std::string>()); };
    std::string title;
    for (auto const& setting : row.at("settings")) {
        title += (title.empty() ? "--set " : " --set ") + escaped(setting.get<std::string>());
    }
    bool const here = row.at("here").get<bool>();
    auto const& error = row.at("error");
    auto const trials = row.at("trials").get<std::int64_t>();
    auto const& probability = row.at("probability_error");
    auto const& ks = row.at("ks_distance");
    return fmt::format(
        "<tr class=\"{}\" title=\"{}\"><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
        "<td>{}</td></tr>\n",
        here                             ? "here"
        : row.at("on_front").get<bool>() ? "front"
                                         : "plain",
        title, text("label"), time_text(row.at("cpu_s").get<double>()), number(error.at("median")),
        number(error.at("p95")), number(error.at("worst")),
        trials == 0 ? "&ndash;" : fmt::format("{} of {}", row.at("flips").get<std::int64_t>(), trials),
        probability.is_null() ? "&ndash;" : fmt::format("{:+.4f}", probability.get<double>()),
        ks.is_null() ? "&ndash;" : fmt::format("{:.4f}", ks.get<double>()));
}

std::string section_of(Json const& knob) {
    auto const text = [&](char const* key) { return escaped(knob.at(key).get<std::string>()); };
    auto section = fmt::format("<section id=\"{}\"><header><h2>{}</h2><p>{}</p></header>\n", text("name"),
                               text("title"), text("advice"));
    section += figure_of("knob", knob);
    section += fmt::format(
        "<div class=\"scroll\"><table><thead><tr><th>setting</th><th>CPU a {}</th><th>median</th>"
        "<th>95 %</th><th>worst</th><th>flips</th><th>P error</th><th>KS</th></tr></thead><tbody>\n",
        text("timed"));
    for (auto const& row : knob.at("settings")) {
        section += row_of(row);
    }
    return section
           + fmt::format("</tbody></table><p class=\"quiet\">Error: {}. {} {}s behind every row.</p></div></section>\n",
                         text("error"), knob.at("units").get<std::int64_t>(), text("timed"));
}

std::string step_section(Json const& error) {
    std::string section =
        "<section id=\"step-error\" style=\"grid-template-columns: minmax(0, 1fr)\"><header><h2>What the step does to "
        "each quantity</h2></header>\n"
        "<div class=\"scroll\"><table><thead><tr><th>quantity</th><th>trials</th><th>half the step, median</th>"
        "<th>95 %</th><th>last bit, median</th><th>95 %</th></tr></thead><tbody>\n";
    for (auto const& row : error.at("quantities")) {
        auto const& step = row.at("step");
        auto const& rounding = row.at("rounding");
        section += fmt::format(
            "<tr class=\"plain\"><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
            escaped(row.at("name").get<std::string>()), step.at("count").get<std::int64_t>(), number(step.at("median")),
            number(step.at("p95")), number(rounding.at("median")), number(rounding.at("p95")));
    }
    return section
           + fmt::format(
               "</tbody></table><p class=\"quiet\">Relative differences in trials that end alike: at half "
               "the campaign's steps, and under motions that are a last bit smaller (this is chaos, not "
               "error). Of {} trials, half the step changes {} verdicts, a last bit {}.</p></div></section>\n",
               error.at("trials").get<std::int64_t>(), error.at("step_flips").get<std::int64_t>(),
               error.at("rounding_flips").get<std::int64_t>());
}

std::string waves_section(Json const& sampling) {
    std::string section = "<section id=\"waves\"><header><h2>Number of waves</h2></header>\n";
    section += figure_of("waves", sampling);
    section +=
        "<div class=\"scroll\"><table><thead><tr><th>waves</th><th>CPU</th><th>width</th><th>1/&radic;n</th></tr>"
        "</thead><tbody>\n";
    for (auto const& point : sampling.at("subsets")) {
        section += fmt::format("<tr class=\"plain\"><td>{}</td><td>{}</td><td>{:.4f}</td><td>{:.4f}</td></tr>\n",
                               point.at("waves").get<std::int64_t>(), time_text(point.at("cpu_s").get<double>()),
                               point.at("width").get<double>(), point.at("root_n_width").get<double>());
    }
    section += fmt::format("<tr class=\"here\"><td>{}</td><td>{}</td><td>{:.4f}</td><td>&ndash;</td></tr>\n",
                           sampling.at("campaign_waves").get<std::int64_t>(),
                           time_text(sampling.at("campaign_cpu_s").get<double>()),
                           2 * sampling.at("campaign_half_width").get<double>());
    return section
           + fmt::format(
               "</tbody></table><p class=\"quiet\">Width of the {:g} % Clopper-Pearson interval of "
               "P(overturn), mean of {} stripes; the campaign's own row is foretold from the sample."
               "</p></div></section>\n",
               100 * sampling.at("confidence").get<double>(), sampling.at("stripes").get<std::int64_t>());
}

std::string rare_section(Json const& rare) {
    auto section = fmt::format(
        "<section id=\"rare\"><header><h2>Rare events</h2><p>Scatter of P(overturn) of {} at factor "
        "{:g}{}.</p></header>"
        "\n",
        escaped(rare.at("body").get<std::string>()), rare.at("amplitude").get<double>(),
        rare.at("probability").is_null() ? "" : fmt::format(", P = {:.2e}", rare.at("probability").get<double>()));
    section += figure_of("rare", rare);
    section +=
        "<div "
        "class=\"scroll\"><table><thead><tr><th>method</th><th>effort</th><th>CPU</th><th>waves</th><th>c.o.v.</th>"
        "<th></th></tr></thead><tbody>\n";
    for (auto const& point : rare.at("points")) {
        auto const& reason = point.at("reason");
        section +=
            fmt::format("<tr class=\"plain\"><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                        point.at("method").get<std::string>(), escaped(point.at("effort").get<std::string>()),
                        time_text(point.at("cpu_s").get<double>()), point.at("waves").get<std::int64_t>(),
                        point.at("cov").is_null() ? "&ndash;" : fmt::format("{:.3f}", point.at("cov").get<double>()),
                        reason.is_null() ? "" : escaped(reason.get<std::string>()));
    }
    return section
           + "</tbody></table><p class=\"quiet\">Crude Monte Carlo is foretold by the binomial law from what one wave "
             "takes; the others were run.</p></div></section>\n";
}

}  // namespace

void check_page_name(std::filesystem::path const& output) {
    validate(output.extension() == ".html", "{}: not the name of a page (its ending says the kind). End it in .html",
             output.string());
}

std::string cost_page(Json const& study) {
    auto const title = escaped(study.at("title").get<std::string>());
    auto const& balance = study.at("balance");
    auto page = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>What accuracy costs: "
        "{0}</title>\n"
        "<style>{1}</style></head><body>\n<h1>What accuracy costs</h1>\n<p>{0}</p>\n<p class=\"answer\">{2}</p>\n",
        title, study_style, escaped(balance.at("sentence").get<std::string>()));
    bool const sampled = !study.at("sampling").is_null();
    page += sampled ? "<div style=\"max-width:44rem\">" + figure_of("balance", balance) + "</div>\n" : "";
    page += fmt::format(
        "<p class=\"quiet\">{} trials of {} on {} waves, spread over the campaign. Every setting ran the same waves "
        "and was "
        "held against a reference of {} a trial; a second one, which differs in rounding only, is {} from it (95 %) "
        "and flips "
        "{} verdicts: nothing below that is resolved. Diamond: where the campaign stands. Full dots, dashed line: the "
        "Pareto "
        "front, where nothing is both faster and more accurate; differences within 15 % decide nothing. Dots are "
        "the "
        "95 % quantile of the error, bars reach from the median to the worst. A flip is a verdict other than the "
        "reference's. Peak rotations are compared where the body rocks in both; rocking is chaotic near the boundary, "
        "so "
        "histories are not, and the Kolmogorov-Smirnov distance KS compares the distributions of peak rotation (one "
        "trial moved by rounding makes it one over the number of trials). Point at a row to see the setting.</p>\n",
        study.at("trials").get<std::int64_t>(), study.at("campaign_trials").get<std::int64_t>(),
        study.at("waves").get<std::int64_t>(), time_text(study.at("reference_cpu_s").get<double>()),
        number(study.at("rounding").at("error").at("p95")), study.at("rounding").at("flips").get<std::int64_t>());
    page += step_section(study.at("step_error"));
    for (auto const& knob : study.at("knobs")) {
        page += section_of(knob);
    }
    page += sampled ? waves_section(study.at("sampling")) : "";
    page += study.contains("rare") ? rare_section(study.at("rare")) : "";
    return page + "</body></html>\n";
}

}  // namespace overturn::report
