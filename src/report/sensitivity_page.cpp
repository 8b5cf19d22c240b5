#include "report/sensitivity_page.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/escaped_html.hpp"
#include "report/cost_page.hpp"
#include "report/detail/study_page.hpp"

namespace overturn::report {
namespace {

using SensitivityJson = nlohmann::ordered_json;

std::string keys_of(SensitivityJson const& row) {
    std::string keys;
    for (auto const& key : row.at("keys")) {
        keys += (keys.empty() ? "" : ", ") + escaped_html(key.get<std::string>());
    }
    return keys;
}

std::string median_cell(SensitivityJson const& row) {
    if (row.value("levels_too_coarse", false)) {
        return "not resolved: coarse levels";
    }
    if (row.at("median_ratio").is_null()) {
        return "&ndash;";
    }
    auto const percent = [&](char const* key) {
        return row.at(key).is_null() ? std::string("open")
                                     : fmt::format("{:+.1f}", 100 * (row.at(key).get<double>() - 1));
    };
    return fmt::format("{} % ({} to {}){}", percent("median_ratio"), percent("median_ratio_lower"),
                       percent("median_ratio_upper"), row.at("resolved").get<bool>() ? "" : ", not resolved");
}

std::string moved_row(SensitivityJson const& row, bool has_design) {
    std::vector<std::string> cells{keys_of(row), text_at(row, "value"), text_at(row, "moved_to")};
    if (!row.at("refused").is_null()) {
        auto const cell =
            fmt::format(R"(</td><td colspan="{}" style="white-space:normal">refused: )", has_design ? 3 : 2);
        cells.back() += cell + text_at(row, "refused");
        return table_row(cells);
    }
    cells.push_back(median_cell(row));
    cells.push_back(fmt::format("+{} &minus;{} of {}", count_at(row, "newly_passed"), count_at(row, "no_longer_passed"),
                                count_at(row, "compared")));
    if (has_design) {
        cells.push_back(fmt::format("{} (+{} &minus;{})", number_at(row, "design_basis_probability", "{:.3g}"),
                                    count_at(row, "design_basis_newly_passed"),
                                    count_at(row, "design_basis_no_longer_passed")));
    }
    return table_row(cells);
}

// Enough of it to be drawn.
bool moves_median(SensitivityJson const& row) {
    constexpr double least = 5e-4;
    return !row.at("median_ratio").is_null() && std::abs(row.at("median_ratio").get<double>() - 1) >= least;
}

std::string section_of_body(SensitivityJson const& tables, SensitivityJson const& unmoved, std::size_t number) {
    auto const& study = tables.at("study").at(0);
    bool const has_design = !study.at("design_basis").is_null();
    auto rows = SensitivityJson::array();
    std::string cells;
    for (auto const& row : tables.at("rows")) {
        if (row.at("body") == unmoved.at("body") && row.at("limit") == unmoved.at("limit")) {
            rows.push_back(row);
            cells += moved_row(row, has_design);
        }
    }
    if (rows.empty()) {
        return "";
    }
    auto section = fmt::format("<section id=\"sensitivity-{}\"><header><h2>{}, {}</h2></header>\n", number,
                               text_at(unmoved, "body"), text_at(unmoved, "limit"));
    if (std::ranges::any_of(rows, moves_median)) {
        section += study_figure("sensitivity_figure.py", {{"rows", rows}, {"unmoved", unmoved}, {"study", study}},
                                "sensitivity of " + text_at(unmoved, "body"));
    }
    std::vector<std::string> headings{"input", "value", "changed to", "median", "verdicts"};
    if (has_design) {
        headings.emplace_back("P at the design basis");
    }
    return section
           + last_table(fmt::format("{}, {}", text_at(unmoved, "body"), text_at(unmoved, "limit")), headings, cells);
}

}  // namespace

std::string sensitivity_page(SensitivityJson const& tables) {
    auto const& study = tables.at("study").at(0);
    auto page = study_head("Effect of assumed values", study,
                           "section { grid-template-columns: minmax(0, 1fr); } figure { max-width: 44rem; }");
    page += fmt::format(
        "<p class=\"quiet\">Each assumed value is changed alone: to both ends of its range, or by 10 %. The waves stay "
        "the "
        "same: {} of {}. Intervals ({:g} %) are of the change itself, by bootstrap over these waves. Verdicts: newly "
        "passed and no longer passed, of trials that are decided in both.</p>\n",
        count_at(study, "waves"), count_at(study, "campaign_waves"), 100 * study.at("confidence").get<double>());
    for (std::size_t i = 0; i < tables.at("unmoved").size(); ++i) {
        page += section_of_body(tables, tables.at("unmoved").at(i), i);
    }
    for (auto const& input : tables.at("not_moved")) {
        page += fmt::format("<p class=\"quiet\">Not changed: {} = {} ({}).</p>\n", text_at(input, "key"),
                            text_at(input, "value"), text_at(input, "why"));
    }
    return page + "</main></body></html>\n";
}

}  // namespace overturn::report
