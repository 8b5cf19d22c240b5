#include "campaign/withheld_inputs.hpp"

#include <algorithm>
#include <array>

#include "config/registry.hpp"
#include "core/error.hpp"
#include "core/regular_file.hpp"
#include "core/withheld.hpp"
#include "motion/record.hpp"
#include "store/sha256.hpp"

namespace overturn {
namespace {

enum class Kept { whole, hashes };

constexpr std::array keeping_kinds{
    config::Entry<Kept>{"stored", "the results file holds every input file", Kept::whole},
    config::Entry<Kept>{"hash-only", "of records it holds names and hashes", Kept::hashes}};

// Components of one recording are one sample for who has no record, too. Which station it is stays where it was.
std::string stands_for(std::string const& content) {
    auto const station = station_of_record(content);
    return withheld_text(store::sha256(content), content.size(), station.empty() ? "" : store::sha256(station));
}

bool is_there(std::filesystem::path const& place) {
    std::error_code error;
    return std::filesystem::is_regular_file(place, error);
}

}  // namespace

std::vector<config::Word> keeping_words() { return config::words_of<keeping_kinds>(); }

bool keeps_hashes_only(config::Table const& root) {
    bool const hashes = root.choice<Kept>(inputs_key, keeping_kinds) == Kept::hashes;
    if (hashes && root.child("waves").text("source") != "records") {
        root.fail("inputs",
                  "hash-only (for source = \"records\": other waves cannot be made without their files). "
                  "Leave it out");
    }
    return hashes;
}

std::map<std::string, std::string> kept_inputs(CampaignInput const& input) {
    auto files = input.files;
    auto const root = config::Table::parse(input.text, input.name, input.settings);
    if (keeps_hashes_only(root)) {
        auto const hazard = input.hazard_file();
        for (auto& [name, content] : files) {
            content = name.ends_with(".toml") || name == hazard ? content : stands_for(content);
        }
    }
    return files;
}

bool has_withheld(CampaignInput const& input) {
    return std::ranges::any_of(input.files, [](auto const& file) { return is_withheld(file.second); });
}

bool is_same_content(std::string const& a, std::string const& b) {
    if (is_withheld(a) == is_withheld(b)) {
        return a == b;
    }
    auto const& kept = is_withheld(a) ? a : b;
    auto const& content = is_withheld(a) ? b : a;
    return stands_for(content).starts_with(kept);  // files of before hold no recording
}

void fetch_withheld(CampaignInput& input, std::filesystem::path const& results) {
    for (auto& [name, content] : input.files) {
        if (!is_withheld(content)) {
            continue;
        }
        auto const beside = results.parent_path() / name;
        auto const place = is_there(beside) ? beside : std::filesystem::path(name);
        validate(
            is_there(place),
            "{}: input {} (its campaign keeps hashes of records alone, and the record is not beside the file). Put "
            "it there",
            results.string(), name);
        auto found = read_regular_file(place, fmt::format("{}: input {}", results.string(), name));
        validate(is_same_content(found, content),
                 "{}: input {} ({} is another file than the one it was made from: its SHA-256 differs). Put that one "
                 "there",
                 results.string(), name, place.string());
        content = std::move(found);
    }
}

}  // namespace overturn
