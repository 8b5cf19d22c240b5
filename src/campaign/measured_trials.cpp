#include "campaign/measured_trials.hpp"

#include "rocking/planar_rocking.hpp"

namespace overturn {

std::vector<std::string> fragility_measure_names() { return {"pga", "pgv", "v_wes", "ou_v_e", "v_wes_ratio", "level"}; }

namespace {

constexpr std::size_t most_trials = 1'000'000;

}  // namespace

void MeasuredTrials::add(WaveRow const& row) {
    if (trials_.size() < most_trials) {
        waves_.insert_or_assign(row.id, Peaks{row.pga_mps2, row.pgv_mps});
    }
}

void MeasuredTrials::add(TrialRow const& row) {
    auto const wave = waves_.find(row.wave);
    bool const full = trials_.size() >= most_trials && row.wave != trials_.back().wave;
    if (full || wave == waves_.end()) {
        passed_by_ += full ? 1 : 0;
        return;
    }
    auto const verdict = static_cast<Verdict>(row.verdict);
    trials_.push_back({row.wave, static_cast<std::int32_t>(row.body),
                       verdict != Verdict::failed && verdict != Verdict::contact_lost, verdict == Verdict::overturned,
                       row.amplitude, row.scale * wave->second.pga_mps2, row.scale * wave->second.pgv_mps,
                       row.v_wes_mps, row.ou_v_e_mps, row.v_ereq_mps});
}

double MeasuredTrials::Trial::value(FragilityMeasure measure) const {
    switch (measure) {
        case FragilityMeasure::pga:
            return pga_mps2;
        case FragilityMeasure::pgv:
            return pgv_mps;
        case FragilityMeasure::v_wes:
            return v_wes_mps;
        case FragilityMeasure::ou_v_e:
            return ou_v_e_mps;
        case FragilityMeasure::v_wes_ratio:
            return v_wes_mps / v_ereq_mps;
        case FragilityMeasure::level:
            break;
    }
    return amplitude;
}

std::vector<SingleTrial> MeasuredTrials::singles(std::int64_t body, FragilityMeasure measure) const {
    std::vector<SingleTrial> singles;
    singles.reserve(trials_.size());
    for (auto const& trial : trials_) {
        if (trial.body == body && trial.decided && trial.value(measure) > 0) {
            singles.push_back({trial.value(measure), trial.wave, trial.overturned});
        }
    }
    return singles;
}

std::int64_t MeasuredTrials::left_out(std::int64_t body, FragilityMeasure measure) const {
    std::int64_t count = 0;
    for (auto const& trial : trials_) {
        count += trial.body == body && !(trial.decided && trial.value(measure) > 0) ? 1 : 0;
    }
    return count;
}

std::vector<CriterionTrial> MeasuredTrials::criterion_trials(std::int64_t body, FragilityMeasure measure) const {
    std::vector<CriterionTrial> list;
    list.reserve(trials_.size());
    for (auto const& trial : trials_) {
        if (trial.body == body && trial.decided) {
            list.push_back({trial.value(measure) / trial.v_ereq_mps, trial.wave, trial.overturned});
        }
    }
    return list;
}

}  // namespace overturn
