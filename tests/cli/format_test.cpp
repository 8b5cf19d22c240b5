// Requirement R-1003: a version of the format names one set of columns, files of it stay readable for ever, and whose
// curves that fit gives is reported.
#include <cstdlib>
#include <numeric>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign/version.hpp"
#include "cli/campaign_files.hpp"
#include "cli/python.hpp"
#include "store/detail/objects.hpp"
#include "store/results_file.hpp"
#include "support/command.hpp"
#include "support/single_blanks.hpp"

namespace overturn::testing {
namespace {

using nlohmann::json;

class Format : public ::testing::Test {
  protected:
    void run(std::string const& campaign, std::string const& output) const {
        folder.write("target.csv", target_csv);
        folder.write("c.toml", campaign);
        auto const ended = overturn(folder, {"run", "c.toml", "-o", output});
        ASSERT_EQ(ended.code, 0) << ended.err;
    }
    void edit(std::string const& statement) const {
        ASSERT_EQ(edit_results(folder, "c.h5", statement).code, 0) << statement;
    }

    Folder folder;
};

std::string kind_of(hid_t dataset) {
    store::Datatype const type(H5Dget_type(dataset));
    auto const bits = 8 * H5Tget_size(type.id());
    switch (H5Tget_class(type.id())) {
        case H5T_FLOAT:
            return fmt::format("real{}", bits);
        case H5T_INTEGER:
            return fmt::format("integer{}", bits);
        case H5T_ENUM:
            return "names";
        default:
            return "other";
    }
}

// "/trials/v_wes real64 m/s" by line, in the order of names.
std::string columns_of(std::filesystem::path const& path) {
    store::Quiet const quiet;
    store::File const file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
    std::map<std::string, std::string> columns;
    store::each_object(file, [&](std::string const& name, store::Object const& object) {
        if (H5Iget_type(object.id()) == H5I_DATASET) {
            auto const units =
                H5Aexists(object.id(), "units") > 0 ? store::read_text_attribute(object.id(), "units") : "-";
            columns[name] = fmt::format("{} {} {}\n", name, kind_of(object.id()), units);
        }
    });
    std::string text;
    for (auto const& [name, line] : columns) {
        text += line;
    }
    return text;
}

// A golden file, for those who open it.
void unpack(Folder const& folder, std::string const& name, std::string const& as) {
    auto const packed = std::filesystem::path(OVERTURN_GOLDEN) / (name + ".h5.gz");
    ASSERT_EQ(execute(folder, {"/bin/sh", "-c", "gzip -dc '" + packed.string() + "' > " + as}).code, 0);
}

bool update_golden() {
    char const* const update = std::getenv("OVERTURN_UPDATE_GOLDEN");
    return update != nullptr && *update != '\0';
}

// With OVERTURN_UPDATE_GOLDEN=1 in the environment it is written instead.
void expect_golden(std::string const& name, std::string const& now) {
    auto const path = std::filesystem::path(OVERTURN_GOLDEN) / name;
    if (update_golden()) {
        std::ofstream(path, std::ios::binary) << now;
    }
    EXPECT_EQ(now, read_text(path)) << "the columns are not those of format version " << store::format_version
                                    << ": give the format its next number (store/results_file.hpp), and keep " << path
                                    << " as it is";
}

std::string rare_campaign() {
    return "seed=7\n[waves]\nsource='filtered-noise'\nrms='1 m/s2'\nmodel='clough-penzien'\nground_frequency='0.5 Hz'\n"
           "ground_damping=0.5\nfilter_frequency='0.1 Hz'\ncount=2\nduration='10.23 s'\ntime_step='0.02 s'\n"
           "[[bodies]]\nname='block'\nmass='12.6 t'\nbase_width='0.9 m'\ncentre_height='1.045 m'\n"
           "inertia='uniform-block'\nrestitution=0.85\n[levels]\nmeasure='factor'\nvalues=[1.25]\n"
           "[rare]\nmethod='subset'\nreplicates=4\n";
}

// Targets drawn in parts, and Sa at periods and over a band.
std::string varying_campaign() {
    return "seed=7\n[waves]\nsource='spectrum-compatible'\ncount=2\nduration='20.48 s'\ntime_step='0.02 s'\n"
           "[waves.target]\nspectrum='mlit-ch1'\n[waves.envelope]\nrise=2\nlevel_end=10\nend=18\n"
           "[waves.variability]\nbetween=0.3\nwithin=0.5\ncorrelation='baker-jayaram-2008'\n"
           "[[bodies]]\nname='block'\nmass='12.6 t'\nbase_width='0.9 m'\ncentre_height='1.045 m'\n"
           "inertia='uniform-block'\n[levels]\nmeasure='pga'\nvalues=[6]\n"
           "[measures]\nsa_periods=[1, 3]\nsa_band=[1, 3]\ncurves=['standardised_cav']\n";
}

// A level of rare events by failure pulses.
std::string pulses_campaign() {
    auto text = read_text(std::filesystem::path(OVERTURN_CAMPAIGNS) / "../tests/portable/rare_pulses.toml");
    std::string const body = "type_b_model.toml";
    return text.replace(text.find(body), body.size(), OVERTURN_CAMPAIGNS "/bodies/" + body);
}

// Some of its waves miss the rule and are no trials.
std::string refusing_campaign() {
    auto text = small_campaign("shared", 4);
    auto const put = [&](std::string const& before, std::string const& now) {
        text.replace(text.find(before), before.size(), now);
    };
    put("match_iterations=3", "match_iterations=5\nacceptance='japan'");
    put("longest=6", "longest=10");
    put("duration='20.48 s'", "duration='40.96 s'");
    put("level_end='10 s'", "level_end='25 s'");
    put("end='18 s'", "end='38 s'");
    return text;
}

TEST_F(Format, OneVersionHasOneTableOfColumns) {
    run(campaign_on_points(2) + "[measures]\nboth_radius_units=true\n[[limits]]\nname='touches'\nquantity='peak_slip'\n"
                                "above='0.1 m'\n",
        "c.h5");
    expect_golden(fmt::format("columns-{}.txt", store::format_version), columns_of(folder / "c.h5"));
    run(rare_campaign(), "rare.h5");
    expect_golden(fmt::format("columns-rare-{}.txt", store::format_version), columns_of(folder / "rare.h5"));
}

// R-1003: What every column means, in a page beside the format's and at a terminal, is what the files themselves say.
TEST_F(Format, ThePageOfColumnsIsTheFilesOwn) {
    run(campaign_on_points(2) + "[measures]\nboth_radius_units=true\n[[limits]]\nname='touches'\nquantity='peak_slip'\n"
                                "above='0.1 m'\n",
        "c.h5");
    run(rare_campaign() + "[[limits]]\nname='half'\nquantity='peak_rotation_ratio'\nabove=0.5\n", "rare.h5");
    run(varying_campaign(), "varying.h5");
    run(small_campaign("shared", 2) + "[site]\nwall='1 m'\nedge='1 m'\n", "site.h5");
    ASSERT_EQ(execute(folder, {"/bin/sh", "-c", "gzip -dc '" OVERTURN_GOLDEN "/results-5.h5.gz' > grid.h5"}).code, 0);
    run(pulses_campaign(), "pulses.h5");
    run(refusing_campaign(), "refusing.h5");
    auto const drawn =
        overturn(folder, {"run", OVERTURN_CAMPAIGNS "/margin.toml", "--set", "waves.count=8", "-o", "drawn.h5"});
    ASSERT_EQ(drawn.code, 0) << drawn.err;
    auto const page = overturn(folder, {"list", "columns", "c.h5", "rare.h5", "varying.h5", "site.h5", "grid.h5",
                                        "pulses.h5", "refusing.h5", "drawn.h5", "--markdown"});
    ASSERT_EQ(page.code, 0) << page.err;

    auto const path = std::filesystem::path(OVERTURN_GOLDEN) / "../../src/store/COLUMNS.md";
    if (update_golden()) {
        std::ofstream(path, std::ios::binary) << page.out;
    }
    EXPECT_EQ(page.out, read_text(path)) << "write it anew: OVERTURN_UPDATE_GOLDEN=1 before this test";
    EXPECT_NE(page.out.find("## /stripes/<body>\n"), std::string::npos);
    EXPECT_NE(page.out.find("## /limits/<limit>/fragility/<body>\n"), std::string::npos);
    EXPECT_NE(page.out.find("| `v_wes` | m/s |"), std::string::npos);
    auto const text = overturn(folder, {"list", "columns", "grid.h5"}).out;
    EXPECT_NE(text.find("/grid/<body>\n"), std::string::npos) << text;
    EXPECT_EQ(text.find("/rare"), std::string::npos) << text;
    for (std::string const name :
         {"c.h5", "rare.h5", "varying.h5", "site.h5", "grid.h5", "pulses.h5", "refusing.h5", "drawn.h5"}) {
        auto const listed = overturn(folder, {"list", "columns", name}).out;
        EXPECT_EQ(listed.find("unknown to this program"), std::string::npos) << name << listed;
    }
    for (auto const& wrong : {std::vector<std::string>{"list", "columns"}, {"list", "columns", "none.h5"}}) {
        EXPECT_EQ(overturn(folder, wrong).code, 2);
    }
}

TEST_F(Format, InputFilesAreListedHoweverMany) {
    auto const ran =
        overturn(folder, {"run", OVERTURN_CAMPAIGNS "/quickstart.toml", "--set", "waves.count=1", "-o", "two.h5"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    ASSERT_EQ(store::ResultsReader(folder / "two.h5").members("inputs").size(), 2U);
    auto const listed = overturn(folder, {"list", "columns", "two.h5"}).out;
    EXPECT_NE(listed.find("/inputs\n  <n>  text of an input file; its attribute description is the file's name\n/"),
              std::string::npos)
        << listed;
    EXPECT_EQ(listed.find("unknown to this program"), std::string::npos) << listed;
}

/// A file of each version that this program reads, as it was written when the version was new.
TEST_F(Format, FilesStayReadable) {
    for (std::string const version : {"3", "4", "5"}) {
        unpack(folder, "results-" + version, "old.h5");

        auto const status = overturn(folder, {"status", "old.h5"});
        EXPECT_EQ(status.code, 0) << status.err;
        EXPECT_TRUE(status.out.starts_with("old.h5: complete, 6 trials of 'kept for ever'\n")) << status.out;
        EXPECT_EQ(status.out.find("Known of its version") != std::string::npos, version == "3") << status.out;
        auto const fit = overturn(folder, {"fit", "old.h5", "--json"});
        EXPECT_TRUE(fit.code == 0 || fit.code == 4) << fit.err;
        auto const stripes = json::parse(fit.out).at("stripes");
        ASSERT_EQ(stripes.size(), 3U);
        EXPECT_EQ(stripes[0].at("overturned"), 0);
        EXPECT_EQ(stripes[2].at("overturned"), 2);
        // All is recomputed to the bit but what has changed since: the landing after the motion counts, of one trial.
        auto const verified = overturn(folder, {"verify", "old.h5"});
        EXPECT_EQ(verified.code, 1) << verified.out << verified.err;
        EXPECT_NE(verified.out.find("6 trials, 2 waves recomputed, NOT all bit-equal: 1 trials, 0 waves differ; first "
                                    "trial 4 (wave 1, block, 500 gal): min_contact_force_ratio\n"),
                  std::string::npos)
            << verified.out;
        EXPECT_EQ(overturn(folder, {"replay", "old.h5", "--trial", "5"}).code, 0);
        EXPECT_EQ(overturn(folder, {"report", "old.h5", "-o", "old.html"}).code, 0);
        auto const listed = overturn(folder, {"list", "columns", "old.h5"}).out;
        EXPECT_EQ(listed.find("unknown to this program"), std::string::npos) << version << listed;
    }
}

/// R-1003: A file of a program that had a wave column (loudness) and a model (crush, with a verdict, an effect, a
/// reason and quantities of its own) more, and other numbers for contact-lost and overturned. What is not known here
/// counts by what the file says of it: crushed trials moved, are decided and did not fall.
TEST_F(Format, AProgramWithMoreIsRead) {
    unpack(folder, "results-more", "more.h5");
    auto const status = overturn(folder, {"status", "more.h5"});
    EXPECT_EQ(status.code, 0) << status.err;
    EXPECT_TRUE(status.out.starts_with("more.h5: complete, 12 trials of 'a column and a model more'")) << status.out;

    auto const fit = overturn(folder, {"fit", "more.h5", "--json"});
    EXPECT_TRUE(fit.code == 0 || fit.code == 4) << fit.err;
    EXPECT_NE(fit.err.find("verdict 'crushed' is not known to this program: its trials count as rocked"),
              std::string::npos)
        << fit.err;
    store::ResultsReader const file(folder / "more.h5");
    auto const crushed = file.integers("stripes/block/crushed");
    auto const rocked = file.integers("stripes/block/rocked");
    auto const overturned = file.integers("stripes/block/overturned");
    auto const stripes = json::parse(fit.out).at("stripes");
    ASSERT_EQ(crushed.size(), 3U);
    EXPECT_GT(std::accumulate(crushed.begin(), crushed.end(), std::int64_t{0}), 0);
    for (std::size_t l = 0; l < 3; ++l) {
        EXPECT_EQ(stripes[l].at("rocked"), rocked[l] + crushed[l]);
        EXPECT_EQ(stripes[l].at("overturned"), overturned[l]);
        EXPECT_EQ(stripes[l].at("contact_lost"), 0);
    }
    auto const columns = overturn(folder, {"list", "columns", "more.h5"});
    // What is not known here is kept and marked: a column of waves, of results, of a model's own.
    for (std::string const name : {"loudness ", "crushed ", "crushing_called ", "depth ", "hits "}) {
        auto const line = columns.out.substr(columns.out.find("  " + name));
        auto const mark = line.find("(unknown to this program) ");
        EXPECT_LT(mark, line.find('\n')) << name << columns.out;
    }
    std::size_t marks = 0;
    for (auto at = columns.out.find("unknown to"); at != std::string::npos;
         at = columns.out.find("unknown to", at + 1)) {
        ++marks;
    }
    EXPECT_EQ(marks, 5U) << columns.out;
    EXPECT_NE(fit.err.find("model 'crush' is not known to this program: its "), std::string::npos) << fit.err;
    EXPECT_EQ(overturn(folder, {"report", "more.h5", "-o", "more.html"}).code, 0);
    EXPECT_NE(
        read_text(folder / "more.html")
            .find("columns that this program does not know: stripes/block/crushed, stripes/block/crushing_called, "
                  "trials/crush/depth, trials/crush/hits, waves/loudness"),
        std::string::npos);
    // Where the models of both ran a trial it is the same to the bit.
    EXPECT_EQ(overturn(folder, {"replay", "more.h5", "--trial", "0"}).code, 0);
    auto const verified = overturn(folder, {"verify", "more.h5"});
    EXPECT_EQ(verified.code, 1);
    EXPECT_NE(
        verified.err.find("not compared (this program does not know them): stripes/block/crushed, "
                          "stripes/block/crushing_called, trials/crush/depth, trials/crush/hits, waves/loudness\n"),
        std::string::npos)
        << verified.err;
    EXPECT_NE(verified.out.find("0 waves differ"), std::string::npos) << verified.out;
    json const unknown{"stripes/block/crushed", "stripes/block/crushing_called", "trials/crush/depth",
                       "trials/crush/hits", "waves/loudness"};
    for (std::string const verb : {"fit", "status"}) {
        auto const found = json::parse(overturn(folder, {verb, "more.h5", "--json"}).out).at("unknown_columns");
        EXPECT_EQ(found, unknown) << verb;
        auto const text = overturn(folder, {verb, "more.h5"});
        auto all = text.out + text.err;
        std::ranges::replace(all, '\n', ' ');
        EXPECT_NE(single_blanks(all).find("columns that this program does not know: stripes/block/crushed, "
                                          "stripes/block/crushing_called"),
                  std::string::npos)
            << text.out << text.err;
    }
}

// R-1003: a column that this program does not know is named whichever table it stands in, and no other is: files of
// every format have none.
TEST_F(Format, UnknownColumnsOfEveryTableAreNamed) {
    auto const unknown_in = [&](std::string const& file) {
        auto const status = overturn(folder, {"status", file, "--json", "--unverified"});
        EXPECT_EQ(status.code, 0) << status.err;
        return json::parse(status.out).at("unknown_columns");
    };
    for (std::string const name : {"results-3", "results-4", "results-5"}) {
        unpack(folder, name, "old.h5");
        EXPECT_EQ(unknown_in("old.h5"), json::array()) << name;
    }
    if (!has_python(folder, "h5py")) {
        GTEST_SKIP() << "no h5py to write with (install python3-h5py)";
    }
    run(small_campaign("shared", 4) + "[[limits]]\nname='tilts'\nquantity='peak_rotation_ratio'\nabove=0.1\n", "c.h5");
    EXPECT_EQ(unknown_in("c.h5"), json::array());
    json added;
    for (std::string const group :
         {"bodies/type-a", "criterion/type-a", "criterion_by_level/type-a/v_wes", "fragility/type-a",
          "limits/tilts/stripes/type-a", "new_table/type-a", "quantiles/type-a/peak_slip", "stripes/type-a", "trials",
          "waves", "waves/type-a"}) {
        added.push_back(group + "/mine");
        auto const there = group.starts_with("new") ? "not in" : "in";
        edit(fmt::format("assert '{0}' {1} f; f.create_dataset('{0}/mine', data=[1.0])", group, there));
    }
    EXPECT_EQ(unknown_in("c.h5"), added);
    auto const fit = overturn(folder, {"fit", "c.h5", "--json", "--unverified"});
    EXPECT_EQ(json::parse(fit.out).at("unknown_columns"), added) << fit.err;
}

// R-1003: what a file does not have is unknown; only what distinguishes trials and how they ended has to be there.
TEST_F(Format, AFileWithFewerColumnsIsRead) {
    if (!has_python(folder, "h5py")) {
        GTEST_SKIP() << "no h5py to write with (install python3-h5py)";
    }
    run(small_campaign("shared", 4), "c.h5");
    edit(
        "[f.__delitem__(column) for column in ['trials/peak_slip', 'trials/peak_rotation_ratio', 'trials/failure', "
        "'waves/acceptance_failures', 'waves/pgv'] if column in f]");
    edit("f.attrs.__setitem__('format', bytes(f.attrs['format']))");  // what other writers make of text: ASCII
    for (auto const& verb : {std::vector<std::string>{"fit"}, {"fit", "--json"}, {"status"}, {"list", "columns"}}) {
        auto const read = overturn(folder, joined(verb, {"c.h5", "--unverified"}));
        EXPECT_TRUE(read.code == 0 || read.code == 4) << verb.back() << read.err;
    }
    // What is not there cannot be compared, and both the text and the record say so.
    auto const verified = overturn(folder, {"verify", "c.h5", "--unverified", "--json"});
    EXPECT_EQ(verified.code, 0) << verified.err;
    EXPECT_NE(verified.err.find("not compared (the file does not have them): trials/"), std::string::npos)
        << verified.err;
    auto const record = nlohmann::json::parse(verified.out);
    auto const absent = record.at("absent_columns").get<std::vector<std::string>>();
    EXPECT_EQ(absent.size(), 5U) << record.at("absent_columns");
    EXPECT_NE(std::ranges::find(absent, "trials/peak_slip"), absent.end());
    EXPECT_NE(overturn(folder, {"verify", "c.h5", "--unverified"}).out.find("in the columns that the file has"),
              std::string::npos);
    // A page and Python do without them too, beside a column of which nothing but its numbers is known.
    edit("f['trials'].create_dataset('loud', data=f['trials/v_ereq'][()])");
    auto const page = overturn(folder, {"report", "c.h5", "--unverified", "-o", "c.html"});
    EXPECT_EQ(page.code, 0) << page.err;
    // Names as other writers number them, in four bytes; predictions and models that are not there are not counted as
    // any.
    edit(
        "old = f['trials/verdict']; kind = h5py.check_enum_dtype(old.dtype); values = old[()].astype('i4'); "
        "del f['trials/verdict']; "
        "f['trials'].create_dataset('verdict', data=values, dtype=h5py.enum_dtype(kind, basetype='i4')); "
        "[f.__delitem__(column) for column in ['trials/v_wes_safe', 'trials/v_wes', 'trials/rung']]");
    auto const fitted = overturn(folder, {"fit", "c.h5", "--unverified", "--json"});
    ASSERT_TRUE(fitted.code == 0 || fitted.code == 4) << fitted.err;
    EXPECT_NE(fitted.err.find("trials/v_wes"), std::string::npos) << fitted.err;
    EXPECT_NE(fitted.err.find(": results that need them are not known\n"), std::string::npos) << fitted.err;
    auto const less = nlohmann::json::parse(fitted.out);
    auto judged = nlohmann::json::object();
    for (auto const& row : less.at("criterion_by_level")) {
        auto& count = judged[row.at("measure").get<std::string>()];
        count = (count.is_null() ? 0 : count.get<int>()) + row.at("true_safe").get<int>()
                + row.at("false_safe").get<int>() + row.at("false_alarm").get<int>()
                + row.at("true_overturn").get<int>();
    }
    EXPECT_EQ(judged.at("v_wes"), 0) << judged;
    EXPECT_GT(judged.at("ou_v_e"), 0) << judged;
    for (auto const& row : less.at("models")) {
        EXPECT_EQ(row.at("trials"), 0) << row;
    }
    edit("del f['waves/id']");
    for (auto const* verb : {"fit", "status", "verify"}) {
        auto const read = overturn(folder, {verb, "c.h5", "--unverified"});
        EXPECT_EQ(read.code, 2) << read.err;
        EXPECT_NE(
            read.err.find("results file: has no waves/id (it was edited or damaged, or another program wrote it)"),
            std::string::npos)
            << read.err;
    }
    edit("del f['trials/verdict']");
    auto const exported = overturn(folder, {"export", "c.h5", "--unverified", "-o", "tables"});
    EXPECT_EQ(exported.code, 2) << exported.err;
    EXPECT_NE(exported.err.find("results file: has no trials/verdict"), std::string::npos) << exported.err;
    EXPECT_FALSE(folder.has("tables"));
}

TEST_F(Format, TheProgramOfTheCurvesIsReported) {
    if (!has_python(folder, "h5py")) {
        GTEST_SKIP() << "no h5py to write with (install python3-h5py)";
    }
    run(small_campaign("shared", 6), "c.h5");
    auto const own = overturn(folder, {"fit", "c.h5"});
    EXPECT_EQ(own.code, 0);
    EXPECT_EQ(own.err, "");

    edit("f.attrs['sources_sha256'] = 'f' * 64");
    auto const same = overturn(folder, {"fit", "c.h5", "--unverified"});
    EXPECT_EQ(same.code, 0) << same.err;
    EXPECT_NE(same.err.find("c.h5: NOT as it was written"), std::string::npos) << same.err;
    EXPECT_NE(same.err.find("refitted by overturn " + program_identity()), std::string::npos) << same.err;
    EXPECT_NE(same.err.find("sources ffffffffffff), all curves equal to 1e-9"), std::string::npos) << same.err;
    EXPECT_EQ(same.out, own.out);

    edit("f['fragility/type-b/rank_area'][0] *= 1 + 3e-8");
    auto const other = overturn(folder, {"fit", "c.h5", "--unverified", "--confidence", "0.9"});
    EXPECT_EQ(other.code, 4) << other.err;
    EXPECT_NE(other.err.find("fragility/type-b/rank_area differs by 3e-08"), std::string::npos) << other.err;

    // Curves of limit states are curves.
    std::filesystem::remove(folder / "c.h5");
    run(small_campaign("shared", 6) + "[[limits]]\nname='tilts'\nquantity='peak_rotation_ratio'\nabove=0.1\n", "c.h5");
    edit("f.attrs['sources_sha256'] = 'f' * 64; f['limits/tilts/fragility/type-b/rank_area'][0] *= 1 + 3e-8");
    auto const limits = overturn(folder, {"fit", "c.h5", "--unverified"});
    EXPECT_EQ(limits.code, 4) << limits.err;
    EXPECT_NE(limits.err.find("limits/tilts/fragility/type-b/rank_area differs by 3e-08"), std::string::npos)
        << limits.err;
}

// R-1103: Outside git the revision distinguishes no programs; the sources do.
TEST(Program, IsIdentifiedByItsSources) {
    EXPECT_EQ(sources_sha256().size(), 64U);
    EXPECT_EQ(sources_sha256().find_first_not_of("0123456789abcdef"), std::string::npos);
    EXPECT_NE(program_identity().find("sources " + sources_sha256().substr(0, 12)), std::string::npos);
    EXPECT_FALSE(compiler().empty());
}

/// What decides last bits, for whoever compares two machines; not in the results.
TEST_F(Format, TheTimesSayOnWhatTheyWereTaken) {
    run(small_campaign("shared", 2), "c.h5");
    auto const runtime = json::parse(folder.read("c.runtime.json"));

    ASSERT_EQ(runtime.at("segments").size(), 1U);
    auto const& segment = runtime.at("segments")[0];
    EXPECT_EQ(segment.at("program"), program_identity());
    EXPECT_EQ(segment.at("compiler"), compiler());
    EXPECT_NE(segment.at("libraries").get<std::string>().find("FFTW"), std::string::npos);
    EXPECT_FALSE(segment.at("mpi").get<std::string>().empty());
    EXPECT_EQ(segment.at("ranks"), 1);
    for (char const* key : {"host", "glibc", "lanes"}) {
        EXPECT_FALSE(runtime.at("ranks")[0].at(key).get<std::string>().empty()) << key;
    }
}

// The time of a run is all of it, as `plan` counts it: reading and calibrating, blocks, rare events, merging.
TEST_F(Format, TheTimeOfARunIsThatOfTheProgram) {
    run(small_campaign("shared", 2), "c.h5");
    auto const runtime = json::parse(folder.read("c.runtime.json"));

    auto const& segment = runtime.at("segments")[0];
    double parts = 0;
    for (char const* part : {"start_s", "work_s", "merge_s"}) {
        EXPECT_GT(segment.at(part), 0) << part;
        parts += segment.at(part).get<double>();
    }
    EXPECT_EQ(segment.at("rare_s"), 0);
    EXPECT_GE(segment.at("wall_s"), parts);
    EXPECT_EQ(runtime.at("wall_s"), segment.at("wall_s"));
    EXPECT_EQ(runtime.at("merge_s"), 0) << "of a program of its own";
}

/// Segments of a run that stopped early are reported, too.
TEST_F(Format, EverySegmentIsReported) {
    folder.write("target.csv", target_csv);
    folder.write("c.toml", small_campaign("shared", 12));
    EXPECT_EQ(overturn(folder, {"run", "c.toml", "--max-walltime", "0.001"}).code, 3);
    EXPECT_EQ(json::parse(folder.read("c.runtime.json")).at("segments").size(), 1U);
    EXPECT_EQ(overturn(folder, {"run", "c.toml", "--resume", "--max-walltime", "0.001"}).code, 3);
    EXPECT_EQ(execute(folder, mpirun(2, {"run", "c.toml", "--resume"})).code, 0);

    auto const runtime = json::parse(folder.read("c.runtime.json"));
    ASSERT_EQ(runtime.at("segments").size(), 3U);
    EXPECT_EQ(runtime.at("segments")[2].at("ranks"), 2);
    EXPECT_EQ(runtime.at("ranks").size(), 4U);
    EXPECT_EQ(runtime.at("ranks")[3].at("segment"), 2);
    EXPECT_EQ(runtime.at("trials"), 72);
    EXPECT_FALSE(folder.has("c.h5.parts"));
}

}  // namespace
}  // namespace overturn::testing
