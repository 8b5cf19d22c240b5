#include "stats/criterion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stats/detail/wave_numbers.hpp"
#include "stats/quantile.hpp"

namespace overturn {

Share share_of(std::int64_t count, std::int64_t of, double confidence, double group_size) {
    return {count, of, clopper_pearson_of_groups(count, count, of, group_size, confidence)};
}

namespace {

// Trials that make up a share, and how many of them each wave gives.
struct ShareOfTrials {
    explicit ShareOfTrials(std::size_t waves) : of_wave(waves) {}

    void add(std::size_t wave, bool counts) {
        ++of_wave[wave];
        count += counts ? 1 : 0;
    }
    // So many trials count as one where all of a wave end alike: the design effect of clusters (Kish 1965).
    [[nodiscard]] Share made(double confidence, double group_size) const {
        std::int64_t all = 0;
        std::int64_t squares = 0;
        for (auto const trials : of_wave) {
            all += trials;
            squares += trials * trials;
        }
        double const effect = all > 0 ? static_cast<double>(squares) / static_cast<double>(all) : 1;
        return share_of(count, all, confidence, effect * group_size);
    }

    std::vector<std::int64_t> of_wave;
    std::int64_t count = 0;
};

}  // namespace

std::optional<RatioQuantiles> ratio_quantiles(std::vector<double> ratios, std::optional<double> independent) {
    if (ratios.empty()) {
        return std::nullopt;
    }
    std::sort(ratios.begin(), ratios.end());
    double const values = independent.value_or(static_cast<double>(ratios.size()));
    auto const at = [&](double share) {
        return values < static_cast<double>(fewest_for_quantile(share)) ? std::numeric_limits<double>::quiet_NaN()
                                                                        : quantile(ratios, share);
    };
    return RatioQuantiles{std::ssize(ratios), ratios.front(), at(0.05),     at(0.25), at(0.5),
                          at(0.75),           at(0.95),       ratios.back()};
}

CriterionStudy study_criterion(std::span<CriterionTrial const> trials, double confidence, double group_size) {
    CriterionStudy study;
    std::vector<double> overturned;
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    struct Wave {
        double lowest_fall = none, highest_stand = none;
        bool predicted_safe = false, safe_fell = false, safe_uplifted = false, uplifted_fell = false;
    };
    auto const numbers = numbers_of_waves(trials);
    std::vector<Wave> waves(numbers.waves);
    ShareOfTrials safe(numbers.waves);
    ShareOfTrials uplifted(numbers.waves);
    ShareOfTrials overturning(numbers.waves);
    ShareOfTrials unsafe(numbers.waves);
    ShareOfTrials standing(numbers.waves);
    for (std::size_t i = 0; i < trials.size(); ++i) {
        auto const& trial = trials[i];
        auto const number = numbers.of_trial[i];
        auto& wave = waves[number];
        study.counts.add(trial.predicted_safe(), trial.overturned);
        (trial.predicted_safe() ? safe : unsafe).add(number, trial.predicted_safe() == trial.overturned);
        (trial.overturned ? overturning : standing).add(number, trial.predicted_safe() == trial.overturned);
        if (trial.predicted_safe()) {
            wave.predicted_safe = true;
            wave.safe_fell = wave.safe_fell || trial.overturned;
            if (trial.uplifted || trial.overturned) {
                uplifted.add(number, trial.overturned);
                wave.safe_uplifted = true;
                wave.uplifted_fell = wave.uplifted_fell || trial.overturned;
            }
        }
        if (trial.overturned) {
            overturned.push_back(trial.ratio);
            wave.lowest_fall = std::fmin(wave.lowest_fall, trial.ratio);
        } else {
            wave.highest_stand = std::fmax(wave.highest_stand, trial.ratio);
        }
    }
    study.safe_but_overturned = safe.made(confidence, group_size);
    study.overturned_predicted_safe = overturning.made(confidence, group_size);
    study.unsafe_but_stood = unsafe.made(confidence, group_size);
    study.stood_predicted_unsafe = standing.made(confidence, group_size);
    study.safe_uplifted_but_overturned = uplifted.made(confidence, group_size);
    auto const by_waves = [&](bool Wave::*predicted, bool Wave::*fell) {
        return share_of(std::ranges::count(waves, true, fell), std::ranges::count(waves, true, predicted), confidence,
                        group_size);
    };
    study.waves_safe_but_overturned = by_waves(&Wave::predicted_safe, &Wave::safe_fell);
    study.waves_safe_uplifted_but_overturned = by_waves(&Wave::safe_uplifted, &Wave::uplifted_fell);
    auto const values = [&](double Wave::*ratio) {
        std::vector<double> list;
        for (auto const& wave : waves) {
            if (!std::isnan(wave.*ratio)) {
                list.push_back(wave.*ratio);
            }
        }
        return list;
    };
    auto const of_waves = [&](double Wave::*ratio) {
        auto list = values(ratio);
        auto const independent = static_cast<double>(list.size()) / group_size;
        return ratio_quantiles(std::move(list), independent);
    };
    study.first_overturning = of_waves(&Wave::lowest_fall);
    study.highest_standing = of_waves(&Wave::highest_stand);
    study.at_overturning =
        ratio_quantiles(std::move(overturned),
                        study.first_overturning ? static_cast<double>(study.first_overturning->count) / group_size : 0);
    return study;
}

}  // namespace overturn
