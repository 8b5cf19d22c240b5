/// The files a campaign names: read once, remembered whole, so that a results file can carry them and replay them.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace overturn {

/// Gives the bytes of a file by the name the campaign calls it, from a folder or from memory. Not for several threads.
class InputFiles {
  public:
    /// Names are relative to `folder` unless absolute.
    explicit InputFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Only these; nothing is read from disk.
    explicit InputFiles(std::map<std::string, std::string> contents)
        : from_memory_(true), contents_(std::move(contents)) {}

    /// The file's bytes; the reference stays valid as long as this object.
    /// \throws InputError if there is no such file or it cannot be read.
    [[nodiscard]] std::string const& read(std::string const& name);

    /// All files read so far (or given), by name.
    [[nodiscard]] std::map<std::string, std::string> const& contents() const { return contents_; }

  private:
    bool from_memory_ = false;
    std::filesystem::path folder_;
    std::map<std::string, std::string> contents_;
};

}  // namespace overturn
