#include "rocking/rocking_models.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "body/response_velocity.hpp"
#include "core/error.hpp"
#include "rocking/detail/block_laws.hpp"
#include "rocking/detail/checkpoint.hpp"

namespace overturn {
namespace {

constexpr std::array vertical_effect{EffectEntry{
    Effect::vertical, "vertical", "vertical motion changes gravity; required by a wave with a vertical component"}};
constexpr std::array sliding_effect{EffectEntry{Effect::sliding, "sliding",
                                                "Coulomb stick-slip, slide-rocking, slip at impacts; required where "
                                                "motion without slip needs more friction than the static coefficient"}};

constexpr std::array sliding_reasons{
    ReasonEntry{2, "friction-demand", "motion without slip needs more friction than the static coefficient"}};

constexpr std::array channels{Channel{"time_s"},
                              Channel{"rotation_rad"},
                              Channel{"velocity_radps"},
                              Channel{"friction_over_weight"},
                              Channel{"contact_force_over_weight"},
                              Channel{"slip_m"},
                              Channel{"slip_velocity_mps"},
                              Channel{"x_m"},
                              Channel{"edge_x_most_m"},
                              Channel{"edge_x_least_m"},
                              Channel{"top_x_m"}};

struct SlipCheckpoints : Checkpoints {
    std::vector<rocking::Checkpoint> at;
};

RockingTrial rocking_trial(Trial const& trial) {
    return {block_of(*trial.body, trial.friction), planar_excitation(trial), {trial.body->initial_tilt_rad(), 0}};
}

// On its corner, slipping on it, or in flight.
void fill_landing(RockingOutcome const& rocking, RigidBody const& body, Outcome& outcome) {
    if (outcome.verdict != Verdict::overturned) {
        return;
    }
    double const b = body.lopsided() ? body.corner(rocking.peak_side).half_width_m : body.half_width_m();
    double const h = body.centre_height_m();
    double const spin = outcome.landing_spin_radps;
    bool const flew = !std::isnan(rocking.flight_along_mps);
    double const along = flew ? rocking.flight_along_mps : spin * b + rocking.landing_slip_mps;
    double const down = flew ? rocking.flight_down_mps : spin * h;
    outcome.landing_velocity_mps = std::hypot(along, down);
    outcome.landing_top_mps = std::hypot(along, down + spin * h);
    double const speed = outcome.landing_velocity_mps;
    outcome.landing_energy_jpkg = 0.5 * (speed * speed + body.inertia_kgm2() / body.mass_kg() * spin * spin);
}

// What the kernel does not know: the body behind the block.
void conclude(RockingOutcome const& rocking, Trial const& trial, EffectMask required, Outcome& outcome) {
    outcome = static_cast<Outcome const&>(rocking);
    outcome.peak_rotation_ratio = rocking.peak_reach_rad / trial.body->alpha_rad();
    outcome.friction_work_jpkg = rocking.energy.friction_work;
    outcome.peak_impact_velocity_mps = 2 * trial.body->half_width_m() * rocking.impact_spin_radps;
    outcome.response_velocity_mps = response_velocity(*trial.body, rocking.peak_rotation_rad, rocking.peak_side);
    outcome.required = required;
    fill_landing(rocking, *trial.body, outcome);
}

// About its corner a body's top goes b (1 - cos theta) + 2 h sin theta. Slip and rotation need not peak at once, nor
// does the corner that was nearer to falling move the top farther: their largest together are never less.
double farthest_top(RockingOutcome const& rocking, RigidBody const& body) {
    auto const way = [&](double half_width_m, double rotation_rad) {
        double const theta = std::min(rotation_rad, rocking::overturned_rad);
        return half_width_m * (1 - std::cos(theta)) + 2 * body.centre_height_m() * std::sin(theta);
    };
    double top = way(body.half_width_m(), rocking.peak_rotation_rad);
    if (body.lopsided()) {
        for (double const side : {-1.0, 1.0}) {
            auto const& corner = body.corner(side);
            double const rotation = rocking.peak_reach_rad * corner.alpha_rad / body.alpha_rad();
            top = std::max(top, way(std::max(corner.half_width_m, body.half_width_m()), rotation));
        }
    }
    return top + rocking.peak_slip_m;
}

RigidQuantities quantities_of(RockingOutcome const& rocking, RigidBody const& body, Outcome const& outcome,
                              bool slips) {
    RigidQuantities all;
    all.rotation_at_peak_rad = std::copysign(rocking.peak_rotation_rad, rocking.peak_side);
    bool const unfollowed = !slips && has(static_cast<EffectMask>(outcome.required), Effect::sliding);
    if (unfollowed || !std::isnan(outcome.contact_lost_s) || outcome.verdict == Verdict::contact_lost
        || outcome.verdict == Verdict::failed) {
        return all;
    }
    all.edge_x_most_m = body.half_width_m() + rocking.most_slip_m;
    all.edge_x_least_m = rocking.least_slip_m - body.half_width_m();
    all.residual_x_m = outcome.verdict == Verdict::overturned ? never : rocking.residual_slip_m;
    all.peak_top_m = farthest_top(rocking, body);
    return all;
}

void put_quantities(Batch const& batch, std::size_t i, RigidQuantities const& quantities) {
    if (!batch.extra.empty()) {
        constexpr std::size_t row = sizeof(RigidQuantities);
        std::memcpy(batch.extra.subspan(i * row, row).data(), &quantities, row);
    }
}

/// Instants of the kernel as rows of channels.
class Shown : public RockingObserver {
  public:
    Shown(Observer& observer, RigidBody const& body) : observer_(observer), body_(body) {}
    void at(RockingInstant const& i) override {
        auto const [x_m, most_m, least_m, top_m] = place_of(i);
        observer_.at(std::array{i.time_s, i.rotation_rad, i.velocity_radps, i.friction_ratio, i.contact_force_ratio,
                                i.slip_m, i.slip_velocity_mps, x_m, most_m, least_m, top_m});
    }

  private:
    // Of the base's centre, its edges and the top: not known in flight.
    [[nodiscard]] std::array<double, 4> place_of(RockingInstant const& i) const {
        double const side = i.rotation_rad < 0 ? -1 : 1;
        if (i.contact_force_ratio == 0 && std::abs(i.rotation_rad) > body_.corner(side).alpha_rad) {
            return {never, never, never, never};
        }
        bool const lopsided = body_.lopsided();
        double const leant_on_m = lopsided ? body_.corner(side).half_width_m : body_.half_width_m();
        double const other_m = lopsided ? body_.corner(-side).half_width_m : body_.half_width_m();
        double const cosine = std::cos(i.rotation_rad);
        double const edge_m = i.slip_m + side * leant_on_m;
        double const far_m = edge_m - side * (leant_on_m + other_m) * cosine;
        double const axis_m = edge_m - side * leant_on_m * cosine;
        return {axis_m, std::max(edge_m, far_m), std::min(edge_m, far_m),
                axis_m + 2 * body_.centre_height_m() * std::sin(i.rotation_rad)};
    }

    Observer& observer_;
    RigidBody const& body_;
};

class RockingModel : public Model {
  public:
    explicit RockingModel(RockingAccuracy const& accuracy) : accuracy_(accuracy) {}
    [[nodiscard]] ModelTraits const& traits() const override { return rocking_traits(); }
    [[nodiscard]] EffectMask possible(Trial const& trial) const override {
        return trial.excitation.vertical_mps2.empty() ? 0 : mask_of(Effect::vertical);
    }
    [[nodiscard]] Requirement required_of(Trial const& trial, Outcome const* /*earlier*/) const override {
        return {possible(trial)};
    }

    [[nodiscard]] std::unique_ptr<Checkpoints> run(Batch const& batch) const override {
        if (batch.observer != nullptr) {
            show(batch);
            return nullptr;
        }
        auto checkpoints = std::make_unique<SlipCheckpoints>();
        checkpoints->at.resize(batch.trials.size());
        run_batch_with(batch, Slip::ignored, checkpoints->at);
        run_batch_with(batch, Slip::detected, checkpoints->at);
        return checkpoints;
    }

  private:
    static Slip slip_of(Trial const& trial) {
        return trial.friction && has(trial.handled_later, Effect::sliding) ? Slip::detected : Slip::ignored;
    }
    static void conclude_one(RockingOutcome const& rocking, Trial const& trial, Outcome& outcome) {
        bool const slips = slip_of(trial) == Slip::detected
                               ? rocking.slip_onset
                               : trial.friction && rocking.friction_demand > trial.friction->static_coefficient;
        conclude(rocking, trial, slips ? mask_of(Effect::sliding) : 0, outcome);
    }

    // All trials that look at friction in the same way, side by side.
    void run_batch_with(Batch const& batch, Slip slip, std::vector<rocking::Checkpoint>& checkpoints) const {
        std::vector<std::size_t> which;
        std::vector<RockingTrial> trials;
        which.reserve(batch.trials.size());
        trials.reserve(batch.trials.size());
        for (std::size_t i = 0; i < batch.trials.size(); ++i) {
            if (slip_of(batch.trials[i]) == slip) {
                which.push_back(i);
                trials.push_back(rocking_trial(batch.trials[i]));
            }
        }
        std::vector<RockingOutcome> outcomes(trials.size());
        std::vector<rocking::Checkpoint> stopped(slip == Slip::detected ? trials.size() : 0);
        if (slip == Slip::detected) {
            simulate_until_slip(trials, accuracy_, outcomes, stopped);
        } else {
            simulate_rocking(trials, accuracy_, slip, outcomes);
        }
        for (std::size_t i = 0; i < which.size(); ++i) {
            auto const& trial = batch.trials[which[i]];
            conclude_one(outcomes[i], trial, batch.outcomes[which[i]]);
            put_quantities(batch, which[i], quantities_of(outcomes[i], *trial.body, batch.outcomes[which[i]], false));
            if (slip == Slip::detected) {
                checkpoints[which[i]] = stopped[i];
            }
        }
    }

    void show(Batch const& batch) const {
        OVERTURN_EXPECT(batch.trials.size() == 1);
        auto const& trial = batch.trials.front();
        auto const [block, shaking, start] = rocking_trial(trial);
        Shown shown(*batch.observer, *trial.body);
        conclude_one(simulate_rocking(block, shaking, accuracy_, start, &shown, slip_of(trial)), trial,
                     batch.outcomes.front());
    }

    RockingAccuracy accuracy_;
};

class SlidingModel : public Model {
  public:
    explicit SlidingModel(RockingAccuracy const& accuracy) : accuracy_(accuracy) {}
    [[nodiscard]] ModelTraits const& traits() const override { return sliding_traits(); }
    [[nodiscard]] EffectMask possible(Trial const& trial) const override {
        return trial.friction ? mask_of(Effect::sliding) : 0;
    }

    [[nodiscard]] std::unique_ptr<Checkpoints> run(Batch const& batch) const override {
        auto const* const stopped = dynamic_cast<SlipCheckpoints const*>(batch.before);
        std::optional<Shown> shown;
        if (batch.observer != nullptr) {
            OVERTURN_EXPECT(batch.trials.size() == 1);
            shown.emplace(*batch.observer, *batch.trials.front().body);
        }
        for (std::size_t i = 0; i < batch.trials.size(); ++i) {
            auto const& trial = batch.trials[i];
            auto const rocking = rocking_trial(trial);
            auto const* const checkpoint = stopped == nullptr ? nullptr : &stopped->at.at(batch.places[i]);
            auto const outcome = checkpoint != nullptr && checkpoint->reached && !shown
                                     ? resume_sliding(rocking, accuracy_, *checkpoint)
                                     : simulate_rocking(rocking.block, rocking.shaking, accuracy_, rocking.start,
                                                        shown ? &*shown : nullptr, Slip::simulated);
            bool const asked = has(static_cast<EffectMask>(batch.outcomes[i].required), Effect::sliding);
            bool const required = asked || outcome.peak_slip_m > 0;
            conclude(outcome, trial, required ? mask_of(Effect::sliding) : 0, batch.outcomes[i]);
            put_quantities(batch, i, quantities_of(outcome, *trial.body, batch.outcomes[i], true));
        }
        return nullptr;
    }

  private:
    RockingAccuracy accuracy_;
};

}  // namespace

template <> Fields const& fields_of<RigidQuantities>() {
    using Q = RigidQuantities;
    static Fields const fields{
        field<&Q::edge_x_most_m>("edge_x_most", "m",
                                 "largest x of the base's edges, from the initial axis; a raised edge counts as laid "
                                 "down"),
        field<&Q::edge_x_least_m>("edge_x_least", "m", "the same towards -x, negative"),
        field<&Q::residual_x_m>("residual_x", "m", "x of the base's centre at the end; NaN: it fell"),
        field<&Q::peak_top_m>(
            "peak_top", "m",
            "largest displacement of the top in plan: on the axis, at twice the height of the centre of "
            "gravity; where it slips or its corners differ, at most that"),
        field<&Q::rotation_at_peak_rad>("rotation_at_peak", "rad",
                                        "peak rotation with its sign: above 0 towards +x; pi/2 if it fell that way")};
    return fields;
}

ModelTraits const& rocking_traits() {
    static ModelTraits const traits{.name = "rocking",
                                    .number = 1,
                                    .holds = mask_of(Effect::vertical),
                                    .effects = vertical_effect,
                                    .channels = channels,
                                    .fields = fields_of<RigidQuantities>(),
                                    .default_row = default_row_of<RigidQuantities>()};
    return traits;
}

ModelTraits const& sliding_traits() {
    static ModelTraits const traits{.name = "sliding",
                                    .number = 2,
                                    .holds = mask_of(Effect::vertical) | mask_of(Effect::sliding),
                                    .always = mask_of(Effect::sliding),
                                    .effects = sliding_effect,
                                    .reasons = sliding_reasons,
                                    .channels = channels,
                                    .fields = fields_of<RigidQuantities>(),
                                    .default_row = default_row_of<RigidQuantities>()};
    return traits;
}

std::unique_ptr<Model> make_rocking_model(RockingAccuracy const& accuracy) {
    return std::make_unique<RockingModel>(accuracy);
}

std::unique_ptr<Model> make_sliding_model(RockingAccuracy const& accuracy) {
    return std::make_unique<SlidingModel>(accuracy);
}

RockingBlock block_of(RigidBody const& body, std::optional<Friction> const& friction) {
    RockingBlock block{.alpha_rad = body.alpha_rad(),
                       .p_radps = body.p_radps(),
                       .restitution = body.restitution(),
                       .inertia_ratio = body.inertia_ratio(),
                       .gravity_mps2 = body.gravity_mps2()};
    if (body.lopsided()) {
        auto const corner_of = [](Corner const& c) {
            return RockingCorner{c.alpha_rad, c.base_angle_rad, c.p_radps, c.restitution, c.inertia_ratio};
        };
        block.lopsided = Lopsided{body.slope_rad(), {corner_of(body.corner(1)), corner_of(body.corner(-1))}};
    }
    if (friction) {
        block.friction_static = friction->static_coefficient;
        block.friction_kinetic = friction->kinetic_coefficient;
    }
    return block;
}

}  // namespace overturn
