#include "config/suggestion.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace overturn::config {
namespace {

// Optimal string alignment distance (Damerau 1964, restricted).
std::size_t distance(std::string_view a, std::string_view b) {
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                d[i][j] = i + j;
                continue;
            }
            std::size_t const substituted = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, substituted});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
            }
        }
    }
    return d[a.size()][b.size()];
}

}  // namespace

std::string nearest_name(std::string_view wrong, std::span<std::string const> known) {
    std::string best;
    std::size_t best_distance = std::max<std::size_t>(2, wrong.size() / 3) + 1;
    for (auto const& name : known) {
        if (auto const d = distance(wrong, name); d < best_distance) {
            best = name;
            best_distance = d;
        }
    }
    return best;
}

std::string joined(std::span<std::string const> names) {
    std::string list;
    for (auto const& name : names) {
        list += list.empty() ? name : ", " + name;
    }
    return list;
}

std::string suggestion(std::string_view wrong, std::span<std::string const> known) {
    auto const near = nearest_name(wrong, known);
    auto const list = fmt::format("Known: {}", fmt::join(known, ", "));
    return near.empty() ? list : fmt::format("Did you mean '{}'? {}", near, list);
}

}  // namespace overturn::config
