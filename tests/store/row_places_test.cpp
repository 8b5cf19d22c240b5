// Requirement R-1001, R-1004: a results file whose rows several processes write, in any order, has the bytes of one
// that one process wrote; what is hashed in stretches is guarded to the last bit, and older digests are still
// understood.
#include "store/row_places.hpp"

#include <algorithm>
#include <fstream>
#include <random>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "store/detail/h5.hpp"
#include "store/detail/objects.hpp"
#include "store/results_file.hpp"
#include "store/seal.hpp"
#include "store/sha256.hpp"
#include "support/expect_input_error.hpp"
#include "support/expect_system_error.hpp"
#include "support/temporary_folder.hpp"

namespace overturn::store {
namespace {

using testing::expect_input_error;
using testing::expect_system_error;
using testing::slurp;
using testing::spill;
using testing::TemporaryFolder;

struct Row {
    double amplitude;
    std::int64_t wave;
    std::int64_t verdict;
};

constexpr std::int64_t row_count = 1'200'000;  // 9.6 MB a column of numbers: three stretches; 1.2 MB of verdicts: none
constexpr std::int64_t wave_count = 1000;

TableSpec table_of(std::string group) {
    return {.group = std::move(group),
            .row_bytes = sizeof(Row),
            .columns = {{.name = "amplitude", .units = "m/s2", .description = "a", .offset = offsetof(Row, amplitude)},
                        {.name = "wave",
                         .units = "1",
                         .description = "w",
                         .type = FieldType::integer,
                         .offset = offsetof(Row, wave)},
                        {.name = "verdict",
                         .units = "1",
                         .description = "v",
                         .type = FieldType::category,
                         .offset = offsetof(Row, verdict),
                         .categories = numbered({"at-rest", "slid", "rocked"})}},
            .axis = "number",
            .axis_description = "n"};
}

std::vector<Row> rows_from(std::int64_t first, std::int64_t count) {
    std::vector<Row> rows;
    for (std::int64_t i = first; i < first + count; ++i) {
        rows.push_back({0.1 * static_cast<double>(i), (std::int64_t{1} << 60) + i, i % 3});
    }
    return rows;
}

std::span<std::byte const> bytes_of(std::vector<Row> const& rows) { return std::as_bytes(std::span(rows)); }

void begin(ResultsWriter& writer) {
    writer.attribute("format", std::string(format_name));
    writer.attribute("format_version", format_version);
    writer.attribute("campaign", std::string(3000, 'c'));
    writer.bytes("inputs", "0000", "an input file", std::string(500, 'i'));
    (void)writer.table(table_of("waves"), wave_count);
    (void)writer.table(table_of("trials"), row_count);
    (void)writer.table(table_of("nothing"), 0);
}

// What a file has beside its rows: its places must not depend on who wrote those.
void end(ResultsWriter& writer, HashStretches const& hash = hash_stretches) {
    for (int i = 0; i < 40; ++i) {
        writer.array(fmt::format("stripes/{}", i), {.name = "failed", .units = "1", .description = "no verdict"},
                     std::vector<std::int64_t>{i});
    }
    writer.attribute("stripes/7", "index", std::int64_t{7});
    writer.bytes("inputs", "0001", "another", std::string(700, 'a'));
    writer.attribute("complete", std::int64_t{1});
    writer.finish(hash);
}

void write_alone(std::filesystem::path const& path) {
    ResultsWriter writer(path);
    begin(writer);
    writer.append(0, bytes_of(rows_from(0, wave_count)));
    constexpr std::int64_t few = 100;  // HDF5 would hold so few back
    writer.append(1, bytes_of(rows_from(0, row_count - few)));
    writer.append(1, bytes_of(rows_from(row_count - few, few)));
    end(writer);
}

TEST(PlacedRows, GiveTheBytesOfRowsThatOneWriterAppends) {
    TemporaryFolder const folder;
    write_alone(folder / "alone.h5");

    ResultsWriter writer(folder / "together.h5");
    begin(writer);
    auto const places = RowPlaces::deserialise(writer.give_places().serialise());
    PlacedRows one(places), other(places);
    constexpr std::int64_t part = 7000;  // no divisor of anything
    for (std::int64_t first = 0; first < row_count; first += part) {
        auto& writes = first / part % 3 == 0 ? other : one;
        auto const from = row_count - std::min(first + part, row_count);  // from the end
        writes.write(1, from, bytes_of(rows_from(from, row_count - first - from)));
    }
    other.write(0, 0, bytes_of(rows_from(0, 600)));
    one.write(0, 600, bytes_of(rows_from(600, wave_count - 600)));
    one.finish();
    other.finish();
    std::size_t hashed = 0;
    end(writer, [&](std::filesystem::path const& path, Stretches const& stretches) {
        hashed += stretches.size();
        return hash_stretches(path, stretches);
    });

    EXPECT_EQ(hashed, 3U * 3 + 1) << "two columns and their axis in three stretches each, and the file";
    EXPECT_TRUE(slurp(folder / "together.h5") == slurp(folder / "alone.h5"));
    ResultsReader const reader(folder / "together.h5");
    EXPECT_EQ(reader.real_at("trials/amplitude", row_count - 1), 0.1 * (row_count - 1));
    EXPECT_EQ(reader.integer_at("trials/verdict", 700'001), 700'001 % 3);
    EXPECT_EQ(reader.integer_at("trials/number", 700'001), 700'001);
}

TEST(PlacedRows, NameTheFileThatTheyCannotWrite) {
    TemporaryFolder const folder;
    expect_system_error([&] { PlacedRows const rows({folder / "gone.h5", {}}); }, "cannot write", "gone.h5");
}

// Stretches of 64 MiB of the file, of which two lie among the columns and what is between these. Nobody writes rows:
// they are holes of the file.
class ReadBack : public ::testing::Test {
  protected:
    // \param hash as ResultsWriter::finish takes it
    void write(HashStretches const& hash) const {
        ResultsWriter writer(path);
        writer.attribute("format", std::string(format_name));
        writer.attribute("format_version", format_version);
        (void)writer.table(table_of("trials"), 9'000'000);  // 72 MB a column of numbers
        (void)writer.table(table_of("waves"), wave_count);  // what is made later lies behind these
        (void)writer.give_places();
        writer.finish(hash);
    }
    static bool is_of_the_file(Stretch const& stretch) {
        return stretch.at % file_stretch == 0 && stretch.bytes > column_stretch;
    }

    TemporaryFolder folder;
    std::filesystem::path path = folder / "out.h5";
};

TEST_F(ReadBack, IsOnePassWhereTheFileHasOnlyColumns) {
    std::vector<Stretches> asked;
    write([&](std::filesystem::path const& file, Stretches const& stretches) {
        asked.push_back(stretches);
        return hash_stretches(file, stretches);
    });
    ASSERT_EQ(asked.size(), 2U);
    std::erase_if(asked[0], [](Stretch const& stretch) { return !is_of_the_file(stretch); });
    EXPECT_EQ(asked[0], (Stretches{{file_stretch, file_stretch}, {2 * file_stretch, file_stretch}}));
    auto const rest = std::filesystem::file_size(path) - 3 * file_stretch;
    ASSERT_EQ(asked[1].size(), 2U);
    EXPECT_EQ(*asked[1].begin(), (Stretch{0, file_stretch}));
    EXPECT_EQ(asked[1].rbegin()->at, 3 * file_stretch);
    EXPECT_LT(asked[1].rbegin()->bytes, rest) << "all but the seal";
    EXPECT_EQ(seal_of(path), Seal::intact);
    EXPECT_TRUE(ResultsReader(path).is_sealed());
}

// What HDF5 keeps between columns was other when it was read back: so was the digest of the stretch around it.
TEST_F(ReadBack, NoticesWhatChangedSince) {
    std::size_t passes = 0, changed = 0;
    write([&](std::filesystem::path const& file, Stretches const& stretches) {
        auto digests = hash_stretches(file, stretches);
        if (passes++ > 0) {
            EXPECT_EQ(stretches.size(), 3U) << "the first, the last, and one anew";
            return digests;
        }
        for (auto& [stretch, digest] : digests) {
            if (constexpr std::uint64_t short_part = 10'000; stretch.bytes < short_part && stretch.at > file_stretch) {
                digest = sha256("other");
                digests.at({stretch.at / file_stretch * file_stretch, file_stretch}) = sha256("other");
                ++changed;
            }
        }
        return digests;
    });
    EXPECT_EQ(changed, 1U);
    EXPECT_EQ(seal_of(path), Seal::intact);
}

TEST(Stretches, CoverEveryByteOnce) {
    EXPECT_EQ(stretches_of(100, 25, 10), (Stretches{{100, 10}, {110, 10}, {120, 5}}));
    EXPECT_EQ(stretches_of(100, 20, 10), (Stretches{{100, 10}, {110, 10}}));
    EXPECT_TRUE(stretches_of(7, 0, 10).empty());
}

TEST(Stretches, AreWhatIsOutsideOfOthers) {
    EXPECT_EQ(outside({100, 50}, {}), (Stretches{{100, 50}}));
    EXPECT_EQ(outside({100, 50}, {{0, 50}, {60, 45}, {110, 5}, {115, 5}, {130, 1}, {140, 20}, {170, 9}}),
              (Stretches{{105, 5}, {120, 10}, {131, 9}}));
    EXPECT_EQ(outside({100, 50}, {{0, 100}, {110, 30}, {150, 10}}), (Stretches{{100, 10}, {140, 10}}));
    EXPECT_EQ(outside({100, 50}, {{160, 10}}), (Stretches{{100, 50}}));
    EXPECT_TRUE(outside({100, 50}, {{90, 70}}).empty());
    EXPECT_TRUE(outside({100, 50}, {{100, 50}}).empty());
}

// FIPS 180-4's digest of "abc", from the middle of a file.
TEST(Stretches, HaveTheDigestOfTheirBytes) {
    TemporaryFolder const folder;
    spill(folder / "file", "xxabcyy");
    auto const digests = hash_stretches(folder / "file", {{2, 3}, {0, 7}, {4, 0}});
    EXPECT_EQ(digests.at({2, 3}), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(digests.at({0, 7}), sha256("xxabcyy"));
    EXPECT_EQ(digests.at({4, 0}), sha256(""));
    EXPECT_TRUE(hash_stretches(folder / "file", {}).empty());
    EXPECT_TRUE(hash_stretches(folder / "gone", {}).empty()) << "nothing to read";
    expect_system_error([&] { (void)hash_stretches(folder / "file", {{5, 3}}); }, "cannot read", "file");
    expect_system_error([&] { (void)hash_stretches(folder / "file", {{0, 3}, {2, 6}}); }, "cannot read");
    expect_system_error([&] { (void)hash_stretches(folder / "gone", {{0, 1}}); }, "cannot read", "gone");
}

// Bytes that this process has asked the kernel for.
std::uint64_t bytes_read() {
    std::ifstream file("/proc/self/io");
    std::string name;
    std::uint64_t bytes = 0;
    file >> name >> bytes;
    EXPECT_EQ(name, "rchar:");
    return bytes;
}

TEST(Stretches, OverlapAndAreReadOnce) {
    TemporaryFolder const folder;
    constexpr std::size_t size = 5'000'000;
    std::mt19937_64 random(2013);
    std::string content(size, '\0');
    std::ranges::generate(content, [&] { return static_cast<char>(random()); });
    spill(folder / "file", content);
    Stretches some{{0, size}, {0, size / 2}, {size / 2, size - size / 2}, {size / 2, 3}, {size - 5, 5}};
    for (int i = 0; i < 60; ++i) {
        auto const at = random() % size;
        some.insert({at, random() % (size - at)});
    }
    auto const before = bytes_read();
    auto const digests = hash_stretches(folder / "file", some);
    auto const read = bytes_read() - before;
    EXPECT_GE(read, size);
    EXPECT_LT(read, size + 2 * some.size() * 8192) << "at each end up to what a stream reads ahead";
    ASSERT_EQ(digests.size(), some.size());
    for (auto const& [stretch, digest] : digests) {
        EXPECT_EQ(digest, sha256(std::string_view(content).substr(stretch.at, stretch.bytes))) << stretch.at;
    }
}

TEST(LongSeal, IsOfTheDigestsOfItsStretches) {
    TemporaryFolder const folder;
    auto const path = folder / "long";
    std::string content(file_stretch + 1000, '\0');
    for (std::size_t i = 0; i < content.size(); i += 997) {
        content[i] = static_cast<char>(i / 997);
    }
    spill(path, content);
    seal(path);
    EXPECT_EQ(seal_of(path), Seal::intact);
    EXPECT_EQ(sealed_digest(path),
              sha256(sha256(content.substr(0, file_stretch)) + sha256(content.substr(file_stretch))));

    auto const whole = slurp(path);
    for (std::size_t const at : {std::size_t{5}, static_cast<std::size_t>(file_stretch) + 7, whole.size() - 3,
                                 whole.size() - 30, whole.size() - 100, whole.size() - 125}) {
        auto changed = whole;
        changed[at] = static_cast<char>(changed[at] ^ 1);
        spill(path, changed);
        EXPECT_EQ(seal_of(path), Seal::broken) << at;
    }
    spill(path, content + fmt::format("\noverturn-seal sha256 {} of {:020} bytes\n", sha256(content), content.size()));
    EXPECT_EQ(seal_of(path), Seal::intact) << "as long files were sealed before";
}

class LongColumns : public ::testing::Test {
  protected:
    LongColumns() { write_alone(path); }
    template <class Edit> void edited(Edit&& edit) const {
        {
            File const file(checked(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), "open"));
            edit(file);
        }
        seal(path);
    }

    TemporaryFolder folder;
    std::filesystem::path path = folder / "out.h5";
};

TEST_F(LongColumns, AreGuardedInEveryStretch) {
    for (std::int64_t const row : {std::int64_t{0}, std::int64_t{524'288}, row_count - 1}) {
        write_alone(path);
        edited([&](File const& file) {
            Dataset const column(checked(H5Dopen2(file.id(), "trials/amplitude", H5P_DEFAULT), "open"));
            Dataspace const space(checked(H5Dget_space(column.id()), "space"));
            hsize_t const first = row;
            hsize_t const one = 1;
            checked(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, &first, nullptr, &one, nullptr), "select");
            Dataspace const memory(checked(H5Screate_simple(1, &one, nullptr), "space"));
            double const value = -1;
            checked(H5Dwrite(column.id(), H5T_NATIVE_DOUBLE, memory.id(), space.id(), H5P_DEFAULT, &value), "write");
        });
        expect_input_error([&] { ResultsReader const reader(path); }, "/trials/amplitude changed");
    }
}

// As files were written before columns were hashed in stretches.
TEST_F(LongColumns, HashedWholeAreStillRead) {
    edited([](File const& file) {
        auto const text = text_of(digests_of(file, ContentHash::whole));
        EXPECT_NE(text, text_of(digests_of(file, ContentHash::stretches)));
        checked(H5Adelete(file.id(), digest_of_all), "delete");
        checked(H5Ldelete(file.id(), "digests/objects", H5P_DEFAULT), "delete");
        write_attribute(file.id(), digest_of_all, sha256(text));
        hsize_t const size = text.size();
        Dataspace const space(checked(H5Screate_simple(1, &size, nullptr), "space"));
        Dataset const list(checked(
            H5Dcreate2(file.id(), "digests/objects", H5T_STD_U8LE, space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
            "create"));
        checked(H5Dwrite(list.id(), H5T_NATIVE_UINT8, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), "write");
    });
    EXPECT_TRUE(ResultsReader(path).is_sealed());
}

}  // namespace
}  // namespace overturn::store
