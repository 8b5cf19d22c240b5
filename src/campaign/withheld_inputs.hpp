/// Records that may not be passed on: a campaign with inputs = "hash-only" keeps their names and hashes alone.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "campaign/campaign_input.hpp"
#include "config/table.hpp"

namespace overturn {

/// Key `inputs` of a campaign: what its results file holds of the files that it names.
[[nodiscard]] std::vector<config::Word> keeping_words();
inline constexpr config::Key inputs_key =
    config::word_key("inputs", &keeping_words, "input files in the results file: contents or hashes only")
        .otherwise("stored");

/// Reads it. \throws InputError if it is "hash-only" and the waves are no records
[[nodiscard]] bool keeps_hashes_only(config::Table const& root);

/// Input files as a results file keeps them: all of them, or hashes in place of those that are not TOML.
[[nodiscard]] std::map<std::string, std::string> kept_inputs(CampaignInput const& input);

/// Is the content of any input file not there?
[[nodiscard]] bool has_withheld(CampaignInput const& input);

/// Are they one file's, where either may be what stands for it?
[[nodiscard]] bool is_same_content(std::string const& a, std::string const& b);

/// Puts the records back into the input of a results file: from its folder, else from the current one.
/// \throws InputError if one is not there, or is another than the hash says
void fetch_withheld(CampaignInput& input, std::filesystem::path const& results);

}  // namespace overturn
