#include "campaign/detail/stated_inputs.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "campaign/detail/campaign_keys.hpp"
#include "campaign/withheld_inputs.hpp"
#include "config/key.hpp"

namespace overturn {
namespace {

using config::StatedValues;

bool is_below(std::string_view path, std::string_view table) {
    return path == table || (path.starts_with(table) && path.size() > table.size() && path[table.size()] == '.');
}

std::vector<StatedValues> entries_of(CampaignInput const& input, std::string_view list) {
    return config::stated_entries(input.text, input.name, input.settings, list);
}

// Of the file that describes a body; none where its entry does.
StatedValues values_in_file(CampaignInput const& input, StatedValues const& body) {
    auto const file = input.files.find(config::text_at(body, "file"));
    return file == input.files.end() ? StatedValues{} : config::stated_values(file->second, file->first, {});
}

// As the campaign calls a body that does not say.
std::string name_of(StatedValues const& body, StatedValues const& in_file) {
    auto const own = config::text_at(body, "name");
    auto const name = own.empty() ? config::text_at(in_file, "name") : own;
    return name.empty() ? "body" : name;
}

// "friction" -> "bodies[1].friction (type-b)"; of a file "friction of cask.toml (bodies[1], type-b)".
void add_body(CampaignInput const& input, std::size_t place, StatedValues const& body, StatedValues& values) {
    auto const in_file = values_in_file(input, body);
    auto const name = name_of(body, in_file);
    for (auto const& [key, value] : body) {
        if (key == "file" && !in_file.empty()) {
            continue;
        }
        auto& put = values[fmt::format("bodies.{}.{}", name, key)] = value;
        put.key = fmt::format("bodies[{}].{} ({})", place, key, name);
    }
    for (auto const& [key, value] : in_file) {
        auto& put = values[fmt::format("bodies.{}.file.{}", name, key)] = value;
        put.key = fmt::format("{} in {} (bodies[{}], {})", key, config::text_at(body, "file"), place, name);
    }
}

std::set<std::string> body_files(CampaignInput const& input) {
    std::set<std::string> files;
    for (auto const& body : entries_of(input, "bodies")) {
        files.insert(config::text_at(body, "file"));
    }
    return files;
}

// A record without those of `others` that are equal to one, each of which counts once.
std::vector<StatedRecord> without(std::vector<StatedRecord> records, std::vector<StatedRecord> others) {
    std::erase_if(records, [&](StatedRecord const& record) {
        auto const same = std::ranges::find(others, record.text, &StatedRecord::text);
        bool const found = same != others.end();
        if (found) {
            others.erase(same);
        }
        return found;
    });
    return records;
}

}  // namespace

StatedValues decisive_values(CampaignInput const& input) {
    auto values = config::stated_values(input.text, input.name, input.settings);
    std::erase_if(values, [](auto const& each) {
        return is_below(each.first, "bodies") || is_below(each.first, "hazard")
               || std::ranges::any_of(cover_keys,
                                      [&](config::Key const& key) { return is_below(each.first, key.name); });
    });
    values.erase(std::string(inputs_key.name));
    values.erase("statistics.confidence");
    values.erase("statistics.beta_u");
    auto const bodies = entries_of(input, "bodies");
    std::string order;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        add_body(input, i, bodies[i], values);
        order += (i > 0 ? ", " : "") + name_of(bodies[i], values_in_file(input, bodies[i]));
    }
    values["bodies"] = {order, order, "bodies"};
    return values;
}

std::map<std::string, std::string> compared_files(CampaignInput const& input) {
    auto files = input.files;
    files.erase(input.hazard_file());
    for (auto const& file : body_files(input)) {
        files.erase(file);
    }
    return files;
}

std::vector<std::string> stated_bodies(CampaignInput const& input) {
    auto const bodies = entries_of(input, "bodies");
    std::vector<std::string> names;
    std::ranges::transform(bodies, std::back_inserter(names),
                           [&](StatedValues const& body) { return name_of(body, values_in_file(input, body)); });
    return names;
}

std::vector<StatedRecord> stated_records(CampaignInput const& input) {
    constexpr std::array components{"", "horizontal", "transverse", "vertical"};
    std::vector<StatedRecord> records;
    if (config::text_at(config::stated_values(input.text, input.name, input.settings), "waves.source") != "records") {
        return records;
    }
    for (char const* list : {"waves.files", "waves.records"}) {
        for (auto const& values : entries_of(input, list)) {
            StatedRecord record{{}, {}, values, {}};
            for (char const* component : components) {
                auto const name = config::text_at(values, component);
                if (!name.empty()) {
                    record.name = record.name.empty() ? name : record.name;
                    record.stems.insert(std::filesystem::path(name).stem().string());
                }
            }
            for (auto const& [key, value] : values) {
                record.text += fmt::format("{} = {}\n", key, value.normal);
            }
            records.push_back(std::move(record));
        }
    }
    return records;
}

RecordsApart records_apart(CampaignInput const& before, CampaignInput const& now) {
    auto const begun = stated_records(before);
    auto const stated = stated_records(now);
    return {without(begun, stated), without(stated, begun)};
}

}  // namespace overturn
