/// At which amplitudes of one shaking a block overturns: every range of them, since a stronger shaking may spare it.
#pragma once

#include <vector>

#include "rocking/planar_rocking.hpp"

namespace overturn {

/// Fate of a block at some amplitude.
enum class Fate {
    stands,
    after_impact,    ///< overturns over a corner that an impact led it to
    without_impact,  ///< overturns over the corner on which it uplifted first
    undecided        ///< it left the ground, or could not be followed
};

/// "stands", "overturns-with-impact", "overturns-without-impact", "undecided".
[[nodiscard]] char const* name_of(Fate fate);

/// Amplitudes of one fate, as factors on the shaking. The next range begins where this one ends; the last one ends with
/// the scan.
struct FateRange {
    Fate fate = Fate::stands;
    double from = 0, to = 0;
};

/// Grid of the amplitudes that are tried: equal ratios from that of uplift on. It is refined once beside an amplitude
/// that stands or falls clearly less than both its neighbours. Then every change is bisected. Ranges narrower than a
/// step may be missed.
struct OverturningScan {
    double highest = 30;       ///< last amplitude over that of uplift, above 1
    double step = 0.01;        ///< ratio of neighbours, less 1
    double precision = 1e-10;  ///< relative, of a boundary
    RockingAccuracy accuracy = {};
};

struct OverturningRanges {
    double uplift = 0;              ///< factor above which it uplifts; infinity: none does
    std::vector<FateRange> ranges;  ///< from `uplift` to the scan's end; empty where nothing uplifts it

    /// The least factor that overturns it; infinity if none of the scan's does.
    [[nodiscard]] double overturning() const;
    /// Up to here every factor stands: above it the block overturns, is undecided, or the scan ends; infinity where
    /// nothing uplifts it.
    [[nodiscard]] double stands_to() const;
};

/// Factor on the shaking above which a resting symmetric block uplifts: the least g tan(alpha) / (abs(a) - tan(alpha)
/// a_vertical) of its samples; infinity if none does. \param restoring linear: alpha in place of its tangent
[[nodiscard]] double uplift_factor(RockingBlock const& block, Excitation const& shaking, Restoring restoring);

/// Ranges of a block that nothing lets slip. A boundary is the end of its bracket at which the block stands, if it
/// stands at one: a range that overturns is never reported narrower than it is. \pre the block's corners do not differ;
/// shaking.scale is not looked at
[[nodiscard]] OverturningRanges overturning_ranges(RockingBlock const& block, Excitation const& shaking,
                                                   OverturningScan const& scan = {});

}  // namespace overturn
