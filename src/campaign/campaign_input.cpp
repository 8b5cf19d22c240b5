#include "campaign/campaign_input.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign/campaign_spec.hpp"
#include "campaign/detail/campaign_keys.hpp"
#include "campaign/detail/stated_inputs.hpp"
#include "campaign/detail/unsound.hpp"
#include "campaign/withdrawn_keys.hpp"
#include "core/regular_file.hpp"
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

}  // namespace

std::string CampaignInput::hazard_file() const {
    return config::Table::parse(text, name, settings).text(campaign_keys["hazard"]);
}

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

std::string CampaignInput::block_key() const {
    auto compared = *this;
    compared.files = compared_files(*this);
    Json json = json_of(compared);
    json.erase("text");
    json.erase("settings");
    auto& values = json["values"] = Json::object();
    for (auto const& [path, value] : decisive_values(*this)) {
        values[path] = value.normal;
    }
    auto const bytes = Json::to_cbor(json);
    return store::sha256(std::string(bytes.begin(), bytes.end()) + program + machine + libraries);
}

CampaignInput load_campaign(std::filesystem::path const& path, std::span<std::string const> settings) {
    CampaignInput input{path.string(),
                        read_regular_file(path, path.string() + ": cannot be read"),
                        {settings.begin(), settings.end()},
                        {}};
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
