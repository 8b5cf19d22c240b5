/// A model of what a body does under a motion. Models know nothing of each other; which of them a trial needs is
/// decided by the effects that they hold (response/model_selector.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/field.hpp"
#include "model/effect.hpp"
#include "model/history.hpp"
#include "model/outcome.hpp"
#include "model/requirement.hpp"
#include "model/trial.hpp"

namespace overturn {

/// Properties of a model: its effects, verdicts, reasons and stored quantities.
struct ModelTraits {
    std::string_view name;                        ///< "sliding"
    std::int64_t number = 0;                      ///< in results files, from 1: never renumber
    EffectMask holds = 0;                         ///< effects that it can simulate
    EffectMask always = 0;                        ///< those of them that it cannot leave out
    std::span<EffectEntry const> effects = {};    ///< those that it brings: cheaper models lack them
    std::span<VerdictEntry const> verdicts = {};  ///< its own, beside the common ones
    std::span<ReasonEntry const> reasons = {};    ///< why it may be called for
    std::span<Channel const> channels = {};       ///< of its histories
    Fields fields = {};                           ///< its own quantities, stored in a group of its name
    std::vector<std::byte> default_row = {};      ///< a row of these for a trial that the model did not run
    /// Quantities that every model else computes and this one does not: NaN.
    std::span<std::string_view const> lacks = {};

    [[nodiscard]] EffectMask brings() const;
    /// \param common whether each model has this quantity, unless it lacks it; else it is one of `fields`
    [[nodiscard]] bool computes(std::string_view quantity, bool common) const;
};

/// The bytes of a default row.
template <class Row> [[nodiscard]] std::vector<std::byte> default_row_of() {
    Row const row{};
    auto const bytes = bytes_of(row);
    return {bytes.begin(), bytes.end()};
}

/// States of a batch's trials where a model ended them early, for a later model that can go on from them.
class Checkpoints {
  public:
    Checkpoints() = default;
    Checkpoints(Checkpoints const&) = delete;
    Checkpoints& operator=(Checkpoints const&) = delete;
    Checkpoints(Checkpoints&&) = delete;
    Checkpoints& operator=(Checkpoints&&) = delete;
    virtual ~Checkpoints() = default;
};

/// Trials to be run at once.
struct Batch {
    std::span<Trial const> trials;
    std::span<Outcome> outcomes;  ///< one per trial; on entry the outcome of the model before, if any
    /// Rows of the model's own fields, one per trial, contiguous; empty if not requested.
    std::span<std::byte> extra = {};
    Checkpoints const* before = nullptr;       ///< of the model that ran before
    std::span<std::size_t const> places = {};  ///< of these trials in that model's batch
    Observer* observer = nullptr;              ///< of a batch of one, which is then run from its start
    /// Called before every trial by models whose trials take long; what it throws ends the batch.
    std::function<void()> before_each = {};
};

class Model {
  public:
    Model() = default;
    Model(Model const&) = delete;
    Model& operator=(Model const&) = delete;
    Model(Model&&) = delete;
    Model& operator=(Model&&) = delete;
    virtual ~Model() = default;

    [[nodiscard]] virtual ModelTraits const& traits() const = 0;
    /// Effects that this model adds and that such a trial can have at all. Default: all.
    [[nodiscard]] virtual EffectMask possible(Trial const& trial) const;
    /// Effects that this model adds and that would act on a trial. \param earlier outcome of a cheaper model that ran;
    /// null: none ran yet. Default: the effects that this outcome itself requires.
    [[nodiscard]] virtual Requirement required_of(Trial const& trial, Outcome const* earlier) const;
    /// Fills the batch's outcomes. Where the trials' order or company changes, no bit does.
    [[nodiscard]] virtual std::unique_ptr<Checkpoints> run(Batch const& batch) const = 0;
};

}  // namespace overturn
