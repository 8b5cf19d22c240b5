// What two campaigns state otherwise, by key and value.
#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "campaign/campaign_input.hpp"
#include "campaign/detail/stated_inputs.hpp"
#include "campaign/withheld_inputs.hpp"

namespace overturn {
namespace {

using config::StatedValues;
using Names = std::set<std::string>;

bool is_below(std::string_view path, std::string_view table) {
    return path == table || (path.starts_with(table) && path.size() > table.size() && path[table.size()] == '.');
}

// By the campaign that is stated now, which a person has before him.
void add_changes(std::vector<std::string>& found, StatedValues const& before, StatedValues const& now) {
    auto const text_of = [](StatedValues const& values, std::string const& path) {
        auto const value = values.find(path);
        return value == values.end() ? std::string("not stated") : value->second.text;
    };
    auto all = now;
    all.insert(before.begin(), before.end());
    for (auto const& [path, value] : all) {
        auto const there = before.find(path);
        auto const here = now.find(path);
        if (there == before.end() || here == now.end() || there->second != here->second) {
            found.push_back(fmt::format("{} was {}, is {}", value.key, text_of(before, path), text_of(now, path)));
        }
    }
}

// \param apart files that may come and go, by their stems
void add_changed_files(std::vector<std::string>& found, CampaignInput const& before, CampaignInput const& now,
                       Names const& apart = {}) {
    auto const may_differ = [&](std::string const& file) {
        return apart.contains(std::filesystem::path(file).stem().string());
    };
    auto const there = compared_files(before);
    auto const here = compared_files(now);
    for (auto const& [file, content] : there) {
        auto const other = here.find(file);
        bool const gone = other == here.end();
        if (gone ? !may_differ(file) : !is_same_content(other->second, content)) {
            found.push_back(fmt::format("file {} {}", file, gone ? "is gone" : "changed"));
        }
    }
    for (auto const& [file, content] : here) {
        if (!there.contains(file) && !may_differ(file)) {
            found.push_back(fmt::format("file {} is new", file));
        }
    }
}

// Which of the bodies a path is of; a name may hold a dot, and begin as another does.
std::string body_of(std::string const& path, Names const& bodies) {
    std::string found;
    for (auto const& name : bodies) {
        if (name.size() >= found.size() && is_below(path, "bodies." + name)) {
            found = name;
        }
    }
    return found;
}

// Takes out what only one of the campaigns has a body for.
void erase_bodies_apart(StatedValues& values, Names const& own, Names const& of_other) {
    values.erase("bodies");
    std::erase_if(values, [&](auto const& each) {
        auto const name = body_of(each.first, own);
        return !name.empty() && !of_other.contains(name);
    });
}

// What adds rows and moves none.
void erase_extent(StatedValues& values) {
    constexpr std::array extents{
        "limits",        "statistics", "levels.values", "levels.design_basis", "levels.beyond_design",
        "waves.records", "waves.files"};
    std::erase_if(values, [&](auto const& each) {
        return each.first == "waves.count"
               || std::ranges::any_of(extents, [&](char const* table) { return is_below(each.first, table); });
    });
}

// A record that is there still, but stated otherwise. \return the stems of those that came or went
Names add_changed_records(std::vector<std::string>& found, CampaignInput const& before, CampaignInput const& now) {
    auto const [gone, come] = records_apart(before, now);
    Names apart;
    for (auto const& record : gone) {
        auto const other = std::ranges::find(come, record.name, &StatedRecord::name);
        if (other == come.end()) {
            apart.insert(record.stems.begin(), record.stems.end());
            continue;
        }
        auto const first = found.size();
        add_changes(found, record.values, other->values);
        for (auto i = first; i < found.size(); ++i) {
            found[i] = fmt::format("of record {}, {}", record.name, found[i]);
        }
    }
    for (auto const& record : come) {
        apart.insert(record.stems.begin(), record.stems.end());
    }
    for (auto const& record : stated_records(before)) {
        if (std::ranges::find(gone, record.text, &StatedRecord::text) == gone.end()) {
            for (auto const& stem : record.stems) {
                apart.erase(stem);
            }
        }
    }
    return apart;
}

}  // namespace

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
    add_changes(found, decisive_values(*this), decisive_values(other));
    add_changed_files(found, *this, other);
    return found;
}

std::vector<std::string> CampaignInput::differences_of_rows(CampaignInput const& other) const {
    auto const bodies = stated_bodies(*this);
    auto const bodies_now = stated_bodies(other);
    Names const names(bodies.begin(), bodies.end());
    Names const names_now(bodies_now.begin(), bodies_now.end());
    auto before = decisive_values(*this);
    auto now = decisive_values(other);
    erase_bodies_apart(before, names, names_now);
    erase_bodies_apart(now, names_now, names);
    erase_extent(before);
    erase_extent(now);
    std::vector<std::string> found;
    add_changes(found, before, now);
    auto const apart = add_changed_records(found, *this, other);
    add_changed_files(found, *this, other, apart);
    return found;
}

std::vector<RecordIdentity> CampaignInput::record_identities() const {
    std::vector<RecordIdentity> records;
    for (auto const& record : stated_records(*this)) {
        records.push_back({record.name, record.text});
    }
    return records;
}

}  // namespace overturn
