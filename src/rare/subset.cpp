#include "rare/subset.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "core/error.hpp"
#include "rare/detail/answer_items.hpp"
#include "rare/detail/answer_row.hpp"
#include "rare/detail/normals.hpp"
#include "rare/detail/scout.hpp"
#include "rare/detail/subset_run.hpp"

namespace overturn::rare {
namespace {

class Simulation {
  public:
    /// \param first number of the first replicate
    Simulation(Problem const& problem, double factor, Request const& request, Workforce& workers,
               SubsetOptions const& options, std::int64_t first, std::int64_t replicates)
        : problem_(problem),
          factor_(factor),
          options_(options),
          workers_(workers),
          name_(first == 0 ? "subset" : fmt::format("more-{}", first)) {
        for (std::int64_t r = first; r < first + replicates; ++r) {
            runs_.emplace_back(DrawKey{.seed = request.seed,
                                       .problem = request.problem,
                                       .replicate = static_cast<std::uint64_t>(r),
                                       .phase = Phase::subset},
                               problem.normals(), options);
        }
    }

    /// All replicates level by level, until each has ended or the runs are spent.
    void run(std::int64_t most_trials) {
        begin();
        for (auto going = close_levels(); !going.empty(); going = close_levels()) {
            auto const steps = options_.samples / options_.chains - 1;
            if (trials_ + steps * options_.chains * std::ssize(going) > most_trials) {
                return;
            }
            for (std::int64_t step = 0; step < steps; ++step) {
                step_all(going, step);
            }
        }
    }

    [[nodiscard]] std::vector<SubsetRun>& runs() { return runs_; }
    [[nodiscard]] std::int64_t trials() const { return trials_; }
    [[nodiscard]] Count const& plain() const { return plain_; }

  private:
    void begin();
    [[nodiscard]] std::int64_t replicates() const { return runs_.size(); }
    template <class Draw> void answer(std::span<AnswerRow> rows, Draw const& draw) const {
        answer_items(problem_, rows.size(), {&factor_, 1}, draw,
                     [&](std::size_t i, std::span<Answer const> answers) { rows[i] = row_of(answers.front()); });
    }
    std::vector<std::size_t> close_levels();
    void step_all(std::vector<std::size_t> const& going, std::int64_t step);

    Problem const& problem_;
    double factor_;
    SubsetOptions options_;
    Workforce& workers_;
    std::string name_;
    std::vector<SubsetRun> runs_;
    std::int64_t trials_ = 0;
    Count plain_;
};

void Simulation::begin() {
    auto const each = options_.samples;
    auto const rows = workers_.map<AnswerRow>({.name = name_ + "-0", .items = each * replicates()},
                                              [&](std::int64_t first, std::span<AnswerRow> out) {
                                                  answer(out, [&](std::size_t i, std::span<double> normals) {
                                                      auto const item = first + static_cast<std::int64_t>(i);
                                                      runs_[item / each].plain(item % each, normals);
                                                  });
                                              });
    for (std::size_t r = 0; r < runs_.size(); ++r) {
        runs_[r].begin(std::span(rows).subspan(r * each, each));
    }
    for (auto const& row : rows) {
        plain_.failed += row.failed;
        plain_.undecided += row.undecided;
    }
    plain_.trials = trials_ = each * replicates();
}

std::vector<std::size_t> Simulation::close_levels() {
    std::vector<std::size_t> going;
    for (std::size_t r = 0; r < runs_.size(); ++r) {
        if (runs_[r].end() == SubsetRun::End::none) {
            runs_[r].close_level();
            if (runs_[r].end() == SubsetRun::End::none) {
                going.push_back(r);
            }
        }
    }
    return going;
}

void Simulation::step_all(std::vector<std::size_t> const& going, std::int64_t step) {
    auto const chains = options_.chains;
    auto const items = chains * std::ssize(going);
    auto const name = fmt::format("{}-{}-{}", name_, runs_[going.front()].result().levels, step + 1);
    auto const rows =
        workers_.map<AnswerRow>({.name = name, .items = items}, [&](std::int64_t first, std::span<AnswerRow> out) {
            answer(out, [&](std::size_t i, std::span<double> normals) {
                auto const item = first + static_cast<std::int64_t>(i);
                runs_[going[item / chains]].propose(item % chains, normals);
            });
        });
    for (std::size_t g = 0; g < going.size(); ++g) {
        auto const from = g * chains;
        runs_[going[g]].step(std::span(rows).subspan(from, chains));
    }
    trials_ += items;
}

// Why no number can be given, if so.
struct Doubt {
    State state = State::trusted;
    std::string reason;
};

/// Replicates so far, batch by batch.
struct Batches {
    std::vector<SubsetRun> runs;
    std::int64_t trials = 0;
    Count plain;

    void add(Simulation simulation) {
        trials += simulation.trials();
        plain.add(simulation.plain());
        auto& more = simulation.runs();
        std::move(more.begin(), more.end(), std::back_inserter(runs));
    }
    /// No level was needed: its plain trials are all there is to it.
    [[nodiscard]] bool is_plain() const {
        return std::ranges::all_of(runs, [](SubsetRun const& run) { return run.result().levels == 0; });
    }
};

Doubt doubt_of(Batches const& batches, Scouted const& scouted, Estimate const& estimate, SubsetOptions const& options) {
    if (!scouted.found) {
        return {State::not_resolved, scouted.reason};
    }
    if (auto const words = words_of(estimate.health); !words.empty()) {
        return {State::not_trusted, words};
    }
    auto const ended = [&](SubsetRun::End how) {
        return std::ranges::count_if(batches.runs, [&](SubsetRun const& run) { return run.end() == how; });
    };
    if (auto const tied = ended(SubsetRun::End::plateau); tied > 0) {
        return {State::not_trusted,
                fmt::format("the driver's threshold ties in {} of {} replicates (many trials answer "
                            "the same, so nothing leads to failure)",
                            tied, batches.runs.size())};
    }
    if (ended(SubsetRun::End::too_deep) > 0) {
        return {State::not_resolved, fmt::format("not reached in {} levels", options.most_levels)};
    }
    if (ended(SubsetRun::End::none) > 0) {
        return {State::not_resolved, fmt::format("not reached in {} waves (max_runs)", batches.trials)};
    }
    return {};
}

void check_health(Estimate& estimate, Batches const& batches, Scouted const& scouted) {
    auto const check = [&](std::string name, double value, double limit) {
        estimate.health.push_back({std::move(name), value, limit, value <= limit});
    };
    check("failures that the driver misses", scouted.missed, most_missed);
    if (batches.trials == 0) {
        return;
    }
    std::int64_t undecided = 0;
    for (auto const& run : batches.runs) {
        undecided += run.undecided();
    }
    constexpr double most_undecided_share = 0.001;
    check("undecided trials", static_cast<double>(undecided) / static_cast<double>(batches.trials),
          most_undecided_share);
}

// Beyond it the interval spans a decade, and the mean rests on one or two replicates.
constexpr double largest_cov = 0.5;

std::vector<double> probabilities_of(Batches const& batches) {
    std::vector<double> probabilities;
    probabilities.reserve(batches.runs.size());
    for (auto const& run : batches.runs) {
        probabilities.push_back(run.result().probability);
    }
    return probabilities;
}

// What is still wanted of replicates; 0: enough, or no more are allowed.
std::int64_t more_wanted(Batches const& batches, Request const& request, SubsetOptions const& options) {
    std::int64_t const done = batches.runs.size();
    auto const mean = mean_of_replicates(probabilities_of(batches));
    bool const ended =
        std::ranges::all_of(batches.runs, [](SubsetRun const& run) { return run.end() == SubsetRun::End::reached; });
    if (!ended || !(mean.mean > 0) || batches.is_plain()) {
        return 0;
    }
    double const cov = mean.standard_error / mean.mean;
    double const factor = std::min(cov * cov / (request.target_cov * request.target_cov), 2.0);
    auto const wanted = static_cast<std::int64_t>(std::ceil(factor * static_cast<double>(done)));
    auto const allowed = std::min(request.replicates * options.most_growth,
                                  done + (request.max_runs - batches.trials) / (batches.trials / done + 1));
    return std::max<std::int64_t>(0, std::min(wanted, allowed) - done);
}

}  // namespace

SubsetResult estimate_subset(Problem const& problem, double factor, Request const& request, Workforce& workers,
                             SubsetOptions const& options, Count const& plain) {
    OVERTURN_EXPECT(options.samples % options.chains == 0 && options.chains < options.samples);
    auto const scouted = scout(problem, factor, request, workers);
    SubsetResult result;
    result.key = {.seed = request.seed, .problem = request.problem, .phase = Phase::subset};
    auto& estimate = result.estimate;
    estimate.factor = factor;
    estimate.method = Method::subset;
    Batches batches;
    bool const leads = scouted.found && scouted.missed <= most_missed;
    for (auto more = leads ? request.replicates : 0; more > 0; more = more_wanted(batches, request, options)) {
        Simulation simulation(problem, factor, request, workers, options, batches.runs.size(), more);
        simulation.run(request.max_runs - batches.trials);
        batches.add(std::move(simulation));
    }
    estimate.runs = scouted.runs + batches.trials;
    for (auto const& run : batches.runs) {
        result.replicates.push_back(run.result());
    }
    estimate.replicates = probabilities_of(batches);
    check_health(estimate, batches, scouted);
    auto doubt = doubt_of(batches, scouted, estimate, options);
    auto const mean = batches.runs.empty() ? ReplicateMean{} : mean_of_replicates(estimate.replicates);
    if (doubt.state == State::trusted && !(mean.standard_error <= largest_cov * mean.mean)) {
        doubt = {State::not_trusted, "replicates disagree"};
    }
    if (doubt.state != State::trusted) {
        auto all = plain;
        all.add(scouted.at_first);
        all.add(batches.plain);
        distrust(estimate, doubt.state, doubt.reason, all);
        return result;
    }
    estimate.state = State::trusted;
    estimate.probability = mean.mean;
    if (batches.is_plain()) {
        estimate.interval_95 = clopper_pearson(batches.plain);
        estimate.cov = std::sqrt((1 - mean.mean) / static_cast<double>(batches.plain.failed));
        estimate.crude_runs = static_cast<double>(batches.plain.trials);
        return result;
    }
    estimate.interval_95 = mean.interval_95;
    estimate.cov = mean.standard_error / mean.mean;
    estimate.crude_runs = crude_runs_for(mean.mean, estimate.cov);
    return result;
}

void normals_of_node(std::vector<SubsetNode> const& nodes, std::int64_t node, DrawKey key, std::span<double> normals) {
    auto const state = ChainStates(key, normals.size()).state_of(nodes, node);
    std::copy(state.begin(), state.end(), normals.begin());
}

}  // namespace overturn::rare
