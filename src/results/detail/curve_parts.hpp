/// What fitting makes of a curve, part by part: a new member does not compile before it is named here.
#pragma once

#include "core/bytes.hpp"
#include "stats/beta_split.hpp"
#include "stats/fragility.hpp"

namespace overturn {

/// \param bytes BytesOut, or BytesIn and a fit that is not const
template <class Bytes, class Fit>
requires std::is_same_v<std::remove_const_t<Fit>, FragilityFit>
void each_part(Bytes& bytes, Fit& fit) {
    auto& [state, passing, flags, trials, overturned, undecided, waves, waves_known, group_size, lowest, highest,
           lowest_proportion, line, profile, bootstrap, ends, method, replicates, replicates_without_curve, refits,
           extreme_refits, goodness, monotone, isotonic, isotonic_median, penalised, bound, pooled, beta_u_known,
           beta_u, beta_u_drawn, beta_u_stated, drawn, beside_five_percent, quotes, band] = fit;
    bytes(state, passing, flags, trials, overturned, undecided, waves, waves_known, group_size, lowest, highest,
          lowest_proportion, line, profile, bootstrap, ends, method, replicates, replicates_without_curve, refits,
          extreme_refits, goodness, monotone, isotonic, isotonic_median, penalised, bound, pooled, beta_u_known, beta_u,
          beta_u_drawn, beta_u_stated, drawn, beside_five_percent, quotes, band);
}

template <class Bytes, class Split>
requires std::is_same_v<std::remove_const_t<Split>, BetaSplit>
void each_part(Bytes& bytes, Split& split) {
    auto& [beta_r, beta_u, per_score, per_score_error, replicates] = split;
    bytes(beta_r, beta_u, per_score, per_score_error, replicates);
}

}  // namespace overturn
