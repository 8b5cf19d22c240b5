// Requirement R-1005: every file a campaign reads is remembered whole, and a missing one is named.
#include "core/input_files.hpp"

#include <fstream>

#include "support/expect_input_error.hpp"

namespace overturn {
namespace {

TEST(InputFiles, RemembersWhatItRead) {
    auto const folder = std::filesystem::path(::testing::TempDir());
    std::ofstream(folder / "input_files_test.bin", std::ios::binary) << std::string("a\0\r\nb", 5);
    InputFiles files(folder);

    EXPECT_EQ(files.read("input_files_test.bin"), std::string("a\0\r\nb", 5));
    std::filesystem::remove(folder / "input_files_test.bin");
    EXPECT_EQ(files.read("input_files_test.bin").size(), 5U);  // from memory now

    InputFiles replayed(files.contents());
    EXPECT_EQ(replayed.read("input_files_test.bin").size(), 5U);
    testing::expect_input_error([&] { (void)replayed.read("other"); }, "'other'", "not among the stored");
}

TEST(InputFiles, MissingFileIsNamed) {
    InputFiles files{std::filesystem::path("/nonexistent")};
    testing::expect_input_error([&] { (void)files.read("wave.csv"); }, "'wave.csv'", "/nonexistent");
    InputFiles here{std::filesystem::path("/")};
    testing::expect_input_error([&] { (void)here.read("tmp"); }, "'tmp' (a folder). Name one file");
}

}  // namespace
}  // namespace overturn
