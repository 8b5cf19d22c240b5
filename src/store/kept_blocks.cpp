#include "store/kept_blocks.hpp"

#include <limits>

#include <fmt/format.h>

#include "core/error.hpp"
#include "store/shards.hpp"

namespace overturn::store {

std::int64_t blocks_beside(std::filesystem::path const& output) {
    ShardFolder const shards(output, "");
    try {
        return shards.begun_with().empty() ? 0
                                           : std::ssize(shards.listed({0, std::numeric_limits<std::int64_t>::max()}));
    } catch (SystemError const&) {
        return 0;  // a damaged record, or a folder that cannot be listed: who goes on is told
    } catch (std::filesystem::filesystem_error const&) {
        return 0;  // a folder that may not be entered: likewise
    }
}

std::string advice_beside_blocks(std::filesystem::path const& output, std::string_view otherwise) {
    auto const blocks = blocks_beside(output);
    return blocks == 0 ? std::string(otherwise)
                       : fmt::format(
                           "Move it away, then overturn merge {} or overturn run --resume: the finished blocks "
                           "in {}.parts are kept ({})",
                           output.string(), output.string(), blocks);
}

}  // namespace overturn::store
