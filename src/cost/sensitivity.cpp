#include "cost/sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <span>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <gsl/gsl_rng.h>

#include "core/elapsed.hpp"
#include "core/random_stream.hpp"
#include "cost/bench.hpp"
#include "cost/detail/paired_trials.hpp"
#include "cost/detail/varied_inputs.hpp"
#include "results/few_waves.hpp"
#include "stats/probit.hpp"
#include "stats/quantile.hpp"

namespace overturn::cost {
namespace {

constexpr std::size_t replicates = 1000;
constexpr std::uint64_t bootstrap_stream = 0x5E45;  // of draws that nothing else makes

// How often each wave of the sample is drawn in every replicate; waves that share a target come together.
std::vector<std::vector<double>> drawn_weights(CampaignSpec const& spec, std::span<std::int64_t const> numbers) {
    std::map<std::int64_t, std::vector<std::size_t>> by_draw;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        by_draw[spec.source->about().shared(numbers[i])].push_back(i);
    }
    std::vector<std::vector<std::size_t>> groups;
    std::ranges::transform(by_draw, std::back_inserter(groups), [](auto const& draw) { return draw.second; });
    std::vector<std::vector<double>> all(replicates, std::vector<double>(numbers.size()));
    for (std::size_t r = 0; r < replicates; ++r) {
        RandomStream stream(spec.seed, r, Purpose::bootstrap, bootstrap_stream);
        for (std::size_t draw = 0; draw < groups.size(); ++draw) {
            for (auto const wave : groups[gsl_rng_uniform_int(stream.gsl(), groups.size())]) {
                all[r][wave] += 1;
            }
        }
    }
    return all;
}

// What no verdict hangs on costs no time; a rule that refuses waves has to see their quality.
void measure_nothing(CampaignSpec& spec) {
    spec.measures.energy = false;
    spec.measures.wave_quality = spec.source->about().acceptance.asked();
}

class SensitivityRunner {
  public:
    SensitivityRunner(CampaignInput const& input, std::int64_t waves)
        : input_(input), spec_(parse_campaign(input)), plan_(spec_) {
        validate(!spec_.is_grid(),
                 "{}: its waves are a grid of frequencies (no random sample: there is no probability "
                 "that an input could move). Read the map of overturn fit instead",
                 input.name);
        validate(!no_sample(spec_, plan_.waves()),
                 "{}: {} recorded motions (no probability, which needs {} or more, and no median that an input could "
                 "move). State more of them",
                 input.name, spec_.source->about().shared.among(plan_.waves()), least_records);
        measure_nothing(spec_);
        numbers_ = spread_over(std::min(waves == 0 ? usual_waves : waves, plan_.waves()), plan_.waves());
        for (auto const number : numbers_) {
            waves_.push_back(prepare_wave(spec_, plan_, number, ignored_));
        }
        weights_ = drawn_weights(spec_, numbers_);
    }

    Sensitivity run(Tell const& tell);

  private:
    [[nodiscard]] PairedTrials trials_with(CampaignInput const& varied, bool of_body);
    [[nodiscard]] std::vector<double> log_medians(PairedTrials const& trials, std::size_t body, std::size_t limit);
    void compare(Sensitivity& study, std::size_t input, std::size_t end, PairedTrials const& before,
                 PairedTrials const& after);
    [[nodiscard]] SensitivityRow& row_of(Sensitivity& study, std::size_t input, std::size_t body, std::size_t limit);
    void describe(Sensitivity& study, PairedTrials const& unmoved);

    CampaignInput const& input_;
    CampaignSpec spec_;
    Plan plan_;
    PhaseSeconds ignored_;
    std::vector<std::int64_t> numbers_;
    std::vector<PreparedWave> waves_;
    std::vector<std::vector<double>> weights_;
    std::vector<std::vector<double>> unmoved_;  // ln medians: all waves once, then the replicates; per body and limit
};

PairedTrials SensitivityRunner::trials_with(CampaignInput const& varied, bool of_body) {
    auto spec = parse_campaign(varied);
    measure_nothing(spec);
    Plan const plan(spec);
    validate(plan.waves() == plan_.waves(),
             "other levels have other waves (levels.waves = \"independent\"). Share "
             "them");
    if (!of_body) {
        std::vector<PreparedWave> waves;
        for (auto const number : spread_over(numbers_.size(), plan.waves())) {
            waves.push_back(prepare_wave(spec, plan, number, ignored_));
        }
        return {spec, plan, waves};
    }
    // The waves are what they were; only who stands under them changed.
    for (auto& wave : waves_) {
        for (std::size_t b = 0; b < spec.bodies.size(); ++b) {
            wave.bodies[b] = spec.bodies[b].for_wave(plan.drawn_for(spec, wave.number), b);
        }
    }
    return {spec, plan, waves_};
}

std::vector<double> SensitivityRunner::log_medians(PairedTrials const& trials, std::size_t body, std::size_t limit) {
    std::vector<double> medians;
    medians.reserve(1 + weights_.size());
    std::vector<double> const once(numbers_.size(), 1.0);
    auto const add = [&](std::span<double const> weights) {
        medians.push_back(trials.log_median(body, limit, weights).value_or(not_known));
    };
    add(once);
    for (auto const& weights : weights_) {
        add(weights);
    }
    return medians;
}

SensitivityRow& SensitivityRunner::row_of(Sensitivity& study, std::size_t input, std::size_t body, std::size_t limit) {
    auto const there = std::ranges::find_if(study.rows, [&](SensitivityRow const& row) {
        return row.input == input && row.body == body && row.limit == limit;
    });
    return there != study.rows.end() ? *there : study.rows.emplace_back(SensitivityRow{input, body, limit, {}});
}

void SensitivityRunner::compare(Sensitivity& study, std::size_t input, std::size_t end, PairedTrials const& before,
                                PairedTrials const& after) {
    auto const& keys = study.inputs[input].keys;
    for (std::size_t body = 0; body < spec_.bodies.size(); ++body) {
        bool const concerned = std::ranges::any_of(keys, [&](std::string const& key) {
            return !key.starts_with("bodies[") || key.starts_with(fmt::format("bodies[{}]", body));
        });
        for (std::size_t limit = 0; concerned && limit < spec_.limits.size(); ++limit) {
            auto shift = after.shift_from(before, body, limit);
            auto const& unmoved = unmoved_[body * spec_.limits.size() + limit];
            auto ratios = log_medians(after, body, limit);
            for (std::size_t i = 0; i < ratios.size(); ++i) {
                ratios[i] -= unmoved[i];
            }
            std::vector<double> const once(numbers_.size(), 1.0);
            shift.levels_too_coarse = before.is_separated(body, limit, once) || after.is_separated(body, limit, once);
            if (!std::isnan(ratios.front()) && !shift.levels_too_coarse) {
                constexpr double open = std::numeric_limits<double>::infinity();
                auto const ends = middle_of(std::span(ratios).subspan(1), spec_.confidence, {-open, open});
                if (std::isfinite(ends.lower) && std::isfinite(ends.upper)) {  // else too few waves identify a median
                    shift.median_ratio = std::exp(ratios.front());
                    shift.median_interval = Interval{std::exp(ends.lower), std::exp(ends.upper)};
                }
            }
            row_of(study, input, body, limit).ends.at(end) = shift;
        }
    }
}

void SensitivityRunner::describe(Sensitivity& study, PairedTrials const& unmoved) {
    study.title = spec_.title.empty() ? input_.name : spec_.title;
    study.measure = spec_.levels.measure_name();
    study.units = spec_.levels.units();
    study.shown_units = spec_.levels.shown_units();
    study.shown_si = study.shown_units == study.units ? 1 : spec_.levels.stated_unit_si;
    study.waves = numbers_.size();
    study.campaign_waves = plan_.waves();
    study.confidence = spec_.confidence;
    study.design_basis = unmoved.design_basis();
    for (auto const& limit : spec_.limits) {
        study.limits.push_back(limit.name);
    }
    for (std::size_t body = 0; body < spec_.bodies.size(); ++body) {
        study.bodies.push_back(spec_.bodies[body].name);
        for (std::size_t limit = 0; limit < spec_.limits.size(); ++limit) {
            unmoved_.push_back(log_medians(unmoved, body, limit));
            bool const coarse = unmoved.is_separated(body, limit, std::vector<double>(numbers_.size(), 1.0));
            double const median = coarse ? not_known : unmoved_.back().front();
            study.unmoved.push_back(
                {body, limit, unmoved.counts(body, limit, {}),
                 unmoved.design_basis() ? unmoved.counts(body, limit, unmoved.design_basis()) : Counts{}, coarse,
                 std::isnan(median) ? std::nullopt : std::optional(std::exp(median))});
        }
    }
}

// What moves the median most comes first; where no median is known, what changes most verdicts.
std::pair<double, std::int64_t> weight_of(SensitivityRow const& row) {
    std::pair<double, std::int64_t> weight{0, 0};
    for (auto const& end : row.ends) {
        if (end) {
            weight.first = std::max(weight.first, std::abs(std::log(end->median_ratio.value_or(1))));
            weight.second = std::max(weight.second, end->flips());
        }
    }
    return weight;
}

Sensitivity SensitivityRunner::run(Tell const& tell) {
    Sensitivity study;
    PairedTrials const unmoved(spec_, plan_, waves_);
    describe(study, unmoved);
    auto varied = varied_inputs(spec_);
    study.inputs = std::move(varied.inputs);
    study.unvaried = std::move(varied.unvaried);
    auto const start = Clock::now();
    for (std::size_t i = 0; i < study.inputs.size(); ++i) {
        auto& input = study.inputs[i];
        for (std::size_t end = 0; end < input.ends.size(); ++end) {
            try {
                bool const of_body = varied.values[i].key.starts_with("bodies[");
                compare(study, i, end, unmoved,
                        trials_with(with_value(input_, varied.values[i], input.ends.at(end)), of_body));
            } catch (InputError const& error) {
                input.refused.at(end) = error.what();
            }
            double const share = static_cast<double>(2 * i + end + 1) / static_cast<double>(2 * study.inputs.size());
            tell(share, seconds_since(start) * (1 - share) / share);
        }
    }
    std::ranges::stable_sort(study.rows, [](SensitivityRow const& a, SensitivityRow const& b) {
        return std::tie(a.body, a.limit) != std::tie(b.body, b.limit)
                   ? std::tie(a.body, a.limit) < std::tie(b.body, b.limit)
                   : weight_of(a) > weight_of(b);
    });
    return study;
}

}  // namespace

std::optional<double> Counts::share() const {
    return decided == 0 ? std::nullopt : std::optional(static_cast<double>(passed) / static_cast<double>(decided));
}

bool Shift::resolved() const {
    constexpr double least = 1e-4;  // of a median: below it lies what a further level does to a fit
    return median_interval && (median_interval->lower > 1 + least || median_interval->upper < 1 - least);
}

Sensitivity study_sensitivity(CampaignInput const& input, std::int64_t waves, Tell const& tell) {
    return SensitivityRunner(input, waves).run(tell);
}

}  // namespace overturn::cost
