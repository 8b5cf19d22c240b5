#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <vector>

#include <fmt/format.h>

#include "core/elapsed.hpp"
#include "core/error.hpp"
#include "qualify/installation.hpp"
#include "store/block_lock.hpp"
#include "store/durable.hpp"

namespace overturn::qualify {
namespace {

Check durable_writes(std::filesystem::path const& folder) {
    constexpr std::size_t bytes = 65'536;  // a block's
    constexpr int writes = 20;
    std::vector<std::byte> const content(bytes, std::byte{0x5a});
    std::vector<double> milliseconds;
    int wrong = 0;
    for (int i = 0; i < writes; ++i) {
        auto const path = folder / fmt::format("block-{}", i);
        auto const begin = Clock::now();
        store::write_durably(path, content);
        milliseconds.push_back(1e3 * seconds_since(begin));
        auto const found = store::read_file(path);
        wrong += found.size() != bytes || std::memcmp(found.data(), content.data(), bytes) != 0 ? 1 : 0;
    }
    std::ranges::sort(milliseconds);
    return {"F-01",
            "blocks are there, whole, after sync and rename",
            "POSIX",
            "files that differ",
            static_cast<double>(wrong),
            0,
            0,
            fmt::format("a block takes {:.1f} ms, {:.1f} ms at most", milliseconds[writes / 2], milliseconds.back())};
}

Check locks(std::filesystem::path const& folder) {
    Check check{"F-02", "a second run on the same output is refused", "POSIX, open-file locks", "runs let in", 1, 0, 0};
    store::BlockLock const first(folder / "output.parts", {0, 4});
    try {
        store::BlockLock const second(folder / "output.parts", {2, 3});
        check.remark = "no locks here: never start two runs on one output";
    } catch (SystemError const&) {
        check.found = 0;
    }
    return check;
}

}  // namespace

Checks file_system_checks(std::filesystem::path const& folder) { return {durable_writes(folder), locks(folder)}; }

}  // namespace overturn::qualify
