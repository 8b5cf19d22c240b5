#include "motion/detail/motion_look.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace overturn {

namespace {

constexpr std::string_view one_sign = "values of one sign throughout";

}  // namespace

std::string_view no_motion(std::span<double const> values) {
    constexpr std::size_t telling = 20;
    if (values.size() < telling) {
        return {};
    }
    auto const [least, most] = std::ranges::minmax(values);
    if (least == most) {
        return "one value throughout";
    }
    if (std::ranges::is_sorted(values) || std::ranges::is_sorted(values, std::ranges::greater{})) {
        return only_rising;
    }
    if (least >= 0 || most <= 0) {
        return one_sign;
    }
    double sum = 0;
    double squares = 0;
    for (double const value : values) {
        sum += value;
        squares += value * value;
    }
    auto const count = static_cast<double>(values.size());
    constexpr double off_zero = 0.5;  // of the root mean square; a noisy baseline's offset stays far below
    return std::abs(sum / count) > off_zero * std::sqrt(squares / count) ? "values about another one than zero"
                                                                         : std::string_view{};
}

std::string_view no_named_motion(std::span<double const> values, bool own) {
    auto const why = no_motion(values);
    bool const zero = std::ranges::find(values, 0.0) != values.end();
    return (why == one_sign && !zero) || (why == only_rising && !own) ? why : std::string_view{};
}

std::optional<std::size_t> gap_in(std::span<double const> values) {
    constexpr std::array marks{999.0, 9999.0, 99999.0, 999999.0, 999.9, 9999.9, 999.99, 9999.99, 12345.0};
    constexpr double far = 3;
    auto const is_mark = [&](double value) { return std::ranges::find(marks, std::abs(value)) != marks.end(); };
    double most = 0;
    for (double const value : values) {
        most = is_mark(value) ? most : std::max(most, std::abs(value));
    }
    auto const at =
        std::ranges::find_if(values, [&](double value) { return is_mark(value) && std::abs(value) > far * most; });
    return at == values.end() ? std::nullopt : std::optional(static_cast<std::size_t>(at - values.begin()));
}

bool are_side_by_side(std::vector<std::vector<double>> const& columns) {
    constexpr std::size_t fewest = 20;
    auto const rows = columns.empty() ? 0 : columns.back().size();
    if (rows < fewest || columns.size() < 2) {
        return false;
    }
    double along_rows = 0;
    double down_columns = 0;
    for (std::size_t row = 0; row + 1 < rows; ++row) {
        for (std::size_t i = 0; i < columns.size(); ++i) {
            bool const last = i + 1 == columns.size();
            along_rows += std::abs((last ? columns[0][row + 1] : columns[i + 1][row]) - columns[i][row]);
            down_columns += std::abs(columns[i][row + 1] - columns[i][row]);
        }
    }
    constexpr double clearly = 0.5;
    return down_columns > 0 && down_columns < clearly * along_rows;
}

bool rises_evenly(std::vector<double> const& values) {
    constexpr std::size_t fewest = 2;
    bool even = values.size() >= fewest && values[1] > values[0];
    for (std::size_t i = 2; even && i < values.size(); ++i) {
        constexpr double printed = 0.1;  // of a step
        double const step = values[1] - values[0];
        even = values[i] > values[i - 1]
               && std::abs(values[i] - values[0] - static_cast<double>(i) * step)
                      <= printed * step * static_cast<double>(i);
    }
    return even;
}

bool counts_rows(std::vector<double> const& values) {
    for (std::size_t row = 1; row < values.size(); ++row) {
        if (values[row] != values[row - 1] + 1) {
            return false;
        }
    }
    return true;
}

}  // namespace overturn
