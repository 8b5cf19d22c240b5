#include "runner/runtime_file.hpp"

#include <chrono>
#include <ctime>

#include <fmt/format.h>
#include <gnu/libc-version.h>
#include <nlohmann/json.hpp>

#include "campaign/version.hpp"
#include "core/error.hpp"
#include "core/print_note.hpp"
#include "simd/instruction_sets.hpp"
#include "store/durable.hpp"

namespace overturn {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

std::string seconds_text(parallel::Communicator const& comm, PhaseSeconds const& seconds) {
    nlohmann::ordered_json json{{"rank", comm.rank()},
                                {"host", comm.host()},
                                {"glibc", gnu_get_libc_version()},
                                {"lanes", simd::name_of(simd::instruction_sets().front())},
                                {"waves_s", seconds.waves},
                                {"measures_s", seconds.measures},
                                {"response_s", seconds.response},
                                {"store_s", seconds.store}};
    for (std::size_t r = 0; r < seconds.models.size(); ++r) {
        json["models"][model_categories()[r].name] = {{"trials", seconds.models[r].trials},
                                                      {"seconds", seconds.models[r].seconds}};
    }
    return json.dump();
}

PhaseSeconds sum_of_models(std::vector<std::string> const& ranks) {
    PhaseSeconds sum;
    for (auto const& rank : ranks) {
        auto const json = nlohmann::json::parse(rank);
        auto const& found = json.at(json.contains("models") ? "models" : "rungs");  // as they were called once
        for (std::size_t r = 0; r < sum.models.size(); ++r) {
            auto const& model = found.at(model_categories()[r].name);
            sum.models[r].trials += model.at("trials").get<std::int64_t>();
            sum.models[r].seconds += model.at("seconds").get<double>();
        }
    }
    return sum;
}

std::string segment_text(Part part, std::vector<std::string> const& ranks, RunSeconds const& seconds,
                         std::int64_t trials) {
    auto const now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
    auto const ended = std::chrono::system_clock::to_time_t(now);
    std::tm utc{};
    ::gmtime_r(&ended, &utc);
    constexpr int first_year = 1900;
    Json json{{"ended_utc", fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", utc.tm_year + first_year,
                                        utc.tm_mon + 1, utc.tm_mday, utc.tm_hour, utc.tm_min, utc.tm_sec)},
              {"part", fmt::format("{}/{}", part.number, part.of)},
              {"program", program_identity()},
              {"compiler", compiler()},
              {"libraries", library_versions()},
              {"mpi", parallel::Communicator::library()},
              {"wall_s", seconds.wall},
              {"start_s", seconds.start},
              {"work_s", seconds.work},
              {"rare_s", seconds.rare},
              {"merge_s", seconds.merge},
              {"trials", trials},
              {"ranks", Json::array()}};
    for (auto const& rank : ranks) {
        json["ranks"].push_back(Json::parse(rank));
    }
    return json.dump();
}

void write_runtime(std::filesystem::path const& output, std::span<std::string const> segments, double merge_s) {
    double wall_s = merge_s;
    std::int64_t trials = 0;
    auto list = Json::array();
    auto ranks = Json::array();
    for (auto const& text : segments) {
        auto segment = Json::parse(text, nullptr, false);
        if (segment.is_discarded() || !segment.contains("ranks")) {
            continue;  // damaged; blocks do not depend on it
        }
        wall_s += segment.value("wall_s", 0.0);
        trials += segment.value("trials", std::int64_t{0});
        for (auto& rank : segment["ranks"]) {
            rank["segment"] = list.size();
            ranks.push_back(rank);
        }
        segment["ranks"] = segment["ranks"].size();
        list.push_back(std::move(segment));
    }
    Json const json{{"wall_s", wall_s}, {"merge_s", merge_s},
                    {"trials", trials}, {"trials_per_s", wall_s > 0 ? static_cast<double>(trials) / wall_s : 0.0},
                    {"segments", list}, {"ranks", ranks}};
    auto path = output;
    path.replace_extension(".runtime.json");
    try {
        store::write_durably(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
    } catch (SystemError const& error) {
        print_note("the times of this run are not kept: {}\n", error.what());
    }
}

}  // namespace overturn
