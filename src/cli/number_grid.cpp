#include "cli/number_grid.hpp"

#include <cmath>
#include <cstddef>

#include "core/error.hpp"
#include "core/parts_of.hpp"
#include "core/units.hpp"

namespace overturn::cli {
namespace {

constexpr std::size_t most_numbers = 2000;

double positive(std::string_view text, char const* option) {
    double value = 0;
    validate(parse_number(trimmed(text), value) && value > 0 && std::isfinite(value),
             "{} '{}' (not a number above 0). Write 1,2,5, or first:last:count for equal ratios", option, text);
    return value;
}

std::vector<double> any_grid(std::string_view text, char const* option) {
    std::vector<double> grid;
    auto const range = parts_of(text, ':');
    if (range.size() == 1) {
        for (auto const part : parts_of(text, ',')) {
            grid.push_back(positive(part, option));
        }
        return grid;
    }
    validate(range.size() == 3, "{} '{}' (neither a list nor first:last:count). Write 1,2,5 or 0.5:10:40", option,
             text);
    double const first = positive(range[0], option);
    double const last = positive(range[1], option);
    double const count = positive(range[2], option);
    validate(count >= 2 && count <= most_numbers && count == std::floor(count),
             "{} '{}' (its count is none from 2 to {}). Mend it", option, text, most_numbers);
    for (int i = 0; i < static_cast<int>(count); ++i) {
        grid.push_back(first * std::pow(last / first, i / (count - 1)));
    }
    return grid;
}

}  // namespace

std::vector<double> number_grid(std::string_view text, char const* option, double least, double most) {
    auto grid = any_grid(text, option);
    for (double const value : grid) {
        validate(value >= least && value <= most, "{} '{}' ({:g} is none from {:g} to {:g}). Mend it", option, text,
                 value, least, most);
    }
    return grid;
}

}  // namespace overturn::cli
