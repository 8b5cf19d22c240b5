#include "results/detail/unusual_hazard.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/units.hpp"
#include "core/usual_range.hpp"

namespace overturn {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
constexpr double endless = std::numeric_limits<double>::infinity();
constexpr double seldom = 1e-4;  // a year: every site's curve is known there

struct Looked {
    HazardCurve const& hazard;
    HazardAxis const& axis;
    std::string const& measure;
};

double first_rate(Looked const& of) { return of.hazard.points().front().annual_exceedance; }
double last_rate(Looked const& of) { return of.hazard.points().back().annual_exceedance; }

std::string at_text(Looked const& of, double intensity, double rate) {
    return fmt::format("{:.3g} exceedances a year of {} {}", rate, of.measure, hazard_text(of.hazard, intensity));
}
std::string first_text(Looked const& of, double rate) { return "it begins at " + at_text(of, of.hazard.first(), rate); }
std::string last_text(Looked const& of, double rate) { return "it ends at " + at_text(of, of.hazard.last(), rate); }

/// What is exceeded once in ten thousand years, from quiet sites to those on a fault.
struct SeldomMotion {
    std::string_view measure;
    double least, most;  ///< [SI]
};
constexpr std::array seldom_motions{SeldomMotion{"pga", 0.02 * g0, 3 * g0},
                                    SeldomMotion{"vector-pga", 0.02 * g0, 4 * g0},
                                    SeldomMotion{"sa", 0.0005 * g0, 8 * g0}, SeldomMotion{"pgv", 0.005, 5}};

SeldomMotion const* seldom_motion(Looked const& of) {
    auto const* const known = std::ranges::find_if(
        seldom_motions, [&](SeldomMotion const& motion) { return of.measure.starts_with(motion.measure); });
    return known == seldom_motions.end() ? nullptr : known;
}

enum class Side { low, high };

// The intensity that is exceeded so seldom [SI]; of a curve that ends before, or begins beyond, the end that bounds it
// on this side, and nothing on the other.
double seldom_intensity(Looked const& of, Side side) {
    auto const& points = of.hazard.points();
    auto const after =
        std::ranges::find_if(points, [](HazardPoint const& point) { return point.annual_exceedance <= seldom; });
    if (after == points.end()) {
        return side == Side::high ? points.back().intensity : not_known;
    }
    if (after == points.begin()) {
        return side == Side::low ? after->intensity : not_known;
    }
    auto const& [a0, n0] = *(after - 1);
    return a0 * std::pow(after->intensity / a0, std::log(n0 / seldom) / std::log(n0 / after->annual_exceedance));
}

// In the least, and in the most, of its measure.
double over_least(Looked const& of) {
    auto const* const known = seldom_motion(of);
    return known == nullptr ? not_known : seldom_intensity(of, Side::low) / known->least;
}
double over_most(Looked const& of) {
    auto const* const known = seldom_motion(of);
    return known == nullptr ? not_known : seldom_intensity(of, Side::high) / known->most;
}
std::string seldom_text(Looked const& of, Side side) {
    return fmt::format("{} of {} is exceeded 1e-4 times a year", hazard_text(of.hazard, seldom_intensity(of, side)),
                       of.measure);
}
std::string least_text(Looked const& of, double /*ratio*/) { return seldom_text(of, Side::low); }
std::string most_text(Looked const& of, double /*ratio*/) { return seldom_text(of, Side::high); }

// How much of the levels' range the curve covers, in decades.
double covered(Looked const& of) {
    double const low = of.axis.lowest;
    double const high = of.axis.highest;
    return low > 0 && high > low
               ? std::log(std::min(high, of.hazard.last()) / std::max(low, of.hazard.first())) / std::log(high / low)
               : not_known;
}
std::string covered_text(Looked const& of, double share) {
    return fmt::format("from {} to {} it covers {:.0f} % of {} to {}, where there are trials or a curve",
                       hazard_text(of.hazard, of.hazard.first()), hazard_text(of.hazard, of.hazard.last()), 100 * share,
                       of.axis.unit.text(of.axis.lowest), of.axis.unit.text(of.axis.highest));
}

constexpr std::string_view of_a_year = "Check that it is of a year: of a return period its inverse";
constexpr std::string_view unit_of_it = "Check the unit of its first column, and of the levels";
constexpr std::array hazard_ranges{
    UsualRange<Looked>{&first_rate, 1e-5, 1, &first_text, "usual: 1 to 1e-3 at its weakest motion", of_a_year},
    UsualRange<Looked>{&last_rate, 1e-14, 1e-2, &last_text, "usual: 1e-4 to 1e-8 at its strongest motion", of_a_year},
    UsualRange<Looked>{&over_least, 1, endless, &least_text, "more on any site", unit_of_it},
    UsualRange<Looked>{&over_most, 0, 1, &most_text, "less on any site", unit_of_it},
    UsualRange<Looked>{&covered, 0.25, endless, &covered_text, "usual: all of it", unit_of_it}};

}  // namespace

std::vector<std::string> unusual_hazard(HazardCurve const& hazard, HazardAxis const& axis, std::string const& measure) {
    Looked const looked{hazard, axis, measure};
    return unusual(looked, std::span<UsualRange<Looked> const>(hazard_ranges));
}

}  // namespace overturn
