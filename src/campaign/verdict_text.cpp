#include "campaign/verdict_text.hpp"

#include <fmt/format.h>

#include "response/registry.hpp"

namespace overturn {
namespace {

// A default that nobody typed is the round number that it is: 1 mm, not 0.03937 in.
std::string threshold_text(double threshold_m, double usual_m, IntensityUnit const& length) {
    return (threshold_m == usual_m ? IntensityUnit{"mm", 1e-3} : length).text(threshold_m);
}

}  // namespace

std::string verdict_text(VerdictEntry const& verdict, MovementSpec const& movement, IntensityUnit const& length) {
    MovementSpec const usual;
    auto const slip = threshold_text(movement.slip_m, usual.slip_m, length);
    auto const rise = threshold_text(movement.uplift_m, usual.uplift_m, length);
    if (movement.by_model) {
        return std::string(verdict.summary);
    }
    switch (verdict.value) {
        case Verdict::at_rest:
            return fmt::format("slid less than {}, and no edge of its base rose {}", slip, rise);
        case Verdict::slid:
            return fmt::format("slid {} or more, and no edge of its base rose {}", slip, rise);
        case Verdict::rocked:
            return fmt::format("an edge of its base rose {} or more; it slid less than {} and stayed upright", rise,
                               slip);
        case Verdict::slid_and_rocked:
            return fmt::format("slid {} or more, an edge of its base rose {} or more, and it stayed upright", slip,
                               rise);
        default:
            return std::string(verdict.summary);
    }
}

std::string at_rest_text(Response const& response, MovementSpec const& movement, IntensityUnit const& length) {
    bool const moved = response.peak_slip_m > 0 || response.peak_rotation_rad > 0;
    return response.verdict == Verdict::at_rest && moved
               ? fmt::format(" ({})", verdict_text(entry_of(response.verdict), movement, length))
               : std::string();
}

}  // namespace overturn
