#include "spectra/peak_response.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/units.hpp"
#include "spectra/detail/close_reading.hpp"
#include "spectra/detail/free_vibration.hpp"
#include "spectra/detail/searched_tiles.hpp"
#include "spectra/detail/tile_bounds.hpp"
#include "spectra/response_spectrum.hpp"

namespace overturn {
namespace {

constexpr double least_oscillating = 0.95;  // damping from which C says little
constexpr int samples_per_period = 24;  // at least; between two of them a sinusoid rises by 0.9 % of its height at most

std::size_t stride_of(double period_s, double time_step_s) {
    double const room = period_s / (samples_per_period * time_step_s);
    return room >= 8 ? 8 : room >= 2 ? 2 : 1;
}

}  // namespace

PeakResponse::ChordError::ChordError(double w, double damping, double dt) {
    double const per_slope = -2 * damping / (w * w * w * dt);  // of a1 - a0 in y - p
    imaginary_v = 1 / (w * std::sqrt(1 - damping * damping));
    imaginary_y = damping * w * imaginary_v;
    real_a0 = 1 / (w * w) - per_slope;
    real_a1 = per_slope;
    imaginary_a0 = imaginary_y * real_a0 - imaginary_v / (w * w * dt);
    imaginary_a1 = imaginary_y * real_a1 + imaginary_v / (w * w * dt);
    scale = w * w * dt * dt / 8;
}

PeakResponse::PeakResponse(std::vector<double> const& periods_s, double damping, double time_step_s)
    : damping_(damping), time_step_s_(time_step_s) {
    [[maybe_unused]] constexpr double heaviest = 5;
    [[maybe_unused]] constexpr double least_steps = 2 * (1 - bound_error);
    OVERTURN_EXPECT(damping >= 0 && damping <= heaviest);
    OVERTURN_EXPECT(periods_s.empty() || periods_s.front() >= least_steps * time_step_s);
    for (std::size_t i = 0; i < periods_s.size(); ++i) {
        double const period = periods_s[i];
        OVERTURN_EXPECT(i == 0 || period > periods_s[i - 1]);
        int const steps = steps_per_sample(period, time_step_s, {});
        auto const stride = stride_of(period, time_step_s);
        auto const form = stride > 1                                 ? SweepForm::strided
                          : steps > 1 && damping < least_oscillating ? SweepForm::amplitude
                                                                     : SweepForm::samples;
        // Lanes are filled up with periods that could do with fewer samples; only the amplitudes of those that need no
        // substeps would say too little.
        constexpr double widest = 8;
        if (groups_.empty() || groups_.back().count == simd::sweep_lanes
            || period > widest * periods_s[groups_.back().first]
            || (groups_.back().swept.form == SweepForm::amplitude) != (form == SweepForm::amplitude)) {
            groups_.push_back({i, 0, {.form = form, .stride = stride}});
        }
        auto& group = groups_.back();
        double const w = 2 * pi / period;
        OscillatorStep const sample(w, damping, time_step_s);
        oscillators_.push_back({w, steps, sample, OscillatorStep(w, damping, time_step_s / steps),
                                ChordError(w, form == SweepForm::amplitude ? damping : 0, time_step_s)});
        if (form != SweepForm::amplitude) {  // there is no bound, or no look between samples
            constexpr double infinity = std::numeric_limits<double>::infinity();
            oscillators_.back().chord_error.scale = steps > 1 ? infinity : -infinity;
        }
        for (std::size_t lane = group.count; lane < simd::sweep_lanes; ++lane) {  // idle lanes repeat the last
            group.swept.set(lane, w, damping, sample, time_step_s);
        }
        ++group.count;
    }
}

// Puts the largest |y| that there may be in place of |C|^2: the ground's line, and the free vibration about it.
TileBound PeakResponse::bound_of(Group const& group) const {
    TileBound bound;
    for (std::size_t lane = 0; lane < simd::sweep_lanes; ++lane) {
        double const w = oscillators_[group.first + std::min(lane, group.count - 1)].w;
        bound.most[lane] = (1 + bound_error) / (w * w);
        bound.steepest[lane] = (1 + bound_error) * 2 * damping_ / (w * w * w * time_step_s_);
        bound.swung[lane] = (1 + bound_error) * group.swept.unit[lane];
    }
    return bound;
}

// x^2 in a tile from which the peak may lie in it. Between two samples that are read, h apart, y strays from the line
// between them by h^2/8 max |y''|; |y''| <= |a| + w^2 |y| + 2 zeta w |y'| and |y'| <= 2 |y| / h + h/2 |y''|.
PeakResponse::LaneValues PeakResponse::limits(Group const& group, SweepTiles const& tiles, double peak_mps2) const {
    LaneValues limit{};
    for (std::size_t lane = 0; lane < simd::sweep_lanes; ++lane) {
        auto const& o = oscillators_[group.first + std::min(lane, group.count - 1)];
        if (group.swept.form == SweepForm::samples) {
            limit[lane] = o.steps == 1 ? tiles.highest[lane] : 0;
            continue;
        }
        double const h = static_cast<double>(group.swept.stride) * time_step_s_;
        double const y = std::abs(group.swept.unit[lane]) * std::sqrt(tiles.highest[lane]);
        double const given = 1 - damping_ * o.w * h - o.w * o.w * h * h / 8;
        double const bent = (peak_mps2 + y * (o.w * o.w + 4 * damping_ * o.w / h)) / given;
        double const least = given > 0 ? std::max(0.0, y * (1 - bound_error) - h * h / 8 * bent) : 0.0;
        double const x = least / group.swept.unit[lane];
        limit[lane] = x * x;
    }
    return limit;
}

void PeakResponse::search_swept(Searched const& searched, TileGround const& ground,
                                std::span<PeakDisplacement> found) const {
    auto const& group = *searched.group;
    auto& tiles = *searched.tiles;
    if (group.swept.form != SweepForm::amplitude) {
        search(searched, limits(group, tiles, ground.peak), found);
        return;
    }
    bound_tiles(bound_of(group), ground, tiles);
    search(searched, tiles.highest, found);  // the higher what is found, the fewer tiles are left to search
    LaneValues limit{};
    for (std::size_t lane = 0; lane < group.count; ++lane) {
        limit[lane] = std::abs(found[lane].displacement_m);
    }
    search(searched, limit, found);
}

std::vector<PeakDisplacement> PeakResponse::peaks(std::span<double const> acceleration_mps2) const {
    std::vector<PeakDisplacement> peaks(oscillators_.size());
    if (acceleration_mps2.size() < 2) {
        return peaks;
    }
    auto const series = come_to_rest(acceleration_mps2);
    if (series.size() < 2) {
        return peaks;
    }
    auto const ground = ground_of_tiles(series);
    std::array<SweepTiles, 2> tiles;
    CloseReading reading;
    for (std::size_t g = 0; g < groups_.size();) {
        bool const both = g + 1 < groups_.size() && go_side_by_side(groups_[g].swept, groups_[g + 1].swept);
        if (both) {
            sweep({&groups_[g].swept, &groups_[g + 1].swept}, series, tiles);
        } else {
            sweep(groups_[g].swept, series, tiles[0]);
        }
        for (std::size_t i = 0; i < (both ? 2 : 1); ++i, ++g) {
            auto const found = std::span(peaks).subspan(groups_[g].first, groups_[g].count);
            Searched const searched{series, &groups_[g], &tiles[i], &reading};
            search_swept(searched, ground, found);
            swing_on(searched, found);
        }
    }
    return peaks;
}

}  // namespace overturn
