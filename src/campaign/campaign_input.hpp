/// Everything that decides a campaign's results, as bytes: what rank 0 reads, every rank gets and a results file
/// carries.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/version.hpp"

namespace overturn {

/// The campaign file as written, the settings on top of it, and every file it names.
struct CampaignInput {
    std::string name;                          ///< for messages
    std::string text;                          ///< TOML
    std::vector<std::string> settings;         ///< "key.sub=value", applied in order
    std::map<std::string, std::string> files;  ///< by the name the campaign uses
    /// What computes it: blocks of two programs must not be mixed, since a change of either may move a bit.
    std::string program = program_identity();
    /// What kind of machine computes it: all x86-64 give the same last bits, aarch64 others.
    std::string machine = overturn::machine();
    /// With what: a library or a compiler of another version may give other last bits.
    std::string libraries = overturn::library_versions() + ", " + overturn::compiler();
    /// Of a results file up to format 4, which is read as programs did then: a trial that overturned passed the limits
    /// that it had passed before it fell, targets without a unit were in SI, unnamed columns told by their place.
    bool before_format_5 = false;

    /// SHA-256 of text, settings and files; neither the name nor program, machine and libraries count.
    [[nodiscard]] std::string sha256() const;
    /// What finished blocks belong to: every key that may decide a row or which waves a block holds, the files, the
    /// program, the kind of machine and the libraries; neither comments nor confidence, nor what pages bear (title,
    /// question, who signs).
    [[nodiscard]] std::string block_key() const;

    [[nodiscard]] std::string serialise() const;
    /// \throws SystemError if the bytes are no campaign
    [[nodiscard]] static CampaignInput deserialise(std::string_view bytes);

    /// One line per difference between two inputs that block_key() knows: "bodies.b.friction was 0.5, is 0.6"; empty if
    /// there is none.
    [[nodiscard]] std::vector<std::string> differences(CampaignInput const& other) const;
    /// Of these, those that bar the rows of this campaign from the other: all but the number of waves, which levels and
    /// which bodies there are, limits and statistics. A body that both have must be the same.
    [[nodiscard]] std::vector<std::string> differences_of_rows(CampaignInput const& other) const;
    /// Of these, those between the programs, the machines and the libraries.
    [[nodiscard]] std::vector<std::string> differences_of_program(CampaignInput const& other) const;
};

/// Reads a campaign file and whatever it refers to, and checks all of it by building the campaign once.
/// \throws InputError
[[nodiscard]] CampaignInput load_campaign(std::filesystem::path const& path, std::span<std::string const> settings);
/// Of a text that need not be a file yet: reads what it refers to, from `folder`, and checks all of it likewise.
/// \throws InputError
void load_files(CampaignInput& input, std::filesystem::path const& folder);

}  // namespace overturn
