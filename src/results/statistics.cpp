#include "results/statistics.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "response/registry.hpp"
#include "results/detail/fitted_measures.hpp"

namespace overturn {
namespace {

void count(LimitStatistics& limit, std::size_t level, VerdictEntry const& end, bool decided, bool passed) {
    auto& stripe = limit.stripes.at(level);
    ++stripe.trials;
    stripe.overturned += passed ? 1 : 0;
    stripe.failed += end.value == Verdict::failed ? 1 : 0;
    stripe.undecided += end.value != Verdict::failed && !decided ? 1 : 0;
    limit.unknown += end.decided && !decided ? 1 : 0;
    limit.fell_within += end.fell && decided && !passed ? 1 : 0;
}

// All waves with their measures of each body, then all trials with what models have to say of their own.
template <class TakeWave, class TakeTrial>
void each_row(BlockRows const& block, std::size_t bodies, TakeWave&& take_wave, TakeTrial&& take_trial) {
    for (std::size_t w = 0; w < block.waves.size(); ++w) {
        take_wave(block.waves[w], std::span(block.measures).subspan(w * bodies, bodies));
    }
    auto const& rows = block.trials.rows;
    auto const extra = rows.empty() ? 0 : block.trials.extra.size() / rows.size();
    for (std::size_t t = 0; t < rows.size(); ++t) {
        take_trial(rows[t], std::span(block.trials.extra).subspan(t * extra, extra));
    }
}

}  // namespace

Statistics::Statistics(CampaignSpec const& spec, TrialsHeld held)
    : judge_(spec.limits, ModelSelector(spec.effects, spec.accuracy)),
      held_(held),
      sigma_(spec),
      measured_(held_measures(spec), spec.source->about().shared) {
    for (auto const& body : spec.bodies) {
        BodyStatistics statistics;
        statistics.body = body.name;
        for (auto const& level : spec.levels.levels) {
            statistics.stripes.push_back(
                {.amplitude = level.value, .group_size = spec.source->about().shared.effect()});
        }
        statistics.limits.resize(spec.limits.size() - 1, {statistics.stripes, 0, 0});
        statistics.v_wes.resize(statistics.stripes.size());
        statistics.ou_v_e.resize(statistics.stripes.size());
        auto const levels = statistics.stripes.size();
        statistics.ends.assign(verdicts().size(), std::vector<std::int64_t>(levels));
        statistics.required.assign(effects().size(), std::vector<std::int64_t>(levels));
        statistics.left_out.resize(effects().size());
        statistics.fell_after_record.resize(levels);
        statistics.peaked_after_record.resize(levels);
        statistics.models.resize(model_categories().size());
        auto const periods = spec.grid_periods_s();
        for (std::size_t w = 0; w < periods.size(); ++w) {
            statistics.grid.emplace_back(static_cast<std::int64_t>(w), periods[w], levels, spec.limits.size());
        }
        bodies_.push_back(std::move(statistics));
    }
}

void Statistics::add(WaveRow const& row, std::span<MeasureRow const> measures) {
    if (waves_.waves == 0) {
        duration_s_ = row.duration_s;
    } else if (row.duration_s != duration_s_) {
        other_durations_[row.id] = row.duration_s;
    }
    waves_.add(row);
    if (row.accepted == Accepted::no) {
        missed_clauses_.add(row);
    }
    sigma_.add(row);
    if (held_ == TrialsHeld::all) {
        measured_.add(row, measures);
    }
}

void Statistics::add_refused(WaveRow const& row) {
    ++waves_.refused;
    missed_clauses_.add(row);
}

void Statistics::add(BlockRows const& block) {
    each_row(
        block, bodies_.size(), [&](auto const& wave, auto measures) { add(wave, measures); },
        [&](auto const& trial, auto extra) { add(trial, extra); });
}

bool Statistics::add_up(CampaignSpec const& spec) {
    return !spec.is_grid() && !spec.source->about().acceptance.asked() && !SigmaCount(spec).counts();
}

template <class Self, class Visit> void Statistics::each_count(Self& self, Visit&& visit) {
    auto const all = [&](auto& numbers) { std::ranges::for_each(numbers, visit); };
    auto const stripes = [&](auto& of_levels) {
        for (auto& stripe : of_levels) {
            for (auto* const number : {&stripe.trials, &stripe.overturned, &stripe.failed, &stripe.undecided}) {
                visit(*number);
            }
        }
    };
    auto const predictions = [&](auto& of_levels) {
        for (auto& c : of_levels) {
            for (auto* const number : {&c.false_safe, &c.false_alarm, &c.true_safe, &c.true_overturn, &c.undecided_safe,
                                       &c.undecided_unsafe}) {
                visit(*number);
            }
        }
    };
    auto& waves = self.waves_;
    for (auto* const number : {&waves.waves, &waves.failed, &waves.not_accepted, &waves.refused, &waves.missed}) {
        visit(*number);
    }
    for (auto& body : self.bodies_) {
        stripes(body.stripes);
        for (auto& limit : body.limits) {
            stripes(limit.stripes);
            visit(limit.unknown);
            visit(limit.fell_within);
        }
        predictions(body.v_wes);
        predictions(body.ou_v_e);
        std::ranges::for_each(body.ends, all);
        std::ranges::for_each(body.required, all);
        all(body.left_out);
        all(body.fell_after_record);
        all(body.peaked_after_record);
        all(body.models);
    }
}

std::vector<std::int64_t> Statistics::counts() const {
    std::vector<std::int64_t> counts;
    each_count(*this, [&](std::int64_t count) { counts.push_back(count); });
    return counts;
}

void Statistics::add_counts(std::span<std::int64_t const> counts) {
    std::size_t next = 0;
    each_count(*this, [&](std::int64_t& count) { count += counts[next++]; });
    OVERTURN_ENSURE(next == counts.size());
}

void Statistics::add(TrialRow const& row, std::span<std::byte const> extra) {
    auto const limits = judge_.judge(row, extra);
    if (held_ == TrialsHeld::all) {
        measured_.add(row, limits);
    }
    auto& body = bodies_.at(row.body);
    std::size_t const level = row.level;
    if (!body.grid.empty()) {
        body.grid.at(row.wave).add(row, limits);
    }
    auto& stripe = body.stripes.at(level);
    auto const& end = entry_of(row.verdict);
    for (std::size_t l = 0; l < body.limits.size(); ++l) {
        count(body.limits[l], level, end, limits.is_decided(l + 1), limits.has_passed(l + 1));
    }
    ++stripe.trials;
    ++body.ends[&end - verdicts().data()][level];
    for (std::size_t e = 0; e < effects().size(); ++e) {
        bool const required = has(static_cast<EffectMask>(row.required), effects()[e].value);
        bool const simulated = has(static_cast<EffectMask>(row.effects), effects()[e].value);
        body.required[e][level] += required ? 1 : 0;
        body.left_out[e] += required && !simulated && row.reason == left_out_reason ? 1 : 0;
    }
    count_after_record(row, body);
    if (row.verdict == Verdict::failed) {
        ++stripe.failed;
    } else {
        if (row.model != unknown_category) {  // else of a model that another program has
            ++body.models[model_place(row.model)];
        }
        stripe.undecided += end.decided ? 0 : 1;
    }
    stripe.overturned += end.decided && end.fell ? 1 : 0;
    auto const predict = [&](std::int64_t safe, auto& counts) {
        if (safe == unknown_category) {  // a file may lack the prediction
            return;
        }
        end.decided ? counts.add(safe != 0, end.fell) : counts.add_undecided(safe != 0);
    };
    predict(row.v_wes_safe, body.v_wes[level]);
    predict(row.ou_v_e_safe, body.ou_v_e[level]);
}

void Statistics::count_after_record(TrialRow const& row, BodyStatistics& body) const {
    auto const other = other_durations_.find(row.wave);
    double const end_s = other == other_durations_.end() ? duration_s_ : other->second;
    std::size_t const level = row.level;
    if (row.overturn_time_s > end_s) {
        ++body.fell_after_record[level];
    } else if (entry_of(row.verdict).decided && row.time_of_peak_s > end_s) {
        ++body.peaked_after_record[level];
    }
}

void WaveCounts::add(WaveRow const& row) {
    ++waves;
    failed += row.failed != 0 ? 1 : 0;
    not_accepted += row.failed == 0 && row.accepted == Accepted::no ? 1 : 0;
    missed +=
        row.failed == 0 && row.accepted == Accepted::not_asked && row.match_iterations > 0 && row.matched == 0 ? 1 : 0;
}

double memory_of_trials(CampaignSpec const& spec, std::int64_t trials) {
    auto const held = std::min(trials, static_cast<std::int64_t>(most_trials_held));
    return MeasuredTrials::bytes_of(held, held_measures(spec));
}

}  // namespace overturn
