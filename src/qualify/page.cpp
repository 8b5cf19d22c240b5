#include "qualify/page.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "output/record_page.hpp"

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
    std::vector<std::pair<std::string, std::string>> facts{
        {"program", "overturn " + shown.program},
        {"machine", shown.machine},
        {"compiler", shown.compiler},
        {"libraries", shown.libraries},
        {"MPI", fmt::format("{}, {}", shown.mpi, shown.ranks == 1 ? "1 rank" : fmt::format("{} ranks", shown.ranks))},
        {"files in", shown.folder}};
    if (!shown.date.empty()) {
        facts.insert(facts.begin(), {"date", shown.date});
    }
    return facts;
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
            {"ranks", shown.ranks},       {"folder", shown.folder},       {"date", shown.date},
            {"checks", std::move(checks)}};
}

std::string page_of(Qualification const& shown) {
    output::RecordPage page{.title = "Qualification: " + verdict(shown),
                            .facts = circumstances(shown),
                            .head = {"", "number", "what it shows", "source", "found"},
                            .rows = {}};
    for (auto const& check : shown.checks) {
        page.rows.push_back(
            {{word(check.passed()), check.number, check.shows, check.source, with_remark(found_text(check), check)},
             check.passed()});
    }
    return output::html_of(page);
}

}  // namespace overturn::qualify
