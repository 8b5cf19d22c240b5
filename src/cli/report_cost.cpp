#include "cli/report_cost.hpp"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "core/print_note.hpp"
#include "output/page_text.hpp"
#include "output/stripe_text.hpp"
#include "runner/runtime_file.hpp"

namespace overturn::cli {
namespace {

namespace fs = std::filesystem;

Json cost_lines(Json const& runtime, fs::path const& path) {
    auto lines = Json::array();
    auto const& segments = runtime.at(runtime.contains("segments") ? "segments" : "legs");  // as they were called once
    std::int64_t most_ranks = 0;
    for (auto const& segment : segments) {
        most_ranks = std::max(most_ranks, segment.at("ranks").get<std::int64_t>());
    }
    lines.push_back(output::cost_text(runtime.at("wall_s").get<double>(), most_ranks, segments.size(),
                                      runtime.at("trials_per_s").get<double>(), path.filename().string()));
    std::vector<std::string> ranks;
    for (auto const& rank : runtime.at("ranks")) {
        ranks.push_back(rank.dump());
    }
    if (auto const costs = output::model_costs(sum_of_models(ranks)); !costs.empty()) {
        lines.push_back(costs);
    }
    return lines;
}

}  // namespace

Json cost_of(fs::path path) {
    path.replace_extension(".runtime.json");
    if (!fs::is_regular_file(path)) {
        return Json::array();
    }
    try {
        std::ifstream stream(path);
        return cost_lines(Json::parse(stream), path);
    } catch (Json::exception const&) {
        print_note("{}: not as overturn run writes it (damaged?). The page shows no times\n", path.string());
        return Json::array();
    }
}

}  // namespace overturn::cli
