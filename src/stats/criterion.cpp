#include "stats/criterion.hpp"

#include <algorithm>
#include <map>

#include "stats/quantile.hpp"

namespace overturn {

Share share_of(std::int64_t count, std::int64_t of, double confidence, std::int64_t alike) {
    return {count, of, clopper_pearson_of_groups(count, count, of, alike, confidence)};
}

std::optional<RatioQuantiles> ratio_quantiles(std::vector<double> ratios) {
    if (ratios.empty()) {
        return std::nullopt;
    }
    std::sort(ratios.begin(), ratios.end());
    return RatioQuantiles{std::ssize(ratios),    ratios.front(),         quantile(ratios, 0.05), quantile(ratios, 0.25),
                          quantile(ratios, 0.5), quantile(ratios, 0.75), quantile(ratios, 0.95), ratios.back()};
}

CriterionStudy study_criterion(std::span<CriterionTrial const> trials, double confidence, std::int64_t alike) {
    CriterionStudy study;
    std::vector<double> overturned;
    std::map<std::int64_t, double> first, highest;
    std::map<std::int64_t, bool> safe_wave_fell, uplifted_wave_fell;
    std::int64_t uplifted = 0;
    for (auto const& trial : trials) {
        study.counts.add(trial.said_safe(), trial.overturned);
        if (trial.said_safe()) {
            safe_wave_fell[trial.wave] |= trial.overturned;
            if (trial.uplifted || trial.overturned) {
                ++uplifted;
                uplifted_wave_fell[trial.wave] |= trial.overturned;
            }
        }
        if (trial.overturned) {
            overturned.push_back(trial.ratio);
            auto& lowest = first.emplace(trial.wave, trial.ratio).first->second;
            lowest = std::min(lowest, trial.ratio);
        } else {
            auto& most = highest.emplace(trial.wave, trial.ratio).first->second;
            most = std::max(most, trial.ratio);
        }
    }
    auto const& c = study.counts;
    study.safe_but_overturned = share_of(c.false_safe, c.false_safe + c.true_safe, confidence, alike);
    study.overturned_said_safe = share_of(c.false_safe, c.false_safe + c.true_overturn, confidence, alike);
    study.unsafe_but_stood = share_of(c.false_alarm, c.false_alarm + c.true_overturn, confidence, alike);
    study.stood_said_unsafe = share_of(c.false_alarm, c.false_alarm + c.true_safe, confidence, alike);
    study.safe_uplifted_but_overturned = share_of(c.false_safe, uplifted, confidence, alike);
    auto const by_waves = [&](std::map<std::int64_t, bool> const& waves) {
        auto const fell = std::count_if(waves.begin(), waves.end(), [](auto const& w) { return w.second; });
        return share_of(fell, waves.size(), confidence, alike);
    };
    study.waves_safe_but_overturned = by_waves(safe_wave_fell);
    study.waves_safe_uplifted_but_overturned = by_waves(uplifted_wave_fell);
    auto const values = [](std::map<std::int64_t, double> const& of_waves) {
        std::vector<double> list;
        list.reserve(of_waves.size());
        for (auto const& [wave, ratio] : of_waves) {
            list.push_back(ratio);
        }
        return list;
    };
    study.at_overturning = ratio_quantiles(std::move(overturned));
    study.first_overturning = ratio_quantiles(values(first));
    study.highest_standing = ratio_quantiles(values(highest));
    return study;
}

}  // namespace overturn
