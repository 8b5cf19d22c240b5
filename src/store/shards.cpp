#include "store/shards.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include <fmt/format.h>

#include "core/error.hpp"
#include "store/durable.hpp"
#include "store/sha256.hpp"

namespace overturn::store {
namespace {

constexpr std::string_view magic = "overturn-block 1\n";
constexpr std::string_view ending = ".block";
constexpr std::string_view leg_ending = ".leg";
constexpr std::string_view record_name = "campaign.record";
constexpr std::size_t hash_length = 64;

std::span<std::byte const> bytes_of(std::string const& text) { return std::as_bytes(std::span(text)); }

// A shard: one line of magic, the campaign's hash, the block's number, then the rows; last, the hash of all before it.
std::string shard_text(std::string const& campaign, std::int64_t block, std::span<std::byte const> rows) {
    std::string text = fmt::format("{}{}\n{}\n", magic, campaign, block);
    text.append(reinterpret_cast<char const*>(rows.data()), rows.size());
    text += sha256(text);
    return text;
}

std::string name_of(std::int64_t block) { return fmt::format("{:010}{}", block, ending); }

// The number of the block a file of this name holds; nothing if we never give out such a name.
std::optional<std::int64_t> block_of(std::string_view name) {
    std::int64_t block = -1;
    std::from_chars(name.data(), name.data() + name.size(), block);
    return block >= 0 && name == name_of(block) ? std::optional(block) : std::nullopt;
}

bool is_unfinished(std::string_view name) { return name.find(unfinished_mark) != std::string_view::npos; }

// What the file is, or was to become.
std::string_view finished_name(std::string_view name) { return name.substr(0, name.find(unfinished_mark)); }

}  // namespace

ShardFolder::ShardFolder(std::filesystem::path output, std::string campaign)
    : folder_(std::move(output)), campaign_(std::move(campaign)) {
    folder_ += ".parts";
}

bool ShardFolder::exists() const { return std::filesystem::is_directory(folder_); }

std::string ShardFolder::begun_with() const {
    auto const record = folder_ / record_name;
    if (!std::filesystem::exists(record)) {
        return {};
    }
    auto const text = read_file(record);
    auto const length = text.size() < hash_length ? 0 : text.size() - hash_length;
    if (sha256(std::string_view(text).substr(0, length)) != std::string_view(text).substr(length)) {
        throw SystemError(fmt::format(
            "{}: damaged (its checksum does not match). Go on with: overturn run CAMPAIGN --resume", record.string()));
    }
    return text.substr(0, length);
}

void ShardFolder::begin(std::string const& campaign_record) const {
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (error) {
        throw SystemError(
            fmt::format("cannot make {} ({}). Choose another place with -o", folder_.string(), error.message()));
    }
    make_durable(folder_.has_parent_path() ? folder_.parent_path() : std::filesystem::path("."));
    (void)create_durably(folder_ / record_name, bytes_of(campaign_record + sha256(campaign_record)));
}

void ShardFolder::begin_again(std::string const& campaign_record) const {
    write_durably(folder_ / record_name, bytes_of(campaign_record + sha256(campaign_record)));
}

std::filesystem::path ShardFolder::file_of(std::int64_t block) const { return folder_ / name_of(block); }

void ShardFolder::commit(std::int64_t block, std::span<std::byte const> rows) const {
    auto const text = shard_text(campaign_, block, rows);
    write_durably(file_of(block), bytes_of(text));
}

ShardFolder::Block ShardFolder::look_into(std::int64_t block) const {
    auto const path = file_of(block);
    auto const text = read_file(path);
    auto const head = fmt::format("{}{}\n{}\n", magic, campaign_, block);
    auto const refused = [&](Content content, char const* why) {
        return Block{content, fmt::format("{}: {}. With --resume it is computed again", path.string(), why), {}};
    };
    if (text.size() < head.size() + hash_length || !text.starts_with(magic)) {
        return refused(Content::damaged, "not a whole block (truncated or foreign)");
    }
    auto const body = std::string_view(text).substr(0, text.size() - hash_length);
    if (sha256(body) != std::string_view(text).substr(body.size())) {
        return refused(Content::damaged, "damaged (its checksum does not match)");
    }
    if (!text.starts_with(head)) {
        return refused(Content::foreign, "a block of another campaign or place (or of another program)");
    }
    auto const rows = std::as_bytes(std::span(body.substr(head.size())));
    return {Content::ours, {}, {rows.begin(), rows.end()}};
}

std::vector<std::byte> ShardFolder::read(std::int64_t block) const {
    auto found = look_into(block);
    if (found.content != Content::ours) {
        throw SystemError(found.problem);
    }
    return std::move(found.rows);
}

// By name alone; others that look alike are told of in `notes`, if given.
std::vector<std::int64_t> ShardFolder::block_files(std::vector<std::string>* notes) const {
    std::vector<std::int64_t> blocks;
    if (!exists()) {
        return blocks;
    }
    for (auto const& entry : std::filesystem::directory_iterator(folder_)) {
        auto const name = entry.path().filename().string();
        if (!name.ends_with(ending)) {
            continue;
        }
        if (auto const block = block_of(name)) {
            blocks.push_back(*block);
        } else if (notes != nullptr) {
            notes->push_back(fmt::format("{}: not a block of ours (left alone)", entry.path().string()));
        }
    }
    std::sort(blocks.begin(), blocks.end());
    return blocks;
}

std::vector<std::int64_t> ShardFolder::committed(BlockRange range, std::vector<std::string>& notes,
                                                 std::function<std::size_t(std::int64_t)> const& bytes) const {
    std::vector<std::int64_t> sound;
    for (auto const block : block_files(&notes)) {
        if (!range.holds(block)) {
            continue;
        }
        try {
            auto const found = look_into(block);
            if (found.content != Content::ours) {
                notes.push_back(found.problem);
            } else if (bytes && found.rows.size() != bytes(block)) {
                notes.push_back(fmt::format("{}: {} bytes of rows (must be {}). With --resume it is computed again",
                                            file_of(block).string(), found.rows.size(), bytes(block)));
            } else {
                sound.push_back(block);
            }
        } catch (SystemError const& error) {  // cannot be read, or another process has just removed it
            notes.emplace_back(error.what());
        }
    }
    std::sort(notes.begin(), notes.end());
    return sound;
}

bool ShardFolder::holds_foreign_blocks() const {
    auto const blocks = block_files(nullptr);
    return std::any_of(blocks.begin(), blocks.end(),
                       [&](std::int64_t block) { return look_into(block).content == Content::foreign; });
}

bool ShardFolder::holds_blocks() const { return !block_files(nullptr).empty(); }

void ShardFolder::keep_leg(std::string const& text) const {
    int number = 1;
    while (!create_durably(folder_ / fmt::format("{:06}{}", number, leg_ending), bytes_of(text))) {
        ++number;
    }
}

std::vector<std::string> ShardFolder::legs() const {
    std::vector<std::filesystem::path> files;
    std::error_code ignored;
    for (auto const& entry : std::filesystem::directory_iterator(folder_, ignored)) {
        if (entry.path().filename().string().ends_with(leg_ending)) {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    std::vector<std::string> texts;
    texts.reserve(files.size());
    for (auto const& file : files) {
        texts.push_back(read_file(file));
    }
    return texts;
}

void ShardFolder::remove_unfinished(BlockRange range) const {
    std::error_code ignored;
    for (auto const& entry : std::filesystem::directory_iterator(folder_, ignored)) {
        auto const name = entry.path().filename().string();
        auto const block = block_of(finished_name(name));
        if (is_unfinished(name) && block && range.holds(*block)) {
            std::filesystem::remove(entry.path(), ignored);
        }
    }
}

// The record goes after the blocks, so that what a kill leaves in between can still be told.
void ShardFolder::remove() const {
    std::error_code ignored;
    for (auto const& entry : std::filesystem::directory_iterator(folder_, ignored)) {
        if (block_of(finished_name(entry.path().filename().string()))) {
            std::filesystem::remove(entry.path(), ignored);
        }
    }
    for (auto const& entry : std::filesystem::directory_iterator(folder_, ignored)) {
        auto const file = entry.path().filename().string();
        if (finished_name(file) == record_name || finished_name(file).ends_with(leg_ending)
            || file == Claim::file_name) {
            std::filesystem::remove(entry.path(), ignored);
        }
    }
    std::filesystem::remove(folder_, ignored);  // stays if anything foreign lies in it
}

}  // namespace overturn::store
