// Requirement R-909: every key that the reference describes is read by the program, under the conditions that it
// states.
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "campaign/campaign_spec.hpp"
#include "campaign/withdrawn_keys.hpp"
#include "config/key_reference.hpp"
#include "support/campaigns.hpp"
#include "support/expect_input_error.hpp"
#include "support/key_campaigns.hpp"

namespace overturn {
namespace {

// What was read of a campaign: "bodies.mass.median" and what it lies in; and what chose among tables of one place.
struct Reading {
    std::set<std::string> keys;
    std::string source;

    explicit Reading(std::string const& text) {
        InputFiles inputs(testing::key_campaign_files());
        auto const spec = parse_campaign(CampaignInput{"c.toml", text, {}, testing::key_campaign_files()}, inputs);
        for (auto const& value : spec.inputs) {
            auto const plain = std::regex_replace(value.key, std::regex(R"(\[\d+\])"), "");
            for (auto dot = plain.find('.'); dot != std::string::npos; dot = plain.find('.', dot + 1)) {
                keys.insert(plain.substr(0, dot));
            }
            keys.insert(plain);
            source = plain == "waves.source" ? "waves.source = " + value.text : source;
        }
    }
};

bool reads(std::vector<Reading> const& readings, config::TablePlace const& place, std::string_view key) {
    auto const path = place.path.empty() ? std::string(key) : place.path + "." + std::string(key);
    return std::ranges::any_of(readings, [&](Reading const& reading) {
        return (place.condition.empty() || place.condition == reading.source) && reading.keys.contains(path);
    });
}

TEST(Keys, EveryDescribedKeyIsRead) {
    std::vector<Reading> readings;
    for (auto const& text : testing::key_campaigns()) {
        try {
            readings.emplace_back(text);
        } catch (std::exception const& error) {
            ADD_FAILURE() << error.what() << "\n" << text;
        }
    }
    std::map<config::Key const*, bool> read;  // a key that several tables share is one
    std::map<config::Key const*, std::string> named;
    for (auto const& placed : tables_within(campaign_table)) {
        for (auto const* key : listed_keys(*placed.table)) {
            read[key] = read[key] || std::ranges::any_of(placed.places, [&](config::TablePlace const& place) {
                            return reads(readings, place, key->name);
                        });
            named[key] = heading_of(placed) + " " + std::string(key->name);
        }
    }
    for (auto const& [key, is_read] : read) {
        EXPECT_TRUE(is_read) << named[key] << ": described, but nothing reads it";
    }
    EXPECT_GT(read.size(), 150U);
}

// Requirement: every source of waves has keys of its own, distinguished by its name.
TEST(Keys, EverySourceHasItsTable) {
    for (auto const& entry : wave_sources()) {
        EXPECT_EQ(entry.value.keys->chosen_by, "source") << entry.name;
        EXPECT_EQ(entry.value.keys->word, entry.name);
        EXPECT_NE(entry.value.keys->find("count"), nullptr) << entry.name;
    }
}

// Requirement: every key has one line that says what it means.
TEST(Keys, EveryKeyHasAMeaning) {
    for (auto const& placed : tables_within(campaign_table)) {
        EXPECT_FALSE(placed.table->meaning.empty()) << heading_of(placed);
        std::set<std::string_view> names;
        for (auto const* key : placed.table->every_key()) {
            EXPECT_FALSE(key->meaning.empty()) << heading_of(placed) << " " << key->name;
            EXPECT_FALSE(takes_text(*key).empty()) << heading_of(placed) << " " << key->name;
            EXPECT_TRUE(names.insert(key->name).second) << heading_of(placed) << " " << key->name << " twice";
        }
    }
}

// R-1003: What campaigns in files of results state is read as it stands; new campaigns are refused another value than
// the constant.
TEST(Keys, WithdrawnOnesAreReadInFilesAndRefusedInNewCampaigns) {
    std::string const text = testing::quick_waves + testing::type_b + testing::levels("values=[6]\n");
    auto const stated = [&](std::string const& key) { return testing::input_from(text + "[accuracy]\n" + key + "\n"); };
    auto const old = parse_campaign(stated("taylor_order=6\nsubsteps=3\nstep_tolerance=1e-9\nsettle=3e-4"));
    EXPECT_EQ(old.accuracy.rocking.taylor_order, 6);
    EXPECT_EQ(old.accuracy.rocking.substeps, 3);
    EXPECT_EQ(old.accuracy.rocking.step_tolerance, 1e-9);
    EXPECT_EQ(old.accuracy.rocking.settle, 3e-4);
    for (std::string const key : {"taylor_order=6", "substeps=3", "step_tolerance=1e-9", "settle=3e-4"}) {
        testing::expect_input_error([&] { refuse_withdrawn_keys(stated(key)); },
                                    "c.toml:", "accuracy." + key.substr(0, key.find('=')) + ": not");
    }
    EXPECT_NO_THROW(refuse_withdrawn_keys(stated("taylor_order=10\nsubsteps=1\nstep_tolerance=1e-11\nsettle=1e-5")));
    EXPECT_NO_THROW(refuse_withdrawn_keys(stated("contact_step=0.1")));
    EXPECT_NO_THROW(refuse_withdrawn_keys(testing::input_from(text)));
    auto const* const accuracy = campaign_table.find("accuracy")->tables().front();
    EXPECT_NE(accuracy->find("settle"), nullptr);
    EXPECT_FALSE(std::ranges::any_of(listed_keys(*accuracy), [](auto const* key) { return key->name == "settle"; }));
}

}  // namespace
}  // namespace overturn
