// Requirement: record n is wave n, untouched, and a damaged or missing file is named where the campaign names it.
#include "generators/records.hpp"

#include "support/expect_input_error.hpp"
#include "support/sources.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;
using testing::source_of;

std::map<std::string, std::string> const files{{"a.csv", "0,0\n0.01,10\n0.02,-20\n0.03,0\n"},
                                               {"b.csv", "0,0\n0.01,1\n0.02,2\n"},
                                               {"slow.csv", "0,0\n0.02,1\n0.04,2\n"},
                                               {"bad.csv", "0,0\n0.01,x\n"}};

TEST(Records, FilesAreWavesInTheirOrder) {
    auto const source = source_of("source='records'\nfiles=['a.csv','b.csv']\nunit='gal'\n", files);

    EXPECT_EQ(source->available(), 2U);
    auto const first = source->make(1, 0);
    EXPECT_EQ(first.label, "a.csv");
    ASSERT_EQ(first.motion.samples(), 4U);
    EXPECT_NEAR(first.motion.time_step_s, 0.01, 1e-15);
    EXPECT_DOUBLE_EQ(first.motion.horizontal_mps2[2], -0.2);
    EXPECT_EQ(source->make(99, 0).motion.horizontal_mps2, first.motion.horizontal_mps2);
    expect_input_error([&] { (void)source->make(1, 2); }, "wave 2 of 2");
}

TEST(Records, TablesPlaceComponents) {
    auto const source =
        source_of("source='records'\n[[records]]\nhorizontal='a.csv'\nvertical='b.csv'\nunit='m/s2'\n", files);

    auto const made = source->make(1, 0);

    EXPECT_EQ(made.motion.vertical_mps2, (std::vector<double>{0, 1, 2}));
    EXPECT_EQ(made.motion.samples(), 3U);
    EXPECT_EQ(made.label, "a.csv (components cut to 3 samples)");
    EXPECT_TRUE(made.motion.transverse_mps2.empty());
}

TEST(Records, RefusesWhatItCannotRead) {
    auto const refuse = [](std::string const& keys, char const* where, char const* part) {
        expect_input_error([&] { (void)source_of("source='records'\n" + keys, files); }, where, part);
    };
    refuse("files=['no.csv']\nunit='gal'\n", "c.toml:2:", "'no.csv'");
    refuse("files=['bad.csv']\nunit='gal'\n", "bad.csv:2", "x");
    refuse("files=['a.csv']\nunit='kine'\n", "c.toml:3:", "not a unit of acceleration");
    refuse("files=['a.csv']\n", "a.csv", "unit");
    refuse("files=[]\nunit='gal'\n", "c.toml:2:", "empty");
    refuse("unit='gal'\n", "c.toml:1:", "either files or records");
    refuse("[[records]]\nhorizontal='a.csv'\nvertical='slow.csv'\nunit='gal'\n", "c.toml:4:", "time step 0.02 s");
    refuse("[[records]]\nhorizontal='a.csv'\nunit='gal'\nscale=2\n", "c.toml:5:", "unknown key");
}

}  // namespace
}  // namespace overturn
