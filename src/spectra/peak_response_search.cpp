#include <algorithm>
#include <cmath>

#include "spectra/detail/close_reading.hpp"
#include "spectra/detail/searched_tiles.hpp"
#include "spectra/detail/tile_bounds.hpp"
#include "spectra/peak_response.hpp"

namespace overturn {
namespace {

bool beats(double value, PeakDisplacement const& found) { return std::abs(value) > std::abs(found.displacement_m); }

}  // namespace

void PeakResponse::add_states(Searched const& searched, std::size_t lane, std::size_t tile,
                              CloseReading& reading) const {
    auto const& o = oscillators_[searched.group->first + lane];
    std::size_t const to = reading.count;
    auto& step = reading.step;
    step.yy[to] = o.sample.yy;
    step.yv[to] = o.sample.yv;
    step.ya0[to] = o.sample.ya0;
    step.ya1[to] = o.sample.ya1;
    step.vy[to] = o.sample.vy;
    step.vv[to] = o.sample.vv;
    step.va0[to] = o.sample.va0;
    step.va1[to] = o.sample.va1;
    auto& chord = reading.chord;
    chord.real_a0[to] = o.chord_error.real_a0;
    chord.real_a1[to] = o.chord_error.real_a1;
    chord.imaginary_y[to] = o.chord_error.imaginary_y;
    chord.imaginary_v[to] = o.chord_error.imaginary_v;
    chord.imaginary_a0[to] = o.chord_error.imaginary_a0;
    chord.imaginary_a1[to] = o.chord_error.imaginary_a1;
    chord.scale[to] = o.chord_error.scale;
    auto const [y, v] = state_before(searched, lane, tile);
    reading.y[0][to] = y;
    reading.v[0][to] = v;
}

void PeakResponse::add_recursion(Searched const& searched, std::size_t lane, std::size_t tile, CloseReading& reading) {
    auto const& swept = searched.group->swept;
    std::size_t const to = reading.count;
    auto& recursion = reading.recursion;
    recursion.ahead[to] = swept.ahead[lane];
    recursion.behind[to] = swept.behind[lane];
    recursion.now[to] = swept.now[lane];
    recursion.last[to] = swept.last[lane];
    recursion.unit[to] = swept.unit[lane];
    recursion.w[to] = searched.state(lane, tile);
    recursion.d[to] = searched.other(lane, tile);
    reading.y[0][to] = 0;
}

void PeakResponse::add(Searched const& searched, std::size_t lane, std::size_t tile) const {
    auto& reading = *searched.reading;
    if (searched.group->swept.form == SweepForm::strided) {
        add_recursion(searched, lane, tile, reading);
    } else {
        add_states(searched, lane, tile, reading);
    }
    std::size_t const first = Searched::first(tile);
    for (std::size_t n = first - 1; n < searched.end(tile); ++n) {
        reading.ground[n + 1 - first][reading.count] = searched.series[n];
    }
    reading.of[reading.count] = {lane, tile};
    ++reading.count;
}

// Over the parts of a step from (y, v) that ends at `sample`, but its last.
void PeakResponse::look_between(Searched const& searched, Oscillator const& o, State state, std::size_t sample,
                                PeakDisplacement& found) const {
    double const a0 = searched.series[sample - 1];
    double const rise = (searched.series[sample] - a0) / o.steps;
    auto [y, v] = state;
    for (int s = 0; s + 1 < o.steps; ++s) {
        double const from = a0 + rise * s;
        double const to = a0 + rise * (s + 1);
        double const next = o.fine.yy * y + o.fine.yv * v + (o.fine.ya0 * from + o.fine.ya1 * to);
        v = o.fine.vy * y + o.fine.vv * v + (o.fine.va0 * from + o.fine.va1 * to);
        y = next;
        if (beats(y, found)) {
            found = {y, time_step_s_ * (static_cast<double>(sample - 1) + (s + 1.0) / o.steps)};
        }
    }
}

// What one lane read.
void PeakResponse::look(Searched const& searched, std::size_t at, PeakDisplacement& found) const {
    auto const& reading = *searched.reading;
    auto const [lane, tile] = reading.of[at];
    auto const& o = oscillators_[searched.group->first + lane];
    bool const strided = searched.group->swept.form == SweepForm::strided;
    std::size_t const first = Searched::first(tile);
    std::size_t const count = searched.end(tile) - first;
    double const known = count == SweepTiles::samples ? reading.most[at] : 0;  // a sample will show it
    for (std::size_t i = 0; i < count; ++i) {
        if (!strided && reading.reach[i][at] > std::max(known, std::abs(found.displacement_m))) {
            look_between(searched, o, {reading.y[i][at], reading.v[i][at]}, first + i, found);
        }
        double const y = reading.y[i + 1][at];
        if (std::abs(y) >= known && beats(y, found)) {
            found = {y, time_step_s_ * static_cast<double>(first + i)};
        }
    }
}

void PeakResponse::read(Searched const& searched, std::span<PeakDisplacement> found) const {
    auto& reading = *searched.reading;
    bool const strided = searched.group->swept.form == SweepForm::strided;
    strided ? read_recursion(reading) : read_states(reading);
    for (std::size_t at = 0; at < reading.count; ++at) {
        auto& best = found[reading.of[at].lane];
        if (beats(reading.most[at], best) || (!strided && beats(reading.furthest[at], best))) {
            look(searched, at, best);
        }
    }
    reading.count = 0;
}

// Into the tiles that reach a limit; where only some samples were read, a peak may also lie before the first.
// What is found raises the limit of a form whose tiles hold heights, and no tile of it is read twice.
void PeakResponse::search(Searched const& searched, LaneValues limit, std::span<PeakDisplacement> found) const {
    bool const strided = searched.group->swept.form == SweepForm::strided;
    bool const heights = searched.group->swept.form == SweepForm::amplitude;
    auto& tiles = *searched.tiles;
    auto& reading = *searched.reading;
    auto const read_all = [&] {
        read(searched, found);
        for (std::size_t lane = 0; heights && lane < found.size(); ++lane) {
            limit[lane] = std::max(limit[lane], std::abs(found[lane].displacement_m));
        }
    };
    reading.count = 0;
    for (std::size_t b = 0; (b = next_reaching(tiles, b, limit, strided)) < tiles.count(); ++b) {
        double* const tile = tiles.at(b);
        double const* const before = strided && b > 0 ? tiles.at(b - 1) : tile;
        for (std::size_t lane = 0; lane < searched.group->count; ++lane) {
            if (std::max(tile[lane], before[lane]) >= limit[lane]) {
                add(searched, lane, b);
                if (heights) {
                    tile[lane] = -1;
                }
                if (reading.count == simd::sweep_lanes) {
                    read_all();
                }
            }
        }
    }
    read_all();
}

}  // namespace overturn
