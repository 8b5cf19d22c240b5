// Requirement R-1004: a finished file proves itself: any flipped bit and any edit is noticed and named, and nothing
// outside the file is read through it.
#include "store/seal.hpp"

#include <random>

#include "store/detail/h5.hpp"
#include "store/results_file.hpp"
#include "store/sha256.hpp"
#include "support/expect_input_error.hpp"
#include "support/temporary_folder.hpp"

namespace overturn::store {
namespace {

using testing::expect_input_error;
using testing::slurp;
using testing::spill;
using testing::TemporaryFolder;

void write_example(std::filesystem::path const& path) {
    ResultsWriter writer(path);
    writer.attribute("format", std::string(format_name));
    writer.attribute("format_version", format_version);
    std::vector<double> values(500);
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = static_cast<double>(i) / 7;
    }
    writer.array("trials", {.name = "amplitude", .units = "m/s2", .description = "pga"}, values);
    writer.array("trials", {.name = "v_wes", .units = "m/s", .description = "energy"}, values, "amplitude");
    writer.array("stripes/a", {.name = "failed", .units = "1", .description = "no verdict"},
                 std::vector<std::int64_t>{0, 1});
    writer.bytes("inputs", "wave.csv", "an input file", "0,1\n");
    writer.finish();
}

class Seals : public ::testing::Test {
  protected:
    Seals() { write_example(path); }

    void refused(std::string const& why) const {
        expect_input_error([&] { ResultsReader const reader(path); }, path.string() + ": ", why);
    }
    // Opens the file for writing, as other programs do.
    template <class Edit> void edited(Edit&& edit) const {
        File const file(checked(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), "open"));
        edit(file.id());
    }

    TemporaryFolder folder;
    std::filesystem::path path = folder / "out.h5";
};

TEST_F(Seals, AreWholeOrBrokenOrNotThere) {
    auto const whole = slurp(path);
    EXPECT_EQ(seal_of(path), Seal::intact);
    EXPECT_TRUE(ResultsReader(path).is_sealed());

    for (std::size_t from_end = 1; from_end < 120; ++from_end) {  // the seal itself, and what is before it
        auto changed = whole;
        changed[changed.size() - from_end] = static_cast<char>(changed[changed.size() - from_end] ^ 1);
        spill(path, changed);
        EXPECT_EQ(seal_of(path), Seal::broken) << from_end;
    }
    spill(path, whole.substr(0, whole.size() - 1));
    EXPECT_NE(seal_of(path), Seal::intact);
    spill(path, whole + "\n");
    EXPECT_NE(seal_of(path), Seal::intact);
    spill(path, "");
    EXPECT_EQ(seal_of(path), Seal::missing);
    spill(path, std::string(5000, 'x'));
    EXPECT_EQ(seal_of(path), Seal::missing);
    seal(path);
    EXPECT_EQ(seal_of(path), Seal::intact);
}

/// Wherever in the file, in values, in what HDF5 keeps between them or in the seal.
TEST_F(Seals, EveryFlippedBitIsNoticed) {
    auto const whole = slurp(path);
    std::mt19937_64 random(2013);
    for (int i = 0; i < 300; ++i) {
        auto const bit = random() % (8 * whole.size());
        auto changed = whole;
        changed[bit / 8] = static_cast<char>(changed[bit / 8] ^ (1 << bit % 8));
        spill(path, changed);

        EXPECT_THROW(ResultsReader{path}, InputError) << "bit " << bit;
    }
    spill(path, whole);
    EXPECT_NO_THROW(ResultsReader{path});
}

TEST_F(Seals, WhatChangedIsNamed) {
    auto const whole = slurp(path);
    auto const at = whole.find(std::string("\0\0\0\0\0\0\xF0\x3F", 8));  // 7/7
    ASSERT_NE(at, std::string::npos);
    auto changed = whole;
    changed[at] = 1;
    spill(path, changed);
    refused("/trials/amplitude changed). Restore it");
    EXPECT_NE(ResultsReader(path, Trust::unverified).real_at("trials/amplitude", 7), 1);
    EXPECT_FALSE(ResultsReader(path, Trust::unverified).is_sealed());

    write_example(path);
    edited([](hid_t) {});
    refused("no value changed, but");

    edited([](hid_t file) { write_attribute(file, "note", "by hand"); });
    refused("(/ changed)");

    write_example(path);
    edited([](hid_t file) {
        checked(H5Ldelete(file, "trials/v_wes", H5P_DEFAULT), "delete");
        Dataset const stripes(checked(H5Dopen2(file, "stripes/a/failed", H5P_DEFAULT), "open"));
        write_attribute(stripes.id(), "note", "by hand");
        Group const added(checked(H5Gcreate2(file, "mine", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), "add"));
    });
    refused("(/stripes/a/failed changed, /trials/v_wes is gone, /mine is new)");

    write_example(path);
    edited([](hid_t file) { checked(H5Adelete(file, "content_sha256"), "delete"); });
    refused("cannot be read");
}

// Whoever writes a program knows how a file is sealed; so links out of it are refused for themselves.
class Crafted : public Seals {
  protected:
    void expect_refused(std::string const& why) const {
        seal(path);
        ASSERT_EQ(seal_of(path), Seal::intact);
        refused(why);
        expect_input_error([&] { ResultsReader const reader(path, Trust::unverified); }, why);
    }
    static void put(hid_t file, PropertyList const& properties) {
        hsize_t const size = 4;
        Dataspace const space(checked(H5Screate_simple(1, &size, nullptr), "make a dataspace"));
        Dataset const dataset(checked(
            H5Dcreate2(file, "trials/mine", H5T_STD_U8LE, space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT),
            "create"));
    }
    [[nodiscard]] static PropertyList properties() {
        return PropertyList(checked(H5Pcreate(H5P_DATASET_CREATE), "make properties"));
    }
};

TEST_F(Crafted, ColumnsInOtherFilesAreRefused) {
    spill(folder / "secret", "text");
    edited([&](hid_t file) {
        auto const made = properties();
        checked(H5Pset_external(made.id(), (folder / "secret").c_str(), 0, 4), "store elsewhere");
        put(file, made);
    });
    expect_refused("/trials/mine is stored in another file");
}

TEST_F(Crafted, MappedColumnsAreRefused) {
    edited([&](hid_t file) {
        hsize_t const size = 4;
        Dataspace const space(checked(H5Screate_simple(1, &size, nullptr), "make a dataspace"));
        auto const made = properties();
        checked(H5Pset_virtual(made.id(), space.id(), (folder / "other.h5").c_str(), "x", space.id()), "map");
        put(file, made);
    });
    expect_refused("/trials/mine is stored in another file");
}

TEST_F(Crafted, LinksToElsewhereAreRefused) {
    for (bool const external : {false, true}) {
        write_example(path);
        edited([&](hid_t file) {
            checked(external ? H5Lcreate_external((folder / "other.h5").c_str(), "/x", file, "stripes/a/mine",
                                                  H5P_DEFAULT, H5P_DEFAULT)
                             : H5Lcreate_soft("/trials/v_wes", file, "stripes/a/mine", H5P_DEFAULT, H5P_DEFAULT),
                    "link");
        });
        expect_refused("/stripes/a/mine is a link to elsewhere");
    }
}

TEST_F(Crafted, CirclesOfGroupsAreRefused) {
    edited(
        [](hid_t file) { checked(H5Lcreate_hard(file, "/", file, "trials/again", H5P_DEFAULT, H5P_DEFAULT), "link"); });
    expect_refused("/trials/again is reached by two names");
}

// HDF5 would look for a library of that number in folders that the environment names, and run it.
TEST_F(Crafted, PluginsAreNotLoaded) {
    edited([&](hid_t file) {
        auto const made = properties();
        hsize_t const chunk = 4;
        checked(H5Pset_chunk(made.id(), 1, &chunk), "set chunks");
        checked(H5Pset_filter(made.id(), 32008, H5Z_FLAG_OPTIONAL, 0, nullptr), "set a filter");
        put(file, made);
    });
    expect_refused("/trials/mine is stored through filter 32008");
    unsigned loaded = 1;
    checked(H5PLget_loading_state(&loaded), "ask");
    EXPECT_EQ(loaded, 0U);
}

TEST(Sha256, OfPartsIsThatOfTheWhole) {
    std::string const text(100'000, 'a');
    Sha256 hash;
    for (std::size_t at = 0; at < text.size(); at += 999) {
        hash.add(std::as_bytes(std::span(text).subspan(at, std::min<std::size_t>(999, text.size() - at))));
    }
    EXPECT_EQ(hash.digits(), sha256(text));
    Sha256 joined;
    joined.add_text("ab");
    joined.add_text("c");
    EXPECT_EQ(joined.digits(), sha256("2:ab1:c"));
}

}  // namespace
}  // namespace overturn::store
