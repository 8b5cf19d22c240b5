#include "output/failed_trials.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "generators/acceptance.hpp"

namespace overturn::output {
namespace {

constexpr std::size_t most_listed = 20;

std::string reason_name(std::int64_t reason) {
    for (auto const& entry : failures()) {
        if (static_cast<std::int64_t>(entry.value) == reason) {
            return std::string(entry.name);
        }
    }
    return fmt::format("reason {}", reason);
}

// Names of the clauses whose bits are set.
std::vector<std::string> names_of_clauses(std::int64_t bits) {
    std::vector<std::string> names;
    auto const all = clause_names();
    for (std::size_t bit = 0; bit < all.size(); ++bit) {
        if ((static_cast<std::uint64_t>(bits) >> bit & 1U) != 0) {
            names.push_back(all[bit]);
        }
    }
    return names;
}

}  // namespace

void FailedTrials::know(WaveRow const& row) {
    if (row.acceptance_failures != 0) {
        clauses_[row.id] = row.acceptance_failures;
        for (auto const& name : names_of_clauses(row.acceptance_failures)) {
            ++not_met_[name];
        }
    }
}

void FailedTrials::add(std::int64_t number, TrialRow const& row) {
    if (row.verdict != Verdict::failed) {
        return;
    }
    ++count_;
    auto const reason = static_cast<std::int64_t>(row.failure);
    ++reasons_[reason];
    if (lists_more()) {
        first_.push_back(fmt::format("  trial {}: wave {}, {}, {} {}: {}\n", number, row.wave,
                                     spec_.bodies.at(row.body).name, spec_.levels.measure_name(),
                                     spec_.levels.text(row.amplitude), reason_name(reason)));
        if (auto const found = clauses_.find(row.wave); found != clauses_.end()) {
            first_.back().pop_back();
            first_.back() += fmt::format(" ({})\n", fmt::join(names_of_clauses(found->second), ", "));
        }
    }
}

bool FailedTrials::lists_more() const { return first_.size() < most_listed; }

std::string FailedTrials::text() const {
    if (count_ == 0) {
        return {};
    }
    std::string reasons;
    for (auto const& [reason, count] : reasons_) {
        reasons += fmt::format("{}{} {}", reasons.empty() ? "" : ", ", reason_name(reason), count);
    }
    auto text =
        fmt::format("failed trials: {} ({}); left out of P, and counted both ways in its interval\n", count_, reasons);
    for (auto const& [name, waves] : not_met_) {
        text += fmt::format("  not met by {} waves: {}\n", waves, name);
    }
    for (auto const& line : first_) {
        text += line;
    }
    auto const more = count_ - std::ssize(first_);
    return more > 0 ? text + fmt::format("  and {} more: the rows of /trials with verdict failed\n", more) : text;
}

}  // namespace overturn::output
