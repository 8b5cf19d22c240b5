#include "results/achieved_sigma.hpp"

#include <cmath>

#include "results/detail/fitted_measures.hpp"

namespace overturn {

SigmaCount::SigmaCount(CampaignSpec const& spec) : of_events_(spec.source->about().draws_events) {
    auto const sigma = spec.source->about().stated_sigma;
    if (!sigma) {
        return;
    }
    auto const take = [&](Measure measure, double period_s) {
        bool const matched = sigma->matched.from_s <= period_s && period_s <= sigma->matched.to_s;
        sums_.emplace_back();
        sums_.back().of = {name_of(measure, spec), label_of(measure, spec), period_s,
                           matched ? std::optional(sigma->at(period_s)) : std::nullopt};
    };
    take(measure_named("pga"), sigma->matched.from_s);
    for (std::size_t i = 0; i < spec.measures.sa_periods_s.size(); ++i) {
        take(sa_measure(i), spec.measures.sa_periods_s[i]);
    }
}

void SigmaCount::add(WaveRow const& row) {
    if (sums_.empty() || row.failed != 0) {
        return;
    }
    auto const one = of_events_ ? row.event : row.target;
    if (in_group_ > 0 && one != last_) {
        close_group();
    }
    last_ = one;
    ++waves_;
    ++in_group_;
    sums_[0].group.add(std::log(row.pga_mps2), in_group_);
    for (std::size_t i = 1; i < sums_.size(); ++i) {
        sums_[i].group.add(std::log(row.sa_mps2[i - 1]), in_group_);
    }
}

void SigmaCount::Moments::add(double value, std::int64_t count) {
    double const deviation = value - mean;
    mean += deviation / static_cast<double>(count);
    squares += deviation * (value - mean);
}

void SigmaCount::close_group() {
    ++independent_;
    in_group_ = 0;
    for (auto& sum : sums_) {
        sum.within += sum.group.squares;
        sum.means.add(sum.group.mean, independent_);
        sum.group = {};
    }
}

std::optional<AchievedSigma> SigmaCount::achieved(std::int64_t missed) const {
    auto whole = *this;
    if (in_group_ > 0) {
        whole.close_group();
    }
    return sums_.empty() || whole.independent_ < 2 ? std::nullopt : std::optional(whole.of_whole_groups(missed));
}

AchievedSigma SigmaCount::of_whole_groups(std::int64_t missed) const {
    auto const waves = static_cast<double>(waves_);
    auto const groups = static_cast<double>(independent_);
    AchievedSigma all{waves_, independent_, of_events_, missed, {}};
    for (auto const& sum : sums_) {
        all.measures.push_back(sum.of);
        auto& measure = all.measures.back();
        double const within = waves_ > independent_ ? sum.within / (waves - groups) : 0;
        measure.achieved = std::sqrt(sum.means.squares / (groups - 1) + within * (1 - groups / waves));
        measure.error = measure.achieved / std::sqrt(2 * (groups - 1));
    }
    return all;
}

}  // namespace overturn
