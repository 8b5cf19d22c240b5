#include <cmath>

#include "spectra/detail/free_vibration.hpp"
#include "spectra/detail/searched_tiles.hpp"
#include "spectra/peak_response.hpp"

namespace overturn {

// At the sample before a tile's first, of the forms that have it.
PeakResponse::State PeakResponse::state_before(Searched const& searched, std::size_t lane, std::size_t tile) const {
    auto const& series = searched.series;
    auto const& o = oscillators_[searched.group->first + lane];
    std::size_t const first = 1 + tile * SweepTiles::samples;
    double const unit = searched.group->swept.unit[lane];
    if (searched.group->swept.form == SweepForm::amplitude) {
        double const slope = (series[first] - series[first - 1]) / time_step_s_;
        double const turned = searched.group->swept.now[lane];
        double const aside = searched.group->swept.last[lane];
        double const f = unit * (turned * searched.state(lane, tile) - aside * searched.other(lane, tile));
        double const q = unit * (aside * searched.state(lane, tile) + turned * searched.other(lane, tile));
        return {f + (2 * damping_ * slope / o.w - series[first - 1]) / (o.w * o.w),
                o.w * (std::sqrt(1 - damping_ * damping_) * q - damping_ * f) - slope / (o.w * o.w)};
    }
    if (first == 1) {
        return {0, 0};
    }
    double const a0 = series[first - 2];
    double const a1 = series[first - 1];
    double const y0 = unit * searched.other(lane, tile);
    double const y = unit * searched.state(lane, tile);
    double const v0 = (y - o.sample.yy * y0 - o.sample.ya0 * a0 - o.sample.ya1 * a1) / o.sample.yv;
    return {y, o.sample.vy * y0 + o.sample.vv * v0 + o.sample.va0 * a0 + o.sample.va1 * a1};
}

PeakResponse::State PeakResponse::state_at_end(Searched const& searched, std::size_t lane) const {
    auto const& series = searched.series;
    auto const& swept = searched.group->swept;
    auto const& o = oscillators_[searched.group->first + lane].sample;
    std::size_t const last = searched.tiles->count() - 1;
    if (swept.form != SweepForm::strided) {
        auto [y, v] = state_before(searched, lane, last);
        for (std::size_t n = 1 + last * SweepTiles::samples; n < series.size(); ++n) {
            double const y1 = o.yy * y + o.yv * v + (o.ya0 * series[n - 1] + o.ya1 * series[n]);
            v = o.vy * y + o.vv * v + (o.va0 * series[n - 1] + o.va1 * series[n]);
            y = y1;
        }
        return {y, v};
    }
    std::size_t const tile = last > 0 ? last - 1 : 0;  // two samples at least
    double w = searched.state(lane, tile);
    double d = searched.other(lane, tile);
    double y0 = 0;
    double y = 0;
    for (std::size_t n = 1 + tile * SweepTiles::samples; n < series.size(); ++n) {
        double const next = swept.ahead[lane] * d + (swept.behind[lane] * w + series[n]);
        double const before = w;
        w += d;
        d = next;
        y0 = y;
        y = swept.unit[lane] * (swept.now[lane] * w + (swept.last[lane] * before + d));
    }
    double const a0 = series[series.size() - 2];
    double const a1 = series.back();
    double const v0 = (y - o.yy * y0 - o.ya0 * a0 - o.ya1 * a1) / o.yv;
    return {y, o.vy * y0 + o.vv * v0 + o.va0 * a0 + o.va1 * a1};
}

// Over still ground, behind the last sample.
void PeakResponse::swing_on(Searched const& searched, std::span<PeakDisplacement> found) const {
    for (std::size_t lane = 0; lane < searched.group->count; ++lane) {
        auto const [y, v] = state_at_end(searched, lane);
        auto const peak = free_peak_and_time(oscillators_[searched.group->first + lane].w, damping_, y, v);
        if (std::abs(peak.value) > std::abs(found[lane].displacement_m)) {
            found[lane] = {peak.value, time_step_s_ * static_cast<double>(searched.series.size() - 1) + peak.time_s};
        }
    }
}

}  // namespace overturn
