/// Long files and columns are hashed in stretches of fixed length, and then the digests of these: so that several
/// processes can hash one file together, and get the digest that one alone gets.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace overturn::store {

/// Part of a file [bytes].
struct Stretch {
    std::uint64_t at = 0, bytes = 0;

    [[nodiscard]] std::uint64_t end() const { return at + bytes; }
    bool operator==(Stretch const&) const = default;
    /// By where they begin.
    bool operator<(Stretch const& other) const { return std::pair(at, bytes) < std::pair(other.at, other.bytes); }
};

using Stretches = std::set<Stretch>;                    ///< they may overlap
using StretchDigests = std::map<Stretch, std::string>;  ///< SHA-256, as 64 hexadecimal digits

inline constexpr std::uint64_t file_stretch = std::uint64_t{64} << 20U;   ///< of a file that is sealed [bytes]
inline constexpr std::uint64_t column_stretch = std::uint64_t{4} << 20U;  ///< of a column [bytes]

/// The stretches of `bytes` from `at` on, each of `each` bytes but the last.
[[nodiscard]] Stretches stretches_of(std::uint64_t at, std::uint64_t bytes, std::uint64_t each);

/// The parts of `whole` that lie in none of `others`. \pre these do not overlap
[[nodiscard]] Stretches outside(Stretch whole, Stretches const& others);

/// Digest of each stretch. A byte is read once, of however many stretches it is. \throws SystemError if the file cannot
/// be read
[[nodiscard]] StretchDigests hash_stretches(std::filesystem::path const& path, Stretches const& stretches);

/// hash_stretches, or what does the same with the help of other processes. All that begins in one stretch of the file
/// (file_stretch) is read by one process.
using HashStretches = std::function<StretchDigests(std::filesystem::path const& path, Stretches const& stretches)>;

}  // namespace overturn::store
