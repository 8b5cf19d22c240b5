/// Selection of the effects that a scene needs, and the response of the body: body + motion + effects -> Response.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "body/rigid_body.hpp"
#include "model/model.hpp"
#include "motion/ground_motion.hpp"
#include "response/accuracy.hpp"
#include "response/effects.hpp"
#include "response/registry.hpp"
#include "response/response.hpp"

namespace overturn {

/// A body as it stands: what does not change from wave to wave.
struct Scene {
    RigidBody const& body;
    std::optional<Friction> friction;  ///< empty: no slip
    Footing const& footing = on_corners();
    int axes = 3;  ///< that shake it: 1 the horizontal one, 2 both horizontal ones, 3 the vertical one too

    /// A square base on its corners, on the usual pad.
    [[nodiscard]] static Footing const& on_corners();
};

/// One trial of many.
struct SceneTrial {
    Scene const& scene;
    GroundMotion const& motion;
    double scale = 1;                                            ///< multiplies every component of the motion
    double peak_mps2 = std::numeric_limits<double>::infinity();  ///< largest |horizontal| of the motion, if known
    ChunkExtremes const* chunks = nullptr;                       ///< of the motion, if at hand
};

/// Trials that ended on a model, and the seconds they took on their way to it. Trials run side by side: the time of a
/// model is shared out evenly among those that it ran.
struct ModelCost {
    std::int64_t trials = 0;
    double seconds = 0;
};

/// Place of a model's extra quantities in the record of a trial.
struct ExtraPart {
    ModelTraits const* traits = nullptr;
    std::size_t offset = 0;  ///< of its row [bytes]
};

/// The models in order of their cost. A trial begins on the first one that supports the effects it is known to need.
/// Where an answer requires effects that its model leaves out, the trial goes on with the first model that supports
/// them too, until one supports all effects that are required and wanted. Where effects are forced, the first model
/// does. Where no model supports all required effects together, those of dearer models are left out: Outcome::called
/// has them, Response::effects lacks them, and the reason is `left_out_reason`.
class ModelSelector {
  public:
    /// \throws InputError if effects are forced that no model supports together
    explicit ModelSelector(EffectRequest const& request, Accuracy const& accuracy = {},
                           std::span<ModelEntry const> entries = models());

    /// Many trials from rest, those of a model side by side: responses[i] and its record are those of trials[i] alone,
    /// bit for bit. \param extra records of extra_bytes() each, or empty \return what every model took, in the order of
    /// model_categories() \param before_each called before every trial that takes long; what it throws ends them all
    [[nodiscard]] std::vector<ModelCost> respond(std::span<SceneTrial const> trials, std::span<Response> responses,
                                                 std::span<std::byte> extra = {},
                                                 std::function<void()> const& before_each = {}) const;
    [[nodiscard]] Response respond(SceneTrial const& trial, std::span<std::byte> extra = {}) const;

    /// Shows the history of a trial on the model that gave `response`; of one that no model ran, its channels alone.
    void show(SceneTrial const& trial, Response const& response, Observer& observer) const;

    /// Effects that this trial requires from the start and that no model supports beside the others that it requires.
    [[nodiscard]] EffectMask left_out(SceneTrial const& trial) const;
    /// Forced effects that no model can simulate of this body, whatever shakes it: slip without friction.
    [[nodiscard]] EffectMask impossible(Scene const& scene) const;

    /// Models that may run here and have extra quantities.
    [[nodiscard]] std::vector<ExtraPart> const& extra_parts() const { return extra_parts_; }
    [[nodiscard]] std::size_t extra_bytes() const { return extra_bytes_; }
    /// What the model that answered says of its own by this name; NaN: nothing. \param own a record of extra_bytes()
    [[nodiscard]] double extra_value(Response const& response, std::string_view name,
                                     std::span<std::byte const> extra) const;
    /// Records of trials that no model has run: they say nothing. \param extra as many as it holds
    void put_defaults(std::span<std::byte> extra) const;

  private:
    struct TrialState;
    [[nodiscard]] TrialState begin(SceneTrial const& at) const;
    [[nodiscard]] std::size_t cheapest(EffectMask needed) const;
    [[nodiscard]] EffectMask supported_with(EffectMask simulated, EffectMask more) const;
    struct Ended;
    void run(std::size_t model, std::size_t from, std::vector<TrialState>& states, std::span<std::byte> extra,
             std::function<void()> const& before_each, Ended& ended) const;
    void go_on(std::size_t model, TrialState& state) const;
    [[nodiscard]] EffectMask left_out(TrialState const& state) const;
    [[nodiscard]] std::int64_t reason_of(TrialState const& state) const;
    [[nodiscard]] Response conclude(TrialState const& state) const;

    EffectRequest request_;
    std::vector<std::unique_ptr<Model>> models_;
    std::vector<ExtraPart> extra_parts_;
    std::size_t extra_bytes_ = 0;
};

}  // namespace overturn
