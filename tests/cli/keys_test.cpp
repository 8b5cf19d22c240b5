// Requirement R-909: the program lists every key that a campaign may state, as text, as a page and as a schema for
// editors.
#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/python.hpp"
#include "support/command.hpp"
#include "support/key_campaigns.hpp"

namespace overturn::testing {
namespace {

using nlohmann::json;

class ListKeys : public ::testing::Test {
  protected:
    [[nodiscard]] std::string told(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"list", "keys"});
        auto const ended = overturn(folder, arguments);
        EXPECT_EQ(ended.code, 0) << ended.err;
        return ended.out;
    }
    void expect_refused(std::vector<std::string> const& arguments, std::string const& words) const {
        auto const ended = overturn(folder, arguments);
        EXPECT_EQ(ended.code, 2);
        EXPECT_TRUE(is_one_error_line(ended.err)) << ended.err;
        EXPECT_NE(ended.err.find(words), std::string::npos) << ended.err;
    }
    Folder folder;
};

TEST_F(ListKeys, FitsATerminalAndNamesUnitRangeDefaultAndMeaning) {
    auto const all = told({});

    std::istringstream lines(all);
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(line.size(), 100U) << line;
        EXPECT_FALSE(line.ends_with(' ')) << "'" << line << "'";
    }
    EXPECT_NE(all.find("\n[[bodies]]\n"), std::string::npos);
    EXPECT_NE(all.find("\n  ramp                     time [s] at least 0; default 0 s\n"), std::string::npos);
    EXPECT_NE(all.find("\n[waves], where waves.source = pulse\n"), std::string::npos);
}

// R-409: beside every key of [accuracy] stands its default, as it is, and a measured error of it.
TEST_F(ListKeys, OfAccuracyAreDocumentedWithTheErrorOfTheirDefaults) {
    std::ifstream file(OVERTURN_CAMPAIGNS "/guide/checking.md");
    std::string const page{std::istreambuf_iterator<char>(file), {}};
    auto const tables = json::parse(told({"accuracy", "--json"}));
    ASSERT_EQ(tables.size(), 1U);
    ASSERT_EQ(tables[0].at("keys").size(), 3U);
    for (auto const& key : tables[0].at("keys")) {
        auto const name = key.at("key").get<std::string>();
        auto const row = page.find("| `" + name + "` | ");
        ASSERT_NE(row, std::string::npos) << name;
        std::istringstream cells(page.substr(row, page.find('\n', row) - row));
        std::string cell, otherwise, error;
        std::getline(cells, cell, '|');
        std::getline(cells, cell, '|');
        std::getline(cells, otherwise, '|');
        std::getline(cells, error, '|');
        auto const stated = key.at("default").get<std::string>();
        auto const value = otherwise.substr(1, otherwise.size() - 2);
        if (name == "restoring") {
            EXPECT_EQ(value, stated);
        } else {
            EXPECT_EQ(std::stod(value), std::stod(stated)) << name;
        }
        EXPECT_NE(error.find_first_of("0123456789"), std::string::npos) << name;
    }
}

// Requirement: one table and those in it can be asked for; one that is not there is refused with the nearest.
TEST_F(ListKeys, OfOneTable) {
    auto const target = told({"waves.target"});
    EXPECT_TRUE(target.starts_with("[waves.target]")) << target;
    EXPECT_NE(target.find("damping_rule"), std::string::npos);
    EXPECT_EQ(target.find("[waves.envelope]"), std::string::npos);
    EXPECT_NE(told({"bodies"}).find("[bodies.pad]"), std::string::npos);

    expect_refused({"list", "keys", "waves.traget"}, "Did you mean 'waves.target'?");
    expect_refused({"list", "keys", "--json", "--schema"}, "Keep one");
    expect_refused({"list", "assumptions", "--schema"}, "used with keys or columns only");
}

TEST_F(ListKeys, AsJson) {
    auto const tables = json::parse(told({"bodies.pad", "--json"}));

    ASSERT_EQ(tables.size(), 1U);
    EXPECT_EQ(tables[0]["places"][0]["path"], "bodies.pad");
    auto const& keys = tables[0]["keys"];
    auto const found = std::ranges::find_if(keys, [](json const& key) { return key["key"] == "normal_restitution"; });
    ASSERT_NE(found, keys.end());
    EXPECT_EQ((*found)["low"], 0.05);
    EXPECT_EQ((*found)["default"], "0.25");
    EXPECT_EQ((*found)["required"], false);
}

// Requirement: the page and the schemas that come with the campaigns are what the program says.
TEST_F(ListKeys, PageAndSchemasAreTheProgramsOwn) {
    for (auto const& [file, arguments] : {std::pair<std::string, std::vector<std::string>>{"KEYS.md", {"--markdown"}},
                                          {"schema.json", {"--schema"}},
                                          {"bodies/schema.json", {"bodies", "--schema"}}}) {
        EXPECT_TRUE(read_text(std::string(OVERTURN_CAMPAIGNS "/") + file) == told(arguments))
            << "campaigns/" << file << " is not what `overturn list keys` says. Write it anew with it";
    }
}

class KeySchema : public ListKeys {
  protected:
    void SetUp() override {
        if (!has_python(folder, "jsonschema, tomllib")) {
            GTEST_SKIP() << "no python3-jsonschema";
        }
        folder.write("schema.json", told({"--schema"}));
        folder.write("body.json", told({"bodies", "--schema"}));
    }
    // Names of the files, a line each, that are none of the schema's.
    [[nodiscard]] std::string refused(std::string const& schema, std::vector<std::string> const& files) const {
        std::vector<std::string> command{OVERTURN_PYTHON, OVERTURN_VALIDATE_TOML, schema};
        command.insert(command.end(), files.begin(), files.end());
        auto const ended = execute(folder, command);
        EXPECT_EQ(ended.code, 0) << ended.err;
        return ended.out;
    }
    [[nodiscard]] std::vector<std::string> written(std::vector<std::string> const& texts) const {
        std::vector<std::string> names;
        for (auto const& text : texts) {
            names.push_back(std::to_string(names.size()) + ".toml");
            folder.write(names.back(), text);
        }
        return names;
    }
};

std::vector<std::string> toml_files_in(std::string const& path) {
    std::vector<std::string> files;
    for (auto const& file : std::filesystem::directory_iterator(path)) {
        if (file.path().extension() == ".toml") {
            files.push_back(file.path());
        }
    }
    return files;
}

// Requirement: what the program accepts, the schema accepts: campaigns and bodies that come with it, and every key.
TEST_F(KeySchema, AcceptsWhatTheProgramAccepts) {
    auto const campaigns = toml_files_in(OVERTURN_CAMPAIGNS);
    auto const bodies = toml_files_in(OVERTURN_CAMPAIGNS "/bodies");
    ASSERT_GE(campaigns.size(), 5U);
    ASSERT_GE(bodies.size(), 5U);
    EXPECT_EQ(refused("schema.json", campaigns), "");
    EXPECT_EQ(refused("body.json", bodies), "");

    auto const every_key = key_campaigns();
    ASSERT_GE(every_key.size(), 20U);
    EXPECT_EQ(refused("schema.json", written(every_key)), "");
}

constexpr auto sound = R"(seed = 1
[waves]
source = "harmonic"
amplitude = "100 GAL"
period = {value = "1 s", basis = "assumed", source = "none", range = ["0.5 s", 2]}
cycles = 5
[[bodies]]
mass = "10 t"
base_width = 1.4
centre_height = {distribution = "normal", mean = 1.0, deviation = "1 cm"}
inertia = "uniform-block"
pad = {strength = "30 MPa"}
[bodies.basis]
mass = "published: here"
[levels]
measure = "pga"
values = {from = 1, to = "400 gal", count = 3}
)";

// Requirement: a misspelt key, a unit of another dimension, a value out of range fail in the editor already.
TEST_F(KeySchema, RefusesWhatIsMisspelt) {
    EXPECT_EQ(refused("schema.json", written({sound})), "");
    auto const changed = [](std::string const& was, std::string const& becomes) {
        std::string text = sound;
        auto const at = text.find(was);
        EXPECT_NE(at, std::string::npos) << was;
        return text.replace(at, was.size(), becomes);
    };
    std::vector<std::string> const wrong{changed("seed =", "sede ="),
                                         changed("amplitude =", "amplitdue ="),
                                         changed("base_width =", "base_widht ="),
                                         changed("strength", "strenght"),
                                         changed("measure =", "mesure ="),
                                         changed("count", "cuont"),
                                         changed("deviation", "deviaton"),
                                         changed("source = \"none\"", "sorce = \"none\""),
                                         changed("\"harmonic\"", "\"harmonics\""),
                                         changed("uniform-block", "uniform-blok"),
                                         changed("100 GAL", "100 m/s"),
                                         changed("base_width = 1.4", "base_width = \"1.4 kg\""),
                                         changed("base_width = 1.4", "base_width = -1.4"),
                                         changed("base_width = 1.4", "base_width = true"),
                                         changed("count = 3", "count = 0"),
                                         changed("\"assumed\"", "\"guessed\""),
                                         changed("cycles = 5", "cycles = 5\nlag = 1"),
                                         changed("[levels]", "[level]")};
    auto const files = written(wrong);
    auto const said = refused("schema.json", files);
    for (std::size_t i = 0; i < files.size(); ++i) {
        EXPECT_TRUE(said.starts_with(files[i] + ": ") || said.find("\n" + files[i] + ": ") != std::string::npos)
            << wrong[i];
    }
}

}  // namespace
}  // namespace overturn::testing
