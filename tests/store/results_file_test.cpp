// Requirement R-1003: the results file holds what was put in, explains itself, and is the same bytes for the same
// content.
#include "store/results_file.hpp"

#include <chrono>
#include <thread>

#include <hdf5_hl.h>

#include "store/detail/h5.hpp"
#include "support/expect_input_error.hpp"
#include "support/expect_system_error.hpp"
#include "support/full_disk.hpp"
#include "support/temporary_folder.hpp"

namespace overturn::store {
namespace {

using testing::expect_input_error;
using testing::expect_system_error;
using testing::FullDisk;
using testing::slurp;
using testing::spill;
using testing::TemporaryFolder;

struct Row {
    double amplitude;
    std::int64_t wave;
    std::int64_t verdict;
};

TableSpec trials() {
    return {.group = "trials",
            .row_bytes = sizeof(Row),
            .columns = {{.name = "amplitude",
                         .units = "m/s2",
                         .description = "what the wave is scaled to",
                         .offset = offsetof(Row, amplitude)},
                        {.name = "wave",
                         .units = "1",
                         .description = "the wave's number",
                         .type = FieldType::integer,
                         .offset = offsetof(Row, wave)},
                        {.name = "verdict",
                         .units = "1",
                         .description = "how it ended",
                         .type = FieldType::category,
                         .offset = offsetof(Row, verdict),
                         .categories = numbered({"at-rest", "slid", "rocked"})}}};
}

std::vector<Row> some_rows(std::size_t count) {
    std::vector<Row> rows;
    for (std::size_t i = 0; i < count; ++i) {
        auto const number = static_cast<std::int64_t>(i);
        rows.push_back({0.1 * static_cast<double>(i), (std::int64_t{1} << 60) + number, number % 3});
    }
    return rows;
}

std::span<std::byte const> bytes_of(std::span<Row const> rows) { return std::as_bytes(rows); }

constexpr std::size_t row_count = 1000;

Field const amplitude_axis{.name = "amplitude", .units = "m/s2", .description = "of the stripe"};
Field const probability{.name = "probability", .units = "1", .description = "overturned over decided"};

/// A file with everything in it, its rows appended in parts of `part` rows.
void write_example(std::filesystem::path const& path, std::size_t part = row_count) {
    ResultsWriter writer(path);
    writer.attribute("format", std::string(format_name));
    writer.attribute("format_version", format_version);
    writer.attribute("campaign", "title = \"Überschlag\"\n");
    writer.attribute("nothing", "");
    auto const rows = some_rows(row_count);
    auto const table = writer.table(trials(), row_count);
    auto const empty =
        writer.table({.group = "waves/type-a", .row_bytes = sizeof(Row), .columns = trials().columns}, 0);
    for (std::size_t at = 0; at < row_count; at += part) {
        writer.append(table, bytes_of(std::span(rows).subspan(at, std::min(part, row_count - at))));
    }
    writer.append(empty, {});
    writer.array("stripes/type-a", amplitude_axis, std::vector{2.0, 4.0});
    writer.array("stripes/type-a", probability, std::vector{0.25, 0.5}, "amplitude");
    writer.array("stripes/type-a", {.name = "failed", .units = "1", .description = "no verdict"},
                 std::vector<std::int64_t>{0, 1}, "amplitude");
    writer.attribute("stripes/type-a", "confidence", 0.95);
    writer.attribute("stripes/type-a", "measure", "pga");
    writer.bytes("inputs", "wave.csv", "an input file", std::string("0,1\0\r\n", 6));
    writer.bytes("inputs", "empty.csv", "an input file", "");
    writer.finish();
}

class Results : public ::testing::Test {
  protected:
    std::filesystem::path const path() const { return folder / "out.h5"; }
    TemporaryFolder folder;
};

TEST_F(Results, HoldWhatWasPutIn) {
    write_example(path());
    ResultsReader const reader(path());
    auto const rows = some_rows(row_count);

    auto const amplitudes = reader.reals("trials/amplitude");
    auto const waves = reader.integers("trials/wave");
    auto const verdicts = reader.integers("trials/verdict");
    ASSERT_EQ(amplitudes.size(), row_count);
    ASSERT_EQ(waves.size(), row_count);
    ASSERT_EQ(verdicts.size(), row_count);
    for (std::size_t i = 0; i < row_count; ++i) {
        EXPECT_EQ(amplitudes[i], rows[i].amplitude);
        EXPECT_EQ(waves[i], rows[i].wave);
        EXPECT_EQ(verdicts[i], rows[i].verdict);
    }
    EXPECT_EQ(reader.real_at("trials/amplitude", 999), rows[999].amplitude);
    EXPECT_EQ(reader.integer_at("trials/wave", 0), rows[0].wave);
    EXPECT_EQ(reader.integer_at("trials/verdict", 998), rows[998].verdict);
    EXPECT_TRUE(reader.reals("waves/type-a/amplitude").empty());
    EXPECT_EQ(reader.integers("stripes/type-a/failed"), (std::vector<std::int64_t>{0, 1}));
}

bool is_axis_of(hid_t file, char const* axis, char const* column) {
    Dataset const scale(checked(H5Dopen2(file, axis, H5P_DEFAULT), "open"));
    Dataset const along(checked(H5Dopen2(file, column, H5P_DEFAULT), "open"));
    return H5DSis_scale(scale.id()) > 0 && H5DSis_attached(along.id(), scale.id(), 0) > 0;
}

// netCDF reads an enumeration only where it is committed, and h5netcdf a column only where it has an axis.
TEST_F(Results, GiveEveryColumnAnAxisAndEveryEnumerationAName) {
    auto with_axis = trials();
    with_axis.axis = "trial";
    auto of_body = trials();
    of_body.group = "trials/contact";
    of_body.axis = "trials/trial";
    of_body.columns.back().categories = numbered({"yes", "no", "unknown"});
    auto by_column = trials();
    by_column.group = "by-column";
    by_column.axis = "amplitude";
    {
        ResultsWriter writer(path());
        auto const rows = some_rows(row_count);
        for (auto const& spec : {with_axis, of_body, by_column}) {
            writer.append(writer.table(spec, row_count), bytes_of(rows));
        }
        writer.array("alone", amplitude_axis, std::vector{2.0, 4.0, 6.0});
        writer.finish();
    }
    File const file(checked(H5Fopen(path().c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), "open"));

    for (char const* column : {"trials/amplitude", "trials/verdict", "trials/contact/wave"}) {
        EXPECT_TRUE(is_axis_of(file.id(), "trials/trial", column)) << column;
    }
    EXPECT_TRUE(is_axis_of(file.id(), "by-column/amplitude", "by-column/verdict"));
    EXPECT_FALSE(is_axis_of(file.id(), "by-column/amplitude", "trials/wave"));
    Dataset const alone(checked(H5Dopen2(file.id(), "alone/amplitude", H5P_DEFAULT), "open"));
    EXPECT_GT(H5DSis_scale(alone.id()), 0);
    auto const type_of = [&](char const* name) {
        Dataset const dataset(checked(H5Dopen2(file.id(), name, H5P_DEFAULT), "open"));
        return Datatype(checked(H5Dget_type(dataset.id()), "read a type"));
    };
    auto const committed = [&](char const* name) {
        return Datatype(checked(H5Topen2(file.id(), name, H5P_DEFAULT), "open"));
    };
    auto const verdicts = committed("verdict_type");
    EXPECT_GT(H5Tcommitted(type_of("trials/verdict").id()), 0);
    EXPECT_GT(H5Tequal(type_of("trials/verdict").id(), verdicts.id()), 0);
    EXPECT_GT(H5Tequal(type_of("by-column/verdict").id(), verdicts.id()), 0);
    EXPECT_GT(H5Tequal(type_of("trials/contact/verdict").id(), committed("verdict_type_2").id()), 0);
    EXPECT_LT(H5Lexists(file.id(), "verdict_type_3", H5P_DEFAULT), 1);
}

TEST_F(Results, KeepTextsAndInputFilesByteForByte) {
    write_example(path());
    ResultsReader const reader(path());

    EXPECT_EQ(reader.text("campaign"), "title = \"Überschlag\"\n");
    EXPECT_EQ(reader.text("nothing"), "");
    EXPECT_EQ(reader.integer("format_version"), format_version);
    EXPECT_EQ(reader.text_attribute("stripes/type-a", "measure"), "pga");
    EXPECT_EQ(reader.content("inputs/wave.csv"), std::string("0,1\0\r\n", 6));
    EXPECT_EQ(reader.content("inputs/empty.csv"), "");
}

TEST_F(Results, KeepACampaignOfAnyLength) {
    std::string const campaign(300000, '#');  // HDF5 keeps at most 64 KiB in an object header
    {
        ResultsWriter writer(path());
        writer.attribute("format", std::string(format_name));
        writer.attribute("format_version", format_version);
        writer.attribute("campaign", campaign);
        writer.finish();
    }
    EXPECT_EQ(ResultsReader(path()).text("campaign"), campaign);
}

TEST_F(Results, EveryColumnStatesUnitsAndMeaning) {
    write_example(path());
    ResultsReader const reader(path());

    for (auto const& column : trials().columns) {
        EXPECT_EQ(reader.text_attribute("trials/" + column.name, "units"), column.units);
        EXPECT_EQ(reader.text_attribute("trials/" + column.name, "description"), column.description);
    }
    EXPECT_EQ(reader.text_attribute("stripes/type-a/failed", "units"), "1");
    EXPECT_EQ(reader.text_attribute("inputs/wave.csv", "description"), "an input file");
}

TEST_F(Results, ListTheirMembers) {
    write_example(path());
    ResultsReader const reader(path());

    EXPECT_EQ(reader.members("stripes"), (std::vector<std::string>{"type-a"}));
    EXPECT_EQ(reader.members("trials"), (std::vector<std::string>{"amplitude", "verdict", "wave"}));
    EXPECT_TRUE(reader.members("no/such/group").empty());
    EXPECT_TRUE(reader.has("waves/type-a/verdict"));
    EXPECT_FALSE(reader.has("waves/type-b/verdict"));
    expect_input_error([&] { (void)reader.reals("has no trials/nothing"); }, "trials/nothing");
    expect_system_error([&] { (void)reader.real_at("trials/amplitude", row_count); }, "trials/amplitude");
}

TEST_F(Results, CategoriesAreNamedInTheFile) {
    write_example(path());
    File const file(H5Fopen(path().c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
    Dataset const dataset(H5Dopen2(file.id(), "trials/verdict", H5P_DEFAULT));
    Datatype const type(H5Dget_type(dataset.id()));

    ASSERT_EQ(H5Tget_class(type.id()), H5T_ENUM);
    ASSERT_EQ(H5Tget_nmembers(type.id()), 3);
    EXPECT_EQ(H5Tget_size(type.id()), 1U);
    char const* const names[] = {"at-rest", "slid", "rocked"};
    for (unsigned i = 0; i < 3; ++i) {
        char* const name = H5Tget_member_name(type.id(), i);
        EXPECT_STREQ(name, names[i]);
        H5free_memory(name);
    }
}

TEST_F(Results, AmplitudeIsTheAxisOfItsStripes) {
    write_example(path());
    File const file(H5Fopen(path().c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
    Dataset const axis(H5Dopen2(file.id(), "stripes/type-a/amplitude", H5P_DEFAULT));

    EXPECT_GT(H5DSis_scale(axis.id()), 0);
    for (char const* const name : {"stripes/type-a/probability", "stripes/type-a/failed"}) {
        Dataset const dataset(H5Dopen2(file.id(), name, H5P_DEFAULT));
        EXPECT_GT(H5DSis_attached(dataset.id(), axis.id(), 0), 0) << name;
    }
}

// R-1001.
TEST_F(Results, SameContentIsTheSameBytes) {
    write_example(path());
    write_example(folder / "again.h5");
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // HDF5 stamps whole seconds, where it does
    write_example(folder / "later.h5");

    EXPECT_TRUE(slurp(path()) == slurp(folder / "again.h5"));
    EXPECT_TRUE(slurp(path()) == slurp(folder / "later.h5"));
}

// R-1001.
TEST_F(Results, PartsOfAnySizeGiveTheSameBytes) {
    write_example(path());
    for (std::size_t const part : {1, 7, 500, 999}) {
        write_example(folder / "parts.h5", part);

        EXPECT_TRUE(slurp(path()) == slurp(folder / "parts.h5")) << part;
    }
}

// Long columns in chunks, of which the last is not full.
void write_long_one(std::filesystem::path const& path, Layout layout, std::size_t part) {
    ResultsWriter writer(path, layout);
    writer.attribute("format", std::string(format_name));
    writer.attribute("format_version", format_version);
    auto const rows = some_rows(40'000);
    auto spec = trials();
    spec.axis = "trial";
    auto const table = writer.table(spec, std::ssize(rows));
    for (std::size_t at = 0; at < rows.size(); at += part) {
        writer.append(table, bytes_of(std::span(rows).subspan(at, std::min(part, rows.size() - at))));
    }
    writer.array("stripes/type-a", amplitude_axis, std::vector{2.0, 4.0});
    writer.finish();
}

// A packed file is smaller, has the same content with the same digest, and the same bytes however its rows came.
TEST_F(Results, PackedTheContentIsTheSame) {
    write_long_one(folder / "plain.h5", Layout::plain, 40'000);
    write_long_one(path(), Layout::packed, 40'000);
    for (std::size_t const part : {999, 16'384, 39'999}) {
        write_long_one(folder / "parts.h5", Layout::packed, part);
        EXPECT_TRUE(slurp(path()) == slurp(folder / "parts.h5")) << part;
    }

    ResultsReader const plain(folder / "plain.h5");
    ResultsReader const packed(path());
    EXPECT_LT(std::filesystem::file_size(path()), std::filesystem::file_size(folder / "plain.h5") / 3);
    EXPECT_EQ(packed.text("content_sha256"), plain.text("content_sha256"));
    EXPECT_EQ(packed.reals("trials/amplitude"), plain.reals("trials/amplitude"));
    EXPECT_EQ(packed.integers("trials/verdict"), plain.integers("trials/verdict"));
    EXPECT_EQ(packed.integers("trials/trial"), plain.integers("trials/trial"));
    std::vector<Row> across(20);
    packed.rows(trials(), 40'000, 16'380, std::as_writable_bytes(std::span(across)));
    auto const written = some_rows(40'000);
    for (std::size_t i = 0; i < across.size(); ++i) {
        EXPECT_EQ(across[i].amplitude, written[16'380 + i].amplitude);
        EXPECT_EQ(across[i].verdict, written[16'380 + i].verdict);
    }
}

// R-1105.
TEST_F(Results, PackedOnAFullDiskIsReportedAndNothingIsLeft) {
    write_long_one(folder / "whole.h5", Layout::packed, 1000);
    auto const whole = std::filesystem::file_size(folder / "whole.h5");
    std::filesystem::remove(folder / "whole.h5");
    constexpr std::size_t steps = 8;
    for (std::size_t i = 0; i < steps; ++i) {
        {
            FullDisk const disk(whole * i / steps);
            expect_system_error([&] { write_long_one(path(), Layout::packed, 1000); }, "HDF5: cannot",
                                "File too large");
        }
        EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << whole * i / steps;
    }
}

TEST_F(Results, UnfinishedFileNeverBearsTheName) {
    spill(path(), "an earlier result");
    {
        ResultsWriter writer(path());
        writer.attribute("format", std::string(format_name));
        (void)writer.table(trials(), 10);

        EXPECT_EQ(slurp(path()), "an earlier result");
    }
    EXPECT_EQ(slurp(path()), "an earlier result");
    EXPECT_FALSE(std::filesystem::exists(folder / "out.h5.merging"));
}

TEST_F(Results, MissingRowsAreOurMistake) {
    ResultsWriter writer(path());
    auto const table = writer.table(trials(), 10);
    writer.append(table, bytes_of(some_rows(9)));

    EXPECT_THROW(writer.finish(), ContractError);
    EXPECT_FALSE(std::filesystem::exists(path()));
#if OVERTURN_CHECKED
    EXPECT_THROW(writer.append(table, bytes_of(some_rows(2))), ContractError);
#endif
}

// R-1105.
TEST_F(Results, UnwritablePlaceIsNamed) {
    expect_system_error([&] { ResultsWriter const writer(folder / "nowhere" / "out.h5"); }, "nowhere/out.h5",
                        "No such file or directory");
}

// R-1105: Wherever in the file the disk runs full. (HDF5 itself crashes at exit over a file it could not write.)
TEST_F(Results, FullDiskIsReportedAndNothingIsLeft) {
    write_example(folder / "whole.h5");
    auto const whole = std::filesystem::file_size(folder / "whole.h5");
    std::filesystem::remove(folder / "whole.h5");
    constexpr std::size_t steps = 50;
    for (std::size_t i = 0; i < steps; ++i) {
        {
            FullDisk const disk(whole * i / steps);
            expect_system_error([&] { write_example(path()); }, "HDF5: cannot", "File too large");
        }
        EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << whole * i / steps;
    }
    write_example(path());  // the next attempt is not hurt by it
    EXPECT_EQ(ResultsReader(path()).reals("trials/amplitude").size(), row_count);
}

TEST_F(Results, ReaderRefusesWhatIsNoResultsFile) {
    expect_input_error([&] { (void)ResultsReader(path()); }, "out.h5", "no such file");
    expect_input_error([&] { (void)ResultsReader(folder.path()); }, "not an HDF5 file");

    spill(path(), "time,a_horizontal\n0,0\n");
    expect_input_error([&] { (void)ResultsReader(path()); }, "out.h5", "not an HDF5 file");

    write_example(path());
    auto const whole = slurp(path());
    spill(path(), whole.substr(0, whole.size() / 2));
    expect_input_error([&] { (void)ResultsReader(path()); }, "out.h5", "damaged");
}

struct Header {
    char const* format;
    std::int64_t version;
};

void write_header(std::filesystem::path const& path, Header const& header) {
    ResultsWriter writer(path);
    writer.attribute("format", std::string(header.format));
    writer.attribute("program_version", std::string("0.0.9"));
    writer.attribute("git_revision", std::string("abc"));
    if (header.version > 0) {
        writer.attribute("format_version", header.version);
    }
    writer.finish();
}

// Rows come back as they were written; a column of another length or kind, or with a value that has no name, is
// refused.
TEST_F(Results, RowsAreReadByTheTableThatWroteThem) {
    write_example(path());
    ResultsReader const reader(path());
    auto const table = trials();
    auto const written = some_rows(row_count);
    std::vector<Row> rows(10);
    auto const bytes = std::as_writable_bytes(std::span(rows));

    reader.rows(table, row_count, 7, bytes);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(rows[i].amplitude, written[7 + i].amplitude);
        EXPECT_EQ(rows[i].wave, written[7 + i].wave);
        EXPECT_EQ(rows[i].verdict, written[7 + i].verdict);
    }
    for (auto const length : {std::int64_t{row_count} - 1, std::int64_t{row_count} + 1}) {
        expect_input_error([&] { reader.rows(table, length, 0, bytes); }, "trials/amplitude has 1000 rows");
    }
    auto other = table;
    other.columns[1].type = FieldType::category;
    other.columns[1].categories = numbered({"one"});
    expect_input_error([&] { reader.rows(other, row_count, 0, bytes); }, "trials/wave holds no names");
}

// R-1003: A column that the file does not have is unknown, or the field's own default; one that no file is without is
// an error.
TEST_F(Results, AbsentColumnsAreUnknown) {
    write_example(path());
    ResultsReader const reader(path());
    std::vector<Row> rows(10);
    auto const bytes = std::as_writable_bytes(std::span(rows));
    auto later = trials();
    later.columns[0].name = "epsilon_7s";
    later.columns[1].name = "bounces";
    later.columns[1].absent = -3;

    reader.rows(later, row_count, 7, bytes);

    for (auto const& row : rows) {
        EXPECT_TRUE(std::isnan(row.amplitude));
        EXPECT_EQ(row.wave, -3);
    }
    EXPECT_EQ(rows[0].verdict, some_rows(row_count)[7].verdict);
    later.columns[0] = later.columns[0].always();
    expect_input_error([&] { reader.rows(later, row_count, 0, bytes); }, "has no trials/epsilon_7s",
                       "another program wrote it");
}

// R-1003: Names are what counts: a program that numbers them otherwise, or knows fewer, reads what is meant.
TEST_F(Results, CategoriesAreReadByName) {
    write_example(path());
    ResultsReader const reader(path());
    std::vector<Row> rows(row_count);
    auto const bytes = std::as_writable_bytes(std::span(rows));
    auto const written = some_rows(row_count);
    auto turned = trials();
    auto& names = turned.columns[2].categories;
    auto const before = names;
    for (auto& category : names) {
        category.value = 40 - category.value;
    }

    reader.rows(turned, row_count, 0, bytes);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(rows[i].verdict, 40 - written[i].verdict);
    }
    EXPECT_EQ(reader.named("trials/verdict", names)[3], 40 - written[3].verdict);
    names.pop_back();
    reader.rows(turned, row_count, 0, bytes);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(rows[i].verdict,
                  written[i].verdict == before.back().value ? unknown_category : 40 - written[i].verdict);
    }
    turned.columns[2] = turned.columns[2].always();
    expect_input_error([&] { reader.rows(turned, row_count, 0, bytes); }, "which this program does not know");
    EXPECT_EQ(reader.categories("trials/verdict").size(), before.size());
    EXPECT_TRUE(reader.categories("trials/wave").empty());
    EXPECT_TRUE(reader.categories("trials/none").empty());
}

TEST_F(Results, ReaderRefusesOtherFormats) {
    write_header(path(), {"somebody-elses-results", 1});
    expect_input_error([&] { (void)ResultsReader(path()); }, "not a results file", format_name);

    write_header(path(), {format_name, format_version + 1});
    expect_input_error([&] { (void)ResultsReader(path()); }, fmt::format("format version {}", format_version + 1),
                       "newer overturn");

    write_header(path(), {format_name, oldest_format_read - 1});
    expect_input_error([&] { (void)ResultsReader(path()); }, "format version 2",
                       fmt::format("reads 3 to {}", format_version), "overturn 0.0.9, revision abc");

    write_header(path(), {format_name, 1});
    expect_input_error([&] { (void)ResultsReader(path()); }, "format version 1", "Known of its version: impacts");

    write_header(path(), {format_name, 0});
    expect_input_error([&] { (void)ResultsReader(path()); }, "not a results file");

    { File const bare(H5Fcreate(path().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)); }
    expect_input_error([&] { (void)ResultsReader(path()); }, "not a results file");
    {
        File const file(H5Fcreate(path().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
        write_attribute(file.id(), "format", std::int64_t{1});
    }
    expect_input_error([&] { (void)ResultsReader(path()); }, "not a results file");
}

TEST(Hdf5, StatesItsVersion) { EXPECT_EQ(hdf5_version().rfind("1.", 0), 0U) << hdf5_version(); }

}  // namespace
}  // namespace overturn::store
