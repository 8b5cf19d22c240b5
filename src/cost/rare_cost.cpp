#include "cost/rare_cost.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "campaign/rare_problem.hpp"
#include "cost/bench.hpp"
#include "rare/pulse_mixture.hpp"
#include "rare/subset.hpp"

namespace overturn::cost {
namespace {

constexpr std::array<std::int64_t, 3> final_runs{500, 2000, 8000};
constexpr std::array<std::int64_t, 3> level_samples{500, 1000, 2000};
constexpr std::int64_t timed_waves = 2000;  // what a plain wave takes is known well enough

RarePoint point_of(rare::Estimate const& estimate, std::string effort, double seconds) {
    return {.method = estimate.method,
            .effort = std::move(effort),
            .seconds = seconds,
            .waves = estimate.runs,
            .cov = estimate.probability && estimate.cov > 0 ? estimate.cov : not_known,
            .foretold = false,
            .reason = estimate.reason};
}

/// Runs estimators one after the other and keeps the best estimate.
class RareStudy {
  public:
    RareStudy(CampaignSpec const& spec, std::function<void(double)> const& done)
        : problem_(spec, 0),
          request_{
              .seed = spec.seed, .target_cov = 1, .max_runs = spec.rare->max_runs, .replicates = spec.rare->replicates},
          done_(done) {
        auto const& levels = spec.levels.levels;
        cost_.body = spec.bodies.front().name;
        cost_.amplitude = levels[levels.size() / 2].value;
        steps_ = level_samples.size() + (problem_.frame() ? final_runs.size() : 0) + 1;
    }

    RareCost run() {
        for (auto const samples : level_samples) {
            rare::SubsetOptions options;
            options.samples = samples;
            options.chains = samples / 10;
            try_out(fmt::format("{} x {} a level", request_.replicates, samples), [&] {
                return rare::estimate_subset(problem_, cost_.amplitude, request_, worker_, options).estimate;
            });
        }
        for (std::size_t i = 0; problem_.frame() && i < final_runs.size(); ++i) {
            rare::PulseOptions options;
            options.final_runs = final_runs[i];
            options.most_rounds = 1;
            try_out(fmt::format("{} x {} at last", request_.replicates, final_runs[i]), [&] {
                std::array const factors{cost_.amplitude};
                return rare::estimate_pulse_mixture(problem_, factors, cost_.amplitude, request_, worker_, {}, options)
                    .estimates.front();
            });
        }
        foretell_crude();
        return std::move(cost_);
    }

  private:
    template <class Estimator> void try_out(std::string effort, Estimator&& estimator) {
        double const before = thread_cpu_seconds();
        rare::Estimate const made = estimator();
        cost_.points.push_back(point_of(made, std::move(effort), thread_cpu_seconds() - before));
        if (made.probability && (!cost_.probability || made.cov < least_cov_)) {
            cost_.probability = made.probability;
            least_cov_ = made.cov;
        }
        done_(static_cast<double>(cost_.points.size()) / static_cast<double>(steps_));
    }

    // No scatter has to be measured of plain trials: sqrt((1 - P) / (n P)).
    void foretell_crude() {
        auto request = request_;
        request.max_runs = timed_waves;
        std::array const factors{cost_.amplitude};
        double const before = thread_cpu_seconds();
        auto const made = rare::estimate_crude(problem_, factors, request, worker_).front();
        double const each = (thread_cpu_seconds() - before) / static_cast<double>(made.runs);
        if (auto const p = cost_.probability ? cost_.probability : made.probability) {
            cost_.probability = p;
            for (double const cov : {0.5, 0.2, 0.1, 0.05}) {
                double const waves = std::ceil(rare::crude_runs_for(*p, cov));
                cost_.points.push_back({.method = rare::Method::crude,
                                        .effort = "by the binomial law",
                                        .seconds = each * waves,
                                        .waves = static_cast<std::int64_t>(waves),
                                        .cov = cov,
                                        .foretold = true,
                                        .reason = {}});
            }
        } else {
            cost_.points.push_back(point_of(made, "plain trials", each * static_cast<double>(made.runs)));
        }
        done_(1);
    }

    RareProblem problem_;
    rare::Request request_;
    rare::LoneWorker worker_;
    std::function<void(double)> const& done_;
    RareCost cost_;
    std::size_t steps_ = 1;
    double least_cov_ = 0;
};

}  // namespace

RareCost study_rare(CampaignSpec const& spec, std::function<void(double)> const& done) {
    return RareStudy(spec, done).run();
}

}  // namespace overturn::cost
