#include "results/measured_trials.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "response/registry.hpp"

namespace overturn {

std::vector<std::string> fragility_measure_names() {
    return {"pga",        "pgv",  "v_wes", "ou_v_e", "v_wes_ratio", "level", "v_wes_other_unit", "ou_v_e_other_unit",
            "sa_average", "sa_1", "sa_2",  "sa_3",   "sa_4"};
}

namespace {

constexpr std::size_t most_trials_held = 1'000'000;

}  // namespace

void MeasuredTrials::add(WaveRow const& row, std::span<MeasureRow const> measures) {
    if (trials_.size() >= most_trials_held) {
        return;
    }
    Peaks peaks{row.pga_mps2, row.pgv_mps, row.sa_average_mps2, row.sa_mps2, {}};
    auto const asked = [](MeasureRow const& body) { return !std::isnan(body.other_unit_v_wes_max_mps); };
    if (std::any_of(measures.begin(), measures.end(), asked)) {
        for (auto const& body : measures) {
            peaks.other_unit.push_back({body.other_unit_v_wes_max_mps, body.other_unit_ou_v_e_mps});
        }
    }
    waves_.insert_or_assign(row.id, std::move(peaks));
}

void MeasuredTrials::add(TrialRow const& row, LimitOutcomes const& limits) {
    auto const wave = waves_.find(row.wave);
    bool const full = trials_.size() >= most_trials_held && row.wave != trials_.back().wave;
    if (full || wave == waves_.end()) {
        passed_by_ += full ? 1 : 0;
        return;
    }
    auto const& verdict = entry_of(row.verdict);
    Measured trial{};
    trial.wave = row.wave;
    trial.body = static_cast<std::int32_t>(row.body);
    trial.decided = verdict.decided;
    trial.limits = limits;
    trial.moved = verdict.moved;
    trial.slipped = row.peak_slip_m > 0;
    trial.uplifted = verdict.fell || row.peak_rotation_ratio > 0;
    auto const missed = static_cast<EffectMask>(row.called) & ~static_cast<EffectMask>(row.effects);
    trial.peak_slip_m = verdict.decided && !has(missed, Effect::sliding) ? row.peak_slip_m : never;
    trial.peak_rotation_ratio = verdict.decided ? row.peak_rotation_ratio : never;
    if (verdict.fell) {
        trial.peak_rotation_ratio = std::numeric_limits<double>::infinity();
    }
    trial.amplitude = row.amplitude;
    trial.scale = row.scale;
    trial.peaks = &wave->second;
    trial.v_wes_mps = row.v_wes_mps;
    trial.ou_v_e_mps = row.ou_v_e_mps;
    trial.v_ereq_mps = row.v_ereq_mps;
    trial.v_resp_mps = row.response_velocity_mps;
    trials_.push_back(trial);
}

double MeasuredTrials::Measured::value(FragilityMeasure measure) const {
    if (auto const place = sa_place(measure)) {
        return scale * peaks->sa_mps2.at(*place);
    }
    auto const other = [this] {
        return peaks->other_unit.empty() ? OtherUnit{} : peaks->other_unit.at(static_cast<std::size_t>(body));
    };
    switch (measure) {
        case FragilityMeasure::pga:
            return scale * peaks->pga_mps2;
        case FragilityMeasure::pgv:
            return scale * peaks->pgv_mps;
        case FragilityMeasure::v_wes:
            return v_wes_mps;
        case FragilityMeasure::ou_v_e:
            return ou_v_e_mps;
        case FragilityMeasure::v_wes_ratio:
            return v_wes_mps / v_ereq_mps;
        case FragilityMeasure::v_wes_other_unit:
            return scale * other().v_wes_mps;
        case FragilityMeasure::ou_v_e_other_unit:
            return scale * other().ou_v_e_mps;
        case FragilityMeasure::sa_average:
            return scale * peaks->sa_average_mps2;
        default:
            break;
    }
    return amplitude;
}

std::vector<SingleTrial> MeasuredTrials::singles(std::int64_t body, FragilityMeasure measure, std::size_t limit) const {
    std::vector<SingleTrial> singles;
    singles.reserve(trials_.size());
    for (auto const& trial : trials_) {
        if (trial.body == body && trial.limits.is_decided(limit) && trial.value(measure) > 0) {
            singles.push_back({trial.value(measure), together(trial.wave), trial.limits.has_passed(limit), trial.wave});
        }
    }
    return singles;
}

std::vector<TwoMeasureTrial> MeasuredTrials::pairs(std::int64_t body, std::array<FragilityMeasure, 2> const& measures,
                                                   std::size_t limit) const {
    std::vector<TwoMeasureTrial> pairs;
    for (auto const& trial : trials_) {
        double const first = trial.value(measures[0]);
        double const second = trial.value(measures[1]);
        if (trial.body == body && trial.limits.is_decided(limit) && first > 0 && second > 0) {
            pairs.push_back(
                {{std::log(first), std::log(second)}, trial.limits.has_passed(limit), together(trial.wave)});
        }
    }
    return pairs;
}

std::vector<SingleTrial> MeasuredTrials::open(std::int64_t body, FragilityMeasure measure, std::size_t limit) const {
    std::vector<SingleTrial> open;
    for (auto const& trial : trials_) {
        if (trial.body == body && !trial.limits.is_decided(limit) && trial.value(measure) > 0) {
            open.push_back({trial.value(measure), together(trial.wave), false, trial.wave});
        }
    }
    return open;
}

std::int64_t MeasuredTrials::left_out(std::int64_t body, FragilityMeasure measure, std::size_t limit) const {
    std::int64_t count = 0;
    for (auto const& trial : trials_) {
        count += trial.body == body && !(trial.limits.is_decided(limit) && trial.value(measure) > 0) ? 1 : 0;
    }
    return count;
}

std::vector<CriterionTrial> MeasuredTrials::criterion_trials(std::int64_t body, FragilityMeasure measure) const {
    std::vector<CriterionTrial> list;
    list.reserve(trials_.size());
    for (auto const& trial : trials_) {
        if (trial.body == body && trial.decided) {
            list.push_back({trial.value(measure) / trial.v_ereq_mps, trial.wave, trial.overturned(), trial.uplifted});
        }
    }
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
