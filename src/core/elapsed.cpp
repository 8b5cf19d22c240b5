#include "core/elapsed.hpp"

namespace overturn {
namespace {

Clock::time_point const loaded = Clock::now();

}  // namespace

Clock::time_point program_begin() { return loaded; }

}  // namespace overturn
