#include <cmath>

#include <fmt/format.h>

#include "qualify/detail/published_parts.hpp"
#include "qualify/published.hpp"

namespace overturn::qualify {
namespace {

// The paper's table 1, of a model at 2/5. Its factors are printed to two decimals, and so is what they give to three.
Checks similarity_factors() {
    constexpr double s = 0.4, mass = 1.43, stiffness = 0.55, section = 0.57;
    constexpr double last_of_factors = 5e-3, last_digit = 5e-4;
    struct Printed {
        char const *number, *of;
        double printed;
        double (*by_factors)(double more);  // where all factors are so much larger
    };
    Checks all;
    for (auto const& [number, of, printed, by_factors] :
         {Printed{"D-01", "longitudinal stiffness", 0.216, [](double more) { return (stiffness + more) * s; }},
          Printed{"D-02", "section", 0.086, [](double more) { return (section + more) * s * s; }},
          Printed{"D-03", "longitudinal force", 0.088,
                  [](double more) { return std::sqrt((mass + more) * (stiffness + more)) * std::pow(s, 2.5); }}}) {
        double const found = by_factors(0);
        all.push_back({number, fmt::format("{} of the model at 2/5 over that of the prototype", of),
                       "PATRAM 2013, table 1", "1", found, printed, by_factors(last_of_factors) - found + last_digit,
                       "", "no factors that round to its own 1.43, 0.55 and 0.57 give what it prints"});
    }
    return all;
}

}  // namespace

Checks published_apart(double least_half_sine) {
    auto all = similarity_factors();
    constexpr double ratio = 4;
    all.push_back(relative("D-04", "least half-sine that overturns the linearised block over alpha g, omega/p 4",
                           "Housner (1963), sqrt(1 + (omega/p)^2)", "1", least_half_sine, std::sqrt(1 + ratio * ratio),
                           1e-2));
    all.back().differs_because = "his block tips at the end of the pulse; Shi and others (1996), L-02: less is enough";
    return all;
}

std::vector<LeftOut> left_out_of_published() {
    return {
        {"what the element RockingBC gives for its example", "OpenSees",
         "that program is not at hand, and the example prints no answer; its block and cases are L-33 and L-34"},
        {"slip spectra of records", "OpenSeismoMatlab", "the records are not part of this program"},
        {"spectral intensities of El Centro", "Housner, from an analogue computer",
         "the record is not part of this program: tests/validation, where it is at hand"},
        {"245 shaking-table tests of two granite blocks", "doi 10.26443/seismica.v3i1.692",
         "the data are not part of this program: tests/validation/experiments"},
        {"one-third scale cask on a shaking table, and LS-DYNA", "Lin and others, J. Vibroengineering (2015)",
         "could not be consulted beyond its abstract, which prints no number"},
        {"the same cask under recorded earthquakes", "Hu and others, J. Vibroengineering (2016)",
         "could not be consulted beyond its abstract: the table test rocks, the finite elements slide"},
        {"cylindrical casks and rectangular modules on soil", "NUREG/CR-6865 (2005)", "could not be consulted"},
        {"sensitivity of cask motions", "Luk and others, SMiRT 17, K08-3 (2003)",
         "could not be consulted beyond its abstract, which prints no number"},
        {"seismic stability of a HI-STORM 100 overpack", "Holtec HI-2002444",
         "could not be consulted; campaigns/overpack.toml has a body of its kind, all assumed"},
    };
}

}  // namespace overturn::qualify
