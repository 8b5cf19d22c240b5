/// The models that there are, and what they bring: effects, verdicts, quantities of their own.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "config/registry.hpp"
#include "model/model.hpp"
#include "response/accuracy.hpp"

namespace overturn {

struct ModelEntry {
    ModelTraits const& (*traits)();
    std::unique_ptr<Model> (*make)(Accuracy const&);
};

/// From the cheapest to the dearest: a trial runs on the first one that holds the effects it needs.
[[nodiscard]] std::span<ModelEntry const> models();

/// The effects that can be simulated, each with the line that `overturn list` prints.
[[nodiscard]] std::span<config::Entry<Effect> const> effects();

/// "1 vertical, 2 sliding": what the bits of an EffectMask mean.
[[nodiscard]] std::string effect_bits();

/// The common verdicts and those of the models.
[[nodiscard]] std::span<VerdictEntry const> verdicts();
/// \pre one of verdicts()
[[nodiscard]] VerdictEntry const& entry_of(Verdict verdict);
[[nodiscard]] std::vector<Category> verdict_categories();

/// Names of the models in results: "at-rest", where the cheapest model had nothing to follow, else the model's name.
[[nodiscard]] std::span<Category const> model_categories();
/// Why a trial may need a model: none, if the cheapest one does; stated, if the campaign says so; else the models' own.
[[nodiscard]] std::span<ReasonEntry const> reasons();
[[nodiscard]] std::vector<Category> reason_categories();

/// Place of a stored model in model_categories().
[[nodiscard]] std::size_t model_place(std::int64_t model);

}  // namespace overturn
