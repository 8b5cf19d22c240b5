#include "stats/response_bins.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace overturn {

std::vector<ResponseBin> response_bins(std::span<ResponseTrial const> trials) {
    constexpr std::array edges{0.0,  0.5, 0.75, 1.0, 1.25, 1.5,
                               1.75, 2.0, 2.5,  3.0, 4.0,  std::numeric_limits<double>::infinity()};
    std::vector<ResponseBin> bins;
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        ResponseBin bin{edges[i], edges[i + 1], 0, {}, {}};
        std::vector<double> without;
        std::vector<double> with;
        for (auto const& trial : trials) {
            if (trial.offered < bin.from || trial.offered >= bin.to) {
                continue;
            }
            if (trial.overturned) {
                ++bin.overturned;
            } else {
                (trial.slipped ? with : without).push_back(trial.responded);
            }
        }
        if (bin.overturned > 0 || !without.empty() || !with.empty()) {
            bin.without_slip = ratio_quantiles(std::move(without));
            bin.with_slip = ratio_quantiles(std::move(with));
            bins.push_back(bin);
        }
    }
    return bins;
}

}  // namespace overturn
