// Requirement R-904: overturn cost begins with the answer; its JSON, file and page say the same; what it
// cannot do it says in one line before any work.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "cli/campaign_files.hpp"
#include "store/results_file.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

using nlohmann::json;

class Cost : public ::testing::Test {
  protected:
    Cost() {
        folder.write("target.csv", target_csv);
        folder.write("c.toml", small_campaign());
    }
    ~Cost() override { ::unsetenv("OVERTURN_PYTHON"); }

    void refused(std::vector<std::string> const& arguments, std::string const& part) {
        auto const ended = overturn(folder, arguments);
        EXPECT_EQ(ended.code, 2) << part;
        EXPECT_TRUE(is_one_error_line(ended.err));
        EXPECT_NE(ended.err.find(part), std::string::npos) << ended.err;
    }

    Folder folder;
};

// Is a field of JSON in the file? Texts are names of numbers or, where they are long, lines of an attribute.
bool is_stored(store::ResultsReader const& file, std::string const& path, FieldType type, std::size_t row,
               json const& value) {
    if (value.is_string() || (value.is_null() && type != FieldType::real)) {
        auto const texts = file.texts(path);
        return row < texts.size() && texts[row] == (value.is_null() ? "" : value.get<std::string>());
    }
    if (type == FieldType::real) {
        double const stored = file.reals(path).at(row);
        return value.is_null() ? std::isnan(stored) : stored == value.get<double>();
    }
    return file.integers(path).at(row)
           == (value.is_boolean() ? std::int64_t{value.get<bool>()} : value.get<std::int64_t>());
}

// R-1003: the tables of `cost -o` and of `cost --json` have the same columns by the same names, with the same values.
// \return how many values were compared
int expect_same_tables(store::ResultsReader const& file, json const& study) {
    std::map<std::string, store::ColumnMeaning> columns;  // by the path that JSON would give them
    std::set<std::string> in_file_only;
    for (auto const& column : file.columns()) {
        if (column.path.starts_with("digests/")) {
            continue;
        }
        auto const name = column.path.rfind('/') + 1;
        auto const path = column.path.substr(0, name) + Field{column.path.substr(name), column.units, {}}.key();
        columns[path] = column;
        in_file_only.insert(path);
    }
    std::map<std::string, std::set<std::string>> const attributes{{"settings", {"knob"}},
                                                                  {"rare", {"body", "amplitude", "probability"}}};
    std::map<std::string, std::size_t> rows;
    int compared = 0;
    for (auto const& [table, list] : study.items()) {
        if (table == "campaign_sha256") {  // the file holds the campaign itself
            continue;
        }
        for (auto const& row : list) {
            auto const group = table == "settings" ? table + "/" + row.at("knob").get<std::string>() : table;
            auto const place = rows[group]++;
            for (auto const& [name, value] : row.items()) {
                if (attributes.contains(table) && attributes.at(table).contains(name)) {
                    continue;
                }
                auto const path = group + "/" + name;
                auto const found = columns.find(path);
                auto const known = found != columns.end();
                EXPECT_TRUE(is_stored(file, known ? found->second.path : path,
                                      known ? found->second.type : FieldType::category, place, value))
                    << path << " " << place << " is not in the file as " << value;
                in_file_only.erase(path);
                ++compared;
            }
        }
    }
    for (auto const& path : in_file_only) {
        ADD_FAILURE() << path << " is not in the JSON";
    }
    return compared;
}

TEST_F(Cost, QuickstartBeginsWithTheAnswer) {
    auto const ended =
        overturn(folder, {"cost", OVERTURN_CAMPAIGNS "/quickstart.toml", "--waves", "2", "-o", "cost.h5"});

    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_TRUE(folder.has("cost.h5"));
    EXPECT_NE(ended.err.find("left"), std::string::npos) << "no word of the time that remains: " << ended.err;
    EXPECT_NE(ended.out.find("sample: 2 of 40 waves, 48 of 960 trials"), std::string::npos) << ended.out;
    EXPECT_NE(ended.out.find("Setting of the campaign: 20 rad"), std::string::npos) << ended.out;
    auto const answer = ended.out.substr(ended.out.find('\n') + 1);
    bool const known = answer.starts_with("The accuracy of the settings suffices: ")
                       || answer.starts_with("The accuracy of the settings does not suffice: ")
                       || answer.starts_with("Not decided: ");
    EXPECT_TRUE(known) << answer;
    auto const effect = answer.find("etting: ");  // of the setting that matters most
    EXPECT_LT(std::min(effect, answer.find("of any setting changes a verdict")), answer.find("sample: ")) << answer;
}

TEST_F(Cost, JsonAndFileHoldEveryKnob) {
    auto const ended = overturn(folder, {"cost", "c.toml", "--waves", "2", "--json", "-o", "cost.h5"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    auto const study = json::parse(ended.out);
    EXPECT_GT(
        expect_same_tables(store::ResultsReader(folder / "cost.h5", store::Trust::sealed, "overturn-cost"), study),
        500);

    std::vector<std::string> names;
    for (auto const& knob : study["knobs"]) {
        names.push_back(knob["knob"]);
        int here = 0;
        for (auto const& setting : study["settings"]) {
            here += setting["knob"] == knob["knob"] && setting["here"] ? 1 : 0;
            EXPECT_GE(setting["trials"], setting["flips"]);
        }
        EXPECT_EQ(here, knob["knob"] == "spectrum_periods" ? 0 : 1) << knob["knob"];
    }
    EXPECT_EQ(names, (std::vector<std::string>{"effects", "ou_v_e", "v_wes", "match_tolerance", "match_iterations",
                                               "spectrum_periods"}));
    auto const& of = study["study"][0];
    EXPECT_EQ(of["waves"], 2);
    EXPECT_EQ(of["trials"], 12);
    EXPECT_EQ(of["campaign_waves"], 12);
    EXPECT_FALSE(of["sentence"].get<std::string>().empty());
}

TEST_F(Cost, PageNeedsNoNetwork) {
    if (execute(folder, {OVERTURN_PYTHON, "-c", "import matplotlib"}).code != 0) {
        GTEST_SKIP() << "no matplotlib to draw with (install python3-matplotlib)";
    }
    folder.write("odd.toml", "title = '<b>A & B</b>'\n" + small_campaign().substr(small_campaign().find("seed")));
    auto const ended = overturn(folder, {"cost", "odd.toml", "--waves", "1", "--html", "p.html"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    auto const page = folder.read("p.html");

    std::size_t figures = 0;
    for (auto at = page.find("<svg"); at != std::string::npos; at = page.find("<svg", at + 1)) {
        ++figures;
    }
    EXPECT_EQ(figures, 8U);  // six knobs, the number of waves, the balance
    EXPECT_NE(page.find("&lt;b&gt;A &amp; B&lt;/b&gt;"), std::string::npos);
    EXPECT_EQ(page.find("<b>A"), std::string::npos);
    auto const steps = page.substr(page.find("<section id=\"step-error\""));
    EXPECT_LT(steps.find("<td>peak_rotation</td>"), steps.find("</section>"));
    for (char const* loads : {"src=", "<link", "@import", "url(http", "<?xml"}) {
        EXPECT_EQ(page.find(loads), std::string::npos) << loads;
    }
    EXPECT_TRUE(page.ends_with("</html>\n"));
}

// where a campaign asks for rare events, what each estimator spends for its scatter stands beside crude.
TEST_F(Cost, RareEventsHaveAPrice) {
    folder.write("rare.toml",
                 "seed=7\n[waves]\nsource='filtered-noise'\nrms='1 m/s2'\nmodel='clough-penzien'\namplitudes='fixed'\n"
                 "ground_frequency='0.5 Hz'\nground_damping=0.5\nfilter_frequency='0.1 Hz'\ncount=3\n"
                 "duration='20.47 s'\ntime_step='0.02 s'\n[[bodies]]\nname='block'\nmass='12.6 t'\n"
                 "base_width='0.9 m'\ncentre_height='1.045 m'\ninertia='uniform-block'\nrestitution=0.85\n"
                 "[levels]\nmeasure='factor'\nvalues=[1.0, 1.42]\n[rare]\nreplicates=4\n");
    auto const ended = overturn(folder, {"cost", "rare.toml", "--waves", "2", "--json", "-o", "rare.h5"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    auto const study = json::parse(ended.out);
    auto const rare = study.at("rare");
    store::ResultsReader const file(folder / "rare.h5", store::Trust::sealed, "overturn-cost");
    EXPECT_GT(expect_same_tables(file, study), 300);
    EXPECT_EQ(file.text_attribute("rare", "body"), "block");
    double const probability = rare.at(0).at("probability");
    EXPECT_EQ(rare.at(0).at("body"), "block");
    EXPECT_EQ(rare.at(0).at("amplitude"), 1.42);
    EXPECT_GT(probability, 1e-5);
    EXPECT_LT(probability, 1e-2);
    int foretold = 0;
    double waves = 0;
    for (auto const& point : rare) {
        EXPECT_TRUE(point.at("method") == "subset" || point.at("method") == "crude") << "waves are not linear";
        foretold += point.at("foretold") ? 1 : 0;
        EXPECT_GT(point.at("cpu_s"), 0);
        if (point.at("foretold")) {
            double const cov = point.at("cov");
            EXPECT_NEAR(point.at("waves").get<double>() * cov * cov * probability, 1, 0.01);
        } else if (!point.at("cov").is_null()) {
            EXPECT_GT(point.at("waves"), waves) << "more effort";
            waves = point.at("waves");
        }
    }
    EXPECT_EQ(foretold, 4);
    EXPECT_GT(waves, 0);
}

TEST_F(Cost, ImpossibleRequestsAreReportedFirst) {
    refused({"cost", "none.toml"}, "none.toml: cannot be read");
    refused({"cost", "c.toml", "--waves", "0"}, "--waves 0 (no sample)");
    refused({"cost", "c.toml", "--html", "p.htm"}, "End it in .html");
    refused({"cost", "c.toml", "-o", "no/folder/cost.h5"}, "no/folder");
    refused({"cost", "c.toml", "--set", "accuracy.contact_stp=0.1"}, "contact_step");
    folder.write("cost.h5", "something");
    refused({"cost", "c.toml", "-o", "cost.h5"}, "exists already");
    EXPECT_EQ(folder.read("cost.h5"), "something");
}

}  // namespace
}  // namespace overturn::testing
