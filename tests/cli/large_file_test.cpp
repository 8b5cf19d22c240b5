// Requirement R-1001, R-1004: a file so large that it and its columns are hashed in stretches is the same bytes from
// any number of ranks, is read by the program and by the Python package, and shows a changed bit wherever it is.
#include <array>
#include <cstddef>

#include <nlohmann/json.hpp>

#include "cli/python.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

// 600 000 trials of a body that stays at rest: columns of 4.8 MB, 360 MB in all.
constexpr char const* campaign = R"(seed = 3
[waves]
source = 'spectrum-compatible'
count = 300
duration = '2.56 s'
time_step = '0.02 s'
match = 'none'
target = {spectrum = 'mlit-ch1', longest = '2 s'}
envelope = {shape = 'jennings', rise = '0.5 s', level_end = '1.5 s', end = '2.4 s'}
[[bodies]]
name = 'wide'
mass = '12.6 t'
base_width = '1.36 m'
centre_height = '1.045 m'
inertia = 'uniform-block'
[levels]
measure = 'pga'
values = {from = '1 gal', to = '200 gal', count = 2000}
)";

TEST(LargeFile, IsTheSameFromAnyRanksAndGuarded) {
    Folder const folder;
    folder.write("c.toml", campaign);
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "-o", "1.h5"}).code, 0);
    auto const together = execute(folder, mpirun(3, {"run", "c.toml", "-o", "3.h5"}));
    ASSERT_EQ(together.code, 0) << together.err;
    auto whole = folder.read("1.h5");
    EXPECT_GT(whole.size(), std::size_t{300'000'000});
    EXPECT_TRUE(whole == folder.read("3.h5"));
    EXPECT_NE(whole.find("overturn-seal sha256 of the sha256 of every 64 MiB"), std::string::npos);

    auto const status = overturn(folder, {"status", "3.h5", "--json"});
    EXPECT_EQ(nlohmann::json::parse(status.out).at("trials").at("done"), 600'000) << status.err;
    if (has_python(folder, "h5py")) {
        EXPECT_EQ(open_in_python(folder, "3.h5").code, 0);
    }
    auto const at = whole.size() / 2;
    whole[at] = static_cast<char>(whole[at] ^ 1);
    folder.write("3.h5", whole);
    auto const refused = overturn(folder, {"status", "3.h5"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_NE(refused.err.find("changed"), std::string::npos) << refused.err;
    if (has_python(folder, "h5py")) {
        EXPECT_EQ(open_in_python(folder, "3.h5").code, 2);
    }
}

}  // namespace
}  // namespace overturn::testing
