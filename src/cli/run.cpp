#include "runner/run.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

#include "cli/collective.hpp"
#include "cli/text_choice.hpp"
#include "cli/verbs.hpp"
#include "cli/walltime.hpp"
#include "core/elapsed.hpp"
#include "core/error.hpp"
#include "core/next_step.hpp"
#include "core/print_note.hpp"
#include "runner/progress.hpp"
#include "runner/stop_policy.hpp"

namespace overturn::cli {
namespace {

struct RunVerbOptions {
    std::string campaign;
    std::optional<std::string> output;
    std::vector<std::string> settings;
    std::optional<std::string> max_walltime;  // given and empty is no wish to leave it out
    std::optional<std::string> part;
    std::optional<std::string> progress;
    TextChoice text;
    bool resume = false;
    bool extend = false;
    bool shrink = false;
    bool leaves_blocks = false;
    Packing packing;
};

// "2/8"
Part read_part(std::string const& text) {
    constexpr std::int64_t most = 1'000'000;
    Part part{0, 0};
    char const* const end = text.data() + text.size();
    auto const [slash, bad_number] = std::from_chars(text.data(), end, part.number);
    bool good = bad_number == std::errc() && slash != end && *slash == '/';
    if (good) {
        auto const [last, bad_count] = std::from_chars(slash + 1, end, part.of);
        good = bad_count == std::errc() && last == end;
    }
    validate(good && part.number >= 1 && part.number <= part.of && part.of <= most,
             "--part '{}' (must be I/N, I from 1 to N). In an array job: $SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT "
             "of an array from 1",
             text);
    return part;
}

// Where the results go: through links to what they name, there or not yet, or the link would be replaced.
std::filesystem::path output_of(RunVerbOptions const& options) {
    namespace fs = std::filesystem;
    validate(!options.output || !options.output->empty(), "-o '' (no name: an unset variable?). Name a file");
    fs::path output = options.output ? fs::path(*options.output) : default_output(options.campaign);
    std::error_code error;
    constexpr int most_links = 40;  // as the kernel
    for (int i = 0; i < most_links && fs::is_symlink(fs::symlink_status(output, error)); ++i) {
        output = output.parent_path() / fs::read_symlink(output, error);  // an absolute one takes the place of all
    }
    auto const found = fs::status(output, error);
    validate(fs::status_known(found) && !fs::is_symlink(fs::symlink_status(output, error)),
             "output {} (links in a circle, or a folder that may not be entered). Name another with -o",
             output.string());
    return output;
}

int run(RunVerbOptions const& options, parallel::Communicator const& comm) {
    auto const text = options.text.options();
    auto const input = load_campaign_everywhere(options.campaign, options.settings, comm);
    RunOptions run_options;
    run_options.merge = {.layout = options.packing.layout(), .text = text, .begun = program_begin()};
    run_options.output = output_of(options);
    run_options.resume = options.resume;
    run_options.extend = options.extend;
    run_options.shrink = options.shrink;
    run_options.leaves_blocks = options.leaves_blocks;
    run_options.max_walltime_s = seconds_of_job(comm);
    if (options.max_walltime) {
        run_options.max_walltime_s = std::min(run_options.max_walltime_s, stated_walltime(*options.max_walltime));
    }
    if (options.part) {
        run_options.part = read_part(*options.part);
    }
    return run_campaign(input, run_options, comm) == RunEnd::complete ? done : resumable;
}

}  // namespace

void add_run(CommandLine& line) {
    auto verb = line.verb("run", "run a campaign, alone or under mpirun");
    auto options = std::make_shared<RunVerbOptions>();
    verb.needs("campaign", options->campaign, "campaign file (TOML)");
    verb.takes("-o,--output", options->output, "results file; default: NAME.h5 of NAME.toml, in the current folder");
    verb.takes("--resume", options->resume, "continue an interrupted run");
    verb.takes(
        "--extend", options->extend,
        "add waves, levels, bodies, limits or statistics to the finished file at -o; its rows are kept. Where no "
        "file is, the campaign begins anew. One run does it: not with --part or --leave-blocks");
    verb.takes("--shrink", options->shrink,
               "with --extend or --resume: give up waves, levels and bodies that the campaign does not hold any more");
    verb.takes("--set", options->settings, "override keys: waves.count=50 bodies.0.friction=0.4", "KEY=VALUE ...");
    verb.takes("--max-walltime", options->max_walltime,
               "stop within this time, to be resumed later: \"50 min\", 01:00:00, 1-00:00:00; without a unit: seconds");
    verb.takes("--part", options->part, "I/N: compute part I of N, for array jobs; overturn merge then makes the file");
    verb.takes("--leave-blocks", options->leaves_blocks,
               "write blocks only; overturn merge then makes the file in a job of one rank");
    verb.takes("--progress", options->progress, "json: write progress to stderr, one JSON object per line", "json");
    options->packing.offered_by(verb);
    options->text.offered_by(verb);
    verb.does([options] {
        validate(!options->progress || *options->progress == "json",
                 "--progress '{}' (unknown). Say json, or leave it out", options->progress.value_or(""));
        if (options->progress) {
            tell_as_json(options->output.value_or(default_output(options->campaign).string()));
        }
        NextStep const next(options->extend ? "go on with --extend" : "go on with --resume");
        stop_on_signals();  // what came earlier, or comes while MPI starts or records are read, is not lost
        return on_all_ranks([&](auto const& comm) { return run(*options, comm); });
    });
}

}  // namespace overturn::cli
