#include "qualify/page.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/wrapped.hpp"
#include "output/record_page.hpp"

namespace overturn::qualify {
namespace {

char const* word(Check const& check) { return check.agrees() ? "PASS" : check.passed() ? "DIFF" : "FAIL"; }

// Counts need no tolerance.
bool is_count(Check const& check) { return check.tolerance == 0 && check.expected == 0; }

std::string found_text(Check const& check) {
    if (is_count(check)) {
        return fmt::format("{:g} {}", check.found, check.unit);
    }
    auto const unit = check.unit == "1" ? "" : " " + check.unit;
    return fmt::format("{:.10g}{}, expected {:.10g}, error {:.1e} (at most {:.1e})", check.found, unit, check.expected,
                       check.error(), check.tolerance);
}

std::string with_remark(std::string text, Check const& check) {
    for (auto const& more : {check.remark, check.agrees() ? std::string() : check.differs_because}) {
        text += more.empty() ? "" : (text.empty() ? "" : "; ") + more;
    }
    return text;
}

// "22 numbers that others printed, 20 published problems solved again and 4 laws"
std::string bases_text(Qualification const& shown) {
    auto const of = [&](Basis basis) { return std::ranges::count(shown.checks, basis, &Check::basis); };
    return fmt::format("{} printed numbers, {} published problems solved again, {} laws", of(Basis::printed),
                       of(Basis::solved_again), of(Basis::law));
}

std::vector<std::string> cells_of(Check const& check, bool published) {
    auto const unit = check.unit == "1" ? "" : " " + check.unit;
    std::vector<std::string> cells{word(check), check.number, check.shows, check.source};
    if (published) {
        cells.emplace_back(name_of(check.basis));
    }
    cells.push_back(fmt::format("{:.10g}{}", check.expected, unit));
    cells.push_back(fmt::format("{:.10g}{}", check.found, unit));
    cells.push_back(fmt::format("{:.1e}", check.error()));
    cells.push_back(is_count(check) ? "0" : fmt::format("{:.1e}", check.tolerance));
    cells.push_back(with_remark("", check));
    return cells;
}

std::string with_source(LeftOut const& left) { return fmt::format("{} ({})", left.result, left.source); }

std::string verdict(Qualification const& shown) {
    std::vector<std::string> failed;
    std::vector<std::string> apart;
    for (auto const& check : shown.checks) {
        if (!check.passed()) {
            failed.push_back(check.number);
        } else if (!check.agrees()) {
            apart.push_back(check.number);
        }
    }
    if (!failed.empty()) {
        return fmt::format("{} of {} checks FAIL: {}", failed.size(), shown.checks.size(), fmt::join(failed, ", "));
    }
    auto const agree = shown.checks.size() - apart.size();
    return apart.empty() ? fmt::format("all {} checks pass", agree)
                         : fmt::format("{} checks pass, and {} differ from what is printed, each for its reason: {}",
                                       agree, apart.size(), fmt::join(apart, ", "));
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
        text += labelled(fmt::format("{}  {}", word(check), check.number),
                         fmt::format("{} ({}{}): {}", check.shows, check.source,
                                     shown.published ? fmt::format("; {}", name_of(check.basis)) : "",
                                     with_remark(found_text(check), check)),
                         12);
    }
    for (auto const& left : shown.left_out) {
        text += wrapped(fmt::format("left out: {}: {}", with_source(left), left.reason), 4);
    }
    for (auto const& [name, value] : circumstances(shown)) {
        text += wrapped(fmt::format("{}: {}", name, value), 4);
    }
    return text + (shown.published ? wrapped(bases_text(shown)) : "") + wrapped(verdict(shown), 4);
}

nlohmann::ordered_json json_of(Qualification const& shown) {
    using Json = nlohmann::ordered_json;
    auto checks = Json::array();
    for (auto const& check : shown.checks) {
        checks.push_back({{"number", check.number},
                          {"passed", check.passed()},
                          {"agrees", check.agrees()},
                          {"shows", check.shows},
                          {"source", check.source},
                          {"basis", name_of(check.basis)},
                          {"unit", check.unit},
                          {"found", std::isfinite(check.found) ? Json(check.found) : Json(nullptr)},
                          {"expected", check.expected},
                          {"tolerance", check.tolerance},
                          {"remark", check.remark},
                          {"differs_because", check.agrees() ? "" : check.differs_because}});
    }
    auto left_out = Json::array();
    for (auto const& left : shown.left_out) {
        left_out.push_back({{"result", left.result}, {"source", left.source}, {"reason", left.reason}});
    }
    return {{"passed", shown.passed()},
            {"summary", verdict(shown)},
            {"program", shown.program},
            {"machine", shown.machine},
            {"compiler", shown.compiler},
            {"libraries", shown.libraries},
            {"mpi", shown.mpi},
            {"ranks", shown.ranks},
            {"folder", shown.folder},
            {"date", shown.date},
            {"published", shown.published},
            {"checks", std::move(checks)},
            {"left_out", std::move(left_out)}};
}

std::string page_of(Qualification const& shown) {
    output::RecordPage page{.title = "Qualification: " + verdict(shown),
                            .facts = circumstances(shown),
                            .head = {"result", "number", "statement", "source"},
                            .rows = {}};
    if (shown.published) {
        page.facts.insert(page.facts.begin(), {"compared with", bases_text(shown)});
        page.head.emplace_back("basis");
    }
    for (char const* const name : {"expected", "here", "difference", "at most", "reason"}) {
        page.head.emplace_back(name);
    }
    for (auto const& check : shown.checks) {
        page.rows.push_back({cells_of(check, shown.published), check.passed()});
    }
    for (auto const& left : shown.left_out) {
        std::vector<std::string> cells{"left out", "", left.result, left.source};
        cells.resize(page.head.size() - 1);
        cells.push_back(left.reason);
        page.rows.push_back({std::move(cells), true});
    }
    return output::html_of(page);
}

}  // namespace overturn::qualify
