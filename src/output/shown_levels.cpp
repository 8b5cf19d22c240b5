#include "output/shown_levels.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace overturn::output {

std::vector<std::size_t> spread_places(std::size_t count) {
    constexpr std::size_t most = 30;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < std::min(count, most); ++i) {
        places.push_back(count <= most ? i : i * (count - 1) / (most - 1));
    }
    return places;
}

std::vector<std::size_t> shown_levels(LevelSpec const& levels) {
    auto places = spread_places(levels.levels.size());
    for (std::size_t l = 0; l < levels.levels.size(); ++l) {
        if (levels.levels[l].purpose != LevelClass::ordinary) {
            places.push_back(l);
        }
    }
    std::ranges::sort(places);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
}

std::string left_out_levels(LevelSpec const& levels) {
    auto const shown = shown_levels(levels).size();
    return shown == levels.levels.size()
               ? std::string()
               : fmt::format("({} of {} levels; all are in the file)\n", shown, levels.levels.size());
}

}  // namespace overturn::output
