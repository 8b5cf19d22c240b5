/// Everything that decides a campaign's results, as bytes: what rank 0 reads, every rank gets and a results file
/// carries.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace overturn {

/// The campaign file as written, the settings on top of it, and every file it names.
struct CampaignInput {
    std::string name;                          ///< for messages
    std::string text;                          ///< TOML
    std::vector<std::string> settings;         ///< "key.sub=value", applied in order
    std::map<std::string, std::string> files;  ///< by the name the campaign uses

    /// SHA-256 of text, settings and files; the name does not count.
    [[nodiscard]] std::string sha256() const;

    [[nodiscard]] std::string serialise() const;
    [[nodiscard]] static CampaignInput deserialise(std::string_view bytes);

    /// One line per difference between two inputs, naming keys where the texts differ; empty if they are the same.
    [[nodiscard]] std::vector<std::string> differences(CampaignInput const& other) const;
};

/// Reads a campaign file and whatever it refers to, and checks all of it by building the campaign once.
/// \throws InputError
[[nodiscard]] CampaignInput load_campaign(std::filesystem::path const& path, std::span<std::string const> settings);

}  // namespace overturn
