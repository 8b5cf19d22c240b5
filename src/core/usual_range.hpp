/// Numbers that are possible and hardly meant, as tables: what is looked at, where it usually lies, and what to say.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace overturn {

/// A number that is stated, or follows from what is stated, and where it usually lies.
template <class Of> struct UsualRange {
    double (*value)(Of const& of);  ///< NaN: does not apply
    double low, high;
    std::string (*text)(Of const& of, double value);
    std::string_view known;   ///< the usual range, in words
    std::string_view remedy;  ///< advice
};

/// Warning for each number outside, a line each: "<text> (<known>). <remedy>".
template <class Of>
[[nodiscard]] std::vector<std::string> unusual(Of const& of, std::span<UsualRange<Of> const> ranges) {
    std::vector<std::string> lines;
    for (auto const& range : ranges) {
        double const value = range.value(of);
        if (value < range.low || value > range.high) {
            lines.push_back(fmt::format("{} ({}). {}", range.text(of, value), range.known, range.remedy));
        }
    }
    return lines;
}

}  // namespace overturn
