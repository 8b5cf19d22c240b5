#include "campaign/run.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>

#include <nlohmann/json.hpp>

#include "campaign/analysis.hpp"
#include "campaign/output_place.hpp"
#include "campaign/progress.hpp"
#include "campaign/results.hpp"
#include "store/durable.hpp"

namespace overturn {
namespace {

using Clock = std::chrono::steady_clock;

// A signal handler can reach nothing else: the one global of the program.
volatile std::sig_atomic_t stop_requested = 0;

void request_stop(int signal) {
    if (stop_requested != 0) {
        std::signal(signal, SIG_DFL);  // a second request leaves at once; blocks on disk stay good
        std::raise(signal);
    }
    stop_requested = 1;
}

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

// Runs `action` on rank 0 and gives its text to all; an InputError there becomes one everywhere.
template <class Action> std::string from_root(parallel::Communicator const& comm, Action&& action) {
    std::string text;
    if (comm.is_root()) {
        try {
            text = "+" + action();
        } catch (InputError const& error) {
            text = std::string("-") + error.what();
        }
    }
    comm.broadcast(text);
    if (text.front() == '-') {
        throw InputError(text.substr(1));
    }
    return text.substr(1);
}

std::vector<std::byte> labelled(std::int64_t block, std::vector<std::byte> const& rows) {
    std::vector<std::byte> message(sizeof block + rows.size());
    std::memcpy(message.data(), &block, sizeof block);
    std::copy(rows.begin(), rows.end(), message.begin() + sizeof block);
    return message;
}

/// One rank's share of the work; rank 0's also commits what all ranks send.
class Worker {
  public:
    Worker(CampaignSpec const& spec, Plan const& plan, std::vector<std::int64_t> const& left, RunOptions const& options,
           parallel::Communicator const& comm, store::ShardFolder const& shards, Progress& progress)
        : spec_(spec), plan_(plan), left_(left), options_(options), comm_(comm), shards_(shards), progress_(progress) {}

    void work() {
        parallel::SharedCounter counter(comm_);
        parallel::Outbox outbox;
        auto const begin = Clock::now();
        auto const count = static_cast<std::int64_t>(left_.size());
        while (true) {
            if (stop_requested != 0 || seconds_since(begin) > options_.max_walltime_s) {
                (void)counter.take(count);  // nobody gets another block
                break;
            }
            auto const turn = counter.take();
            if (turn >= count) {
                break;
            }
            auto const block = left_[static_cast<std::size_t>(turn)];
            auto const rows = run_block(spec_, plan_, block, seconds_).pack();
            if (comm_.is_root()) {
                commit(block, rows);
                drain();
            } else {
                outbox.post(labelled(block, rows));
            }
        }
        if (!comm_.is_root()) {
            outbox.post({});  // nothing more from here
        } else {
            while (finished_ < comm_.size() - 1) {
                take(comm_.receive());
            }
        }
    }

    [[nodiscard]] std::int64_t committed() const { return committed_; }
    [[nodiscard]] PhaseSeconds& seconds() { return seconds_; }

  private:
    void commit(std::int64_t block, std::span<std::byte const> rows) {
        auto const begin = Clock::now();
        shards_.commit(block, rows);
        seconds_.store += seconds_since(begin);
        ++committed_;
        progress_.block_done();
    }
    void take(parallel::Message const& message) {
        if (message.bytes.empty()) {
            ++finished_;
            return;
        }
        std::int64_t block = 0;
        std::memcpy(&block, message.bytes.data(), sizeof block);
        commit(block, std::span(message.bytes).subspan(sizeof block));
    }
    void drain() {
        while (auto const message = comm_.poll()) {
            take(*message);
        }
    }

    CampaignSpec const& spec_;
    Plan const& plan_;
    std::vector<std::int64_t> const& left_;
    RunOptions const& options_;
    parallel::Communicator const& comm_;
    store::ShardFolder const& shards_;
    Progress& progress_;
    PhaseSeconds seconds_;
    std::int64_t committed_ = 0;
    int finished_ = 0;
};

// The rungs of all ranks, from what they sent.
PhaseSeconds sum_of(std::vector<std::string> const& ranks) {
    PhaseSeconds sum;
    for (auto const& rank : ranks) {
        auto const rungs = nlohmann::json::parse(rank).at("rungs");
        for (std::size_t r = 0; r < sum.rungs.size(); ++r) {
            auto const& rung = rungs.at(rung_names()[r]);
            sum.rungs[r].trials += rung.at("trials").get<std::int64_t>();
            sum.rungs[r].seconds += rung.at("seconds").get<double>();
        }
    }
    return sum;
}

void write_runtime(std::filesystem::path const& output, std::vector<std::string> const& ranks, double wall_s,
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
    path.replace_extension(".runtime.json");
    auto const text = json.dump(2) + "\n";
    store::write_durably(path, std::as_bytes(std::span(text)));
}

std::string seconds_json(parallel::Communicator const& comm, PhaseSeconds const& s) {
    nlohmann::ordered_json json{{"rank", comm.rank()},      {"host", comm.host()},      {"waves_s", s.waves},
                                {"measures_s", s.measures}, {"response_s", s.response}, {"store_s", s.store}};
    for (std::size_t r = 0; r < s.rungs.size(); ++r) {
        json["rungs"][rung_names()[r]] = {{"trials", s.rungs[r].trials}, {"seconds", s.rungs[r].seconds}};
    }
    return json.dump();
}

std::vector<std::int64_t> blocks_left(Plan const& plan, std::vector<std::int64_t> const& committed) {
    std::vector<std::int64_t> left;
    for (std::int64_t block = 0; block < plan.blocks(); ++block) {
        if (!std::binary_search(committed.begin(), committed.end(), block)) {
            left.push_back(block);
        }
    }
    return left;
}

}  // namespace

void stop_on_signals() {
    for (int const signal : {SIGUSR1, SIGTERM, SIGINT}) {
        std::signal(signal, &request_stop);
    }
}

std::filesystem::path default_output(std::filesystem::path const& campaign) {
    return campaign.stem().replace_extension(".h5");
}

CampaignInput load_campaign_everywhere(std::filesystem::path const& path, std::span<std::string const> settings,
                                       parallel::Communicator const& comm) {
    return CampaignInput::deserialise(from_root(comm, [&] { return load_campaign(path, settings).serialise(); }));
}

RunEnd run_campaign(CampaignInput const& input, RunOptions const& options, parallel::Communicator const& comm) {
    auto const spec = parse_campaign(input);
    Plan const plan(spec);
    store::ShardFolder const shards(options.output, input.sha256());
    auto const found = nlohmann::json::parse(from_root(comm, [&] {
        auto const state = take_output(options.output, shards, input, plan, options.resume);
        return nlohmann::json{{"complete", state.complete}, {"committed", state.committed}}.dump();
    }));
    if (found.at("complete").get<bool>()) {
        if (comm.is_root()) {
            fmt::print("{}: complete already, nothing to do\n", options.output.string());
        }
        return RunEnd::complete;
    }
    auto const committed = found.at("committed").get<std::vector<std::int64_t>>();
    auto const left = blocks_left(plan, committed);
    if (comm.is_root()) {
        fmt::print(stderr, "waves: {}\n", spec.source->describe());
    }
    Progress progress(plan.blocks(), static_cast<std::int64_t>(committed.size()),
                      static_cast<double>(plan.trials()) / static_cast<double>(plan.blocks()));
    Worker worker(spec, plan, left, options, comm, shards, progress);
    worker.work();
    bool const whole =
        comm.largest(comm.is_root() && worker.committed() < static_cast<std::int64_t>(left.size()) ? 1 : 0) == 0;
    if (comm.is_root()) {
        progress.finish();
        if (whole) {
            auto const begin = Clock::now();
            Statistics statistics(spec);
            auto const analysis = write_results(
                options.output, input, spec, plan, [&](std::int64_t block) { return shards.read(block); }, statistics);
            shards.remove();
            worker.seconds().store += seconds_since(begin);
            fmt::print("{}{}", stripe_table(spec, statistics), analysis_table(analysis, spec.confidence));
        } else {
            fmt::print(stderr,
                       "stopped early: {} of {} blocks are done and safe. Go on with the same command and --resume\n",
                       static_cast<std::int64_t>(committed.size()) + worker.committed(), plan.blocks());
        }
    }
    auto const ranks = comm.gather(seconds_json(comm, worker.seconds()));
    if (comm.is_root()) {
        fmt::print(stderr, "cost: {}\n", rung_costs(sum_of(ranks)));
        write_runtime(options.output, ranks, progress.elapsed_s(), worker.committed() * plan.trials() / plan.blocks());
        if (whole) {
            fmt::print("results: {}\n", options.output.string());
        }
    }
    return whole ? RunEnd::complete : RunEnd::stopped;
}

}  // namespace overturn
