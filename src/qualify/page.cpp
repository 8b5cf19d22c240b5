#include "qualify/page.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "output/record_page.hpp"

namespace overturn::qualify {
namespace {

char const* word(Check const& check) { return check.agrees() ? "PASS" : check.passed() ? "DIFF" : "FAIL"; }

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
    for (auto const& more : {check.remark, check.agrees() ? std::string() : check.differs_because}) {
        text += more.empty() ? "" : "; " + more;
    }
    return text;
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
        fmt::format_to(std::back_inserter(text), "{}  {}  {} ({}): {}\n", word(check), check.number, check.shows,
                       check.source, with_remark(found_text(check), check));
    }
    for (auto const& left : shown.left_out) {
        fmt::format_to(std::back_inserter(text), "left out: {}: {}\n", with_source(left), left.reason);
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
                          {"agrees", check.agrees()},
                          {"shows", check.shows},
                          {"source", check.source},
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
                            .head = {"result", "number", "what it shows", "source", "found"},
                            .rows = {}};
    for (auto const& check : shown.checks) {
        page.rows.push_back(
            {{word(check), check.number, check.shows, check.source, with_remark(found_text(check), check)},
             check.passed()});
    }
    for (auto const& left : shown.left_out) {
        page.rows.push_back({{"left out", "", left.result, left.source, left.reason}, true});
    }
    return output::html_of(page);
}

}  // namespace overturn::qualify
