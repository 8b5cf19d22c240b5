#include <cmath>

#include "spectra/detail/close_reading.hpp"
#include "spectra/detail/free_vibration.hpp"
#include "spectra/detail/searched_tiles.hpp"
#include "spectra/peak_response.hpp"

namespace overturn {

// At the sample before a tile's first, of the forms that have it.
PeakResponse::State PeakResponse::state_before(Searched const& searched, std::size_t lane, std::size_t tile) const {
    auto const& series = searched.series;
    auto const& o = oscillators_[searched.group->first + lane];
    std::size_t const first = Searched::first(tile);
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

// Every oscillator up to the last sample. The strided form needs the two last, which may lie in two tiles.
void PeakResponse::read_to_end(Searched const& searched) const {
    auto& reading = *searched.reading;
    std::size_t const last = searched.tiles->count() - 1;
    bool const strided = searched.group->swept.form == SweepForm::strided;
    std::size_t const from = strided && last > 0 ? last - 1 : last;
    for (std::size_t lane = 0; lane < searched.group->count; ++lane) {
        add(searched, lane, from);
    }
    if (!strided) {
        read_states(reading);
        return;
    }
    read_recursion(reading);
    if (from < last) {
        reading.y[0] = reading.y.back();
        for (std::size_t n = Searched::first(last); n < searched.series.size(); ++n) {
            reading.ground[n + 1 - Searched::first(last)].fill(searched.series[n]);
        }
        read_recursion(reading);
    }
}

PeakResponse::State PeakResponse::state_at_end(Searched const& searched, std::size_t lane) const {
    auto const& reading = *searched.reading;
    auto const& series = searched.series;
    std::size_t const count = series.size() - Searched::first(searched.tiles->count() - 1);
    double const y = reading.y[count][lane];
    if (searched.group->swept.form != SweepForm::strided) {
        return {y, reading.v[count][lane]};
    }
    auto const& o = oscillators_[searched.group->first + lane].sample;
    double const a0 = series[series.size() - 2];
    double const a1 = series.back();
    double const y0 = reading.y[count - 1][lane];
    double const v0 = (y - o.yy * y0 - o.ya0 * a0 - o.ya1 * a1) / o.yv;
    return {y, o.vy * y0 + o.vv * v0 + o.va0 * a0 + o.va1 * a1};
}

// Over still ground, behind the last sample.
void PeakResponse::swing_on(Searched const& searched, std::span<PeakDisplacement> found) const {
    read_to_end(searched);
    for (std::size_t lane = 0; lane < searched.group->count; ++lane) {
        auto const [y, v] = state_at_end(searched, lane);
        auto const peak = free_peak_and_time(oscillators_[searched.group->first + lane].w, damping_, y, v);
        if (std::abs(peak.value) > std::abs(found[lane].displacement_m)) {
            found[lane] = {peak.value, time_step_s_ * static_cast<double>(searched.series.size() - 1) + peak.time_s};
        }
    }
}

}  // namespace overturn
