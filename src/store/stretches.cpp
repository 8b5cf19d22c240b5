#include "store/stretches.hpp"

#include <algorithm>
#include <fstream>

#include <fmt/format.h>

#include "core/error.hpp"
#include "store/sha256.hpp"

namespace overturn::store {

std::vector<Stretch> stretches_of(std::uint64_t at, std::uint64_t bytes, std::uint64_t each) {
    OVERTURN_EXPECT(each > 0);
    std::vector<Stretch> stretches;
    stretches.reserve(bytes / each + 1);
    for (std::uint64_t done = 0; done < bytes; done += each) {
        stretches.push_back({at + done, std::min(each, bytes - done)});
    }
    return stretches;
}

std::vector<std::string> hash_stretches(std::filesystem::path const& path, std::span<Stretch const> stretches) {
    constexpr std::uint64_t at_once = 1 << 20;
    std::vector<std::string> digests;
    digests.reserve(stretches.size());
    std::ifstream file(path, std::ios::binary);
    std::vector<char> part(at_once);
    for (auto const& stretch : stretches) {
        Sha256 hash;
        file.seekg(static_cast<std::streamoff>(stretch.at));
        for (auto left = stretch.bytes; left > 0;) {
            auto const size = std::min(left, at_once);
            if (!file.read(part.data(), static_cast<std::streamsize>(size))) {
                throw SystemError(
                    fmt::format("cannot read {} (a failing disk?). Check the disk and retry", path.string()));
            }
            hash.add(std::as_bytes(std::span(part).first(size)));
            left -= size;
        }
        digests.push_back(hash.digits());
    }
    return digests;
}

}  // namespace overturn::store
