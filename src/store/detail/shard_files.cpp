#include "store/detail/shard_files.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/next_step.hpp"
#include "store/durable.hpp"
#include "store/shards.hpp"

namespace overturn::store {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view group_ending = ".blocks";

std::string name_of_block(std::int64_t block) { return fmt::format("{:010}{}", block, block_ending); }
std::string name_of_group(std::int64_t group) { return fmt::format("{:07}{}", group, group_ending); }

std::int64_t leading_number(std::string_view name) {
    std::int64_t number = -1;
    std::from_chars(name.data(), name.data() + name.size(), number);
    return number;
}

// Folders may vanish while they are listed: another process removes what is merged.
void each_in(fs::path const& folder, std::int64_t group, std::function<void(ShardEntry const&)> const& look) {
    std::error_code error;
    fs::directory_iterator at(folder, error);
    for (; !error && at != fs::directory_iterator(); at.increment(error)) {
        look({at->path(), at->path().filename().string(), group});
    }
    if (error && error != std::errc::no_such_file_or_directory && error != std::errc::not_a_directory) {
        throw SystemError(fmt::format("{}: cannot be listed ({}). Make it readable, then {}", folder.string(),
                                      error.message(), next_step()));
    }
}

}  // namespace

fs::path place_of_block(std::int64_t block) {
    auto const name = name_of_block(block);
    return block < blocks_in_a_folder ? fs::path(name) : fs::path(name_of_group(block / blocks_in_a_folder)) / name;
}

std::optional<std::int64_t> ShardEntry::block() const {
    auto const finished = finished_name();
    auto const number = leading_number(finished);
    bool const ours = number >= 0 && finished == name_of_block(number) && number / blocks_in_a_folder == group;
    return ours ? std::optional(number) : std::nullopt;
}

std::optional<std::int64_t> ShardEntry::number_of_group() const {
    auto const number = leading_number(name);
    return group == 0 && number > 0 && name == name_of_group(number) ? std::optional(number) : std::nullopt;
}

bool ShardEntry::is_unfinished() const { return name.find(unfinished_mark) != std::string::npos; }

std::string ShardEntry::finished_name() const { return name.substr(0, name.find(unfinished_mark)); }

void each_beside_record(fs::path const& folder, std::function<void(ShardEntry const&)> const& look) {
    each_in(folder, 0, look);
}

void each_in_group(ShardEntry const& group, std::function<void(ShardEntry const&)> const& look) {
    each_in(group.path, *group.number_of_group(), look);
}

void each_file(fs::path const& folder, BlockRange const& range, std::function<void(ShardEntry const&)> const& look) {
    std::vector<ShardEntry> groups;
    each_beside_record(folder, [&](ShardEntry const& entry) {
        if (entry.is_group()) {
            groups.push_back(entry);
        } else {
            look(entry);
        }
    });
    auto const first = range.first / blocks_in_a_folder;
    auto const last = (range.last - 1) / blocks_in_a_folder;
    for (auto const& group : groups) {
        auto const number = *group.number_of_group();
        if (first <= number && number <= last) {
            each_in(group.path, number, look);
        }
    }
}

}  // namespace overturn::store
