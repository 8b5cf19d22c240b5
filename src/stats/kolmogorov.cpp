#include "stats/kolmogorov.hpp"

#include <algorithm>
#include <cmath>

#include "stats/extended_real.hpp"

namespace overturn {
namespace {

double stretch(double size) {
    double const root = std::sqrt(size);
    return root + 0.12 + 0.11 / root;  // Stephens (1970)
}

KolmogorovTest test_of(double distance, double size) {
    constexpr double critical = 1.3580986393225505;  // 5 % of the Kolmogorov distribution lies beyond
    return {distance, ks_p_value(distance, size), critical / stretch(size)};
}

}  // namespace

double ks_distance(std::vector<double> a, std::vector<double> b) {
    if (a.empty() || b.empty()) {
        return unknown;
    }
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    double distance = 0;
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.size() && j < b.size()) {
        double const at = std::min(a[i], b[j]);
        for (; i < a.size() && a[i] == at; ++i) {}
        for (; j < b.size() && b[j] == at; ++j) {}
        double const gap = static_cast<double>(i) / static_cast<double>(a.size())
                           - static_cast<double>(j) / static_cast<double>(b.size());
        distance = std::max(distance, std::abs(gap));
    }
    return distance;
}

double ks_distance(std::vector<double> values, std::function<double(double)> const& distribution) {
    if (values.empty()) {
        return unknown;
    }
    std::sort(values.begin(), values.end());
    auto const count = static_cast<double>(values.size());
    double distance = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        auto const below = static_cast<double>(i);
        double const at = distribution(values[i]);
        distance = std::max({distance, (below + 1) / count - at, at - below / count});
    }
    return distance;
}

double ks_p_value(double distance, double size) {
    if (std::isnan(distance) || !(size > 0)) {
        return unknown;
    }
    double const x = stretch(size) * distance;
    constexpr double nothing_beyond = 0.2;  // below it the series needs many terms and is 1 to 12 digits
    if (x < nothing_beyond) {
        return 1;
    }
    double sum = 0;
    double sign = 1;
    constexpr int most_terms = 100;
    for (int k = 1; k <= most_terms; ++k) {
        double const term = std::exp(-2 * x * x * k * k);
        sum += sign * term;
        sign = -sign;
        if (term < 1e-17) {
            break;
        }
    }
    return std::clamp(2 * sum, 0.0, 1.0);
}

KolmogorovTest ks_test(std::vector<double> const& a, std::vector<double> const& b) {
    auto const n = static_cast<double>(a.size());
    auto const m = static_cast<double>(b.size());
    return test_of(ks_distance(a, b), n * m / (n + m));
}

KolmogorovTest ks_test(std::vector<double> const& values, std::function<double(double)> const& distribution) {
    return test_of(ks_distance(values, distribution), static_cast<double>(values.size()));
}

}  // namespace overturn
