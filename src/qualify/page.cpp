#include "qualify/page.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/texts_of.hpp"
#include "core/wrapped.hpp"
#include "output/json.hpp"
#include "output/record_page.hpp"
#include "output/table.hpp"

namespace overturn::qualify {
namespace {

char const* word(Check const& check) { return check.agrees() ? "PASS" : check.passed() ? "DIFF" : "FAIL"; }

output::Table check_table(Qualification const& shown) {
    output::TableOf<Check> table({.name = "checks"}, shown.checks);
    table.add("number", "1", "number of the check, never given to another", [](Check const& c) { return c.number; })
        .add("passed", "1", "true: it agrees, or differs for the reason given",
             [](Check const& c) { return c.passed(); })
        .add("agrees", "1", "true: the error is within the tolerance", [](Check const& c) { return c.agrees(); })
        .add("shows", "1", "statement that holds if it passes", [](Check const& c) { return c.shows; })
        .add("source", "1", "whence the expected value: author and year, or the law",
             [](Check const& c) { return c.source; })
        .category("basis", "what the expected value rests on",
                  {name_of(Basis::printed), name_of(Basis::solved_again), name_of(Basis::law)},
                  [](Check const& c) { return std::string(name_of(c.basis)); })
        .add("unit", "1", "of found, expected and tolerance; 1: pure numbers", [](Check const& c) { return c.unit; })
        .add("found", output::stated_unit("1"), "value found here; null: nothing finite",
             [](Check const& c) { return c.found; })
        .add("expected", output::stated_unit("1"), "known value", [](Check const& c) { return c.expected; })
        .add("tolerance", output::stated_unit("1"), "largest difference that passes",
             [](Check const& c) { return c.tolerance; })
        .add("remark", "1", "further facts", [](Check const& c) { return c.remark; })
        .add("differs_because", "1", "why a published number is not met; empty: it is",
             [](Check const& c) { return c.agrees() ? std::string() : c.differs_because; });
    return table.take();
}

output::Table left_out_table(Qualification const& shown) {
    output::TableOf<LeftOut> table({.name = "left_out"}, shown.left_out);
    table.add("result", "1", "published result that is not among the checks", [](LeftOut const& l) { return l.result; })
        .add("source", "1", "author and year", [](LeftOut const& l) { return l.source; })
        .add("reason", "1", "why it is left out", [](LeftOut const& l) { return l.reason; });
    return table.take();
}

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
        {"MPI", fmt::format("{}, {}", shown.mpi, count_text(shown.ranks, "rank"))},
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
            {"checks", output::json_of(check_table(shown))},
            {"left_out", output::json_of(left_out_table(shown))}};
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
