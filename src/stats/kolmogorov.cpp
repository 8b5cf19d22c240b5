#include "stats/kolmogorov.hpp"

#include <algorithm>
#include <cmath>

#include "stats/detail/extended_real.hpp"

namespace overturn {

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

}  // namespace overturn
