#include "report/sensitivity_page.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "report/cost_page.hpp"
#include "report/detail/study_page.hpp"

namespace overturn::report {
namespace {

using SensitivityJson = nlohmann::ordered_json;

std::string keys_of(SensitivityJson const& row) {
    std::string keys;
    for (auto const& key : row.at("keys")) {
        keys += (keys.empty() ? "" : ", ") + escaped(key.get<std::string>());
    }
    return keys;
}

std::string median_cell(SensitivityJson const& end) {
    if (end.at("median_ratio").is_null()) {
        return "&ndash;";
    }
    auto const percent = [](SensitivityJson const& ratio) {
        return ratio.is_null() ? std::string("open") : fmt::format("{:+.1f}", 100 * (ratio.get<double>() - 1));
    };
    auto const& ends = end.at("median_ratio_interval");
    return fmt::format("{} % ({} to {}){}", percent(end.at("median_ratio")), percent(ends.at(0)), percent(ends.at(1)),
                       end.at("resolved").get<bool>() ? "" : ", not resolved");
}

std::string end_cells(SensitivityJson const& row, char const* side, bool has_design) {
    auto const& end = row.at(side);
    auto cells = fmt::format("<tr class=\"plain\"><td>{}</td><td>{}</td><td>{}</td>", keys_of(row),
                             escaped(row.at("value").get<std::string>()), escaped(end.at("value").get<std::string>()));
    if (!end.contains("median_ratio")) {
        return cells
               + fmt::format("<td colspan=\"{}\" style=\"white-space:normal\">refused: {}</td></tr>\n",
                             has_design ? 3 : 2, escaped(end.at("refused").get<std::string>()));
    }
    cells += fmt::format("<td>{}</td><td>+{} &minus;{} of {}</td>", median_cell(end),
                         end.at("newly_passed").get<std::int64_t>(), end.at("no_longer_passed").get<std::int64_t>(),
                         end.at("compared").get<std::int64_t>());
    if (has_design) {
        auto const& design = end.at("design_basis");
        cells += fmt::format(
            "<td>{} (+{} &minus;{})</td>",
            design.at("probability").is_null() ? std::string("&ndash;")
                                               : fmt::format("{:.3g}", design.at("probability").get<double>()),
            design.at("newly_passed").get<std::int64_t>(), design.at("no_longer_passed").get<std::int64_t>());
    }
    return cells + "</tr>\n";
}

// Enough of it to be drawn.
bool moves_median(SensitivityJson const& end) {
    constexpr double least = 5e-4;
    return end.contains("median_ratio") && !end.at("median_ratio").is_null()
           && std::abs(end.at("median_ratio").get<double>() - 1) >= least;
}

std::string section_of_body(SensitivityJson const& study, SensitivityJson const& unmoved, std::size_t number) {
    auto rows = SensitivityJson::array();
    for (auto const& row : study.at("rows")) {
        if (row.at("body") == unmoved.at("body") && row.at("limit") == unmoved.at("limit")) {
            rows.push_back(row);
        }
    }
    if (rows.empty()) {
        return "";
    }
    bool const has_design = !study.at("design_basis").is_null();
    auto const body = escaped(unmoved.at("body").get<std::string>());
    auto section = fmt::format("<section id=\"sensitivity-{}\"><header><h2>{}, {}</h2></header>\n", number, body,
                               escaped(unmoved.at("limit").get<std::string>()));
    bool const moved = std::ranges::any_of(
        rows, [](SensitivityJson const& row) { return moves_median(row.at("low")) || moves_median(row.at("high")); });
    if (moved) {
        section += study_figure("sensitivity_figure.py", {{"rows", rows}, {"unmoved", unmoved}, {"study", study}});
    }
    section += fmt::format(
        "<div class=\"scroll\"><table><thead><tr><th>input</th><th>is</th><th>moved to</th><th>median"
        "</th><th>verdicts</th>{}</tr></thead><tbody>\n",
        has_design ? "<th>P at the design basis</th>" : "");
    for (auto const& row : rows) {
        section += end_cells(row, "low", has_design) + end_cells(row, "high", has_design);
    }
    return section + "</tbody></table></div></section>\n";
}

}  // namespace

std::string sensitivity_page(SensitivityJson const& study) {
    auto const title = escaped(study.at("title").get<std::string>());
    auto page = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>What assumed numbers decide: "
        "{0}</title>\n<style>{1}section {{ grid-template-columns: minmax(0, 1fr); }} figure {{ max-width: 44rem; "
        "}}</style></head><body>\n<h1>What assumed numbers decide</h1>\n<p>{0}</p>\n"
        "<p class=\"quiet\">Each number that is said to be assumed is moved alone, to both ends of its range or by a "
        "tenth, under the same {2} waves of {3}. Intervals ({4:g} %) are of the change itself, from resampled waves "
        "that "
        "both share; verdicts: newly passed and no longer passed, of those that both decide.</p>\n",
        title, study_style, study.at("waves").get<std::int64_t>(), study.at("campaign_waves").get<std::int64_t>(),
        100 * study.at("confidence").get<double>());
    for (std::size_t i = 0; i < study.at("unmoved").size(); ++i) {
        page += section_of_body(study, study.at("unmoved").at(i), i);
    }
    for (auto const& input : study.at("not_moved")) {
        page += fmt::format("<p class=\"quiet\">Not moved: {} = {} ({}).</p>\n",
                            escaped(input.at("key").get<std::string>()), escaped(input.at("value").get<std::string>()),
                            escaped(input.at("why").get<std::string>()));
    }
    return page + "</body></html>\n";
}

}  // namespace overturn::report
