#include "qualify/page.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

namespace overturn::qualify {
namespace {

char const* word(bool passed) { return passed ? "PASS" : "FAIL"; }

// Counts need no tolerance.
std::string found_text(Check const& check) {
    if (check.tolerance == 0 && check.expected == 0) {
        return fmt::format("{:g} {}", check.found, check.unit);
    }
    auto const unit = check.unit == "1" ? "" : " " + check.unit;
    return fmt::format("{:.10g}{}, expected {:.10g}, error {:.1e} (at most {:.1e})", check.found, unit, check.expected,
                       check.error(), check.tolerance);
}

std::string with_remark(std::string text, Check const& check) {
    return check.remark.empty() ? text : std::move(text) + "; " + check.remark;
}

std::string verdict(Qualification const& shown) {
    auto const failed = std::ranges::count_if(shown.checks, [](Check const& check) { return !check.passed(); });
    return failed == 0 ? fmt::format("all {} checks pass", shown.checks.size())
                       : fmt::format("{} of {} checks FAIL", failed, shown.checks.size());
}

std::vector<std::pair<std::string, std::string>> circumstances(Qualification const& shown) {
    return {
        {"program", "overturn " + shown.program},
        {"machine", shown.machine},
        {"compiler", shown.compiler},
        {"libraries", shown.libraries},
        {"MPI", fmt::format("{}, {}", shown.mpi, shown.ranks == 1 ? "1 rank" : fmt::format("{} ranks", shown.ranks))},
        {"files in", shown.folder}};
}

std::string escaped(std::string const& text) {
    std::string safe;
    for (char const c : text) {
        safe += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
    }
    return safe;
}

}  // namespace

bool Qualification::passed() const { return std::ranges::all_of(checks, &Check::passed); }

std::string text_of(Qualification const& shown) {
    std::string text;
    for (auto const& check : shown.checks) {
        fmt::format_to(std::back_inserter(text), "{}  {}  {} ({}): {}\n", word(check.passed()), check.number,
                       check.shows, check.source, with_remark(found_text(check), check));
    }
    for (auto const& [name, value] : circumstances(shown)) {
        fmt::format_to(std::back_inserter(text), "{}: {}\n", name, value);
    }
    return text + verdict(shown) + "\n";
}

nlohmann::ordered_json json_of(Qualification const& shown) {
    using Json = nlohmann::ordered_json;
    auto checks = Json::array();
    for (auto const& check : shown.checks) {
        checks.push_back({{"number", check.number},
                          {"passed", check.passed()},
                          {"shows", check.shows},
                          {"source", check.source},
                          {"unit", check.unit},
                          {"found", std::isfinite(check.found) ? Json(check.found) : Json(nullptr)},
                          {"expected", check.expected},
                          {"tolerance", check.tolerance},
                          {"remark", check.remark}});
    }
    return {{"passed", shown.passed()},   {"program", shown.program},     {"machine", shown.machine},
            {"compiler", shown.compiler}, {"libraries", shown.libraries}, {"mpi", shown.mpi},
            {"ranks", shown.ranks},       {"folder", shown.folder},       {"checks", std::move(checks)}};
}

std::string page_of(Qualification const& shown) {
    std::string rows;
    for (auto const& check : shown.checks) {
        fmt::format_to(std::back_inserter(rows),
                       "<tr class=\"{}\"><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                       check.passed() ? "pass" : "fail", word(check.passed()), check.number, escaped(check.shows),
                       escaped(check.source), escaped(with_remark(found_text(check), check)));
    }
    std::string facts;
    for (auto const& [name, value] : circumstances(shown)) {
        fmt::format_to(std::back_inserter(facts), "<dt>{}</dt><dd>{}</dd>\n", name, escaped(value));
    }
    return fmt::format(R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>overturn: qualification</title>
<style>
body {{ font: 15px/1.5 sans-serif; color: #222; max-width: 70rem; margin: 2rem auto; padding: 0 1rem; }}
div {{ overflow-x: auto; }} table {{ border-collapse: collapse; }}
th, td {{ text-align: left; vertical-align: top; padding: .25rem .75rem .25rem 0; border-bottom: 1px solid #ddd; }}
.pass td:first-child {{ color: #17633a; }} .fail td {{ color: #a02020; font-weight: bold; }}
dt {{ color: #666; }} dd {{ margin: 0 0 .4rem; }}
</style></head><body>
<h1>Qualification: {}</h1>
<dl>
{}</dl>
<div><table><thead><tr><th></th><th>number</th><th>what it shows</th><th>source</th><th>found</th></tr></thead><tbody>
{}</tbody></table></div>
</body></html>
)",
                       verdict(shown), facts, rows);
}

}  // namespace overturn::qualify
