#include <filesystem>
#include <limits>
#include <sstream>
#include <string>

#include <fmt/format.h>

#include "campaign/version.hpp"
#include "core/print_note.hpp"
#include "qualify/installation.hpp"
#include "runner/root_broadcast.hpp"
#include "runner/run.hpp"
#include "store/durable.hpp"
#include "store/results_file.hpp"
#include "store/sha256.hpp"
#include "store/shards.hpp"

namespace overturn::qualify {
namespace {

namespace fs = std::filesystem;

// Waves matched one by one, bodies that rock, slide, stand on a pad and move in space, energies over their bands.
constexpr char const* campaign_text = R"(seed = 2013
[waves]
source = "spectrum-compatible"
count = 3
duration = "40.96 s"
time_step = "0.01 s"
match = "each"
[waves.target]
spectrum = "mlit-ch1"
time_scale = 0.632
[waves.envelope]
shape = "jennings"
rise = "4 s"
level_end = "20 s"
end = "38 s"
[waves.transverse]
ratio = 0.8
[waves.vertical]
ratio = 0.5
[[bodies]]
name = "wide"
axes = 1
mass = "12.6 t"
base_width = "1.36 m"
centre_height = "1.045 m"
inertia = "uniform-block"
restitution = "housner"
friction = {static = 0.55, kinetic = 0.5}
[[bodies]]
name = "narrow"
axes = 1
mass = "12.6 t"
base_width = "0.90 m"
centre_height = "1.045 m"
inertia = "uniform-block"
restitution = {distribution = "lognormal", median = 0.75, beta = 0.05, high = 0.95}
[[bodies]]
name = "on a pad"
mass = "12.6 t"
base_width = "0.90 m"
centre_height = "1.045 m"
inertia = "uniform-block"
axes = 1
base = {bedding = "flat", points = 5}
pad = {strength = "5 MPa"}
[[bodies]]
name = "in space"
mass = "12.6 t"
base_width = "0.90 m"
centre_height = "1.045 m"
inertia = "uniform-block"
friction = 0.6
base = {shape = "round", points = 16}
[levels]
measure = "pga"
values = {from = "300 gal", to = "1500 gal", count = 7}
)";

// SHA-256 of the digests of all stored rows, by kind of machine: the same on every x86-64 CPU.
std::string known_rows(std::string const& kind) {
    return kind == "x86-64" ? "56e02bb1c72ee18273796c01edc54c325754d69e214f3c1f07aa5a7e4d47fa2a" : "";
}

CampaignInput campaign() {
    CampaignInput input;
    input.name = "qualify.toml";
    input.text = campaign_text;
    return input;
}

// Of the rows alone: other objects name the program.
std::string rows_digest(fs::path const& path) {
    store::ResultsReader const file(path);
    std::istringstream digests(file.content("digests/objects"));
    std::string rows;
    for (std::string line; std::getline(digests, line);) {
        rows += line.find("  /trials/") != std::string::npos || line.find("  /waves/") != std::string::npos
                    ? line + '\n'
                    : "";
    }
    return store::sha256(rows);
}

RunEnd run(fs::path const& output, parallel::Communicator const& comm, bool resume, double max_walltime_s) {
    RunOptions options;
    options.output = output;
    options.resume = resume;
    options.max_walltime_s = max_walltime_s;
    options.quiet = true;
    return run_campaign(campaign(), options, comm);
}

// What a kill at a bad moment leaves: a block that is cut short, and one that never got its name.
void wound(fs::path const& output) {
    for (auto const& entry : fs::recursive_directory_iterator(store::ShardFolder(output, "").folder())) {
        if (entry.is_regular_file() && entry.path().extension() == ".block") {
            fs::resize_file(entry.path(), entry.file_size() / 2);
            fs::copy_file(entry.path(), entry.path().string() + store::unfinished_mark + "-1");
            return;
        }
    }
}

Check known_bytes(fs::path const& file, int ranks) {
    auto const found = rows_digest(file);
    auto const known = known_rows(machine());
    Check check{"C-01",
                fmt::format("three waves with four bodies at seven levels, on {}, give the known rows",
                            ranks == 1 ? "one rank" : fmt::format("{} ranks", ranks)),
                "x86-64 reference, one rank",
                "files that differ",
                found == known ? 0.0 : 1.0,
                0,
                0};
    check.remark = known.empty()    ? fmt::format("no reference for {}; rows have SHA-256 {}", machine(), found)
                   : found == known ? ""
                                    : fmt::format("rows have SHA-256 {}", found);
    return check;
}

}  // namespace

Checks campaign_checks(fs::path const& folder, parallel::Communicator const& comm) {
    QuietNotes const quiet;
    auto const whole = folder / "whole.h5";
    auto const resumed = folder / "resumed.h5";
    bool const ran = run(whole, comm, false, std::numeric_limits<double>::infinity()) == RunEnd::complete;
    // No time is left once each rank has its first block.
    bool const stopped = run(resumed, comm, false, 0) == RunEnd::stopped;
    (void)broadcast_from_root(comm, [&] {
        if (stopped) {
            wound(resumed);
        }
        return std::string();
    });
    bool const went_on = run(resumed, comm, true, std::numeric_limits<double>::infinity()) == RunEnd::complete;
    if (!comm.is_root()) {
        return {};
    }
    Check again{"C-02",
                "a run that was stopped, with a block cut short, goes on to the same file",
                "this program",
                "files that differ",
                1,
                0,
                0};
    again.found = ran && went_on && store::read_file(whole) == store::read_file(resumed) ? 0 : 1;
    again.remark = stopped ? "" : "so many ranks that nothing was left to resume";
    return {known_bytes(whole, comm.size()), again};
}

}  // namespace overturn::qualify
