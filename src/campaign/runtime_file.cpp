#include "campaign/runtime_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign/results.hpp"
#include "core/error.hpp"
#include "core/note.hpp"
#include "store/durable.hpp"

namespace overturn {

std::string seconds_text(parallel::Communicator const& comm, PhaseSeconds const& seconds) {
    nlohmann::ordered_json json{{"rank", comm.rank()},
                                {"host", comm.host()},
                                {"waves_s", seconds.waves},
                                {"measures_s", seconds.measures},
                                {"response_s", seconds.response},
                                {"store_s", seconds.store}};
    for (std::size_t r = 0; r < seconds.rungs.size(); ++r) {
        json["rungs"][rungs()[r].name] = {{"trials", seconds.rungs[r].trials}, {"seconds", seconds.rungs[r].seconds}};
    }
    return json.dump();
}

PhaseSeconds sum_of_rungs(std::vector<std::string> const& ranks) {
    PhaseSeconds sum;
    for (auto const& rank : ranks) {
        auto const found = nlohmann::json::parse(rank).at("rungs");
        for (std::size_t r = 0; r < sum.rungs.size(); ++r) {
            auto const& rung = found.at(rungs()[r].name);
            sum.rungs[r].trials += rung.at("trials").get<std::int64_t>();
            sum.rungs[r].seconds += rung.at("seconds").get<double>();
        }
    }
    return sum;
}

void write_runtime(std::filesystem::path const& output, Part part, std::vector<std::string> const& ranks, double wall_s,
                   std::int64_t trials) {
    nlohmann::ordered_json json;
    json["wall_s"] = wall_s;
    json["trials"] = trials;
    json["trials_per_s"] = wall_s > 0 ? static_cast<double>(trials) / wall_s : 0.0;
    json["ranks"] = nlohmann::ordered_json::array();
    for (auto const& rank : ranks) {
        json["ranks"].push_back(nlohmann::ordered_json::parse(rank));
    }
    auto path = output;
    path.replace_extension(part.is_whole() ? ".runtime.json"
                                           : fmt::format(".part-{}-of-{}.runtime.json", part.number, part.of));
    auto const text = json.dump(2) + "\n";
    try {
        store::write_durably(path, std::as_bytes(std::span(text)));
    } catch (SystemError const& error) {
        note("the times of this run are not kept: {}\n", error.what());
    }
}

}  // namespace overturn
