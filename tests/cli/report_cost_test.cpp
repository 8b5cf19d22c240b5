// Requirement R-1003: the page states what a run took, of files of times that older programs wrote too.
#include "cli/report_cost.hpp"

#include <fstream>

#include <nlohmann/json.hpp>

#include "response/registry.hpp"
#include "support/temporary_folder.hpp"

namespace overturn::cli {
namespace {

TEST(ReportCost, IsReadUnderTheNamesOfOlderPrograms) {
    nlohmann::json models;
    for (auto const& model : model_categories()) {
        models[model.name] = {{"trials", 3}, {"seconds", 6e-6}};
    }
    auto const written = [&](char const* segments, char const* of_rank) {
        return nlohmann::json{{"wall_s", 2.0},
                              {"trials_per_s", 6.0},
                              {segments, nlohmann::json::array({{{"ranks", 2}}})},
                              {"ranks", nlohmann::json::array({{{of_rank, models}}})}}
            .dump();
    };
    testing::TemporaryFolder const folder;
    std::ofstream(folder / "c.runtime.json") << written("segments", "models");
    auto const now = cost_of(folder / "c.h5");
    ASSERT_EQ(now.size(), 2U);
    EXPECT_NE(now[0].get<std::string>().find("2 ranks"), std::string::npos) << now;
    EXPECT_NE(now[1].get<std::string>().find("3 trials, 2.0 us each"), std::string::npos) << now;

    std::ofstream(folder / "c.runtime.json") << written("legs", "rungs");
    EXPECT_EQ(cost_of(folder / "c.h5"), now);
}

}  // namespace
}  // namespace overturn::cli
