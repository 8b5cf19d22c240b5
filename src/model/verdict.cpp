#include "model/verdict.hpp"

#include <array>

namespace overturn {

std::span<VerdictEntry const> common_verdicts() {
    static constexpr std::array entries{
        VerdictEntry{Verdict::at_rest, "at-rest", "moved less than the threshold of movement", false, true, false},
        VerdictEntry{Verdict::slid, "slid", "slid, and its base hardly uplifted", true, true, false},
        VerdictEntry{Verdict::rocked, "rocked", "uplifted, hardly slid, and stayed upright", true, true, false},
        VerdictEntry{Verdict::slid_and_rocked, "slid-and-rocked", "slid, uplifted and stayed upright", true, true,
                     false},
        VerdictEntry{Verdict::overturned, "overturned", "fell over", true, true, true},
        VerdictEntry{Verdict::contact_lost, "contact-lost", "lost contact with the ground, beyond the model that ran",
                     true, false, false},
        VerdictEntry{Verdict::failed, "failed", "no verdict, for the reason given", false, false, false}};
    return entries;
}

}  // namespace overturn
