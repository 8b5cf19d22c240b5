// Requirement R-702: tables of words and numbers are read below the line that names their columns; all other lines are
// text, and kept.
#include "motion/cell_rows.hpp"

#include <string>

#include "support/expect_input_error.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

struct Seen {
    std::string names, text;
    int rows = 0;
};

Seen read(std::string const& content) {
    std::string const file = "t.csv";
    CellRows rows(content, file, "Begin with a,b");
    Seen seen;
    while (rows.next()) {
        ++seen.rows;
    }
    for (auto const& cell : rows.header()) {
        seen.names += std::string(cell.text) + "|";
    }
    for (auto const& line : rows.text()) {
        seen.text += std::to_string(line.number) + line.text + "|";
    }
    return seen;
}

TEST(CellRows, TheHeaderIsFoundBelowProse) {
    for (char const* prose : {"Tests of Smith\n", "Tests of Smith (2010)\n", "Shaking table, north\n",
                              "A report\n\nof many words, and a comma\n"}) {
        auto const seen = read(std::string(prose) + "wave,motion,block\na,m,1\nb,m,0\n");
        EXPECT_EQ(seen.names, "wave|motion|block|") << prose;
        EXPECT_EQ(seen.rows, 2) << prose;
        EXPECT_NE(seen.text.find("1"), std::string::npos) << prose;
    }
    // Rows without a number are rows, whatever comes first.
    EXPECT_EQ(read("wave,motion,block\na,m,\nb,m,1\n").rows, 2);
    EXPECT_EQ(read("wave,block\na,\nb,\n").rows, 2);
    EXPECT_EQ(read("capacity [g]\n0.5\n>1.3\n").names, "capacity [g]|");
    EXPECT_EQ(read("1,2\n3,4\n").names, "1|2|");
}

TEST(CellRows, CommentsAreKeptAsText) {
    auto const seen = read("# in g\n% old\nim,n\n1,2  # odd\n\n");
    EXPECT_EQ(seen.text, "1# in g|2% old|4# odd|");
    EXPECT_EQ(seen.rows, 1);
}

TEST(CellRows, RowsThatDoNotFitAreRefusedWhereTheyStand) {
    expect_input_error([] { (void)read("im,n\n1\n"); }, "t.csv:2:1: 1 columns (the header has 2)");
    expect_input_error([] { (void)read("prose\nim,n\n1,2,3\n"); }, "t.csv:");
    expect_input_error([] { (void)read("im,n\n0,2,4\n"); }, "decimal commas");
    expect_input_error([] { (void)read(""); }, "t.csv: empty (no header). Begin with a,b");
}

}  // namespace
}  // namespace overturn
