#include "results/rare_rows.hpp"

namespace overturn {
namespace {

void put_key(RareRow& row, rare::DrawKey const& key) {
    row.problem = key.problem;
    row.replicate = key.replicate;
    row.phase = static_cast<std::int64_t>(key.phase);
}

void add_mixture(std::vector<RareRow>& rows, rare::PulseResult const& result, std::int64_t run) {
    for (auto const& stages : result.stages) {
        for (std::size_t s = 0; s < stages.size(); ++s) {
            for (std::size_t i = 0; i < stages[s].rows.size(); ++i) {
                auto const& from = stages[s].rows[i];
                RareRow row{.method = static_cast<std::int64_t>(rare::Method::pulse_mixture), .run = run};
                put_key(row, stages[s].key);
                row.stage = s;
                row.index = i;
                row.weight = from.weight;
                row.failed = from.failed;
                row.undecided = from.undecided;
                row.plain = from.plain;
                rows.push_back(row);
            }
        }
    }
}

void add_subset(std::vector<RareRow>& rows, rare::SubsetResult const& result, std::int64_t run) {
    for (std::size_t r = 0; r < result.replicates.size(); ++r) {
        std::int64_t const first = rows.size();
        for (auto const& node : result.replicates[r].nodes) {
            RareRow row{.method = static_cast<std::int64_t>(rare::Method::subset), .run = run};
            put_key(row, result.key);
            row.replicate = r;
            row.stage = node.level;
            row.step = node.step;
            row.index = node.index;
            row.parent = node.parent < 0 ? -1 : first + node.parent;
            row.step_size = node.parent < 0 ? never : node.step_size;
            row.driver = node.driver;
            row.failed = node.failed;
            row.plain = node.parent < 0 ? 1 : 0;
            rows.push_back(row);
        }
    }
}

}  // namespace

std::vector<RareRow> rare_rows(RareBody const& body) {
    std::vector<RareRow> rows;
    for (std::size_t m = 0; m < body.record.mixtures.size(); ++m) {
        add_mixture(rows, body.record.mixtures[m], m);
    }
    for (std::size_t s = 0; s < body.record.subsets.size(); ++s) {
        add_subset(rows, body.record.subsets[s], s);
    }
    return rows;
}

std::vector<std::string> rare_method_names() {
    using enum rare::Method;
    return {name_of(crude), name_of(subset), name_of(pulse_mixture)};
}

std::vector<std::string> rare_state_names() {
    using enum rare::State;
    return {name_of(trusted), name_of(not_trusted), name_of(not_resolved)};
}

template <> Fields const& fields_of<RareRow>() {
    using R = RareRow;
    static Fields const fields{
        category<&R::method>("method", "estimator that drew it", numbered(rare_method_names())),
        field<&R::run>("run", "1", "which of the estimator's runs: groups mixture-N and subset-N"),
        field<&R::problem>("problem", "1", "random stream: number of the limit state"),
        field<&R::replicate>("replicate", "1", "independent repetition"),
        field<&R::phase>("phase", "1", "random stream: 3 pilot, 4 final, 5 subset"),
        field<&R::stage>("stage", "1", "stage of the pilot runs, or level of the subset simulation"),
        field<&R::step>("step", "1", "of a Markov chain within the level"),
        field<&R::index>("index", "1", "of the trial within its stage, or of the chain"),
        field<&R::parent>("parent", "1", "row of this table from which the chain came; -1: independent draw"),
        field<&R::weight>("weight", "1", "weight: density of a plain draw over that of the mixture of this stage"),
        field<&R::step_size>("step_size", "1", "s of x' = sqrt(1 - s^2) x + s draw; NaN: independent draw"),
        field<&R::driver>(
            "driver", "1",
            "driver of the subset simulation: distance to overturning, negative at rest; NaN: not stored"),
        field<&R::failed>("failed", "1", "overturned: one bit for each factor of the stage"),
        field<&R::undecided>("undecided", "1", "further trials without a verdict"),
        field<&R::plain>("plain", "1", "1: without a change to the drawn wave")};
    return fields;
}

}  // namespace overturn
