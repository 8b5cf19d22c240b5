/// Randomness by identity: every stream is a pure function of (campaign seed, wave, purpose, index), never of rank or
/// order.
#pragma once

#include <array>
#include <cstdint>

#include <gsl/gsl_rng.h>

namespace overturn {

/// One separate stream per physical cause, so that a draw added to one cause leaves the others' numbers alone.
/// Values are part of what a seed means: never renumber them.
enum class Purpose : std::uint64_t {
    wave_phase = 0,
    wave_amplitude = 1,
    wave_envelope = 2,
    body_scatter = 3,
    restitution_scatter = 4,
    friction_scatter = 5,
    record_choice = 6,
    calibration = 7,
    bootstrap = 8,
    rare_normals = 9,
    rare_choice = 10,
    target_spectrum = 11,
    event_spectrum = 12,
    shape_test = 13,
};

/// What all numbers of a stream follow from.
struct StreamKey {
    std::uint64_t seed = 0, wave = 0;
    Purpose purpose = Purpose::wave_phase;
    std::uint64_t index = 0;  ///< separates streams of one purpose within one wave: a motion's component, a body
};

/// A Threefry4x64-20 counter stream (Salmon et al., SC'11) behind GSL's generator interface, so that every
/// distribution is GSL's. Making one costs nanoseconds; make one where it is needed, share none.
class RandomStream {
  public:
    explicit RandomStream(StreamKey const& key);
    RandomStream(std::uint64_t seed, std::uint64_t wave, Purpose purpose, std::uint64_t index = 0)
        : RandomStream(StreamKey{seed, wave, purpose, index}) {}

    /// For GSL's distributions; valid as long as this object stays where it is.
    [[nodiscard]] gsl_rng* gsl() { return &rng_; }

    /// The next 64 random bits.
    std::uint64_t bits() { return gsl_rng_get(&rng_); }

    RandomStream(RandomStream const&) = delete;
    RandomStream& operator=(RandomStream const&) = delete;
    RandomStream(RandomStream&&) = delete;
    RandomStream& operator=(RandomStream&&) = delete;
    ~RandomStream() = default;

  private:
    struct State {
        std::array<std::uint64_t, 4> key;
        std::uint64_t counter;
        std::array<std::uint64_t, 4> block;
        std::uint64_t left;
    };
    static unsigned long next(void* state);
    static double next_unit(void* state);
    static void refuse_seed(void* state, unsigned long seed);
    static gsl_rng_type const type;

    State state_;
    gsl_rng rng_;
};

}  // namespace overturn
