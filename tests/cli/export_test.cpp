// Requirement R-917: what `export` writes as csv and as a workbook is what h5py reads of the file: every number, name
// and empty cell, of old files too; nothing is written over unasked, and nothing is left half written.
#include <fmt/format.h>

#include "cli/campaign_files.hpp"
#include "cli/python.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

class Export : public ::testing::Test {
  protected:
    void run(std::string const& campaign) const {
        folder.write("target.csv", target_csv);
        folder.write("c.toml", campaign);
        auto const ended = overturn(folder, {"run", "c.toml"});
        ASSERT_EQ(ended.code, 0) << ended.err;
    }
    void unpack(std::string const& name) const {
        auto const packed = std::filesystem::path(OVERTURN_GOLDEN) / (name + ".h5.gz");
        ASSERT_EQ(execute(folder, {"/bin/sh", "-c", "gzip -dc '" + packed.string() + "' > c.h5"}).code, 0);
    }
    void expect_exported_as_stored() const {
        auto const ended = overturn(folder, {"export", "c.h5", "--force"});
        ASSERT_EQ(ended.code, 0) << ended.err;
        auto const compared = execute(folder, {OVERTURN_PYTHON, OVERTURN_COMPARE_TABLES, "c.h5", "c.tables"});
        EXPECT_EQ(compared.code, 0) << compared.out << compared.err;
        EXPECT_NE(compared.out.find("curves "), std::string::npos) << compared.out;
    }
    void expect_refused(std::vector<std::string> const& arguments, std::string const& why) const {
        auto const ended = overturn(folder, joined({"export"}, arguments));
        EXPECT_EQ(ended.code, 2) << ended.err;
        EXPECT_TRUE(is_one_error_line(ended.err));
        EXPECT_NE(ended.err.find(why), std::string::npos) << ended.err;
    }
    void SetUp() override {
        unpack("results-5");
        if (overturn(folder, {"export", "c.h5", "--as", "xlsx"}).err.find("without libxlsxwriter")
            != std::string::npos) {
            GTEST_SKIP() << "no libxlsxwriter in this build (install libxlsxwriter-dev)";
        }
        std::filesystem::remove_all(folder / "c.tables");
        std::filesystem::remove(folder / "c.h5");
    }
    [[nodiscard]] std::size_t files_in(std::string const& name) const {
        std::filesystem::directory_iterator const files(folder / name);
        return static_cast<std::size_t>(std::distance(begin(files), end(files)));
    }

    Folder folder;
};

constexpr char const* no_python = "no h5py and openpyxl to read with (install python3-h5py, python3-openpyxl)";

// Bodies on points have columns of their own, limit states have stripes and curves of theirs.
TEST_F(Export, IsWhatTheFileHolds) {
    if (!has_python(folder, "h5py, openpyxl")) {
        GTEST_SKIP() << no_python;
    }
    run(campaign_on_points(4) + "[[limits]]\nname='touches, \"hard\"'\nquantity='peak_slip'\nabove='10 cm'\n");
    expect_exported_as_stored();
    auto const first = folder.read("c.tables/tables.xlsx");
    EXPECT_NE(folder.read("c.tables/stripes.csv").find(",\"touches, \"\"hard\"\"\",3,300,"), std::string::npos);
    ASSERT_EQ(overturn(folder, {"export", "c.h5", "--force"}).code, 0);
    EXPECT_TRUE(folder.read("c.tables/tables.xlsx") == first) << "equal files give equal bytes";
}

// R-1003: of every version of the format, and of a program that knew more.
TEST_F(Export, OldFilesToo) {
    if (!has_python(folder, "h5py, openpyxl")) {
        GTEST_SKIP() << no_python;
    }
    for (auto const* name : {"results-3", "results-4", "results-5", "results-more"}) {
        unpack(name);
        expect_exported_as_stored();
    }
}

TEST_F(Export, OneKindAloneAndIntoAFolder) {
    unpack("results-5");
    ASSERT_EQ(overturn(folder, {"export", "c.h5", "--as", "csv", "-o", "a/b"}).code, 0);
    EXPECT_EQ(files_in("a/b"), 6U);
    EXPECT_TRUE(folder.read("a/b/trials.csv").starts_with("trial,wave,body,level,amplitude [m/s2],amplitude [gal],"));
    EXPECT_EQ(overturn(folder, {"export", "c.h5", "--as", "xlsx", "-o", "book"}).code, 0);
    EXPECT_EQ(files_in("book"), 1U);
    EXPECT_FALSE(folder.has("c.tables"));
}

// R-1105: what cannot be written, or would be lost, is said before anything is written.
TEST_F(Export, RefusesWhatItCannotDo) {
    unpack("results-5");
    folder.write("taken", "");
    expect_refused({"c.h5", "-o", "taken"}, "taken (is no folder and cannot be one");
    expect_refused({"c.h5", "-o", ""}, "-o ''");
    expect_refused({"c.h5", "-o", "/proc/1/nowhere"}, "/proc/1/nowhere (is no folder");
    expect_refused({"c.h5", "--as", "ods"}, "--as 'ods' (unknown)");
    expect_refused({"none.h5"}, "none.h5: no such file");
    expect_refused({"taken"}, "taken");
    EXPECT_FALSE(folder.has("c.tables"));

    ASSERT_EQ(overturn(folder, {"export", "c.h5", "--as", "csv"}).code, 0);
    folder.write("c.tables/curves.csv", "mine");
    expect_refused({"c.h5"}, "c.tables/trials.csv: exists already (it would be lost)");
    EXPECT_EQ(folder.read("c.tables/curves.csv"), "mine");
    EXPECT_FALSE(folder.has("c.tables/tables.xlsx"));
    std::filesystem::create_directories(folder / "other" / "tables.xlsx");
    expect_refused({"c.h5", "-o", "other", "--force"}, "other/tables.xlsx: a folder");
    EXPECT_EQ(files_in("other"), 1U) << "refused before anything is written";
}

// R-1105: tables of two results files are never left in one folder, forced or not; of one file kind may follow kind.
TEST_F(Export, OfTwoFilesDoNotMix) {
    unpack("results-5");
    std::filesystem::rename(folder / "c.h5", folder / "first.h5");
    unpack("results-4");
    ASSERT_EQ(overturn(folder, {"export", "first.h5", "-o", "t", "--as", "csv"}).code, 0);
    auto const about = folder.read("t/about.csv");
    expect_refused({"c.h5", "-o", "t"}, "t/trials.csv: ");
    for (auto const* force : {"", "--force"}) {
        std::vector<std::string> words{"c.h5", "-o", "t", "--as", "xlsx"};
        if (*force != 0) {
            words.emplace_back(force);
        }
        expect_refused(words, "t/trials.csv: stays beside these tables (and may be of other results)");
    }
    EXPECT_EQ(files_in("t"), 6U);
    EXPECT_TRUE(folder.read("t/about.csv") == about);
    EXPECT_EQ(overturn(folder, {"export", "first.h5", "-o", "t", "--as", "xlsx"}).code, 0) << "of the same file";
    expect_refused({"c.h5", "-o", "t", "--as", "csv", "--force"}, "t/tables.xlsx: stays beside these tables");
    EXPECT_EQ(overturn(folder, {"export", "c.h5", "-o", "t", "--force"}).code, 0) << "all of them take the new place";
    EXPECT_FALSE(folder.read("t/about.csv") == about);
}

TEST_F(Export, WhatIsNotWholeIsNotExported) {
    folder.write("target.csv", target_csv);
    folder.write("c.toml", small_campaign("shared", 2));
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "--part", "1/2"}).code, 0);
    expect_refused({"c.h5"}, "c.h5: not there yet");
    unpack("results-5");
    auto text = folder.read("c.h5");
    text[text.size() / 2] = static_cast<char>(text[text.size() / 2] ^ 1);
    folder.write("c.h5", text);
    expect_refused({"c.h5"}, "c.h5");
    EXPECT_FALSE(folder.has("c.tables"));
}

TEST_F(Export, AnEditedFileIsExportedWhenAsked) {
    if (!has_python(folder, "h5py, openpyxl")) {
        GTEST_SKIP() << no_python;
    }
    unpack("results-5");
    ASSERT_EQ(edit_results(folder, "c.h5", "f['trials/scale'][0] = float('inf')").code, 0);
    expect_refused({"c.h5"}, "c.h5");
    auto const ended = overturn(folder, {"export", "c.h5", "--unverified"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.err.find("NOT as it was written"), std::string::npos) << ended.err;
    EXPECT_NE(folder.read("c.tables/trials.csv").find(",inf,"), std::string::npos);
    ASSERT_EQ(edit_results(folder, "c.h5", "f.attrs['complete'] = 0").code, 0);
    expect_refused({"c.h5", "--unverified", "--force"}, "not complete");
}

// R-1105: a disk that is full leaves no file that looks whole, and keeps the one that was there.
TEST_F(Export, AFullDiskLeavesNothingHalf) {
    unpack("results-5");
    for (auto const* kind : {"csv", "xlsx"}) {
        auto const command =
            fmt::format("trap '' XFSZ; ulimit -f 1; exec {} export c.h5 --as {}", OVERTURN_PROGRAM, kind);
        auto const ended = execute(folder, {"/bin/sh", "-c", command});
        EXPECT_EQ(ended.code, 1) << ended.err;
        auto const ours = ended.err.find("overturn: cannot write c.tables/");  // libxlsxwriter has its say before
        ASSERT_NE(ours, std::string::npos) << ended.err;
        EXPECT_TRUE(is_one_error_line(ended.err.substr(ours)));
        EXPECT_EQ(files_in("c.tables"), 0U) << kind;
    }
}

}  // namespace
}  // namespace overturn::testing
