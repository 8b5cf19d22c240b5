/// Finished blocks beside the output: each one durable as soon as it is there, so that a killed run loses only what was
/// under way.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "store/block_lock.hpp"

namespace overturn::store {

/// With 10^5 files a folder is slow on every file system.
inline constexpr std::int64_t blocks_in_a_folder = 1024;

/// A block as it is stored.
struct PackedBlock {
    std::int64_t number = 0;
    std::vector<std::byte> rows;
};

/// The folder `OUTPUT.parts` with one checked file per finished block, but for the first 1024 in folders of its own.
class ShardFolder {
  public:
    /// \param campaign what the blocks belong to: a hash of everything that decides their content
    ShardFolder(std::filesystem::path output, std::string campaign);

    [[nodiscard]] bool exists() const;
    /// The whole campaign as the run began it, kept so that a resume can say what changed; empty if there is none.
    /// \throws SystemError if it is damaged
    [[nodiscard]] std::string begun_with() const;
    /// Makes the folder and puts the record into it, unless there is one already: begun_with() gives its owner.
    /// \throws SystemError
    void begin(std::string const& campaign_record) const;
    /// The same in the place of a damaged record.
    void begin_again(std::string const& campaign_record) const;

    /// Writes blocks, each whole and durable: several in little more time than one. \throws SystemError
    void commit(std::span<PackedBlock const> blocks) const;
    void commit(std::int64_t block, std::span<std::byte const> rows) const;
    /// The blocks of `range` that are there and sound, in rising order. Damaged or foreign files are named in `notes`
    /// and left out. \param bytes how many a block's rows must have, if known
    [[nodiscard]] std::vector<std::int64_t> committed(BlockRange range, std::vector<std::string>& notes,
                                                      std::function<std::size_t(std::int64_t)> const& bytes = {}) const;
    /// The blocks of `range` by the names of their files alone, in rising order: cheap, and nothing says they are
    /// sound.
    [[nodiscard]] std::vector<std::int64_t> listed(BlockRange range) const;
    /// Are there blocks, sound by themselves, that belong to something else?
    [[nodiscard]] bool holds_foreign_blocks() const;
    /// Is there any file that is named like a block?
    [[nodiscard]] bool holds_blocks() const;
    /// The rows of a committed block. \throws SystemError if it is missing or damaged
    [[nodiscard]] std::vector<std::byte> read(std::int64_t block) const;
    /// Puts the blocks and the record of an earlier campaign into a folder inside this one, where they wait for
    /// whatever can use their rows; its segments stay. Broken off, it goes on when called again. \param key the earlier
    /// campaign's \throws SystemError
    void set_aside(std::string const& key) const;
    /// The folders of campaigns that were set aside, as the outputs of ShardFolders.
    [[nodiscard]] std::vector<std::filesystem::path> aside() const;

    /// Keeps a text about one segment of the work (a run, a part) beside its blocks. \throws SystemError
    void keep_segment(std::string const& text) const;
    /// All of them, in the order in which they were kept.
    [[nodiscard]] std::vector<std::string> segments() const;
    /// Removes what killed writers of these blocks left half done. \pre nobody else writes them now
    void remove_unfinished(BlockRange range) const;
    /// Removes the files of these blocks.
    void remove_blocks(BlockRange range) const;
    /// Removes the folder and everything this class put into it.
    void remove() const;

    [[nodiscard]] std::filesystem::path const& folder() const { return folder_; }

  private:
    void make_group_of(std::filesystem::path const& file) const;
    enum class Content { ours, damaged, foreign };
    struct Block {
        Content content = Content::damaged;
        std::string problem;
        std::vector<std::byte> rows;
    };
    [[nodiscard]] std::filesystem::path file_of(std::int64_t block) const;
    [[nodiscard]] Block look_into(std::int64_t block) const;
    [[nodiscard]] std::vector<std::int64_t> block_files(BlockRange range, std::vector<std::string>* notes) const;

    std::filesystem::path folder_;
    std::string campaign_;
    mutable std::filesystem::path safe_group_;  ///< the folder of blocks that this process last made sure of
};

}  // namespace overturn::store
