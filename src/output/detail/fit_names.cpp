#include "output/detail/fit_names.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace overturn::output {
namespace {

constexpr std::array<char const*, fragility_flags> flag_names{"no-trials",
                                                              "nothing-overturned",
                                                              "all-overturned",
                                                              "one-level",
                                                              "separated",
                                                              "not-rising",
                                                              "not-converged",
                                                              "one-overturned",
                                                              "two-levels",
                                                              "non-monotone",
                                                              "poor-fit",
                                                              "median-outside-data",
                                                              "hclpf-outside-data",
                                                              "undecided-trials",
                                                              "few-waves",
                                                              "interval-unbounded",
                                                              "waves-left-out",
                                                              "no-beta-u",
                                                              "five-percent-doubtful"};

// By the values of FragilityState.
constexpr std::array<char const*, 12> state_names{"fitted",    "no-trials", "nothing-overturned", "all-overturned",
                                                  "one-level", "separated", "not-rising",         "not-converged",
                                                  "grid",      "undecided", "few-records",        "few-waves"};

// The same with the words of the limit state: "nothing-overturned", "nothing overturned".
std::string in_words(std::string text, Passing passing) {
    constexpr std::string_view overturned = "overturned";
    auto const at = text.find(overturned);
    if (passing == Passing::exceeded && at != std::string::npos) {
        text.replace(at, overturned.size(), "exceeded");
    }
    return text;
}

}  // namespace

std::string name_of(FragilityState state, Passing passing) {
    return in_words(state_names.at(static_cast<std::size_t>(state)), passing);
}

std::vector<std::string> names_of_states(Passing passing) {
    std::vector<std::string> names;
    names.reserve(state_names.size());
    for (std::string const name : state_names) {
        names.push_back(in_words(name, passing));
    }
    return names;
}

std::string state_words(FragilityFit const& fit) {
    switch (fit.state) {
        case FragilityState::separated:
            return std::isfinite(fit.isotonic_median.upper) ? "levels too far apart" : "levels too low";
        case FragilityState::not_rising:
            return "P does not rise with the level";
        default:
            break;
    }
    auto words = name_of(fit.state, fit.passing);
    std::ranges::replace(words, '-', ' ');
    return words;
}

std::vector<std::string> names_of(FragilityFlags flags, Passing passing) {
    std::vector<std::string> names;
    for (std::uint32_t f = 0; f < fragility_flags; ++f) {
        if (has(flags, static_cast<FragilityFlag>(f))) {
            names.push_back(in_words(flag_names.at(f), passing));
        }
    }
    return names;
}

}  // namespace overturn::output
