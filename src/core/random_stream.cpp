#include "core/random_stream.hpp"

#include <cstddef>
#include <limits>

#include <Random123/threefry.h>

#include "core/error.hpp"

namespace overturn {

gsl_rng_type const RandomStream::type = {
    "threefry4x64-20", std::numeric_limits<unsigned long>::max(), 0, sizeof(State), &refuse_seed, &next, &next_unit};

RandomStream::RandomStream(StreamKey const& key)
    : state_{{key.seed, key.wave, static_cast<std::uint64_t>(key.purpose), key.index}, 0, {}, 0},
      rng_{&type, &state_} {}

unsigned long RandomStream::next(void* state) {
    auto& s = *static_cast<State*>(state);
    if (s.left == 0) {
        r123::Threefry4x64 threefry;
        auto const block = threefry({{s.counter, 0, 0, 0}}, {{s.key[0], s.key[1], s.key[2], s.key[3]}});
        s.block = std::to_array({block[0], block[1], block[2], block[3]});
        s.left = 4;
        ++s.counter;
    }
    return s.block.at(4 - s.left--);
}

double RandomStream::next_unit(void* state) {
    constexpr double ulp = 0x1p-53;
    return static_cast<double>(next(state) >> 11U) * ulp;
}

void RandomStream::refuse_seed(void* /*state*/, unsigned long /*seed*/) {
    throw ContractError("a random stream is keyed at construction, never seeded");
}

}  // namespace overturn
