/// Text of the answer's cells.
#pragma once

#include <string>
#include <string_view>

#include "output/answer.hpp"

namespace overturn::output {

/// "0 of 1", where no probability follows.
[[nodiscard]] std::string passed_text(Stripe const& stripe);

/// "12.0 / 55.1 (<= 71.3)": median and 95th percentile, and the upper end of that one's interval; "<0.1" where all of
/// it is below `least`; "(open)" where there is no such end. \param at null: not simulated \param unit of the response,
/// in that of `at`
[[nodiscard]] std::string percentiles_text(LevelQuantiles const* at, double unit, double least);

/// Behind a 95th percentile that too few waves give no upper end.
inline constexpr std::string_view no_upper_end = " (open)";

/// "0.0136 [0.012, 0.0153]", or "< 1.2e-05" where the estimate is but a bound.
[[nodiscard]] std::string rare_text(rare::Estimate const& estimate);

/// ">= 510 gal (estimate 540 gal)": the 5 % point, or why there is none.
[[nodiscard]] std::string five_percent_text(MeasuredFragility const& curve);

/// What the cell of HCLPF adds.
struct HclpfWords {
    bool low_point = true;        ///< the 5 % point where beta_U is missing
    bool beta_u = true;           ///< what is stated of beta_U
    bool beta_u_assumed = false;  ///< the campaign's beta_U, by which it is known
};
/// ">= 380 gal (estimate 420 gal); by beta_U 0.3, assumed", or why there is none.
[[nodiscard]] std::string hclpf_text(MeasuredFragility const& curve, HclpfWords words);

/// "3.8e-08 to 5.9e-08 a year"; "> 3.8e-08 a year" where beta_U, which raises it, is not known.
[[nodiscard]] std::string frequency_words(BodyFrequency const& f);
/// The one number of it that is safest: "<= 5.9e-08 a year", at 95 % confidence.
[[nodiscard]] std::string frequency_in_short(BodyFrequency const& f);

}  // namespace overturn::output
