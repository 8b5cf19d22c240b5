/// The baseline of recorded motions, corrected as data centres do it: what instrument and digitiser have added to the
/// ground's motion is taken off. Without it an offset of some gal becomes hundreds of kine of PGV.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "config/table.hpp"
#include "motion/ground_motion.hpp"

namespace overturn {

enum class BaselineMethod {
    none,
    mean,        ///< the mean acceleration is taken off
    polynomial,  ///< and then the second derivative of the polynomial that fits the displacement
    high_pass    ///< and what lies below a corner frequency
};

/// A causal filter keeps what precedes a phase quiet and shifts phases; a zero-phase one does neither.
enum class FilterPhase { zero, causal };

struct RecordBaseline {
    BaselineMethod method = BaselineMethod::none;
    double corner_hz = 0;  ///< of the high-pass [Hz]
    int order = 4;         ///< of the Butterworth filter
    FilterPhase phase = FilterPhase::zero;

    /// "high-passed at 0.05 Hz (Butterworth, order 4, zero phase)"; empty for none.
    [[nodiscard]] std::string says() const;
};

/// The key `baseline`, and its table where that states a high-pass.
extern config::KeyTable const high_pass_table;
inline constexpr config::Key baseline_key =
    config::text_key("baseline", R"(none, mean, polynomial, "high-pass 0.05 Hz", or a table of the high-pass)")
        .or_as(config::table_key<high_pass_table>("baseline", ""))
        .optional();

/// Nothing is corrected where the key is absent. \throws InputError at the key
[[nodiscard]] RecordBaseline read_baseline(config::Table const& table);

/// The same from one text. \throws InputError without a place
[[nodiscard]] RecordBaseline parse_baseline(std::string_view text);

/// Corrects every component of a motion in place; its length stays.
/// - polynomial: after the mean, c2 t^2 + ... + c6 t^6 fitted to the displacement by least squares (PEER NGA-West2,
///   Ancheta et al. 2013: no constant and no slope, as the ground begins at rest), and here with the motion's own end
///   velocity, so that it ends at rest: a record cut off while it shook would otherwise keep some of it.
/// - high_pass: after the mean, Butterworth. Zero phase has the response 1 / (1 + (corner / f)^(2 order)), forwards and
///   backwards, in zero pads of 1.5 order / corner seconds at either end (Boore 2005); causal has the filter's own. As
///   the motion is cut out of its pads, the polynomial is taken off after it (Boore et al. 2012).
/// \throws InputError if the corner is below 0.001 Hz or 1 / duration, or not below a quarter of the sampling frequency
void correct_record(GroundMotion& motion, RecordBaseline const& baseline);

/// Corrects the baseline, and describes the correction and its effect on each component: "mean taken off (PGA +0.2 %,
/// PGV -31 %, PGD -97 %, Sa from 0.3 to 10 s by -12 % at most)". Empty for none.
[[nodiscard]] std::string correct_and_tell(GroundMotion& motion, RecordBaseline const& baseline);

}  // namespace overturn
