#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "qualify/detail/published_parts.hpp"
#include "stats/capacity_fit.hpp"
#include "stats/probit.hpp"

namespace overturn::qualify {
namespace {

constexpr double half_a_digit = 5e-5;  // of numbers printed, or known, to four decimals

Check printed(char const* number, char const* shows, char const* source, double found, double expected,
              double tolerance, char const* remark = "printed to four digits") {
    return {number, shows, source, "1", found, expected, tolerance, remark};
}

Checks capacities() {
    std::vector<double> const example{0.49, 0.62, 0.63, 0.63, 0.65, 0.70, 0.71, 0.72, 0.77, 0.79, 0.80, 0.84, 0.91,
                                      0.92, 0.93, 0.97, 1.04, 1.04, 1.05, 1.08, 1.08, 1.09, 1.12, 1.13, 1.22, 1.32,
                                      1.33, 1.34, 1.40, 1.40, 1.47, 1.72, 1.76, 2.15, 2.31, 2.42, 2.50};
    constexpr double tried_to = 1.3;
    std::vector<Capacity> all;
    all.reserve(example.size());
    for (double const capacity : example) {
        all.push_back({std::min(capacity, tried_to), capacity <= tried_to});
    }
    auto const line = fit_capacities(all);
    double const median = line ? std::exp(line->log_median()) : std::nan("");
    double const beta = line ? line->beta() : std::nan("");
    constexpr char const* source = "Baker (2015), example";
    return {printed("L-18", "median of 37 capacities tried up to 1.3", source, median, 1.0582, half_a_digit),
            printed("L-19", "their beta", source, beta, 0.3821, half_a_digit)};
}

struct Group {
    double intensity, tried, passed;
};

template <std::size_t count> ProbitLine fitted(std::array<Group, count> const& groups) {
    std::vector<FragilityPoint> points;
    points.reserve(count);
    for (auto const& group : groups) {
        points.push_back(
            {.log_intensity = std::log(group.intensity), .trials = group.tried, .overturned = group.passed});
    }
    return fit_probit(points).value_or(ProbitLine{std::nan(""), std::nan("")});
}

Checks stripes() {
    constexpr double motions = 40;
    auto const line = fitted(std::array{Group{0.2, motions, 0}, Group{0.3, motions, 0}, Group{0.4, motions, 0},
                                        Group{0.6, motions, 4}, Group{0.7, motions, 6}, Group{0.8, motions, 13},
                                        Group{0.9, motions, 12}, Group{1.0, motions, 16}});
    constexpr char const* source = "Baker (2015), multiple stripes";
    constexpr char const* remark = "the paper prints 1.076 and 0.429; more digits by another maximiser";
    return {printed("L-20", "median of eight stripes of 40 motions", source, std::exp(line.log_median()), 1.076116,
                    1e-6, remark),
            printed("L-21", "their beta", source, line.beta(), 0.429237, 1e-6, remark)};
}

// Beetles of one kind, eight doses of carbon disulphide, killed of so many: doses as decimal logarithms.
Checks doses() {
    auto const at = [](double decades, double tried, double killed) {
        return Group{std::pow(10, decades), tried, killed};
    };
    auto const line =
        fitted(std::array{at(1.6907, 59, 6), at(1.7242, 60, 13), at(1.7552, 62, 18), at(1.7842, 56, 28),
                          at(1.8113, 63, 52), at(1.8369, 59, 53), at(1.8610, 62, 61), at(1.8839, 60, 60)});
    constexpr char const* source = "Bliss (1935), probit of textbooks";
    return {
        printed("L-22", "slope per decade of eight doses, 481 beetles", source, line.slope * std::log(10.0), 19.7279,
                half_a_digit, "textbooks print 19.728"),
        printed("L-23", "its intercept", source, line.intercept, -34.9353, half_a_digit, "textbooks print -34.935")};
}

}  // namespace

Checks published_fits() {
    Checks all = capacities();
    for (auto const& more : {stripes(), doses()}) {
        all.insert(all.end(), more.begin(), more.end());
    }
    return all;
}

}  // namespace overturn::qualify
