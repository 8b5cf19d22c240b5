/// When a campaign that ends where it is precise enough is looked at.
#pragma once

#include <cstdint>

namespace overturn {

/// Waves after which a target is looked at first, of a campaign of so many: whole blocks. It decides where the campaign
/// ends, so that it depends on nothing else.
[[nodiscard]] std::int64_t waves_per_look(std::int64_t waves);

}  // namespace overturn
