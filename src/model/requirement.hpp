/// Why a trial needs a model that cheaper ones cannot stand in for.
#pragma once

#include <cstdint>
#include <string_view>

#include "model/effect.hpp"

namespace overturn {

/// One reason to call for an effect. Numbers are stored in results files: never renumber, never share.
struct ReasonEntry {
    std::int64_t number = 0;  ///< from 1
    std::string_view name;    ///< "transverse-motion"
    std::string_view summary;
};

inline constexpr std::int64_t no_reason = 0;
inline constexpr std::int64_t stated_reason = 1;
inline constexpr std::int64_t left_out_reason = 100;

/// Effects that a model finds acting on a trial.
struct Requirement {
    EffectMask effects = 0;
    std::int64_t reason = 0;  ///< one of the model's own; 0: its first
};

}  // namespace overturn
