#include "campaign/trial.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "campaign/detail/known_rows.hpp"
#include "campaign/detail/wave_rows.hpp"
#include "campaign/site_judge.hpp"
#include "campaign/site_path.hpp"
#include "campaign/wave_check.hpp"
#include "core/elapsed.hpp"
#include "core/error.hpp"

namespace overturn {
namespace {

class Stopwatch {
  public:
    explicit Stopwatch(double& seconds) : seconds_(seconds), begin_(Clock::now()) {}
    ~Stopwatch() { seconds_ += seconds_since(begin_); }
    Stopwatch(Stopwatch const&) = delete;
    Stopwatch& operator=(Stopwatch const&) = delete;
    Stopwatch(Stopwatch&&) = delete;
    Stopwatch& operator=(Stopwatch&&) = delete;

  private:
    double& seconds_;
    Clock::time_point begin_;
};

}  // namespace

void PhaseSeconds::add(PhaseSeconds const& more) {
    waves += more.waves;
    measures += more.measures;
    response += more.response;
    store += more.store;
    for (std::size_t r = 0; r < models.size(); ++r) {
        models[r].trials += more.models[r].trials;
        models[r].seconds += more.models[r].seconds;
    }
}

PreparedWave prepare_wave(CampaignSpec const& spec, Plan const& plan, std::int64_t wave, PhaseSeconds& seconds) {
    PreparedWave prepared;
    prepared.number = wave;
    auto const id = plan.wave_id(wave);
    prepared.row.id = id;
    describe_match(prepared.row, {});  // compared with nothing yet
    prepared.measures.resize(spec.bodies.size());
    auto const drawn_for = plan.drawn_for(spec, wave);
    for (std::size_t b = 0; b < spec.bodies.size(); ++b) {
        prepared.bodies.push_back(spec.bodies[b].for_wave(drawn_for, b));
    }
    try {
        Stopwatch const watch(seconds.waves);
        bool const judged = spec.measures.wave_quality;
        auto generated = judged ? spec.source->make(spec.seed, id) : spec.source->make_unjudged(spec.seed, id);
        validate_motion(generated.motion);
        if (judged) {
            describe_check(prepared, check_wave(generated, spec.bodies, spec.measures.radius_unit));
        }
        prepared.tried = is_tried(spec.source->about().acceptance, prepared.row);
        describe_match(prepared.row, generated);
        if (generated.drawn) {
            describe_drawn(prepared.row, *generated.drawn);
        }
        prepared.row.turned_rad = generated.turned_rad;
        prepared.motion = std::move(generated.motion);
    } catch (InputError const&) {
        prepared.row.failed = 1;
        return prepared;
    }
    Stopwatch const watch(seconds.measures);
    prepared.chunks = ChunkExtremes(prepared.motion.horizontal_mps2, prepared.motion.vertical_mps2);
    prepared.intensity = intensity_of(prepared.motion);
    describe_motion(prepared.row, prepared.motion, prepared.intensity);
    measure_sa(spec.measures, prepared);
    for (std::size_t b = 0; spec.measures.energy && b < spec.bodies.size(); ++b) {
        measure_energy(spec.measures, prepared.motion, prepared.bodies[b].body, prepared.measures[b]);
    }
    return prepared;
}

bool is_tried(Acceptance const& acceptance, WaveRow const& row) {
    return row.accepted == Accepted::yes || !acceptance.refuses();
}

namespace {

// A row before its response: what is known of the trial beforehand.
TrialRow open_row(CampaignSpec const& spec, PreparedWave const& wave, std::int64_t body, std::int64_t level) {
    auto const& drawn = wave.bodies.at(body);
    auto const& at = spec.levels.levels.at(level);
    TrialRow row;
    row.wave = wave.row.id;
    row.body = body;
    row.level = level;
    row.amplitude = at.value;
    row.mass_kg = drawn.body.mass_kg();
    row.centre_height_m = drawn.body.centre_height_m();
    row.restitution = drawn.body.restitution();
    if (drawn.friction) {
        row.static_friction = drawn.friction->static_coefficient;
        row.kinetic_friction = drawn.friction->kinetic_coefficient;
    }
    row.v_ereq_mps = drawn.body.limit_velocity_mps();
    bool const usable = wave.row.failed == 0 && wave.tried;
    auto const scale = usable ? spec.levels.scale(at, wave.row) : std::nullopt;
    if (scale) {
        row.scale = *scale;
        measure_scaled(spec.measures.curves, wave.motion, row);
        return row;
    }
    static_cast<Outcome&>(row) = unknown_outcome(wave.row.failed != 0 ? FailureReason::wave_failed
                                                 : !wave.tried        ? FailureReason::wave_not_accepted
                                                                      : FailureReason::wave_cannot_be_scaled);
    return row;
}

bool failed(TrialRow const& row) { return row.failure != FailureReason::none; }

Scene scene_of(CampaignSpec const& spec, PreparedWave const& wave, std::int64_t body) {
    std::size_t const number = body;
    auto const& drawn = wave.bodies.at(number);
    auto const& stated = spec.bodies.at(number);
    return {drawn.body, drawn.friction, stated.footing, stated.axes};
}

SceneTrial scaled(Scene const& scene, PreparedWave const& wave, TrialRow const& row) {
    return {scene, wave.motion, row.scale, wave.intensity.pga_mps2, &wave.chunks};
}

void close_row(CampaignSpec const& spec, TrialRow& row, PreparedWave const& wave, Response const& response,
               double peak_rise_m) {
    static_cast<Response&>(row) = response;
    auto const& drawn = wave.bodies[row.body];
    row.verdict = spec.measures.movement.verdict(response, drawn.body, drawn.friction.has_value(),
                                                 spec.bodies[row.body].footing.pad, peak_rise_m);
    auto const& measures = wave.measures.at(row.body);
    if (std::isnan(measures.v_wes_max_mps)) {
        return;
    }
    row.v_wes_mps = row.scale * measures.v_wes_max_mps;
    row.ou_v_e_mps = row.scale * measures.ou_v_e_mps;
    row.v_wes_safe = row.v_wes_mps < row.v_ereq_mps ? 1 : 0;
    row.ou_v_e_safe = row.ou_v_e_mps < row.v_ereq_mps ? 1 : 0;
}

void account(std::vector<ModelCost> const& taken, PhaseSeconds& seconds) {
    for (std::size_t r = 0; r < taken.size(); ++r) {
        seconds.models[r].trials += taken[r].trials;
        seconds.models[r].seconds += taken[r].seconds;
        seconds.response += taken[r].seconds;
    }
}

// A trial alone, but for what a site makes of it.
TrialRows answered(CampaignSpec const& spec, ModelSelector const& selector, PreparedWave const& wave, std::int64_t body,
                   std::int64_t level) {
    TrialRows trial{{open_row(spec, wave, body, level)}, std::vector<std::byte>(selector.extra_bytes())};
    auto& row = trial.rows.front();
    selector.put_defaults(trial.extra);
    if (!failed(row)) {
        auto const scene = scene_of(spec, wave, body);
        auto const response = selector.respond(scaled(scene, wave, row), trial.extra);
        close_row(spec, row, wave, response, selector.extra_value(response, "peak_rise", trial.extra));
    }
    return trial;
}

/// What answered trials.
struct Answering {
    CampaignSpec const& spec;
    ModelSelector const& selector;
    PreparedWave const& wave;
};

// The history of a trial that ran.
void show(Answering const& by, TrialRow const& row, Observer& observer) {
    if (!std::isnan(row.scale)) {
        auto const scene = scene_of(by.spec, by.wave, row.body);
        by.selector.show(scaled(scene, by.wave, row), row, observer);
    }
}

void show_in_its_room(Answering const& by, TrialRow const& row, std::optional<SiteJudge::Trial> const& neighbour,
                      Observer& observer) {
    auto const& bodies = by.spec.bodies;
    auto const& beside = neighbour ? neighbour->row : row;
    SitePath its_path(by.spec.site, bodies.at(beside.body), beside);
    if (by.spec.site.cask.any()) {
        show(by, beside, its_path);
    }
    OtherCask const other{its_path, !neighbour};
    SitePath path(by.spec.site, bodies.at(row.body), row, &observer, &other);
    show(by, row, path);
}

// Rows of waves from `first_row` on, each with its bodies and their levels: the other cask is another of these rows.
void judge_site(SiteJudge const& site, Plan const& plan, TrialRows& trials, std::size_t first_row) {
    if (!site.asked()) {
        return;
    }
    std::size_t const of_wave = plan.trials_per_wave();
    std::size_t const levels = plan.level_count();
    auto const each = trials.extra.size() / std::max<std::size_t>(1, trials.rows.size());
    auto const trial = [&](std::size_t number) {
        return SiteJudge::Trial{trials.rows[number], std::span(trials.extra).subspan(number * each, each)};
    };
    for (auto number = first_row; number < trials.rows.size(); ++number) {
        auto const place = (number - first_row) % of_wave;
        std::optional<SiteJudge::Trial> neighbour;
        if (auto const other = site.neighbour_of(trials.rows[number].body)) {
            neighbour.emplace(trial(number - place + *other * levels + place % levels));
        }
        site.fill(trials.rows[number], trial(number), neighbour);
    }
}

}  // namespace

TrialRows run_trial(CampaignSpec const& spec, PreparedWave const& wave, std::int64_t body, std::int64_t level,
                    Observer* observer) {
    ModelSelector const selector(spec.effects, spec.accuracy);
    SiteJudge const site(spec.site, spec.bodies, selector);
    auto trial = answered(spec, selector, wave, body, level);
    TrialRows other;
    std::optional<SiteJudge::Trial> neighbour;
    if (auto const number = site.neighbour_of(body)) {
        other = answered(spec, selector, wave, *number, level);
        neighbour.emplace(SiteJudge::Trial{other.rows.front(), other.extra});
    }
    if (observer != nullptr && site.asked()) {
        show_in_its_room({spec, selector, wave}, trial.rows.front(), neighbour, *observer);
    } else if (observer != nullptr) {
        show({spec, selector, wave}, trial.rows.front(), *observer);
    }
    site.fill(trial.rows.front(), {trial.rows.front(), trial.extra}, neighbour);
    return trial;
}

bool append_trials(CampaignSpec const& spec, Plan const& plan, std::span<PreparedWave const> waves, TrialRows& trials,
                   PhaseSeconds& seconds, std::function<bool()> const& keep_running, KnownTrials const* known) {
    struct Place {
        std::size_t row;
        PreparedWave const* wave;
    };
    ModelSelector const selector(spec.effects, spec.accuracy);
    std::vector<Place> places;
    std::vector<SceneTrial> tried;
    std::vector<Scene> scenes;
    auto& rows = trials.rows;
    auto const most = waves.size() * plan.trials_per_wave();
    auto const first_row = rows.size();
    places.reserve(most);
    tried.reserve(most);
    scenes.reserve(waves.size() * plan.bodies());
    rows.reserve(rows.size() + most);
    auto const each = selector.extra_bytes();
    trials.extra.resize((first_row + most) * each);
    selector.put_defaults(std::span(trials.extra).subspan(first_row * each));
    for (auto const& wave : waves) {
        auto const first_level = plan.first_level(wave.number);
        auto const first_of_wave = rows.size();
        KnownRows const known_rows(known != nullptr ? known->of(wave.number) : std::nullopt, wave.row);
        for (std::int64_t body = 0; body < plan.bodies(); ++body) {
            scenes.push_back(scene_of(spec, wave, body));
            for (auto level = first_level; level < first_level + plan.level_count(); ++level) {
                rows.push_back(open_row(spec, wave, body, level));
                auto const extra = std::span(trials.extra).subspan((rows.size() - 1) * each, each);
                if (failed(rows.back()) || known_rows.take(rows.size() - 1 - first_of_wave, rows.back(), extra)) {
                    continue;
                }
                places.push_back({rows.size() - 1, &wave});
                tried.push_back(scaled(scenes.back(), wave, rows.back()));
            }
        }
    }
    // A second's work or less but for trials on points, which take long enough to be asked for one by one: some waves
    // have tens of thousands of levels.
    constexpr std::size_t most_at_once = 4096;
    struct TimeToGo {};
    auto const leave_in_time = [&] {
        if (!keep_running()) {
            throw TimeToGo();
        }
    };
    std::vector<Response> responses(std::min(most_at_once, tried.size()));
    std::vector<std::byte> extra(responses.size() * each);
    for (std::size_t first = 0; first < tried.size(); first += most_at_once) {
        if (first > 0 && !keep_running()) {
            return false;
        }
        auto const count = std::min(most_at_once, tried.size() - first);
        try {
            account(selector.respond(std::span(tried).subspan(first, count), std::span(responses).first(count),
                                     std::span(extra).first(count * each), leave_in_time),
                    seconds);
        } catch (TimeToGo const&) {
            return false;
        }
        for (std::size_t i = 0; i < count; ++i) {
            auto const& [row, wave] = places[first + i];
            double const rise_m =
                selector.extra_value(responses[i], "peak_rise", std::span(extra).subspan(i * each, each));
            close_row(spec, rows[row], *wave, responses[i], rise_m);
            std::copy_n(extra.begin() + (i * each), each, trials.extra.begin() + (row * each));
        }
    }
    judge_site(SiteJudge(spec.site, spec.bodies, selector), plan, trials, first_row);
    return true;
}

std::int64_t waves_together(Plan const& plan) {
    constexpr std::int64_t most_trials = 256;
    return std::max<std::int64_t>(1, most_trials / plan.trials_per_wave());
}

}  // namespace overturn
