#include "results/detail/hazard_years.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/units.hpp"
#include "motion/telling_words.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

// The number that ends before `at`; nothing if none does.
std::optional<double> number_before(std::string_view text, std::size_t at) {
    auto const end = text.find_last_not_of(" \t-", at == 0 ? 0 : at - 1);
    if (at == 0 || end == std::string_view::npos) {
        return std::nullopt;
    }
    auto const begin = text.find_last_not_of("0123456789.", end);
    auto const digits = text.substr(begin == std::string_view::npos ? 0 : begin + 1, end - begin);
    double value = 0;
    return parse_number(digits, value) ? std::optional(value) : std::nullopt;
}

std::optional<double> first_number(std::string_view text) {
    auto const first = std::min(text.find_first_of("0123456789"), text.size());
    auto const end = std::min(text.find_first_not_of("0123456789.e+", first), text.size());
    double number = 0;
    return parse_number(text.substr(first, end - first), number) ? std::optional(number) : std::nullopt;
}

// "values x 100", "in 10^-4 per year", "per century", "per 50 years": rates that are not what their column says.
bool tells_other_rates(std::string const& lower) {
    constexpr std::array<std::string_view, 6> powers{"in 10^", "in 10-", "in 1e-", "in 10**", "times 10", "x 10^"};
    auto const years = named_years(lower);
    return tells_factor(lower) || tells_other_span(lower)
           || (years && *years != 1 && lower.find("per ") != std::string::npos)
           || std::ranges::any_of(powers, [&](auto power) { return lower.find(power) != std::string::npos; });
}

}  // namespace

std::optional<double> named_years(std::string_view text) {
    for (std::string_view const word : {"year", "yr"}) {
        for (auto at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
            if (auto const years = number_before(text, at)) {
                return years;
            }
        }
    }
    return std::nullopt;
}

std::optional<double> years_in(std::string const& text) {
    auto const has = [&](std::string_view words) { return text.find(words) != std::string::npos; };
    bool const investigation = has("investigation");
    bool const probability = has("probab") || has("poe");
    constexpr std::array<std::string_view, 6> spans{"investigation", "exposure",    "life",
                                                    "reference p",   "time window", "time span"};
    auto const* const span = std::ranges::find_if(spans, has);
    if (span == spans.end() && !probability && !has("exceed")) {
        return std::nullopt;
    }
    if (auto const years = named_years(text)) {
        return years;
    }
    if (span != spans.end()) {
        auto const years = first_number(std::string_view(text).substr(text.find(*span)));
        return years || !investigation ? years : std::optional(0.0);
    }
    bool const annual = has("annual") || has("per year");
    return probability && !annual ? std::optional(0.0) : std::nullopt;
}

// By any of its usual names, with its unit in brackets or none.
bool is_annual_frequency(std::string_view name) {
    constexpr std::array<std::string_view, 12> names{"annual exceedance",
                                                     "annual rate",
                                                     "annual frequency",
                                                     "annual exceedance frequency",
                                                     "annual exceedance rate",
                                                     "annual frequency of exceedance",
                                                     "annual rate of exceedance",
                                                     "mean annual frequency of exceedance",
                                                     "mean annual rate of exceedance",
                                                     "mafe",
                                                     "mare",
                                                     "afe"};
    constexpr std::array<std::string_view, 9> units{"",    "1/a",   "1/yr",     "1/year", "/a",
                                                    "/yr", "/year", "per year", "a-1"};
    auto lower = lowered(name);
    std::ranges::replace(lower, '_', ' ');
    auto const open = lower.find_first_of("[(");
    auto const close = lower.find_first_of("])", std::min(open, lower.size()));
    auto const unit =
        open == std::string::npos ? std::string_view() : std::string_view(lower).substr(open + 1, close - open - 1);
    bool const ended = open == std::string::npos || (close != std::string::npos && close + 1 == lower.size());
    return ended && std::ranges::find(names, trimmed(std::string_view(lower).substr(0, open))) != names.end()
           && std::ranges::find(units, trimmed(unit)) != units.end();
}

void check_annual(PairTable const& table, Location const& where) {
    if (!is_annual_frequency(table.second_name)) {
        throw InputError(
            where, fmt::format("'{}' (must be annual_exceedance [1/a]: exceedances in a year; of a return period its "
                               "inverse, of a probability in t years -ln(1 - p) / t). Convert it",
                               table.second_name));
    }
}

std::vector<std::string> check_years(PairTable const& table, std::string const& name) {
    std::vector<std::string> remarks;
    for (auto const& line : table.text) {
        auto const text = lowered(line.text);
        auto const years = years_in(text);
        auto const named = named_years(text);
        if (!years && tells_other_rates(text)) {
            throw InputError({name, line.number},
                             fmt::format("{} (speaks of a factor or of another span than a year, and {} is read as it "
                                         "stands). Apply it to the numbers, and take the line away",
                                         in_quotes(trimmed(line.text)), table.second_name));
        }
        if (!years && named && *named != 1) {
            remarks.push_back(
                fmt::format("line {} names {:g} years: exceedances of one year are read. Check that they "
                            "are",
                            line.number, *named));
        }
        if (!years || *years == 1) {
            continue;
        }
        auto const time = *years > 0 ? fmt::format("{:g}", *years) : std::string("t");
        throw InputError({name, line.number},
                         fmt::format("{} (are these probabilities in {} years?). If so, convert them by -ln(1 - p) / "
                                     "{}; if they are exceedances in a year, remove this line",
                                     in_quotes(line.text), time, time));
    }
    return remarks;
}

}  // namespace overturn
