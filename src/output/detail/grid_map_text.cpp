#include "output/detail/grid_map_text.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "core/text_width.hpp"

namespace overturn::output {
namespace {

// "<= 400": already the lowest that was tried; "> 1000": none that was tried; "-" where the trials leave it open.
std::string least_text(GridMap const& map, GridLine const& line, std::optional<std::size_t> level) {
    if (!level) {
        return line.undecided > 0 ? "-" : fmt::format("> {:.4g}", map.shown_in.of(map.levels.back()));
    }
    return fmt::format("{}{:.4g}", *level == 0 ? "<= " : "", map.shown_in.of(map.levels[*level]));
}

}  // namespace

std::string grid_map_text(GridMap const& map) {
    auto const unit = map.shown_in.symbol.empty() || map.shown_in.symbol == "1" ? map.measure : map.shown_in.symbol;
    auto text = fmt::format("  least of {} levels, {} {:.4g} to {}, that lifts it off, overturns it{}\n",
                            map.levels.size(), map.measure, map.shown_in.of(map.levels.front()),
                            map.shown_in.text(map.levels.back()), map.limits.size() > 1 ? ", exceeds a limit" : "");
    std::vector<std::string> heads{"uplift " + unit, "overturning", "stands up to"};
    heads.insert(heads.end(), map.limits.begin() + 1, map.limits.end());
    text += fmt::format("{:>12}", "Hz");
    for (auto const& head : heads) {
        text += fmt::format("  {:>12}", head);
    }
    text += '\n';
    for (auto const& line : map.lines) {
        std::vector<std::string> cells{
            least_text(map, line, line.uplift), least_text(map, line, line.least.front()),
            line.standing ? fmt::format("{:.4g}", map.shown_in.of(map.levels[*line.standing])) : std::string("-")};
        for (std::size_t limit = 1; limit < line.least.size(); ++limit) {
            cells.push_back(least_text(map, line, line.least[limit]));
        }
        text += fmt::format("{:>12.4g}", 1 / line.period_s);
        for (std::size_t c = 0; c < cells.size(); ++c) {
            text += fmt::format("  {:>{}}", cells[c], std::max<std::size_t>(text_width(heads[c]), 12));
        }
        text += line.undecided > 0 ? fmt::format("  {} levels without a verdict\n", line.undecided) : "\n";
    }
    return text;
}

}  // namespace overturn::output
