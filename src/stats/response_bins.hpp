/// Response of a body (V_resp) to the energy that its waves offered (V_WES), with and without slip.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "stats/criterion.hpp"

namespace overturn {

/// One decided trial that moved.
struct ResponseTrial {
    double offered = 0;    ///< V_WES / V_Ereq
    double responded = 0;  ///< V_resp / V_Ereq, at most 1
    bool slipped = false, overturned = false;
};

/// Trials with `from` <= offered < `to`.
struct ResponseBin {
    double from = 0, to = 0;  ///< the last one is open: infinite
    std::int64_t overturned = 0;
    std::optional<RatioQuantiles> without_slip, with_slip;  ///< V_resp / V_Ereq of those that stood
};

/// Only bins that hold a trial, rising. A plateau, as the paper reports one beyond V_WES = V_Ereq (PATRAM 2013, figure
/// 12), is a median that stops rising from bin to bin.
[[nodiscard]] std::vector<ResponseBin> response_bins(std::span<ResponseTrial const> trials);

}  // namespace overturn
