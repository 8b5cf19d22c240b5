/// Extremes of a motion by chunks of samples: what cannot move a body is passed a chunk at a time.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace overturn {

class ChunkExtremes {
  public:
    static constexpr std::size_t samples = 64;  ///< of a chunk

    ChunkExtremes() = default;
    /// \param vertical may be empty
    ChunkExtremes(std::span<double const> horizontal, std::span<double const> vertical);

    struct Chunk {
        double strongest = 0;            ///< largest |horizontal|
        double lowest = 0, highest = 0;  ///< vertical
    };
    /// Extremes of the whole chunk that begins at `sample`; null if none does.
    [[nodiscard]] Chunk const* at(std::size_t sample) const {
        return sample % samples == 0 && sample / samples < chunks_.size() ? &chunks_[sample / samples] : nullptr;
    }

  private:
    std::vector<Chunk> chunks_;
};

}  // namespace overturn
