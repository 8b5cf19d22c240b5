#include "store/stretches.hpp"

#include <algorithm>
#include <fstream>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "store/sha256.hpp"

namespace overturn::store {

Stretches stretches_of(std::uint64_t at, std::uint64_t bytes, std::uint64_t each) {
    OVERTURN_EXPECT(each > 0);
    Stretches stretches;
    for (std::uint64_t done = 0; done < bytes; done += each) {
        stretches.insert(stretches.end(), {at + done, std::min(each, bytes - done)});
    }
    return stretches;
}

Stretches outside(Stretch whole, Stretches const& others) {
    Stretches parts;
    auto at = whole.at;
    for (auto const& other : others) {
        if (auto const end = std::min(other.at, whole.end()); end > at) {
            parts.insert({at, end - at});
        }
        at = std::max(at, other.end());
    }
    if (at < whole.end()) {
        parts.insert({at, whole.end() - at});
    }
    return parts;
}

StretchDigests hash_stretches(std::filesystem::path const& path, Stretches const& stretches) {
    constexpr std::uint64_t at_once = 1 << 20;
    std::set<std::uint64_t> edges;
    for (auto const& stretch : stretches) {
        edges.insert({stretch.at, stretch.end()});
    }
    StretchDigests digests;
    std::map<Stretch, Sha256> open;
    auto next = stretches.begin();
    std::ifstream file(path, std::ios::binary);
    std::vector<char> part(at_once);
    for (auto edge = edges.begin(); edge != edges.end();) {
        auto at = *edge++;
        for (; next != stretches.end() && next->at == at; ++next) {
            open[*next];
        }
        for (auto& [stretch, hash] : open) {
            if (stretch.end() == at) {
                digests.emplace(stretch, hash.digits());
            }
        }
        std::erase_if(open, [&](auto const& one) { return one.first.end() == at; });
        file.seekg(static_cast<std::streamoff>(at));
        while (!open.empty() && at < *edge) {
            auto const size = std::min(*edge - at, at_once);
            if (!file.read(part.data(), static_cast<std::streamsize>(size))) {
                throw SystemError(
                    fmt::format("cannot read {} (a failing disk?). Check the disk and retry", path.string()));
            }
            for (auto& [stretch, hash] : open) {
                hash.add(std::as_bytes(std::span(part).first(size)));
            }
            at += size;
        }
    }
    return digests;
}

}  // namespace overturn::store
