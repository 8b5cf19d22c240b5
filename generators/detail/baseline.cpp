#include "generators/detail/baseline.hpp"

#include <array>
#include <cstddef>

namespace overturn {
namespace {

struct Ends {
    double velocity, displacement;  // over dt and dt^2
};

// From rest, of accelerations on straight lines: a sample's share in the end velocity is 1, in the end displacement the
// number of samples that follow; the first and the last have half of a triangle. Four sums side by side, as one would
// wait for itself.
Ends ends_of(std::span<double const> a, int last) {
    constexpr int width = 4;
    std::array<double, width> velocity{}, displacement{};
    int i = 1;
    for (; i + width <= last; i += width) {
        for (int j = 0; j < width; ++j) {
            double const value = a[i + j];
            velocity[j] += value;
            displacement[j] += (last - i - j) * value;
        }
    }
    for (; i < last; ++i) {
        velocity[0] += a[i];
        displacement[0] += (last - i) * a[i];
    }
    Ends ends{0.5 * (a[0] + a[last]), (0.5 * last - 1.0 / 6) * a[0] + a[last] / 6};
    for (int j = 0; j < width; ++j) {
        ends.velocity += velocity[j];
        ends.displacement += displacement[j];
    }
    return ends;
}

// Zero at both ends, of the share of the duration; the second is odd about the middle and has no end velocity.
double bump(double s) { return s * (1 - s); }
double wave(double s) { return bump(s) * (2 * s - 1); }

}  // namespace

void correct_baseline(std::span<double> acceleration_mps2) { correct_baseline_to(acceleration_mps2, 0, 0); }

void correct_baseline_to(std::span<double> acceleration_mps2, double velocity, double displacement) {
    if (acceleration_mps2.size() < 5) {
        return;
    }
    int const last = static_cast<int>(acceleration_mps2.size()) - 1;
    double const n = last;
    double const per_sample = 1 / n;
    double const squares = (n - 1) * (2 * n - 1) / (6 * n);  // sums of (i/n)^k over 0 < i < n
    double const cubes = (n - 1) * (n - 1) / (4 * n);
    double const fourths = (n - 1) * (2 * n - 1) * (3 * n * n - 3 * n - 1) / (30 * n * n * n);
    Ends const by_bump{(n * n - 1) / (6 * n), (n * n - 1) / 12};
    double const displacement_by_wave = n * (2 * fourths - 3 * cubes + squares);
    for (int pass = 0; pass < 2; ++pass) {  // the second removes what rounding left
        auto const ends = ends_of(acceleration_mps2, last);
        double const bumps = (ends.velocity - velocity) / by_bump.velocity;
        double const waves = (ends.displacement - displacement - bumps * by_bump.displacement) / displacement_by_wave;
        for (int i = 0; i <= last; ++i) {
            double const s = i * per_sample;
            acceleration_mps2[i] -= bumps * bump(s) + waves * wave(s);
        }
    }
}

}  // namespace overturn
