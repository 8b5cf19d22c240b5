#include "rare/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include "core/error.hpp"
#include "stats/proportion.hpp"

namespace overturn::rare {
namespace {

constexpr double tail = 0.025;  // on either side of 95 %

}  // namespace

std::string name_of(Method method) {
    switch (method) {
        case Method::crude:
            return "crude";
        case Method::subset:
            return "subset";
        case Method::pulse_mixture:
            return "pulse-mixture";
    }
    return "";
}

std::string name_of(State state) {
    switch (state) {
        case State::trusted:
            return "trusted";
        case State::not_trusted:
            return "not-trusted";
        case State::not_resolved:
            return "not-resolved";
    }
    return "";
}

Interval clopper_pearson(Count const& count) {
    OVERTURN_EXPECT(count.failed >= 0 && count.failed + count.undecided <= count.trials);
    constexpr double confidence = 1 - 2 * tail;
    return {overturn::clopper_pearson(count.failed, count.trials, confidence).lower,
            overturn::clopper_pearson(count.failed + count.undecided, count.trials, confidence).upper};
}

ReplicateMean mean_of_replicates(std::span<double const> replicates) {
    OVERTURN_EXPECT(replicates.size() >= 2);
    auto const n = static_cast<double>(replicates.size());
    ReplicateMean result;
    for (double const p : replicates) {
        result.mean += p / n;
    }
    double squares = 0;
    for (double const p : replicates) {
        squares += (p - result.mean) * (p - result.mean);
    }
    result.standard_error = std::sqrt(squares / (n - 1) / n);
    if (result.mean > 0) {
        double const t = gsl_cdf_tdist_Pinv(1 - tail, n - 1);
        double const factor = std::exp(t * result.standard_error / result.mean);
        result.interval_95 = {result.mean / factor, std::min(1.0, result.mean * factor)};
    }
    return result;
}

double crude_runs_for(double probability, double cov) { return (1 - probability) / (probability * cov * cov); }

void distrust(Estimate& estimate, State state, std::string reason, Count const& plain) {
    OVERTURN_EXPECT(state != State::trusted && !reason.empty());
    estimate.state = state;
    estimate.reason = std::move(reason);
    estimate.probability.reset();
    estimate.interval_95 = {0, plain.trials > 0 ? clopper_pearson(plain).upper : 1.0};
    estimate.cov = 0;
    estimate.crude_runs = 0;
}

std::string words_of(std::span<HealthCheck const> failed) {
    std::string words;
    for (auto const& check : failed) {
        if (!check.passed) {
            words += fmt::format("{}{} {:.3g} (limit {:.3g})", words.empty() ? "" : ", ", check.name, check.value,
                                 check.limit);
        }
    }
    return words;
}

}  // namespace overturn::rare
