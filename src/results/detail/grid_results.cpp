#include "results/detail/grid_results.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

#include <fmt/format.h>

namespace overturn {

void write_grid(store::ResultsWriter& file, CampaignSpec const& spec, BodyAnalysis const& body) {
    auto const group = "grid/" + body.body;
    auto const& map = *body.grid;
    auto const put = [&](Field const& field, auto get, char const* axis) {
        std::vector<decltype(get(map.lines.front()))> values;
        std::ranges::transform(map.lines, std::back_inserter(values), get);
        file.array(group, field, values, axis);
    };
    put(
        {"frequency", "Hz", "frequency of the wave"}, [](GridLine const& line) { return 1 / line.period_s; }, "");
    put(
        {"wave", "1", "number of the wave", FieldType::integer}, [](GridLine const& line) { return line.wave; },
        "frequency");
    auto const level = [&](std::string const& name, std::string const& what, auto place) {
        put(
            {name, spec.levels.units(), what + "; NaN: none that was tried"},
            [&](GridLine const& line) { return map.value(place(line)); }, "frequency");
    };
    level("uplift", "least level that lifted it off", [](GridLine const& line) { return line.uplift; });
    level("overturning", "least level that overturned it", [](GridLine const& line) { return line.least.front(); });
    level("standing", "highest level at which it stood", [](GridLine const& line) { return line.standing; });
    for (std::size_t limit = 1; limit < map.limits.size(); ++limit) {
        level("limit_" + map.limits[limit], fmt::format("least level that exceeded {}", map.limits[limit]),
              [limit](GridLine const& line) { return line.least.at(limit); });
    }
    put(
        {"undecided", "1", "levels without a verdict", FieldType::integer},
        [](GridLine const& line) { return line.undecided; }, "frequency");
    file.attribute(group, "level_measure", spec.levels.measure_name());
}

}  // namespace overturn
