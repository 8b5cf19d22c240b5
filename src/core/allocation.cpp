#include "core/allocation.hpp"

#include <cstdlib>  // says whether this is glibc

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace overturn {

void keep_freed_memory() {
#if defined(__GLIBC__)
    constexpr int largest_block = 32 << 20;  // as much as glibc allows
    constexpr int kept = 256 << 20;
    mallopt(M_MMAP_THRESHOLD, largest_block);
    mallopt(M_TRIM_THRESHOLD, kept);
#endif
}

}  // namespace overturn
