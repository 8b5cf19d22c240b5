#include "stats/detail/wave_sums.hpp"

#include "simd/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "stats/detail/wave_sums.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes first: it includes this file once per instruction set
#include "simd/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace overturn::HWY_NAMESPACE {

using SomeLanes = simd::HWY_NAMESPACE::SweepDoubles<2>;

void add_cells(std::span<std::size_t const> first_of_group, std::span<CellCount const> entries,
               std::span<double const> times, std::span<double> sums) {
    constexpr std::size_t lanes = simd::sweep_lanes;
    for (std::size_t lane = 0; lane < lanes; lane += SomeLanes::count) {
        for (std::size_t g = 0; g + 1 < first_of_group.size(); ++g) {
            auto const often = SomeLanes::load(times.data() + g * lanes + lane);
            for (auto const& entry : entries.subspan(first_of_group[g], first_of_group[g + 1] - first_of_group[g])) {
                double* const trials = sums.data() + std::size_t{2} * entry.cell * lanes + lane;
                double* const overturned = trials + lanes;
                (SomeLanes::load(trials) + often * static_cast<double>(entry.trials)).store(trials);
                (SomeLanes::load(overturned) + often * static_cast<double>(entry.overturned)).store(overturned);
            }
        }
    }
}

void add_in_order(std::span<RankedTrial const> trials, std::span<double const> times, RankSums const& sums) {
    constexpr std::size_t lanes = simd::sweep_lanes;
    for (std::size_t lane = 0; lane < lanes; lane += SomeLanes::count) {
        auto stood = SomeLanes::load(sums.stood.data() + lane);
        auto overturned = SomeLanes::load(sums.overturned.data() + lane);
        auto above = SomeLanes::load(sums.above.data() + lane);
        for (std::size_t i = 0; i < trials.size();) {
            SomeLanes tied_stood = 0;
            SomeLanes tied_overturned = 0;
            bool any = false;
            for (double const at = trials[i].intensity; i < trials.size() && trials[i].intensity == at; ++i) {
                auto const often = SomeLanes::load(times.data() + trials[i].group * lanes + lane);
                if (trials[i].overturned != 0) {
                    tied_overturned = tied_overturned + often;
                    any = true;
                } else {
                    tied_stood = tied_stood + often;
                }
            }
            if (any) {
                above = above + tied_overturned * (stood + 0.5 * tied_stood);
                overturned = overturned + tied_overturned;
            }
            stood = stood + tied_stood;
        }
        stood.store(sums.stood.data() + lane);
        overturned.store(sums.overturned.data() + lane);
        above.store(sums.above.data() + lane);
    }
}

}  // namespace overturn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overturn {

HWY_EXPORT(add_cells);
HWY_EXPORT(add_in_order);

void add_cell_counts(std::span<std::size_t const> first_of_group, std::span<CellCount const> entries,
                     std::span<double const> times, std::span<double> sums) {
    HWY_DYNAMIC_DISPATCH(add_cells)(first_of_group, entries, times, sums);
}

void add_ranked(std::span<RankedTrial const> trials, std::span<double const> times, RankSums const& sums) {
    HWY_DYNAMIC_DISPATCH(add_in_order)(trials, times, sums);
}

}  // namespace overturn
#endif
