/// Basis of the values given to a campaign: measured, published, assumed. Assumptions of the model itself are in
/// model_assumptions.hpp.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "config/input_value.hpp"

namespace overturn {

inline constexpr std::string_view beta_u_key = "statistics.beta_u";

/// The inputs that move the answer: those of [waves], [[bodies]], [levels], [site] and [[limits]], beta_U and the
/// hazard curve. Stated values, defaults of this program, and keys of which the campaign says that their absence is
/// assumed. Not among them: names, the motions that are read (the pages list them), how much is computed and how
/// finely, a key of a body's file that one beside the file outranks, and what no model reads that the campaign may run.
[[nodiscard]] std::vector<config::InputValue> physical_inputs(CampaignSpec const& spec);

/// Number of inputs by their basis.
struct InputTally {
    std::int64_t assumed = 0, published = 0, measured = 0, not_stated = 0, by_default = 0;

    [[nodiscard]] std::int64_t all() const { return assumed + published + measured + not_stated + by_default; }
};
[[nodiscard]] InputTally tally_of(std::span<config::InputValue const> inputs);
/// Was the campaign's beta_U assumed?
[[nodiscard]] bool is_beta_u_assumed(CampaignSpec const& spec);
/// "12 of 30 inputs are assumed, 9 published, 0 measured, 2 not stated, 7 defaults of this program"
[[nodiscard]] std::string text_of(InputTally const& tally);
/// "3 of 26 inputs are assumed (bodies.inertia, levels.design_basis, 1 more key), 4 without a source": the keys, of all
/// bodies together, as far as a line holds them.
[[nodiscard]] std::string assumed_text(std::span<config::InputValue const> inputs);

}  // namespace overturn
