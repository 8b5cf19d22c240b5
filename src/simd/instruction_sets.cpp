#include "simd/instruction_sets.hpp"

#include "simd/targets.hpp"
// The targets come first: they say what Highway compiles.
#include <hwy/targets.h>

namespace overturn::simd {
namespace {

void choose(std::int64_t among) {
    hwy::SetSupportedTargetsForTest(among);  // none: what the machine has
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace

std::vector<std::int64_t> instruction_sets() {
    // Highway's better ones have the lower bits; the fallback always runs, whether it counts as supported or not.
    auto const usable = (hwy::SupportedTargets() & HWY_TARGETS) | HWY_STATIC_TARGET;
    std::vector<std::int64_t> sets;
    for (std::uint64_t rest = usable; rest != 0; rest &= rest - 1) {
        sets.push_back(rest & (~rest + 1));
    }
    return sets;
}

std::string_view name_of(std::int64_t instruction_set) { return hwy::TargetName(instruction_set); }

OnlyInstructionSet::OnlyInstructionSet(std::int64_t instruction_set) { choose(instruction_set); }
OnlyInstructionSet::~OnlyInstructionSet() { choose(0); }

}  // namespace overturn::simd
