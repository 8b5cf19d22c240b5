#include "response/model_selector.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <utility>

#include "core/elapsed.hpp"
#include "core/error.hpp"
#include "response/detail/out_of_range.hpp"

namespace overturn {
namespace {

constexpr std::size_t none = ~std::size_t{0};
constexpr std::size_t most_models = 8;

class Stopwatch {
  public:
    [[nodiscard]] double lap() {
        auto const now = Clock::now();
        return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
    }

  private:
    Clock::time_point last_ = Clock::now();
};

}  // namespace

// Where a trial stands between the models: what it may need, what has been required, and which model takes it next.
struct ModelSelector::TrialState {
    Trial trial;
    EffectMask possible = 0, required = 0;
    Outcome outcome;
    std::size_t next = none, last = none;             ///< model
    std::size_t batch = none, place = 0;              ///< the one it was in last, and where
    std::uint64_t ran = 0;                            ///< a bit for each model that followed it
    std::array<std::int64_t, most_models> reasons{};  ///< of each: why it was required first; none: not yet

    void call(std::size_t model, Requirement const& more) {
        required |= more.effects;
        if (more.effects != 0 && reasons[model] == no_reason) {
            reasons[model] = more.reason;
        }
    }

    // The cheapest model follows nothing of a trial at rest.
    [[nodiscard]] bool followed() const { return last != none && (last > 0 || outcome.verdict != Verdict::at_rest); }
};

// What the batches left behind, contiguous.
struct ModelSelector::Ended {
    std::vector<std::unique_ptr<Checkpoints>> batches;
};

ModelSelector::ModelSelector(EffectRequest const& request, Accuracy const& accuracy,
                             std::span<ModelEntry const> entries)
    : request_(request) {
    for (auto const& entry : entries) {
        models_.push_back(entry.make(accuracy));
        auto const& traits = models_.back()->traits();
        bool const may_run = models_.size() == 1 || (traits.brings() & request.wanted()) != 0;
        if (may_run && !traits.fields.empty()) {
            extra_parts_.push_back({&traits, extra_bytes_});
            extra_bytes_ += traits.default_row.size();
        }
    }
    OVERTURN_EXPECT(models_.size() <= most_models);
    validate(request.mode != EffectMode::forced || cheapest(request.include) != none,
             "effects {} (no model supports them together). Leave one out", text_of(request));
}

std::size_t ModelSelector::cheapest(EffectMask needed) const {
    auto const found =
        std::ranges::find_if(models_, [&](auto const& model) { return holds_all(model->traits().holds, needed); });
    return found == models_.end() ? none : static_cast<std::size_t>(found - models_.begin());
}

// `simulated` and as many of `more`, in the models' order, as some model holds together.
EffectMask ModelSelector::supported_with(EffectMask simulated, EffectMask more) const {
    for (auto const& model : models_) {
        for (auto const& effect : model->traits().effects) {
            auto const with = simulated | (more & mask_of(effect.value));
            simulated = cheapest(with) != none ? with : simulated;
        }
    }
    return simulated;
}

ModelSelector::TrialState ModelSelector::begin(SceneTrial const& at) const {
    TrialState state;
    auto& trial = state.trial;
    trial.body = &at.scene.body;
    trial.footing = &at.scene.footing;
    trial.friction = at.scene.friction;
    trial.excitation = {.horizontal_mps2 = at.motion.horizontal_mps2,
                        .time_step_s = at.motion.time_step_s,
                        .scale = at.scale,
                        .peak_mps2 = at.peak_mps2,
                        .chunks = at.chunks};
    if (at.scene.axes >= 2) {
        trial.excitation.transverse_mps2 = at.motion.transverse_mps2;
    }
    if (at.scene.axes >= 3) {
        trial.excitation.vertical_mps2 = at.motion.vertical_mps2;
    }
    for (std::size_t model = 0; model < models_.size(); ++model) {
        state.possible |= models_[model]->possible(trial);
        state.call(model, models_[model]->required_of(trial, nullptr));
    }
    bool const chooses = request_.mode == EffectMode::automatic;
    trial.simulated = supported_with(
        0, state.possible & request_.wanted() & (chooses ? state.required | request_.include : ~EffectMask{0}));
    if (out_of_range(trial.excitation, trial.simulated)) {
        state.outcome = unknown_outcome(FailureReason::out_of_range);
    } else {
        state.next = cheapest(trial.simulated);
    }
    return state;
}

// What the model's answer calls for, and who takes the trial over.
void ModelSelector::go_on(std::size_t model, TrialState& state) const {
    state.last = model;
    state.next = none;
    state.ran |= state.followed() ? std::uint64_t{1} << model : 0;
    state.required |= static_cast<EffectMask>(state.outcome.required);
    for (auto dearer = model + 1; dearer < models_.size(); ++dearer) {
        state.call(dearer, models_[dearer]->required_of(state.trial, &state.outcome));
    }
    if (request_.mode != EffectMode::automatic) {
        return;
    }
    state.trial.simulated = supported_with(state.trial.simulated, state.required & state.possible);
    if (!holds_all(models_[model]->traits().holds, state.trial.simulated)) {
        state.next = cheapest(state.trial.simulated);
    }
}

// All trials that the model gets from one batch of another (or from none), at once.
void ModelSelector::run(std::size_t model, std::size_t from, std::vector<TrialState>& states,
                        std::span<std::byte> extra, std::function<void()> const& before_each, Ended& ended) const {
    auto const& traits = models_[model]->traits();
    bool const chooses = request_.mode == EffectMode::automatic;
    std::vector<std::size_t> which;
    std::vector<std::size_t> places;
    std::vector<Trial> trials;
    std::vector<Outcome> outcomes;
    for (std::size_t i = 0; i < states.size(); ++i) {
        auto& state = states[i];
        if (state.next == model && state.batch == from) {
            auto const simulated = state.trial.simulated;
            state.trial.handled_later = chooses ? supported_with(simulated, state.possible) & ~traits.holds : 0;
            which.push_back(i);
            places.push_back(state.place);
            trials.push_back(state.trial);
            outcomes.push_back(state.outcome);
        }
    }
    if (trials.empty()) {
        return;
    }
    auto const part = std::ranges::find(extra_parts_, &traits, &ExtraPart::traits);
    auto const row_bytes = extra.empty() || part == extra_parts_.end() ? 0 : traits.default_row.size();
    std::vector<std::byte> rows(trials.size() * row_bytes);
    auto const* const before = from == none ? nullptr : ended.batches[from].get();
    ended.batches.push_back(models_[model]->run({.trials = trials,
                                                 .outcomes = outcomes,
                                                 .extra = rows,
                                                 .before = before,
                                                 .places = places,
                                                 .before_each = before_each}));
    for (std::size_t i = 0; i < which.size(); ++i) {
        auto& state = states[which[i]];
        state.outcome = outcomes[i];
        state.batch = ended.batches.size() - 1;
        state.place = i;
        go_on(model, state);
        if (row_bytes > 0 && state.next == none) {  // what a model says that another one follows counts no more
            std::memcpy(extra.data() + which[i] * extra_bytes_ + part->offset, rows.data() + i * row_bytes, row_bytes);
        }
    }
}

// What was chosen, is possible, and is held by no model beside what was simulated.
EffectMask ModelSelector::left_out(TrialState const& state) const {
    return request_.mode == EffectMode::automatic
               ? (state.required | request_.include) & state.possible & ~state.trial.simulated
               : 0;
}

EffectMask ModelSelector::left_out(SceneTrial const& trial) const { return left_out(begin(trial)); }

EffectMask ModelSelector::impossible(Scene const& scene) const {
    GroundMotion const of_all{
        .time_step_s = 1, .horizontal_mps2 = {0, 0}, .transverse_mps2 = {0, 0}, .vertical_mps2 = {0, 0}};
    Scene const shaken{scene.body, scene.friction, scene.footing};
    return request_.mode == EffectMode::forced ? request_.include & ~begin({shaken, of_all}).possible : 0;
}

// Why the trial ended on its model.
std::int64_t ModelSelector::reason_of(TrialState const& state) const {
    if (request_.mode != EffectMode::automatic) {
        return stated_reason;
    }
    auto const& traits = models_[state.last]->traits();
    if ((left_out(state) & ~traits.always) != 0) {
        return left_out_reason;
    }
    auto const& reasons = traits.reasons;
    auto const reason = state.reasons[state.last];
    if (reason == no_reason && (traits.brings() & request_.include) != 0) {
        return stated_reason;
    }
    return state.last == 0 ? no_reason : reason == no_reason && !reasons.empty() ? reasons.front().number : reason;
}

Response ModelSelector::conclude(TrialState const& state) const {
    Response response;
    static_cast<Outcome&>(response) = state.outcome;
    response.required = state.required;
    if (state.last != none) {
        auto const& traits = models_[state.last]->traits();
        response.effects = state.trial.simulated | traits.always;
        response.model = state.followed() ? traits.number : 0;
        response.reason = reason_of(state);
    }
    return response;
}

double ModelSelector::extra_value(Response const& response, std::string_view name,
                                  std::span<std::byte const> extra) const {
    for (auto const& [traits, offset] : extra_parts_) {
        if (traits->number == response.model) {
            auto const field = std::ranges::find(traits->fields, name, &Field::name);
            return field == traits->fields.end() ? never : real_at(extra.subspan(offset), *field);
        }
    }
    return never;
}

void ModelSelector::put_defaults(std::span<std::byte> extra) const {
    for (std::size_t at = 0; at < extra.size(); at += extra_bytes_) {
        for (auto const& [traits, offset] : extra_parts_) {
            std::ranges::copy(traits->default_row, extra.begin() + (at + offset));
        }
    }
}

std::vector<ModelCost> ModelSelector::respond(std::span<SceneTrial const> trials, std::span<Response> responses,
                                              std::span<std::byte> extra,
                                              std::function<void()> const& before_each) const {
    OVERTURN_EXPECT(responses.size() == trials.size());
    OVERTURN_EXPECT(extra.empty() || extra.size() == trials.size() * extra_bytes_);
    put_defaults(extra);
    Stopwatch watch;
    std::vector<TrialState> states;
    states.reserve(trials.size());
    for (auto const& trial : trials) {
        states.push_back(begin(trial));
    }
    std::vector<double> seconds{watch.lap()};  // of beginning, then of each model
    Ended ended;
    for (std::size_t model = 0; model < models_.size(); ++model) {
        run(model, none, states, extra, before_each, ended);
        for (std::size_t from = 0, before = ended.batches.size(); from < before; ++from) {
            run(model, from, states, extra, before_each, ended);
        }
        seconds.push_back(watch.lap());
    }
    std::vector<std::int64_t> on(models_.size());  // trials that each model followed
    for (std::size_t i = 0; i < trials.size(); ++i) {
        responses[i] = conclude(states[i]);
        for (std::size_t model = 0; model < models_.size(); ++model) {
            on[model] += static_cast<std::int64_t>(states[i].ran >> model & 1U);
        }
    }
    std::vector<ModelCost> costs(models_.size() + 1);
    for (auto const& state : states) {
        auto& cost = costs[state.followed() ? state.last + 1 : 0];
        ++cost.trials;
        cost.seconds += seconds[0] / static_cast<double>(trials.size());
        for (std::size_t model = 0; model < models_.size(); ++model) {
            if ((state.ran >> model & 1U) != 0) {
                cost.seconds += seconds[model + 1] / static_cast<double>(on[model]);
            }
        }
    }
    return costs;
}

Response ModelSelector::respond(SceneTrial const& trial, std::span<std::byte> extra) const {
    Response response;
    (void)respond(std::span(&trial, 1), std::span(&response, 1), extra);
    return response;
}

void ModelSelector::show(SceneTrial const& trial, Response const& response, Observer& observer) const {
    auto state = begin(trial);
    auto const is_its = [&](auto const& model) { return model->traits().number == response.model; };
    auto const answered = std::ranges::find_if(models_, is_its);
    auto const& model = answered != models_.end() ? *answered : models_.front();
    observer.begin(model->traits().channels);
    if (state.next == none) {
        return;
    }
    state.trial.simulated = static_cast<EffectMask>(response.effects);
    (void)model->run(
        {.trials = std::span(&state.trial, 1), .outcomes = std::span(&state.outcome, 1), .observer = &observer});
}

}  // namespace overturn
