// Requirement R-107: names that cannot tell which component a column is are asked about, and quoted ones stay whole.
#include <string>
#include <vector>

#include "motion/record.hpp"
#include "support/expect_input_error.hpp"
#include "support/read_record.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

constexpr double gal = 0.01;

GroundMotion read(std::string const& content) {
    return testing::read_record(content, {.name = "a.csv", .unit_mps2 = gal});
}

std::vector<double> const three{100 * gal, -200 * gal, 300 * gal};

// axes of a program say not which of them is up; a comma within quotes parts no names.
TEST(NamesOfColumns, LettersAndQuotesOfNames) {
    std::string const four = "0,100,1,2\n0.5,-200,-1,-3\n1,300,2,1\n";
    std::string const three_rows = "0,100,1\n0.5,-200,-1\n1,300,2\n";
    for (char const* names : {"t,u,v,w", "time,U (gal),V (gal),W (gal)", "time,a_u,a_v,a_w", "time,au,av,aw"}) {
        expect_input_error([&] { (void)read(std::string(names) + "\n" + four); }, "a.csv:1: columns '",
                           "axes of a program");
    }
    for (char const* names : {"t,v,w", "time,u [gal],w [gal]", "time,u,v"}) {
        expect_input_error([&] { (void)read(std::string(names) + "\n" + three_rows); }, "a.csv:1: columns '",
                           "axes of a program");
    }
    EXPECT_EQ(read("time,N,W,U\n" + four).vertical_mps2, (std::vector{2 * gal, -3 * gal, 1 * gal}));
    std::string const quoted = "\"Time (s)\",\"Displacement (cm), N-S\",\"Acceleration (gal), E-W\"\n";
    EXPECT_EQ(read(quoted + three_rows).horizontal_mps2, (std::vector{1 * gal, -1 * gal, 2 * gal}));
    expect_input_error([&] { (void)read("\"Time (s)\",\"Displacement (cm), N-S\"\n0,1\n0.5,-2\n1,3\n"); },
                       "a.csv:1: column 'Displacement (cm), N-S' (a displacement");
    auto const upward = read("\"Time (s)\",\"Acceleration (gal), N-S\",\"Acceleration (gal), U-D\"\n" + three_rows);
    EXPECT_EQ(upward.horizontal_mps2, three);
    EXPECT_EQ(upward.vertical_mps2, (std::vector{1 * gal, -1 * gal, 2 * gal}));
}

// names that stand one below the other, each with the number of its column, are as good as a row of them.
TEST(NamesOfColumns, NumberedNamesAreNames) {
    std::string const rows = "0 100 1\n0.5 -200 -1\n1 300 2\n";
    for (char const* text :
         {"# Column 1: Time (s)\n# Column 2: UD (gal)\n# Column 3: NS (gal)\n",
          "Column 1 - time (s), column 2 - acceleration UD (gal), column 3 - acceleration NS (gal)\n",
          "# col 1 = time\n# col 2 = acc_UD\n# col 3 = acc_NS\n", "# Spalte 1: Zeit\n# Spalte 2: UD\n# Spalte 3: NS\n",
          "# Col. 3: NS\n# Col. 1: t\n# Col. 2: vertical\n"}) {
        auto const motion = read(text + rows);
        EXPECT_EQ(motion.vertical_mps2, three) << text;
        EXPECT_EQ(motion.horizontal_mps2, (std::vector{1 * gal, -1 * gal, 2 * gal})) << text;
    }
    EXPECT_EQ(read("# Column 1: time\n# Column 2: acceleration\n# Column 3: velocity\n" + rows).horizontal_mps2, three);
    expect_input_error([&] { (void)read("# Column 1: time\n# Column 2: displacement\n# Column 3: velocity\n" + rows); },
                       "a.csv:1: column 'displacement'");
    expect_input_error([&] { (void)read("# Column 1: NS\n# Column 2: EW\n# Column 3: velocity\n" + rows); }, "a.csv:");
    expect_input_error([&] { (void)read("# Column 1: time\n# Column 2: UD\n# Column 3: NS\n# Column 4: EW\n" + rows); },
                       "a.csv:1: names of 4 columns above 3", "--columns");
    for (char const* text :
         {"# Column 2: NS\n# Column 3: EW\n", "# Column 1: time\n# Column 2: NS\n# Column 2: UD\n",
          "# Column bases 1: fixed\n", "# Column 1: time\n# Column 2: NS\n# Column 2: UD\n# Column 3: EW\n"}) {
        expect_input_error([&] { (void)read(text + rows); }, "a.csv:", "--columns");
    }
}

}  // namespace
}  // namespace overturn
