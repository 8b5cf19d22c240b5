#include "campaign/campaign_input.hpp"

#include <fstream>
#include <iterator>

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "campaign/campaign_spec.hpp"
#include "campaign/detail/unsound.hpp"
#include "campaign/withdrawn_keys.hpp"
#include "store/sha256.hpp"

namespace overturn {
namespace {

using Json = nlohmann::json;

Json json_of(CampaignInput const& input) {
    Json files = Json::object();
    for (auto const& [name, content] : input.files) {
        files[name] = Json::binary({content.begin(), content.end()});
    }
    return {
        {"text", Json::binary({input.text.begin(), input.text.end()})}, {"settings", input.settings}, {"files", files}};
}

std::string text_of(Json const& binary) {
    auto const& bytes = binary.get_binary();
    return {bytes.begin(), bytes.end()};
}

std::vector<std::string> lines_of(std::string const& text) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        auto const end = std::min(text.find('\n', begin), text.size());
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

}  // namespace

std::string CampaignInput::serialise() const {
    auto json = json_of(*this);
    json["name"] = name;
    json["program"] = program;
    json["machine"] = machine;
    json["libraries"] = libraries;
    auto const bytes = Json::to_cbor(json);
    return {bytes.begin(), bytes.end()};
}

CampaignInput CampaignInput::deserialise(std::string_view bytes) {
    try {
        auto const json = Json::from_cbor(bytes.begin(), bytes.end());
        CampaignInput input{json.at("name").get<std::string>(),
                            text_of(json.at("text")),
                            json.at("settings").get<std::vector<std::string>>(),
                            {},
                            json.value("program", "an older one"),
                            json.value("machine", "an unnamed machine"),
                            json.value("libraries", "libraries that it does not name")};
        for (auto const& [name, content] : json.at("files").items()) {
            input.files.emplace(name, text_of(content));
        }
        return input;
    } catch (Json::exception const&) {
        throw SystemError("the record of the campaign is not what this program writes (another version's?)");
    }
}

std::string CampaignInput::sha256() const {
    auto const bytes = Json::to_cbor(json_of(*this));
    return store::sha256({reinterpret_cast<char const*>(bytes.data()), bytes.size()});
}

std::string CampaignInput::block_key() const { return store::sha256(sha256() + program + machine + libraries); }

std::vector<std::string> CampaignInput::differences(CampaignInput const& other) const {
    std::vector<std::string> found;
    if (program != other.program) {
        found.push_back(fmt::format("begun by overturn {}, this is {}", program, other.program));
    }
    if (machine != other.machine) {
        found.push_back(fmt::format("begun on {}, this is {}: their last bits differ", machine, other.machine));
    }
    if (libraries != other.libraries) {
        found.push_back(
            fmt::format("begun with {}, this has {}: their last bits may differ", libraries, other.libraries));
    }
    auto const ours = lines_of(text);
    auto const theirs = lines_of(other.text);
    for (std::size_t i = 0; i < std::max(ours.size(), theirs.size()); ++i) {
        auto const a = i < ours.size() ? ours[i] : std::string("(no line)");
        auto const b = i < theirs.size() ? theirs[i] : std::string("(no line)");
        if (a != b) {
            found.push_back(fmt::format("line {}: '{}' became '{}'", i + 1, a, b));
            break;  // one line names the key; what follows may only have moved
        }
    }
    if (settings != other.settings) {
        found.push_back(
            fmt::format("--set: '{}' became '{}'", fmt::join(settings, " "), fmt::join(other.settings, " ")));
    }
    for (auto const& [file, content] : files) {
        auto const there = other.files.find(file);
        if (there == other.files.end() || there->second != content) {
            found.push_back(fmt::format("file {} {}", file, there == other.files.end() ? "is gone" : "changed"));
        }
    }
    for (auto const& [file, content] : other.files) {
        if (!files.contains(file)) {
            found.push_back(fmt::format("file {} is new", file));
        }
    }
    return found;
}

CampaignInput load_campaign(std::filesystem::path const& path, std::span<std::string const> settings) {
    std::ifstream file(path, std::ios::binary);
    validate(static_cast<bool>(file) && !std::filesystem::is_directory(path),
             "{}: cannot be read (no such file, or no right to). Check the name", path.string());
    CampaignInput input{
        path.string(), std::string(std::istreambuf_iterator<char>(file), {}), {settings.begin(), settings.end()}, {}};
    validate(!input.text.starts_with("\x89HDF"),
             "{}: a results file (a campaign is a TOML file). Name the campaign, or ask fit, report, status or replay",
             path.string());
    for (auto const& setting : input.settings) {
        validate(setting.find('\n') == std::string::npos,
                 "--set {} (spans lines, which a results file cannot carry). State it in the campaign", setting);
    }
    load_files(input, path.has_parent_path() ? path.parent_path() : std::filesystem::path("."));
    return input;
}

void load_files(CampaignInput& input, std::filesystem::path const& folder) {
    // A results file carries the text as an attribute, which HDF5 holds to 64 KiB.
    constexpr std::size_t longest = 60'000;
    validate(input.text.size() <= longest,
             "{}: {} bytes (a results file can carry {}). Move long tables into files that the campaign names",
             input.name, input.text.size(), longest);
    InputFiles files(folder);
    auto const spec = parse_campaign(input, files);
    refuse_drifting_levels(input, spec);
    refuse_unsound(input, spec);
    refuse_withdrawn_keys(input);
    input.files = files.contents();
}

}  // namespace overturn
