#include "campaign/campaign_input.hpp"

#include <algorithm>
#include <array>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign/campaign_spec.hpp"
#include "campaign/detail/campaign_keys.hpp"
#include "campaign/detail/unsound.hpp"
#include "campaign/withdrawn_keys.hpp"
#include "campaign/withheld_inputs.hpp"
#include "config/stated_values.hpp"
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

using StatedValues = std::map<std::string, std::string>;

bool is_below(std::string const& key, std::string_view table) {
    return key == table || (key.starts_with(table) && key.size() > table.size() && key[table.size()] == '.');
}

// Of what a campaign states: all but what moves neither a row nor a block.
StatedValues decisive(CampaignInput const& input) {
    auto values = config::stated_values(input.text, input.name, input.settings);
    std::erase_if(values, [](auto const& each) {
        return std::ranges::any_of(cover_keys, [&](config::Key const& key) { return is_below(each.first, key.name); });
    });
    values.erase(std::string(inputs_key.name));
    values.erase("statistics.confidence");
    values.erase("statistics.beta_u");
    std::erase_if(values, [](auto const& each) { return is_below(each.first, "hazard"); });
    return values;
}

// "'a.toml'" -> "a.toml"
std::string unquoted(std::string const& stated) {
    bool const quoted = stated.size() > 1 && stated.front() == stated.back() && (stated[0] == '\'' || stated[0] == '"');
    return quoted ? stated.substr(1, stated.size() - 2) : stated;
}

// Without the file of the hazard curve, which moves neither.
CampaignInput without_hazard(CampaignInput input) {
    input.files.erase(input.hazard_file());
    return input;
}

void add_changes(std::vector<std::string>& found, StatedValues const& before, StatedValues const& now) {
    auto const text_of = [](StatedValues const& values, std::string const& key) {
        auto const value = values.find(key);
        return value == values.end() ? std::string("not stated") : value->second;
    };
    auto keys = before;
    keys.insert(now.begin(), now.end());
    for (auto const& [key, value] : keys) {
        if (text_of(before, key) != text_of(now, key)) {
            found.push_back(fmt::format("{} was {}, is {}", key, text_of(before, key), text_of(now, key)));
        }
    }
}

using Names = std::set<std::string>;

// \param apart files that may come and go
void add_changed_files(std::vector<std::string>& found, CampaignInput const& before, CampaignInput const& now,
                       Names const& apart = {}) {
    for (auto const& [file, content] : before.files) {
        auto const there = now.files.find(file);
        bool const gone = there == now.files.end();
        if (gone ? !apart.contains(file) : !is_same_content(there->second, content)) {
            found.push_back(fmt::format("file {} {}", file, gone ? "is gone" : "changed"));
        }
    }
    for (auto const& [file, content] : now.files) {
        if (!before.files.contains(file) && !apart.contains(file)) {
            found.push_back(fmt::format("file {} is new", file));
        }
    }
}

Names body_names(CampaignInput const& input) {
    auto const names = config::names_in_list(input.text, input.name, input.settings, "bodies");
    return {names.begin(), names.end()};
}

// Which of the bodies a key is of; a name may hold a dot, and begin as another does.
std::string body_of(std::string const& key, Names const& bodies) {
    std::string found;
    for (auto const& name : bodies) {
        if (name.size() >= found.size() && is_below(key, "bodies." + name)) {
            found = name;
        }
    }
    return found;
}

// Takes out what only one of the campaigns has a body for. \return the files that are named there
Names erase_bodies_apart(StatedValues& values, Names const& own, Names const& of_other) {
    Names files;
    values.erase("bodies");
    std::erase_if(values, [&](auto const& each) {
        auto const name = body_of(each.first, own);
        bool const apart = !name.empty() && !of_other.contains(name);
        if (apart && each.first == "bodies." + name + ".file") {
            files.insert(unquoted(each.second));
        }
        return apart;
    });
    return files;
}

// What adds rows and moves none.
void erase_extent(StatedValues& values) {
    constexpr std::array extents{"limits", "statistics", "levels.values", "levels.design_basis",
                                 "levels.beyond_design"};
    std::erase_if(values, [&](auto const& each) {
        return each.first == "waves.count"
               || std::ranges::any_of(extents, [&](char const* table) { return is_below(each.first, table); });
    });
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
    Json json = json_of(without_hazard(*this));
    json.erase("text");
    json.erase("settings");
    json["values"] = decisive(*this);
    auto const bytes = Json::to_cbor(json);
    return store::sha256(std::string(bytes.begin(), bytes.end()) + program + machine + libraries);
}

std::vector<std::string> CampaignInput::differences_of_program(CampaignInput const& other) const {
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
    return found;
}

std::vector<std::string> CampaignInput::differences(CampaignInput const& other) const {
    auto found = differences_of_program(other);
    add_changes(found, decisive(*this), decisive(other));
    add_changed_files(found, without_hazard(*this), without_hazard(other));
    return found;
}

std::vector<std::string> CampaignInput::differences_of_rows(CampaignInput const& other) const {
    auto before = decisive(*this);
    auto now = decisive(other);
    auto const bodies = body_names(*this);
    auto const bodies_now = body_names(other);
    auto apart = erase_bodies_apart(before, bodies, bodies_now);
    apart.merge(erase_bodies_apart(now, bodies_now, bodies));
    erase_extent(before);
    erase_extent(now);
    std::vector<std::string> found;
    add_changes(found, before, now);
    add_changed_files(found, without_hazard(*this), without_hazard(other), apart);
    return found;
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
