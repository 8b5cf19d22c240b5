#include "runner/detail/rare_run.hpp"

#include <utility>

#include <fmt/format.h>

#include "campaign/rare_problem.hpp"
#include "core/print_note.hpp"
#include "runner/detail/rank_workforce.hpp"

namespace overturn {

std::optional<std::vector<RareBody>> run_rare(CampaignSpec const& spec, store::ShardFolder const& shards,
                                              StopPolicy& stop_policy, parallel::Communicator const& comm) {
    std::vector<double> factors;
    for (auto const& level : spec.levels.levels) {
        factors.push_back(level.value);
    }
    RankWorkforce workers(shards, stop_policy, comm);
    std::vector<RareBody> bodies;
    try {
        auto const count = spec.bodies.size();
        for (std::size_t p = 0; p < count * spec.limits.size(); ++p) {
            auto const [b, limit] = std::pair(p % count, p / count);
            if (comm.is_root()) {
                print_note("rare events of {}{}\n", spec.bodies[b].name,
                           limit == 0 ? "" : ", " + spec.limits[limit].name);
            }
            RareProblem const problem(spec, b, limit);
            workers.set_name(limit == 0 ? fmt::format("body-{}/", b) : fmt::format("body-{}-limit-{}/", b, limit));
            rare::Request const request{.seed = spec.seed,
                                        .problem = p,
                                        .target_cov = spec.rare->target_cov,
                                        .max_runs = spec.rare->max_runs,
                                        .replicates = spec.rare->replicates};
            RareBody body{.body = b, .limit = limit, .estimates = {}, .record = {}};
            body.estimates = rare::estimate(problem, factors, spec.rare->method, request, workers, &body.record);
            bodies.push_back(std::move(body));
        }
    } catch (RareStopped const&) {
        return std::nullopt;
    }
    return bodies;
}

}  // namespace overturn
