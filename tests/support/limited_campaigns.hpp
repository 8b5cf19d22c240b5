/// A campaign of a body that slides, with limit states, and rows to hold to them.
#pragma once

#include <string>

#include "campaign/rows.hpp"
#include "support/campaigns.hpp"

namespace overturn::testing {

inline std::string const sliding_body = type_a + "friction=0.5\n";
inline std::string const touches = "[[limits]]\nname='touches'\nquantity='peak_slip'\nabove='30 cm'\n";
inline std::string const tilts = "[[limits]]\nname='tilts'\nquantity='peak_rotation_ratio'\nabove=0.5\n";

inline CampaignSpec with_limits(std::string const& limits, std::string const& more = "") {
    return campaign_from(quick_waves + sliding_body + levels("values=[3,6,9]\n") + limits + more);
}

inline TrialRow row_of(Verdict verdict, double slip, double ratio) {
    TrialRow row;
    row.verdict = verdict;
    row.peak_slip_m = slip;
    row.peak_rotation_ratio = ratio;
    return row;
}

}  // namespace overturn::testing
