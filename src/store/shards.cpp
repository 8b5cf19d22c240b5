#include "store/shards.hpp"

#include <algorithm>
#include <limits>
#include <system_error>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/next_step.hpp"
#include "store/detail/shard_files.hpp"
#include "store/durable.hpp"
#include "store/sha256.hpp"

namespace overturn::store {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view magic = "overturn-block 1\n";
constexpr std::string_view segment_ending = ".segment";
constexpr std::string_view record_name = "campaign.record";
constexpr std::size_t hash_length = 64;
constexpr std::string_view folder_ending = ".parts";
constexpr std::size_t aside_name_length = 16;  // of the key, in hexadecimal digits

bool is_aside(ShardEntry const& entry) {
    auto const& name = entry.name;
    return name.size() == aside_name_length + folder_ending.size() && name.ends_with(folder_ending)
           && name.find_first_not_of("0123456789abcdef") == aside_name_length && fs::is_directory(entry.path);
}

void move(fs::path const& from, fs::path const& to) {
    std::error_code error;
    fs::rename(from, to, error);
    if (error) {
        throw SystemError(fmt::format("cannot move {} to {} ({}). Make both writable, then {}", from.string(),
                                      to.string(), error.message(), next_step()));
    }
}

std::span<std::byte const> bytes_of(std::string const& text) { return std::as_bytes(std::span(text)); }

// A shard: one line of magic, the campaign's hash, the block's number, then the rows; last, the hash of all before it.
std::string shard_text(std::string const& campaign, std::int64_t block, std::span<std::byte const> rows) {
    std::string text = fmt::format("{}{}\n{}\n", magic, campaign, block);
    text.append(reinterpret_cast<char const*>(rows.data()), rows.size());
    text += sha256(text);
    return text;
}

[[noreturn]] void cannot_make(fs::path const& folder, std::error_code const& error, std::string const& advice) {
    throw SystemError(fmt::format("cannot make {} ({}). {}", folder.string(), error.message(), advice));
}

constexpr BlockRange everything{0, std::numeric_limits<std::int64_t>::max()};

}  // namespace

ShardFolder::ShardFolder(fs::path output, std::string campaign)
    : folder_(std::move(output)), campaign_(std::move(campaign)) {
    folder_ += folder_ending;
}

bool ShardFolder::exists() const { return fs::is_directory(folder_); }

std::string ShardFolder::begun_with() const {
    auto const record = folder_ / record_name;
    if (!fs::exists(record)) {
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
    fs::create_directories(folder_, error);
    if (error) {
        cannot_make(folder_, error, "Choose another place with -o");
    }
    make_durable(folder_.has_parent_path() ? folder_.parent_path() : fs::path("."));
    (void)create_durably(folder_ / record_name, bytes_of(campaign_record + sha256(campaign_record)));
}

void ShardFolder::begin_again(std::string const& campaign_record) const {
    write_durably(folder_ / record_name, bytes_of(campaign_record + sha256(campaign_record)));
}

fs::path ShardFolder::file_of(std::int64_t block) const { return folder_ / place_of_block(block); }

// Whoever made the folder may have been killed before it was safe: each rank sees to the folders that it uses.
void ShardFolder::make_group_of(fs::path const& file) const {
    auto const group = file.parent_path();
    if (group == folder_ || group == safe_group_) {
        return;
    }
    std::error_code error;
    fs::create_directory(group, error);
    if (error) {
        cannot_make(group, error, "Bring the folder back or free space, then " + next_step());
    }
    make_durable(folder_);
    safe_group_ = group;
}

void ShardFolder::commit(std::int64_t block, std::span<std::byte const> rows) const {
    PackedBlock const packed{block, {rows.begin(), rows.end()}};
    commit(std::span(&packed, 1));
}

void ShardFolder::commit(std::span<PackedBlock const> blocks) const {
    std::vector<std::string> texts;
    std::vector<FileContent> files;
    texts.reserve(blocks.size());
    for (auto const& block : blocks) {
        texts.push_back(shard_text(campaign_, block.number, block.rows));
        files.push_back({file_of(block.number), bytes_of(texts.back())});
        make_group_of(files.back().path);
    }
    write_durably(files);
}

ShardFolder::Block ShardFolder::look_into(std::int64_t block) const {
    auto const path = file_of(block);
    auto const text = read_file(path);
    auto const head = fmt::format("{}{}\n{}\n", magic, campaign_, block);
    auto const refused = [&](Content content, char const* why) {
        return Block{content, fmt::format("{}: {}. overturn run --resume computes it again", path.string(), why), {}};
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

// By name alone; other files with similar names are reported in `notes`, if given.
std::vector<std::int64_t> ShardFolder::block_files(BlockRange range, std::vector<std::string>* notes) const {
    std::vector<std::int64_t> blocks;
    each_file(folder_, range, [&](ShardEntry const& entry) {
        if (!entry.name.ends_with(block_ending)) {
            return;
        }
        if (auto const block = entry.block()) {
            blocks.push_back(*block);
        } else if (notes != nullptr) {
            notes->push_back(fmt::format("{}: not a block of this run (left as it is)", entry.path.string()));
        }
    });
    std::sort(blocks.begin(), blocks.end());
    return blocks;
}

std::vector<std::int64_t> ShardFolder::committed(BlockRange range, std::vector<std::string>& notes,
                                                 std::function<std::size_t(std::int64_t)> const& bytes) const {
    std::vector<std::int64_t> sound;
    for (auto const block : block_files(range, &notes)) {
        if (!range.holds(block)) {
            continue;
        }
        try {
            auto const found = look_into(block);
            if (found.content != Content::ours) {
                notes.push_back(found.problem);
            } else if (bytes && found.rows.size() != bytes(block)) {
                notes.push_back(
                    fmt::format("{}: {} bytes of rows (must be {}). overturn run --resume computes it again",
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

std::vector<std::int64_t> ShardFolder::listed(BlockRange range) const {
    auto blocks = block_files(range, nullptr);
    std::erase_if(blocks, [&](std::int64_t block) { return !range.holds(block); });
    return blocks;
}

bool ShardFolder::holds_foreign_blocks() const {
    auto const blocks = block_files(everything, nullptr);
    return std::any_of(blocks.begin(), blocks.end(),
                       [&](std::int64_t block) { return look_into(block).content == Content::foreign; });
}

bool ShardFolder::holds_blocks() const { return !block_files(everything, nullptr).empty(); }

// Folders of blocks go whole; where one is there already, from a time when it was set aside before, file by file.
void ShardFolder::set_aside(std::string const& key) const {
    ShardFolder const other(folder_ / key.substr(0, aside_name_length), key);
    other.begin(begun_with());
    std::vector<ShardEntry> entries;
    each_beside_record(folder_, [&](ShardEntry const& entry) {
        if (entry.is_group() || (entry.block() && !entry.is_unfinished())) {
            entries.push_back(entry);
        }
    });
    for (auto const& entry : entries) {
        auto const place = other.folder_ / entry.name;
        if (!entry.is_group() || !fs::exists(place)) {
            move(entry.path, place);
            continue;
        }
        each_in_group(entry, [&](ShardEntry const& file) {
            if (file.block() && !file.is_unfinished()) {
                move(file.path, place / file.name);
            }
        });
        make_durable(place);
    }
    make_durable(other.folder_);
    make_durable(folder_);
}

std::vector<fs::path> ShardFolder::aside() const {
    std::vector<fs::path> outputs;
    each_beside_record(folder_, [&](ShardEntry const& entry) {
        if (is_aside(entry)) {
            outputs.push_back(folder_ / entry.name.substr(0, aside_name_length));
        }
    });
    std::sort(outputs.begin(), outputs.end());
    return outputs;
}

void ShardFolder::keep_segment(std::string const& text) const {
    int number = 1;
    while (!create_durably(folder_ / fmt::format("{:06}{}", number, segment_ending), bytes_of(text))) {
        ++number;
    }
}

std::vector<std::string> ShardFolder::segments() const {
    std::vector<fs::path> files;
    std::error_code ignored;
    for (auto const& entry : fs::directory_iterator(folder_, ignored)) {
        if (entry.path().filename().string().ends_with(segment_ending)) {
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
    each_file(folder_, range, [&](ShardEntry const& entry) {
        auto const block = entry.block();
        if (entry.is_unfinished() && block && range.holds(*block)) {
            std::error_code ignored;
            fs::remove(entry.path, ignored);
        }
    });
}

void ShardFolder::remove_blocks(BlockRange range) const {
    each_file(folder_, range, [&](ShardEntry const& entry) {
        if (auto const block = entry.block(); block && range.holds(*block)) {
            std::error_code ignored;
            fs::remove(entry.path, ignored);
        }
    });
}

// The record goes after the blocks, so that the remains of a kill in between can still be identified.
void ShardFolder::remove() const {
    for (auto const& output : aside()) {
        ShardFolder(output, "").remove();
    }
    remove_blocks(everything);
    std::error_code ignored;
    each_beside_record(folder_, [&](ShardEntry const& entry) {
        auto const file = entry.finished_name();
        if (file == record_name || file.ends_with(segment_ending) || file == BlockLock::file_name || entry.is_group()) {
            fs::remove(entry.path, ignored);  // folders stay if anything foreign lies in them
        }
    });
    fs::remove(folder_, ignored);
}

}  // namespace overturn::store
