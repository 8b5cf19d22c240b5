#include "cost/sampling.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/texts_of.hpp"
#include "results/statistics.hpp"
#include "stats/proportion.hpp"

namespace overturn::cost {
namespace {

template <class Value> double mean_over_stripes(Statistics const& statistics, Value&& value) {
    double sum = 0;
    double count = 0;
    for (auto const& body : statistics.bodies()) {
        for (auto const& stripe : body.stripes) {
            if (stripe.trials > 0) {
                sum += value(stripe);
                count += 1;
            }
        }
    }
    return count > 0 ? sum / count : 0;
}

double width_of(Interval const& interval) { return interval.upper - interval.lower; }

// Undecided trials are left out: what they hide is no matter of chance.
double width_at(Stripe const& stripe, double share, double confidence) {
    auto const scaled = [&](std::int64_t count) {
        return static_cast<std::int64_t>(std::llround(share * static_cast<double>(count)));
    };
    auto const decided = scaled(stripe.decided());
    auto const overturned = std::min(scaled(stripe.overturned), decided);
    return width_of(clopper_pearson_of_groups(overturned, overturned, decided, stripe.group_size, confidence));
}

}  // namespace

Sampling study_sampling(CampaignSpec const& spec, Plan const& plan, std::vector<std::int64_t> const& numbers) {
    Sampling sampling;
    std::int64_t const most = numbers.size();
    std::vector<std::int64_t> sizes;
    constexpr std::int64_t halvings = 6;
    for (std::int64_t size = most; size > 0 && std::ssize(sizes) < halvings; size /= 2) {
        sizes.insert(sizes.begin(), size);
    }
    for (auto const size : sizes) {
        Statistics statistics(spec);
        PhaseSeconds ignored;
        std::vector<PreparedWave> waves;
        auto const begin = thread_cpu_seconds();
        for (auto const place : spread_over(size, most)) {
            waves.push_back(prepare_wave(spec, plan, numbers[place], ignored));
        }
        auto const rows = run_trials(spec, plan, waves).rows;
        double const seconds = thread_cpu_seconds() - begin;
        for (auto const& row : rows) {
            statistics.add(row);
        }
        sampling.subsets.push_back(
            {size, seconds,
             mean_over_stripes(statistics, [&](Stripe const& stripe) { return width_at(stripe, 1, spec.confidence); }),
             0});
        if (size == most) {
            sampling.stripes = plan.bodies() * std::ssize(spec.levels.levels);
            sampling.probability = mean_over_stripes(
                statistics, [](Stripe const& stripe) { return stripe.decided() > 0 ? stripe.probability() : 0; });
            sampling.half_width = mean_over_stripes(statistics, [&](Stripe const& stripe) {
                return width_at(stripe, static_cast<double>(spec.wave_count) / static_cast<double>(stripe.trials),
                                spec.confidence)
                       / 2;
            });
            sampling.seconds = seconds / static_cast<double>(size) * static_cast<double>(plan.waves());
        }
    }
    for (auto& point : sampling.subsets) {
        point.root_n_width =
            sampling.subsets.back().width * std::sqrt(static_cast<double>(most) / static_cast<double>(point.waves));
    }
    if (spec.is_grid()) {  // no sample: what it takes is known, what it is worth is nothing
        for (auto& point : sampling.subsets) {
            point.width = point.root_n_width = not_known;
        }
        sampling.probability = sampling.half_width = not_known;
    }
    return sampling;
}

Balance balance_of(Comparison const& defaults, double half_width, double confidence) {
    Balance balance;
    balance.sampling = half_width;
    balance.is_bound = defaults.overturning_flips == 0;
    if (defaults.trials == 0) {
        balance.numerical = 1;
    } else {
        balance.numerical =
            balance.is_bound ? clopper_pearson(0, defaults.trials, confidence).upper
                             : static_cast<double>(defaults.overturning_flips) / static_cast<double>(defaults.trials);
    }
    bool const smaller = balance.numerical < balance.sampling;
    balance.factor = smaller ? balance.sampling / balance.numerical : balance.numerical / balance.sampling;
    balance.dominates = smaller ? Dominates::sampling : balance.is_bound ? Dominates::unknown : Dominates::numerical;
    return balance;
}

std::string sentence_of(Balance const& balance, Comparison const& defaults, CampaignSpec const& spec,
                        std::int64_t stripes) {
    auto const differ =
        fmt::format("{} of {} verdicts differ from the reference", defaults.overturning_flips, defaults.trials);
    auto const numerical = fmt::format("numerical error of P(overturn) is {}{:.2g} ({})",
                                       balance.is_bound ? "at most " : "", balance.numerical, differ);
    if (spec.is_grid()) {
        return fmt::format("The {}. A grid of {} is no sample, so no P(overturn) is estimated.", numerical,
                           count_text(spec.wave_count, "frequency", "frequencies"));
    }
    auto const sampling = fmt::format("sampling error +-{:.2g} ({:g} %, {} waves, mean of {} stripes)",
                                      balance.sampling, 100 * spec.confidence, spec.wave_count, stripes);
    switch (balance.dominates) {
        case Dominates::sampling:
            return fmt::format(
                "The accuracy of the settings suffices: {}, {}{:.2g} times below the {}. More waves make P "
                "more accurate, finer steps do not.",
                numerical, balance.is_bound ? "at least " : "", balance.factor, sampling);
        case Dominates::numerical:
            return fmt::format(
                "The accuracy of the settings does not suffice: {}, {:.2g} times the {}. Finer steps make P "
                "more accurate, more waves do not.",
                numerical, balance.factor, sampling);
        case Dominates::unknown:
            break;
    }
    return fmt::format("Not decided: {}, which is not below the {}. Use a larger sample (--waves).", numerical,
                       sampling);
}

}  // namespace overturn::cost
