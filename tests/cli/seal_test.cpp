// Requirement R-1004: whoever reads a finished file holds it against what was written: no flipped bit and no edit
// passes, what changed is named, and --unverified reads it all the same.
#include <random>

#include "cli/campaign_files.hpp"
#include "cli/python.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

class SealedFile : public ::testing::Test {
  protected:
    void SetUp() override {
        folder.write("target.csv", target_csv);
        folder.write("c.toml", small_campaign("shared", 4));
        ASSERT_EQ(overturn(folder, {"run", "c.toml"}).code, 0);
        sound = folder.read("c.h5");
    }

    void expect_refused(std::vector<std::string> const& arguments, std::string const& why) const {
        auto const told = overturn(folder, arguments);
        EXPECT_EQ(told.code, 2) << arguments[0] << why;
        EXPECT_TRUE(is_one_error_line(told.err)) << arguments[0] << why;
        EXPECT_NE(told.err.find(why), std::string::npos) << arguments[0] << why << told.err;
    }

    /// As a person does who knows how a file is sealed.
    void seal_anew() const {
        folder.write(
            "seal.py",
            "import hashlib\nbody = open('c.h5', 'rb').read().split(b'\\noverturn-seal sha256 ')[0]\n"
            "line = f'\\noverturn-seal sha256 {hashlib.sha256(body).hexdigest()} of {len(body):020} bytes\\n'\n"
            "open('c.h5', 'wb').write(body + line.encode())\n");
        ASSERT_EQ(execute(folder, {OVERTURN_PYTHON, "seal.py"}).code, 0);
    }

    Folder folder;
    std::string sound;
};

struct Edit {
    char const* statement;
    char const* named;
};

constexpr Edit edits[] = {
    {"f['trials/v_wes'][5] *= 2", "/trials/v_wes changed"},
    {"f['trials/v_wes'][...] = f['trials/v_wes'][...] * 1.1", "/trials/v_wes changed"},
    {"f['trials/v_wes'][3] = float('nan')", "/trials/v_wes changed"},
    {"f['trials/scale'][3] *= 2", "/trials/scale changed"},
    {"f['trials/amplitude'][3] *= 2", "/trials/amplitude changed"},
    {"f['trials/wave'][3] = 2", "/trials/wave changed"},
    {"v = f['trials/verdict'][...]; f['trials/verdict'][...] = v[::-1]", "/trials/verdict changed"},
    {"f['trials/v_resp'][3] += 1", "/trials/v_resp changed"},
    {"f['trials/peak_rotation'][3] += 1", "/trials/peak_rotation changed"},
    {"f['waves/pga'][1] *= 2", "/waves/pga changed"},
    {"f['stripes/type-a/probability'][0] = 0.5", "/stripes/type-a/probability changed"},
    {"f['fragility/type-b/median'][...] = 3", "/fragility/type-b/median changed"},
    {"f['trials/verdict'][5] = (f['trials/verdict'][5] + 1) % 6", "/trials/verdict changed"},
    {"f['bodies/type-a/mass'].attrs['units'] = 't'", "/bodies/type-a/mass changed"},
    {"f.attrs['seed'] = 1", "(/ changed)"},
    {"del f['criterion']", "/criterion is gone"},
};

TEST_F(SealedFile, EditsAreNamed) {
    if (!has_python(folder, "h5py")) {
        GTEST_SKIP() << "no h5py to write with (install python3-h5py)";
    }
    for (auto const& [statement, named] : edits) {
        folder.write("c.h5", sound);
        ASSERT_EQ(edit_results(folder, "c.h5", statement).code, 0) << statement;
        for (std::string const verb : {"status", "fit"}) {
            expect_refused({verb, "c.h5"}, named);
        }
    }
}

TEST_F(SealedFile, EveryReaderLooks) {
    if (!has_python(folder, "h5py")) {
        GTEST_SKIP() << "no h5py to write with (install python3-h5py)";
    }
    ASSERT_EQ(edit_results(folder, "c.h5", "f['trials/v_wes'][...] = f['trials/v_wes'][...] * 1.1").code, 0);
    std::string const why = "c.h5: damaged or edited (/trials/v_wes changed). Restore it or run the campaign again";

    expect_refused({"report", "c.h5", "-o", "page.html"}, why);
    EXPECT_FALSE(folder.has("page.html"));
    expect_refused({"replay", "c.h5", "--trial", "3"}, why);
    expect_refused({"merge", "c.h5"}, why);
    expect_refused({"list", "columns", "c.h5"}, why);
    auto const listed = overturn(folder, {"list", "columns", "c.h5", "--unverified"});
    EXPECT_EQ(listed.code, 0) << listed.err;
    EXPECT_NE(listed.err.find("c.h5: NOT as it was written"), std::string::npos) << listed.err;
    EXPECT_EQ(overturn(folder, {"list", "keys", "--unverified"}).code, 2);
    expect_refused({"run", "c.toml", "--resume"}, why);
    EXPECT_EQ(overturn(folder, {"status", "c.h5", "--unverified"}).code, 0);
    EXPECT_EQ(overturn(folder, {"fit", "c.h5", "--unverified", "--json"}).code, 0);
    auto const replayed = overturn(folder, {"replay", "c.h5", "--trial", "3", "--unverified"});
    EXPECT_EQ(replayed.code, 1);
    EXPECT_NE(replayed.out.find("NOT bit-equal to the stored row: v_wes differ"), std::string::npos) << replayed.out;
}

/// A seal can be made anew; the digests inside show it all the same, and whoever reads what was edited gets a warning.
TEST_F(SealedFile, ASealMadeAnewDoesNotHide) {
    if (!has_python(folder, "h5py")) {
        GTEST_SKIP() << "no h5py to write with (install python3-h5py)";
    }
    ASSERT_EQ(edit_results(folder, "c.h5", "f['trials/v_wes'][...] = f['trials/v_wes'][...] * 1.1").code, 0);
    seal_anew();
    for (std::string const verb : {"status", "fit"}) {
        expect_refused({verb, "c.h5"}, "/trials/v_wes changed");
    }

    auto const status = overturn(folder, {"status", "c.h5", "--unverified"});
    EXPECT_TRUE(status.out.starts_with("c.h5: complete but edited or damaged, ")) << status.out;
    auto const fit = overturn(folder, {"fit", "c.h5", "--unverified", "--json"});
    EXPECT_NE(fit.err.find("c.h5: NOT as it was written"), std::string::npos) << fit.err;
    EXPECT_NE(fit.out.find("\"unverified\": true"), std::string::npos);
    folder.write("c.h5", sound);
    auto const fine = overturn(folder, {"fit", "c.h5", "--unverified", "--json"});
    EXPECT_EQ(fine.err, "");
    EXPECT_NE(fine.out.find("\"unverified\": false"), std::string::npos);
    EXPECT_TRUE(overturn(folder, {"status", "c.h5", "--unverified"}).out.starts_with("c.h5: complete, "));
}

// Each value is one that the program wrote, but not there; or lies where the file does not prove it.
constexpr Edit exchanges[] = {
    {"t = f['trials']; t.move('v_resp', 'x'); t.move('peak_rotation', 'v_resp'); t.move('x', 'peak_rotation')",
     "/trials/peak_rotation changed, /trials/v_resp changed"},
    {"a, b = f['trials/v_resp'], f['trials/v_wes']; v = a[...]; a[...] = b[...]; b[...] = v",
     "/trials/v_resp changed, /trials/v_wes changed"},
    {"s = f['stripes']; s.move('type-a', 'x'); s.move('type-b', 'type-a'); s.move('x', 'type-b')", "/stripes/type-a"},
    {"del f['trials/v_wes']; f['trials/v_wes'] = f['trials/v_resp']", "/trials/v_wes changed"},
    {"del f['trials/v_wes']; f['trials/v_wes'] = h5py.SoftLink('/trials/v_resp')",
     "/trials/v_wes is a link to elsewhere"},
    {"del f['trials/v_wes']; f['trials/v_wes'] = h5py.ExternalLink('other.h5', '/trials/v_wes')",
     "/trials/v_wes is a link to elsewhere"},
    {"del f['stripes/type-b']; f['stripes/type-b'] = f['stripes/type-a']", "is reached by two names"},
    {"del f['stripes/type-b']; f['stripes/type-b'] = h5py.SoftLink('/stripes/type-a')",
     "/stripes/type-b is a link to elsewhere"},
};

TEST_F(SealedFile, ExchangedColumnsAndLinksAreRefused) {
    if (!has_python(folder, "h5py")) {
        GTEST_SKIP() << "no h5py to write with (install python3-h5py)";
    }
    folder.write("other.h5", sound);
    for (auto const& [statement, named] : exchanges) {
        for (bool const with_seal : {false, true}) {
            folder.write("c.h5", sound);
            ASSERT_EQ(edit_results(folder, "c.h5", statement).code, 0) << statement;
            if (with_seal) {
                seal_anew();
            }
            SCOPED_TRACE(std::string(statement) + (with_seal ? ", sealed anew" : ""));
            expect_refused({"fit", "c.h5"}, named);
            expect_refused({"report", "c.h5", "-o", "page.html"}, named);
            expect_refused({"verify", "c.h5"}, named);
            expect_refused({"status", "c.h5"}, named);
            expect_refused({"export", "c.h5", "-o", "tables"}, named);
            expect_refused({"list", "columns", "c.h5"}, named);
            auto const opened = open_in_python(folder, "c.h5");
            EXPECT_EQ(opened.code, 2) << opened.err;
            EXPECT_TRUE(opened.out.starts_with("c.h5: ")) << opened.out;
            EXPECT_TRUE(!with_seal || opened.out.find(named) != std::string::npos) << opened.out;
        }
    }
    EXPECT_FALSE(folder.has("page.html"));
    EXPECT_FALSE(folder.has("tables"));
}

TEST_F(SealedFile, ItsPageStatesThatItWasEdited) {
    if (!has_python(folder, "h5py") || !has_python(folder, "matplotlib")) {
        GTEST_SKIP() << "nothing to draw with (install python3-h5py python3-matplotlib)";
    }
    ASSERT_EQ(edit_results(folder, "c.h5", "f['trials/v_wes'][5] *= 2").code, 0);
    ASSERT_EQ(overturn(folder, {"report", "c.h5", "-o", "edited.html", "--unverified"}).code, 0);
    EXPECT_NE(folder.read("edited.html").find("The results file is NOT as it was written"), std::string::npos);
}

/// Where no reader of HDF5 would ever look, too.
TEST_F(SealedFile, FlippedBitsAreNoticed) {
    std::mt19937_64 random(2013);
    for (int i = 0; i < 30; ++i) {  // 300 of them in store/Seals.EveryFlippedBitIsNoticed
        auto const bit = random() % (8 * sound.size());
        auto changed = sound;
        changed[bit / 8] = static_cast<char>(changed[bit / 8] ^ (1 << bit % 8));
        folder.write("c.h5", changed);
        std::vector<std::vector<std::string>> const readers{
            {"status", "c.h5"}, {"fit", "c.h5"}, {"list", "columns", "c.h5"}};
        expect_refused(readers[static_cast<std::size_t>(i) % readers.size()], "c.h5: ");
    }
}

/// A campaign may be read as it is after a verdict was set by hand: curves are those of the rows.
TEST_F(SealedFile, UnverifiedFitsWhatTheRowsSay) {
    if (!has_python(folder, "h5py")) {
        GTEST_SKIP() << "no h5py to write with (install python3-h5py)";
    }
    ASSERT_EQ(edit_results(folder, "c.h5", "f['trials/verdict'][...] = 3").code, 0);
    auto const fit = overturn(folder, {"fit", "c.h5", "--unverified", "--full"});

    EXPECT_EQ(fit.code, 0) << fit.err;
    EXPECT_NE(fit.out.find("1.0000"), std::string::npos) << fit.out;
}

TEST_F(SealedFile, AColumnOfWordsInPlaceOfNumbersIsBadInput) {
    if (!has_python(folder, "h5py")) {
        GTEST_SKIP() << "no h5py to write with (install python3-h5py)";
    }
    ASSERT_EQ(edit_results(folder, "c.h5",
                           "n = len(f['trials/peak_rotation']); del f['trials/peak_rotation']; "
                           "f['trials/peak_rotation'] = [b'high'] * n")
                  .code,
              0);
    auto const refused = [&](std::vector<std::string> const& command, std::string const& column) {
        auto const ended = overturn(folder, joined(command, {"--unverified"}));
        EXPECT_EQ(ended.code, 2) << command.front() << ended.err;
        EXPECT_NE(ended.err.find(column + " holds no numbers"), std::string::npos) << ended.err;
    };
    refused({"fit", "c.h5"}, "trials/peak_rotation");
    refused({"replay", "c.h5", "--trial", "3"}, "trials/peak_rotation");
    ASSERT_EQ(edit_results(folder, "c.h5",
                           "n = len(f['trials/wave']); del f['trials/wave']; f['trials/wave'] = [b'high'] * n")
                  .code,
              0);
    refused({"status", "c.h5"}, "trials/wave");  // of trials it reads what it counts by
}

}  // namespace
}  // namespace overturn::testing
