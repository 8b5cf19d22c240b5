/// The instruction sets that lanes can run on here: one of them is chosen for good when lanes are first used.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace overturn::simd {

/// Instruction sets that simd/targets.hpp has compiled and this machine supports, as Highway's numbers; the best first,
/// plain doubles last.
[[nodiscard]] std::vector<std::int64_t> instruction_sets();

[[nodiscard]] std::string_view name_of(std::int64_t instruction_set);

/// While it lives, lanes run on one instruction set. For tests and measurements; no other thread may use lanes
/// meanwhile.
class OnlyInstructionSet {
  public:
    /// \pre `instruction_set` is one of instruction_sets()
    explicit OnlyInstructionSet(std::int64_t instruction_set);
    ~OnlyInstructionSet();
    OnlyInstructionSet(OnlyInstructionSet const&) = delete;
    OnlyInstructionSet& operator=(OnlyInstructionSet const&) = delete;
    OnlyInstructionSet(OnlyInstructionSet&&) = delete;
    OnlyInstructionSet& operator=(OnlyInstructionSet&&) = delete;
};

}  // namespace overturn::simd
