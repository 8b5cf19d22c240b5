/// Files that are there after a crash: written whole beside their place, synced, then renamed into it.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace overturn::store {

/// Advice for a disk that gave an error while results were written; next_step() is its end. \param reason errno
[[nodiscard]] std::string advice_on_disk(int reason);

/// Forces a written file to disk. \throws SystemError
void make_durable(std::filesystem::path const& path);

/// Renames within one folder and forces the folder to disk. \throws SystemError
void rename_durably(std::filesystem::path const& from, std::filesystem::path const& to);

/// Suffix of a file's name while write_durably writes it, before what distinguishes the writers.
inline constexpr char const* unfinished_mark = ".tmp";

/// Writes `content` under `path`, whole or not at all, whoever else writes it.
/// \throws SystemError saying what failed (full disk, no right, ...)
void write_durably(std::filesystem::path const& path, std::span<std::byte const> content);
void write_durably(std::filesystem::path const& path, std::string_view text);

/// Path and content of a file to be written.
struct FileContent {
    std::filesystem::path path;
    std::span<std::byte const> bytes;
};

/// The same of several files, for which the disk is waited for about as long as for one. Where it fails some of them
/// may be there, each whole. \throws SystemError
void write_durably(std::span<FileContent const> files);

/// The same as of one, unless there is such a file already: of several who try at once, one makes it. \return whether
/// this one did
bool create_durably(std::filesystem::path const& path, std::span<std::byte const> content);

/// A file that is written piece by piece under a name beside its own, and removed unless keep() gives it that one.
class FileInWork {
  public:
    explicit FileInWork(std::filesystem::path path);
    ~FileInWork();
    FileInWork(FileInWork const&) = delete;
    FileInWork& operator=(FileInWork const&) = delete;
    FileInWork(FileInWork&&) = delete;
    FileInWork& operator=(FileInWork&&) = delete;

    /// Path to write to.
    [[nodiscard]] std::filesystem::path const& beside() const { return beside_; }
    /// Whole and durable at its place. \throws SystemError
    void keep();

  private:
    std::filesystem::path path_, beside_;
};

/// Adds to the end of a file that is there. \throws SystemError
void append(std::filesystem::path const& path, std::span<std::byte const> content);

/// The bytes of a file. \throws SystemError
[[nodiscard]] std::string read_file(std::filesystem::path const& path);

/// Leaves nothing behind. \throws InputError if there is no such folder, SystemError if no file can be created in it
void require_writable(std::filesystem::path const& path);

}  // namespace overturn::store
