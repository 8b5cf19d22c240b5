/// Names and places of the files of finished blocks: the first 1024 beside the record, each further 1024 in a folder of
/// their own, since a folder of 10^5 files is slow on every file system.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "store/block_lock.hpp"

namespace overturn::store {

inline constexpr std::string_view block_ending = ".block";

/// "0000000012.block", "0000007.blocks/0000007168.block"
[[nodiscard]] std::filesystem::path place_of_block(std::int64_t block);

/// One file or folder, as it was listed.
struct ShardEntry {
    std::filesystem::path path;
    std::string name;
    std::int64_t group = 0;  ///< number of the folder of blocks that it lies in; 0: beside the record

    /// The block that it holds, or was to become; nothing for whatever does not lie where we put blocks.
    [[nodiscard]] std::optional<std::int64_t> block() const;
    /// Is it a folder of blocks, by its name?
    [[nodiscard]] bool is_group() const { return number_of_group().has_value(); }
    [[nodiscard]] std::optional<std::int64_t> number_of_group() const;
    /// Is it a file that a killed writer left?
    [[nodiscard]] bool is_unfinished() const;
    /// Name of the finished file that it is, or was to become.
    [[nodiscard]] std::string finished_name() const;
};

/// All that lies beside the record; nothing where there is no folder. \throws SystemError if it cannot be listed
void each_beside_record(std::filesystem::path const& folder, std::function<void(ShardEntry const&)> const& look);
/// All that lies in a folder of blocks. \throws likewise
void each_in_group(ShardEntry const& group, std::function<void(ShardEntry const&)> const& look);
/// Calls `look` for all that lies beside the record except folders of blocks, and for all that lies in those folders
/// that may hold some of the range.
void each_file(std::filesystem::path const& folder, BlockRange const& range,
               std::function<void(ShardEntry const&)> const& look);

}  // namespace overturn::store
