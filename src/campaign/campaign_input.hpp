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

/// A record, wherever it stands among the others.
struct RecordIdentity {
    std::string name;  ///< of its first file, for messages
    std::string text;  ///< all that the campaign states of it

    friend bool operator==(RecordIdentity const& a, RecordIdentity const& b) { return a.text == b.text; }
};

/// The campaign file as written, the settings on top of it, and every file it names.
struct CampaignInput {
    std::string name;                          ///< for messages
    std::string text;                          ///< TOML
    std::vector<std::string> settings;         ///< "key.sub=value", applied in order
    std::map<std::string, std::string> files;  ///< by the name the campaign uses
    /// The program that computes it. Blocks of two programs must not be mixed: a change of either may change a bit.
    std::string program = program_identity();
    /// The kind of machine that computes it: all x86-64 give the same last bits, aarch64 others.
    std::string machine = overturn::machine();
    /// With what: a library or a compiler of another version may give other last bits.
    std::string libraries = overturn::library_versions() + ", " + overturn::compiler();
    /// True for a results file up to format 4, which is read as programs read it then: a trial that overturned passed
    /// the limits that it had passed before it fell, targets without a unit were in SI, unnamed columns were known by
    /// place.
    bool before_format_5 = false;

    /// SHA-256 of text, settings and files; neither the name nor program, machine and libraries count.
    [[nodiscard]] std::string sha256() const;
    /// Key of finished blocks: every value that may decide a row or the waves of a block, the files, the program, the
    /// kind of machine and the libraries. Comments, units of values, confidence, beta_U, the cover's text (title,
    /// question, signatures), the hazard curve and whether inputs are stored do not count: they move no row.
    [[nodiscard]] std::string block_key() const;

    /// Name of the file of the seismic hazard curve; empty if the campaign states none. \throws InputError
    [[nodiscard]] std::string hazard_file() const;

    [[nodiscard]] std::string serialise() const;
    /// \throws SystemError if the bytes are no campaign
    [[nodiscard]] static CampaignInput deserialise(std::string_view bytes);

    /// One line per difference between two inputs that block_key() knows: "bodies[1].friction (b) was 0.5, is 0.6";
    /// empty if there is none.
    [[nodiscard]] std::vector<std::string> differences(CampaignInput const& other) const;
    /// Those differences that forbid the other to use rows of this campaign: all but the number of waves, the choice of
    /// levels, bodies and records, limits and statistics. A body or record that both have must be the same.
    [[nodiscard]] std::vector<std::string> differences_of_rows(CampaignInput const& other) const;
    /// The records, in their order; empty where its waves are none.
    [[nodiscard]] std::vector<RecordIdentity> record_identities() const;
    /// Those differences that lie in the programs, the machines or the libraries.
    [[nodiscard]] std::vector<std::string> differences_of_program(CampaignInput const& other) const;
};

/// Reads a campaign file and whatever it refers to, and checks all of it by building the campaign once.
/// \throws InputError
[[nodiscard]] CampaignInput load_campaign(std::filesystem::path const& path, std::span<std::string const> settings);
/// The same for a text that need not be a file yet: reads the files that it names, from `folder`, and checks all.
/// \throws InputError
/// \throws InputError
void load_files(CampaignInput& input, std::filesystem::path const& folder);

}  // namespace overturn
