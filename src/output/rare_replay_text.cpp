#include "output/rare_replay_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace overturn::output {

std::string rare_replay_text(RareReplay const& replay, std::int64_t row, std::string const& body,
                             std::string const& limit) {
    std::vector<std::string> ends;
    for (std::size_t f = 0; f < replay.factors.size(); ++f) {
        ends.push_back(fmt::format("{} at factor {:.6g}",
                                   !replay.passed[f]            ? "stood"
                                   : limit == overturning_limit ? "overturned"
                                                                : "passed",
                                   replay.factors[f]));
    }
    auto const& stored = replay.stored;
    return fmt::format("row {} of {}: {}, replicate {}, stage {}, index {}, weight {:.6g}\n{}\n", row, body,
                       name_of(static_cast<rare::Method>(stored.method)), stored.replicate, stored.stage, stored.index,
                       stored.weight, fmt::join(ends, ", "));
}

Json rare_replay_json(RareReplay const& replay, std::int64_t row, std::string const& body, std::string const& limit) {
    auto ends = Json::array();
    for (std::size_t f = 0; f < replay.factors.size(); ++f) {
        ends.push_back({{"factor", replay.factors[f]}, {"passed", static_cast<bool>(replay.passed[f])}});
    }
    auto const& stored = replay.stored;
    return {{"row", row},
            {"body_name", body},
            {"limit", limit},
            {"method", name_of(static_cast<rare::Method>(stored.method))},
            {"replicate", stored.replicate},
            {"stage", stored.stage},
            {"index", stored.index},
            {"weight", stored.weight},
            {"ends", std::move(ends)},
            {"bit_equal", replay.different.empty()},
            {"different", replay.different}};
}

}  // namespace overturn::output
