#include "rare/mixture.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include <gsl/gsl_rng.h>

#include "core/error.hpp"
#include "core/units.hpp"
#include "rare/detail/pulse_density.hpp"
#include "spectra/transform.hpp"

namespace overturn::rare {
namespace {

// The first place whose running sum exceeds u of the whole.
std::size_t chosen(std::span<double const> running, double u) {
    auto const at = std::upper_bound(running.begin(), running.end(), u * running.back());
    return std::min(static_cast<std::size_t>(at - running.begin()), running.size() - 1);
}

}  // namespace

std::size_t Mixture::grid_of(PulseFrame const& frame) { return std::bit_ceil(2 * (frame.lines + 1)); }

Mixture::Mixture(PulseFrame const& frame, std::vector<Pulse> pulses) : frame_(frame), pulses_(std::move(pulses)) {
    double sum = 0;
    for (auto const& pulse : pulses_) {
        OVERTURN_EXPECT(pulse.lines.size() == frame_.lines && pulse.arrival.size() == grid_of(frame_));
        totals_.push_back(sum += pulse.share);
        double square = 0;
        for (auto const& line : pulse.lines) {
            square += std::norm(line);
        }
        squares_.push_back(square);
    }
    for (std::size_t m = 0; m < grid_of(frame_) && !pulses_.empty(); ++m) {
        turns_.push_back(std::polar(1.0, -2 * pi * static_cast<double>(m) / static_cast<double>(grid_of(frame_))));
    }
    for (auto const& pulse : pulses_) {
        sum = 0;
        for (double const share : pulse.arrival) {
            totals_.push_back(sum += share);
        }
    }
}

bool Mixture::shift(std::span<double> normals, RandomStream& choice) const {
    if (pulses_.empty() || gsl_rng_uniform(choice.gsl()) < plain_share) {
        return false;
    }
    auto const grid = grid_of(frame_);
    auto const totals = std::span(totals_);
    auto const c = chosen(totals.first(pulses_.size()), gsl_rng_uniform(choice.gsl()));
    auto const j = chosen(totals.subspan(pulses_.size() + c * grid, grid), gsl_rng_uniform(choice.gsl()));
    auto const strength = pulse_strengths.at(gsl_rng_uniform_int(choice.gsl(), pulse_strengths.size()));
    double const signed_strength = gsl_rng_uniform(choice.gsl()) < 0.5 ? -strength : strength;
    for (std::size_t k = 1; k <= frame_.lines; ++k) {
        auto const turned = signed_strength * pulses_[c].lines[k - 1] * turns_[k * j % grid];
        normals[2 * k - 2] += turned.real();
        normals[2 * k - 1] += turned.imag();
    }
    return true;
}

double Mixture::weight(std::span<double const> normals) const {
    if (pulses_.empty()) {
        return 1;
    }
    auto const transform = real_synthesis(grid_of(frame_));
    double density = 0;
    for (std::size_t c = 0; c < pulses_.size(); ++c) {
        std::fill(transform.in.begin(), transform.in.end(), 0.0);
        for (std::size_t k = 1; k <= frame_.lines; ++k) {
            // Half of it: the transform adds the conjugate.
            std::complex<double> const z(0.5 * normals[2 * k - 2], 0.5 * normals[2 * k - 1]);
            transform.in[k] = std::conj(pulses_[c].lines[k - 1]) * z;
        }
        transform.run();
        density += pulses_[c].share * pulse_density(pulses_[c].arrival, transform.out, squares_[c]);
    }
    return 1 / (plain_share + (1 - plain_share) * density);
}

Mixture Mixture::strengthened(double factor) const {
    auto pulses = pulses_;
    for (auto& pulse : pulses) {
        for (auto& line : pulse.lines) {
            line *= factor;
        }
    }
    return {frame_, std::move(pulses)};
}

}  // namespace overturn::rare
