#include "results/achieved_sigma.hpp"

#include <cmath>

#include <fmt/format.h>

#include "results/detail/fitted_measures.hpp"

namespace overturn {

SigmaCount::SigmaCount(CampaignSpec const& spec) : of_events_(spec.source->draws_events()) {
    auto const sigma = spec.source->stated_sigma();
    if (!sigma) {
        return;
    }
    auto const take = [&](FragilityMeasure measure, double period_s) {
        bool const matched = sigma->matched.from_s <= period_s && period_s <= sigma->matched.to_s;
        sums_.push_back({{name_of(measure, spec), label_of(measure, spec), period_s,
                          matched ? std::optional(sigma->at(period_s)) : std::nullopt}});
    };
    take(FragilityMeasure::pga, sigma->matched.from_s);
    for (std::size_t i = 0; i < spec.measures.sa_periods_s.size(); ++i) {
        take(sa_measure(i), spec.measures.sa_periods_s[i]);
    }
}

void SigmaCount::add(WaveRow const& row) {
    if (sums_.empty() || row.failed != 0) {
        return;
    }
    ++waves_;
    auto const one = of_events_ ? row.event : row.target;
    if (waves_ == 1 || one != last_) {
        ++independent_;
        last_ = one;
    }
    add(0, row.pga_mps2);
    for (std::size_t i = 1; i < sums_.size(); ++i) {
        add(i, row.sa_mps2[i - 1]);
    }
}

void SigmaCount::add(std::size_t place, double value) {
    auto& sum = sums_[place];
    double const deviation = std::log(value) - sum.mean;
    sum.mean += deviation / static_cast<double>(waves_);
    sum.squares += deviation * (std::log(value) - sum.mean);
}

std::optional<AchievedSigma> SigmaCount::achieved(std::int64_t missed) const {
    if (sums_.empty() || independent_ < 2) {
        return std::nullopt;
    }
    AchievedSigma all{waves_, independent_, of_events_, missed, {}};
    for (auto const& sum : sums_) {
        all.measures.push_back(sum.of);
        auto& measure = all.measures.back();
        measure.achieved = std::sqrt(sum.squares / static_cast<double>(waves_ - 1));
        measure.error = measure.achieved / std::sqrt(2 * static_cast<double>(independent_ - 1));
    }
    return all;
}

std::string AchievedSigma::text() const {
    auto line =
        fmt::format("achieved sd of ln (stated of Sa), over {} {}:", independent, of_events ? "events" : "targets");
    for (auto const& m : measures) {
        bool const pga = &m == &measures.front();
        line += fmt::format("{} {} {:.3f} +- {:.3f} ({}{})", pga ? "" : ",", m.label, m.achieved, m.error,
                            m.stated ? fmt::format("{:.3g}", *m.stated) : "not matched there",
                            pga ? fmt::format(" at {:.2g} s, the shortest matched", m.period_s) : "");
    }
    return line + fmt::format("; {} of {} waves missed match_tolerance", missed, waves);
}

}  // namespace overturn
