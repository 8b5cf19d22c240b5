/// Long files and columns are hashed in stretches of fixed length, and then the digests of these: so that several
/// processes can hash one file together, and get the digest that one alone gets.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace overturn::store {

/// Part of a file [bytes].
struct Stretch {
    std::uint64_t at = 0, bytes = 0;
};

inline constexpr std::uint64_t file_stretch = std::uint64_t{64} << 20U;   ///< of a file that is sealed [bytes]
inline constexpr std::uint64_t column_stretch = std::uint64_t{4} << 20U;  ///< of a column [bytes]

/// The stretches of `bytes` from `at` on, each of `each` bytes but the last.
[[nodiscard]] std::vector<Stretch> stretches_of(std::uint64_t at, std::uint64_t bytes, std::uint64_t each);

/// SHA-256 of each stretch, as 64 hexadecimal digits. \throws SystemError if the file cannot be read
[[nodiscard]] std::vector<std::string> hash_stretches(std::filesystem::path const& path,
                                                      std::span<Stretch const> stretches);

/// hash_stretches, or what does the same with the help of other processes.
using HashStretches =
    std::function<std::vector<std::string>(std::filesystem::path const& path, std::span<Stretch const> stretches)>;

}  // namespace overturn::store
