/// Limit states of a campaign: a name and a rule that every trial's stored row passes, keeps within, or leaves open.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/rows.hpp"
#include "response/model_selector.hpp"
#include "stats/fragility.hpp"
#include "stats/intensity_unit.hpp"
#include "stats/precision.hpp"

namespace overturn {

/// A stored response that a limit may be set to. Compared is its magnitude, unless its sign counts.
struct LimitQuantity {
    std::string name;   ///< of the column: "peak_slip"
    std::string units;  ///< "m"
    std::string description;
    /// Effects that a model needs to compute it: where one of them would have acted and was not simulated, the quantity
    /// is unknown.
    EffectMask needs = 0;
    bool of_every_model = true;  ///< else one of those that only some models know (ModelTraits::fields)
    bool is_signed = false;      ///< compared is not its magnitude: less is worse, below 0 too

    /// Is it a property of the landing of a body that has overturned? A fall passes such a limit by its value only.
    [[nodiscard]] bool is_of_the_fall() const { return name.starts_with("landing_"); }
};

/// All of them: what every model answers, then what contact and spatial add. Times and properties of the base are none.
[[nodiscard]] std::span<LimitQuantity const> limit_quantities();

struct LimitState {
    enum class Rule { overturning, above, below, any, all };

    std::string name;
    Rule rule = Rule::overturning;
    LimitQuantity quantity;  ///< of above and below
    double threshold = 0;    ///< likewise [SI]
    IntensityUnit shown;     ///< that the threshold was written in; no symbol: in none
    /// A trial that overturned has passed a limit of above or below, whatever it did before. Otherwise its response up
    /// to the fall is compared, and the definition says "without overturning".
    bool falls_pass = true;
    std::vector<std::size_t> of;  ///< of any and all: places in the campaign's list, all before this one's
    PrecisionTarget target;       ///< met, together with all others, before all waves are done, it ends the campaign

    [[nodiscard]] bool is_overturning() const { return rule == Rule::overturning; }
    /// "30 cm" as it was written; an angle that was not in degrees has them beside it: "0.349 rad = 20 deg".
    [[nodiscard]] std::string threshold_text() const;
    /// Verb for a passed limit in texts of fits.
    [[nodiscard]] Passing passing() const { return is_overturning() ? Passing::overturned : Passing::exceeded; }
};

/// Suffix of a limit state that a fall alone does not pass.
inline constexpr std::string_view without_overturning = " without overturning";

/// The name of the one that is always there, the first; those of [site], which are there with it.
inline constexpr char const* overturning_limit = "overturning";
inline constexpr char const *touching_limit = "touches", *leaving_limit = "leaves-the-pad";

/// Name of a limit state in results: "touches"; where a fall alone does not pass it "touches without overturning".
[[nodiscard]] std::string full_name(LimitState const& limit, std::span<LimitState const> limits);

/// "peak_slip > 30 cm"; "peak_slip > 30 cm without overturning"; "any of touches, overturning".
[[nodiscard]] std::string definition_of(LimitState const& limit, std::span<LimitState const> limits);

/// Outcome of one trial for all limit states: a bit each, in their order.
struct LimitOutcomes {
    std::uint32_t decided = 0;  ///< it is known whether the trial passed
    std::uint32_t passed = 0;   ///< never set where not decided

    [[nodiscard]] bool is_decided(std::size_t limit) const { return (decided >> limit & 1U) != 0; }
    [[nodiscard]] bool has_passed(std::size_t limit) const { return (passed >> limit & 1U) != 0; }
};
inline constexpr std::size_t most_limits = 32;

/// Holds rows to the limit states. A trial without a verdict decides none of them; one whose quantity is unknown
/// decides none that depends on it. `any` is passed as soon as one is, `all` is kept as soon as one is.
class LimitJudge {
  public:
    /// \param limits outlive it
    LimitJudge(std::span<LimitState const> limits, ModelSelector const& selector);

    /// \param own the record of what models have to say of their own; empty: unknown
    [[nodiscard]] LimitOutcomes judge(TrialRow const& row, std::span<std::byte const> extra) const;
    /// Ratio of the response to the limit, continuous [-]: at least 1 where the trial passed, at most 1 where it did
    /// not. It is the magnitude over its threshold (inverse for `below`), the largest of `any`, the smallest of `all`,
    /// the tilt over alpha for overturning. NaN where it is unknown.
    [[nodiscard]] double nearness(std::size_t limit, TrialRow const& row, std::span<std::byte const> extra) const;
    /// Does any limit depend on such a record?
    [[nodiscard]] bool reads_extra() const;

  private:
    struct Own {
        std::size_t limit;
        std::int64_t model;
        Field field;  ///< its offset is that in the record
    };
    [[nodiscard]] double value_of(std::size_t limit, TrialRow const& row, std::span<std::byte const> extra) const;

    std::span<LimitState const> limits_;
    std::vector<Field const*> columns_;  ///< of /trials, one a limit; null where it reads none
    std::vector<Own> extra_;
};

}  // namespace overturn
