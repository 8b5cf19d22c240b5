#include "results/measured_trials.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "core/bytes.hpp"
#include "core/error.hpp"
#include "response/registry.hpp"

namespace overturn {
namespace {

// On points a body also rotates by as much as its pad yields; its verdict leaves that out.
bool left_ground(TrialRow const& row) {
    auto const mask = static_cast<EffectMask>(row.effects);
    if (has(mask, Effect::contact) || has(mask, Effect::spatial)) {
        return row.verdict == Verdict::rocked || row.verdict == Verdict::slid_and_rocked;
    }
    return row.peak_rotation_ratio > 0;
}

}  // namespace

MeasuredTrials::MeasuredTrials(std::vector<Measure> measures, SharedDraws shared) : shared_(std::move(shared)) {
    std::ranges::partition_copy(measures, std::back_inserter(linear_), std::back_inserter(others_), is_linear);
}

void MeasuredTrials::add(WaveRow const& row, std::span<MeasureRow const> measures) {
    if (trials_.size() >= most_trials_held) {
        return;
    }
    std::vector<double> values;
    values.reserve(measures.size() * linear_.size());
    for (auto const& of_body : measures) {
        for (auto const* const measure : linear_) {
            values.push_back(unscaled(measure, row, of_body));
        }
    }
    waves_.insert_or_assign(row.id, std::move(values));
}

void MeasuredTrials::add(TrialRow const& row, LimitOutcomes const& limits) {
    bool const same = !trials_.empty() && row.wave == trials_.back().wave();
    bool const full = trials_.size() >= most_trials_held && !same;
    if (full) {
        ++passed_by_;
        return;
    }
    auto const wave = same ? waves_.end() : waves_.find(row.wave);
    if (!same && wave == waves_.end()) {
        return;
    }
    auto const& verdict = entry_of(row.verdict);
    Measured trial{};
    trial.of_wave = same ? trials_.back().of_wave : &*wave;
    trial.body = static_cast<std::int16_t>(row.body);
    trial.decided = verdict.decided;
    trial.limits = limits;
    trial.moved = verdict.moved;
    trial.slipped = row.peak_slip_m > 0;
    trial.uplifted = verdict.fell || left_ground(row);
    auto const missed = static_cast<EffectMask>(row.required) & ~static_cast<EffectMask>(row.effects);
    trial.peak_slip_m = verdict.decided && !has(missed, Effect::sliding) ? row.peak_slip_m : never;
    trial.peak_rotation_ratio = verdict.decided ? row.peak_rotation_ratio : never;
    if (verdict.fell) {
        trial.peak_rotation_ratio = trial.peak_slip_m = std::numeric_limits<double>::infinity();
    }
    trial.amplitude = row.amplitude;
    trial.scale = row.scale;
    trial.v_wes_mps = row.v_wes_mps;
    trial.v_ereq_mps = row.v_ereq_mps;
    trial.v_resp_mps = row.response_velocity_mps;
    trials_.push_back(trial);
    for (auto const* const measure : others_) {
        values_.push_back(of_trial(measure, row));
    }
}

// Trials of a wave lie together.
void MeasuredTrials::give(std::function<bool(std::int64_t)> const& wants,
                          std::function<void(std::string)> const& piece) const {
    constexpr std::size_t enough = 1 << 22;
    BytesOut out;
    for (std::size_t first = 0; first < trials_.size();) {
        if (out.size() == 0) {
            out(passed_by_);
        }
        auto const& wave = *trials_[first].of_wave;
        std::vector<Measured> trials;
        std::vector<double> others;
        auto last = first;
        for (; last < trials_.size() && trials_[last].of_wave == &wave; ++last) {
            if (wants(trials_[last].body)) {
                trials.push_back(trials_[last]);
                auto const begin = values_.begin() + static_cast<std::int64_t>(last * others_.size());
                others.insert(others.end(), begin, begin + std::ssize(others_));
            }
        }
        if (!trials.empty()) {
            out(wave.first, wave.second, trials, others);
        }
        first = last;
        if (out.size() >= enough || first == trials_.size()) {
            piece(out.take());
        }
    }
}

void MeasuredTrials::take(std::string_view piece) {
    BytesIn in(piece);
    std::int64_t passed_by = 0;
    in(passed_by);
    passed_by_ = std::max(passed_by_, passed_by);  // each piece states that of all
    while (!in.at_end()) {
        std::int64_t id = 0;
        std::vector<double> linear;
        std::vector<Measured> trials;
        std::vector<double> others;
        in(id, linear, trials, others);
        if (trials_.size() >= most_trials_held) {
            passed_by_ += std::ssize(trials);
            continue;
        }
        auto const& wave = *waves_.insert_or_assign(id, std::move(linear)).first;
        for (auto& trial : trials) {
            trial.of_wave = &wave;
            trials_.push_back(trial);
        }
        values_.insert(values_.end(), others.begin(), others.end());
    }
}

double MeasuredTrials::bytes_of(std::int64_t trials, std::span<Measure const> measures) {
    auto const others = measures.size() - static_cast<std::size_t>(std::ranges::count_if(measures, is_linear));
    return static_cast<double>(trials) * static_cast<double>(sizeof(Measured) + others * sizeof(double));
}

MeasuredTrials::Place MeasuredTrials::place_of(Measure measure) const {
    auto const& among = is_linear(measure) ? linear_ : others_;
    auto const found = std::ranges::find(among, measure);
    OVERTURN_EXPECT(found != among.end());
    return {is_linear(measure), static_cast<std::size_t>(found - among.begin())};
}

double MeasuredTrials::value(std::size_t trial, Place place) const {
    auto const& of = trials_[trial];
    auto const first = of.body * linear_.size();
    return place.linear ? of.scale * of.of_wave->second[first + place.at] : values_[trial * others_.size() + place.at];
}

std::vector<SingleTrial> MeasuredTrials::singles(std::int64_t body, Measure measure, std::size_t limit) const {
    std::vector<SingleTrial> singles;
    singles.reserve(trials_.size());
    each_of(body, [&, at = place_of(measure)](std::size_t t, Measured const& trial) {
        if (double const x = value(t, at); trial.limits.is_decided(limit) && x > 0) {
            singles.push_back({x, together(trial.wave()), trial.limits.has_passed(limit), trial.wave()});
        }
    });
    return singles;
}

std::vector<TwoMeasureTrial> MeasuredTrials::pairs(std::int64_t body, std::array<Measure, 2> const& measures,
                                                   std::size_t limit) const {
    std::vector<TwoMeasureTrial> pairs;
    each_of(body, [&, one = place_of(measures[0]), two = place_of(measures[1])](std::size_t t, Measured const& trial) {
        double const first = value(t, one);
        double const second = value(t, two);
        if (trial.limits.is_decided(limit) && first > 0 && second > 0) {
            pairs.push_back(
                {{std::log(first), std::log(second)}, trial.limits.has_passed(limit), together(trial.wave())});
        }
    });
    return pairs;
}

std::vector<SingleTrial> MeasuredTrials::open(std::int64_t body, Measure measure, std::size_t limit) const {
    std::vector<SingleTrial> open;
    each_of(body, [&, at = place_of(measure)](std::size_t t, Measured const& trial) {
        if (double const x = value(t, at); !trial.limits.is_decided(limit) && x > 0) {
            open.push_back({x, together(trial.wave()), false, trial.wave()});
        }
    });
    return open;
}

std::int64_t MeasuredTrials::left_out(std::int64_t body, Measure measure, std::size_t limit) const {
    std::int64_t count = 0;
    each_of(body, [&, at = place_of(measure)](std::size_t t, Measured const& trial) {
        count += trial.limits.is_decided(limit) && value(t, at) > 0 ? 0 : 1;
    });
    return count;
}

std::vector<CriterionTrial> MeasuredTrials::criterion_trials(std::int64_t body, Measure measure) const {
    std::vector<CriterionTrial> list;
    list.reserve(trials_.size());
    each_of(body, [&, at = place_of(measure)](std::size_t t, Measured const& trial) {
        if (trial.decided && !std::isnan(value(t, at) / trial.v_ereq_mps)) {  // a file may lack either
            list.push_back({value(t, at) / trial.v_ereq_mps, trial.wave(), trial.overturned(), trial.uplifted});
        }
    });
    return list;
}

std::vector<ResponseTrial> MeasuredTrials::responses(std::int64_t body) const {
    std::vector<ResponseTrial> list;
    list.reserve(trials_.size());
    for (auto const& trial : trials_) {
        if (trial.body == body && trial.decided && trial.moved) {
            list.push_back({trial.v_wes_mps / trial.v_ereq_mps, trial.v_resp_mps / trial.v_ereq_mps, trial.slipped,
                            trial.overturned()});
        }
    }
    return list;
}

std::map<double, std::vector<double>> MeasuredTrials::by_level(std::int64_t body, LevelResponse response) const {
    std::map<double, std::vector<double>> values;
    for (auto const& trial : trials_) {
        if (trial.body == body) {
            values[trial.amplitude].push_back(response == LevelResponse::peak_slip ? trial.peak_slip_m
                                                                                   : trial.peak_rotation_ratio);
        }
    }
    return values;
}

}  // namespace overturn
