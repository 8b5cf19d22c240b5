#include "cost/comparison.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "response/registry.hpp"
#include "stats/kolmogorov.hpp"

namespace overturn::cost {
namespace {

enum class Fate { stood, overturned, undecided };

Fate fate_of(TrialRow const& row) {
    auto const& end = entry_of(row.verdict);
    return end.fell ? Fate::overturned : end.decided ? Fate::stood : Fate::undecided;
}

bool failed(TrialRow const& row) { return row.verdict == Verdict::failed; }
bool rocked(TrialRow const& row) { return row.verdict == Verdict::rocked || row.verdict == Verdict::slid_and_rocked; }

double overturned_share(std::span<TrialRow const> rows) {
    std::int64_t decided = 0;
    std::int64_t overturned = 0;
    for (auto const& row : rows) {
        decided += fate_of(row) == Fate::undecided ? 0 : 1;
        overturned += fate_of(row) == Fate::overturned ? 1 : 0;
    }
    return decided > 0 ? static_cast<double>(overturned) / static_cast<double>(decided) : not_known;
}

std::vector<double> peaks_of(std::span<TrialRow const> rows) {
    std::vector<double> peaks;
    peaks.reserve(rows.size());
    for (auto const& row : rows) {
        if (!failed(row)) {
            peaks.push_back(row.peak_rotation_ratio);
        }
    }
    return peaks;
}

}  // namespace

Spread spread_of(std::vector<double> values) {
    if (values.empty()) {
        return {};
    }
    std::sort(values.begin(), values.end());
    auto const at = [&](double share) {
        auto const rank = std::ceil(share * static_cast<double>(values.size()));
        return values[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
    };
    constexpr double half = 0.5;
    constexpr double most = 0.95;
    return {std::ssize(values), at(half), at(most), values.back()};
}

Comparison compare(std::span<TrialRow const> rows, std::span<TrialRow const> reference) {
    OVERTURN_EXPECT(rows.size() == reference.size());
    Comparison result;
    std::vector<double> errors;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        auto const& row = rows[i];
        auto const& exact = reference[i];
        if (failed(row) && failed(exact)) {
            continue;
        }
        ++result.trials;
        result.flips += row.verdict != exact.verdict ? 1 : 0;
        result.overturning_flips += fate_of(row) != fate_of(exact) ? 1 : 0;
        if (rocked(row) && rocked(exact) && exact.peak_rotation_rad > 0) {
            errors.push_back(std::abs(row.peak_rotation_rad / exact.peak_rotation_rad - 1));
        }
    }
    result.peak = spread_of(std::move(errors));
    result.probability = overturned_share(rows);
    result.probability_error = result.probability - overturned_share(reference);
    result.ks = ks_distance(peaks_of(rows), peaks_of(reference));
    return result;
}

}  // namespace overturn::cost
