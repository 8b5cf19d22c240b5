#include "rare/detail/subset_run.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"

namespace overturn::rare {
namespace {

// The C library's may differ between machines, and the step decides what is drawn: the series, |x| < 1.
double small_exponential(double x) {
    double sum = 1;
    constexpr int terms = 18;
    for (int k = terms; k > 0; --k) {
        sum = 1 + sum * x / k;
    }
    return sum;
}

}  // namespace

void SubsetRun::plain(std::int64_t index, std::span<double> normals) {
    auto const state = states_.root({.index = index});
    std::copy(state.begin(), state.end(), normals.begin());
}

void SubsetRun::begin(std::span<AnswerRow const> rows) {
    OVERTURN_EXPECT(std::ssize(rows) == options_.samples);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        samples_.push_back(result_.nodes.size());
        result_.nodes.push_back(
            {.index = static_cast<std::int64_t>(i), .driver = rows[i].driver, .failed = rows[i].failed});
        undecided_ += rows[i].undecided;
    }
}

void SubsetRun::close_level() {
    auto const failed = std::count_if(samples_.begin(), samples_.end(), [&](auto n) { return node(n).failed != 0; });
    auto const n_c = options_.chains;
    if (failed >= n_c) {
        double const p0 = static_cast<double>(n_c) / static_cast<double>(options_.samples);
        result_.probability = std::pow(p0, static_cast<double>(result_.levels)) * static_cast<double>(failed)
                              / static_cast<double>(options_.samples);
        end_ = End::reached;
        return;
    }
    std::stable_sort(samples_.begin(), samples_.end(), [&](auto a, auto b) {
        return std::pair(node(a).failed, node(a).driver) > std::pair(node(b).failed, node(b).driver);
    });
    auto const in = samples_[n_c - 1];
    auto const out = samples_[n_c];
    // A chain that stood still has one state twice; two states that answer the same are a plateau.
    if (in != out && node(in).driver == node(out).driver) {
        end_ = End::plateau;
        return;
    }
    if (result_.levels == options_.most_levels) {
        end_ = End::too_deep;
        return;
    }
    result_.thresholds.push_back(0.5 * (node(in).driver + node(out).driver));
    ++result_.levels;
    chains_.assign(samples_.begin(), samples_.begin() + n_c);
    samples_ = chains_;
    states_.keep_only(chains_);
    proposals_.assign(chains_.size(), {});
    step_ = accepted_ = 0;
}

SubsetNode SubsetRun::next_node(std::int64_t chain) const {
    return {
        .parent = chains_[chain], .level = result_.levels, .step = step_ + 1, .index = chain, .step_size = step_size_};
}

void SubsetRun::propose(std::int64_t chain, std::span<double> normals) {
    auto const at = chains_[chain];
    auto& proposal = proposals_[chain];
    proposal = states_.moved(states_.state_of(result_.nodes, at), next_node(chain));
    std::copy(proposal.begin(), proposal.end(), normals.begin());
}

void SubsetRun::step(std::span<AnswerRow const> rows) {
    OVERTURN_EXPECT(rows.size() == chains_.size() && !level_is_full());
    std::int64_t accepted = 0;
    for (std::size_t c = 0; c < rows.size(); ++c) {
        undecided_ += rows[c].undecided;
        if (rows[c].failed != 0 || rows[c].driver >= result_.thresholds.back()) {
            auto made = next_node(c);
            made.driver = rows[c].driver;
            made.failed = rows[c].failed;
            chains_[c] = result_.nodes.size();
            result_.nodes.push_back(made);
            if (!proposals_[c].empty()) {
                states_.keep(chains_[c], std::move(proposals_[c]));
            }
            ++accepted;
        }
        proposals_[c].clear();
        samples_.push_back(chains_[c]);
    }
    ++step_;
    accepted_ += accepted;
    auto const n = static_cast<double>(rows.size());
    constexpr double smallest = 0.02;
    double const change =
        (static_cast<double>(accepted) / n - options_.wanted_acceptance) / std::sqrt(static_cast<double>(step_));
    step_size_ = std::clamp(step_size_ * small_exponential(change), smallest, 1.0);
    if (level_is_full()) {
        result_.acceptance.push_back(static_cast<double>(accepted_) / (n * static_cast<double>(step_)));
    }
}

}  // namespace overturn::rare
