/// Instruction sets that lanes are compiled for: AVX-512, AVX2 and plain doubles on x86; those of the machine
/// elsewhere. Every file with lanes includes it before <hwy/foreach_target.h>, so that all choose among the same.
#pragma once

// Without fused multiply-add (SSE) a plain lane with std::fma is as fast and gives the same bits.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4)

// Where Highway would take arrays for registers, it does not fuse: a plain lane there too.
#define HWY_BROKEN_EMU128 1

// What takes lanes is inlined, or they would travel through memory. GCC's sanitizers watch every access of what is
// inlined, again wherever it is: a quarter of an hour of compiling for a long kernel. Calls bring that to a minute.
#if defined(__SANITIZE_ADDRESS__)
#define OVERTURN_LANES_INLINE inline
#else
#define OVERTURN_LANES_INLINE HWY_INLINE
#endif
