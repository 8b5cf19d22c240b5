/// The files a campaign names: read once, remembered whole, so that a results file can carry them and replay them.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

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

    /// Is there such a folder? From memory every folder is.
    [[nodiscard]] bool has_folder(std::string const& name) const;

    /// All files in the folder of `name`, as the campaign would call them, in the order of their names; from memory,
    /// the stored ones of that folder.
    [[nodiscard]] std::vector<std::string> beside(std::string const& name) const;

    /// At most the first `most` bytes of a file, which is not remembered for it; empty if it cannot be read.
    [[nodiscard]] std::string head(std::string const& name, std::size_t most) const;

    /// All files read so far (or given), by name.
    [[nodiscard]] std::map<std::string, std::string> const& contents() const { return contents_; }

    /// Read as before format 5 of results files: tables without a unit are in SI, unnamed columns known by their place.
    void read_as_before_format_5(bool yes) { before_format_5_ = yes; }
    [[nodiscard]] bool are_before_format_5() const { return before_format_5_; }

  private:
    bool from_memory_ = false;
    bool before_format_5_ = false;
    std::filesystem::path folder_;
    std::map<std::string, std::string> contents_;
};

}  // namespace overturn
