#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "campaign/plan.hpp"
#include "cli/verbs.hpp"
#include "store/results_file.hpp"
#include "store/shards.hpp"

namespace overturn::cli {
namespace {

int status(std::string const& path) {
    if (std::filesystem::exists(path)) {
        store::ResultsReader const file(path);
        auto const verdicts = file.integers("trials/verdict");
        fmt::print("{}: complete, {} trials of '{}'\n", path, verdicts.size(), file.text("title"));
        return done;
    }
    store::ShardFolder const unnamed(path, "");
    validate(unnamed.exists() && !unnamed.begun_with().empty(),
             "{}: no such results, finished or not (nothing was begun there). Check the name", path);
    auto const input = CampaignInput::deserialise(unnamed.begun_with());
    auto const spec = parse_campaign(input);
    Plan const plan(spec);
    std::vector<std::string> notes;
    auto const committed = store::ShardFolder(path, input.sha256()).committed(notes);
    for (auto const& note : notes) {
        fmt::print(stderr, "{}\n", note);
    }
    auto const left = plan.blocks() - static_cast<std::int64_t>(committed.size());
    std::string settings;
    for (auto const& setting : input.settings) {
        settings += fmt::format(" --set '{}'", setting);
    }
    fmt::print("{}: not complete, {} of {} blocks are done, {} left. Go on with: overturn run {} -o {} --resume{}\n",
               path, committed.size(), plan.blocks(), left, input.name, path, settings);
    return resumable;
}

}  // namespace

void add_status(CLI::App& app, Action& action) {
    auto* verb = app.add_subcommand("status", "is a run complete? exit 0: yes, 3: resumable");
    auto path = std::make_shared<std::string>();
    verb->add_option("file", *path, "results file")->required();
    verb->callback([path, &action] { action = [path] { return status(*path); }; });
}

}  // namespace overturn::cli
