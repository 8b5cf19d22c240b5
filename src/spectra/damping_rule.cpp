#include "spectra/damping_rule.hpp"

#include <array>
#include <cmath>

namespace overturn {
namespace {

double japan(double damping) { return 1.5 / (1 + 10 * damping); }

double eurocode_8(double damping) {
    constexpr double smallest = 0.55;
    double const factor = std::sqrt(10 / (5 + 100 * damping));
    validate(factor >= smallest, "damping {} (eurocode-8 ends at a factor of {}, about 0.28). Lower it or use a table",
             damping, smallest);
    return factor;
}

}  // namespace

std::span<config::Entry<DampingRule> const> damping_rules() {
    static constexpr std::array entries{
        config::Entry<DampingRule>{"japan", "1.5 / (1 + 10 h), notification 1457 of 2000", &japan},
        config::Entry<DampingRule>{"eurocode-8", "sqrt(10 / (5 + 100 h)), at least 0.55, EN 1998-1", &eurocode_8},
    };
    return entries;
}

}  // namespace overturn
