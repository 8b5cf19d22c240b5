// Requirement R-1001: what all ranks compute together is the same on any number of them, and none of it twice.
#include "parallel/rows_of_ranks.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace overturn::parallel {
namespace {

constexpr std::size_t row_length = 3;

void make_row(std::int64_t item, std::span<double> row) {
    for (std::size_t i = 0; i < row.size(); ++i) {
        row[i] = std::sin(static_cast<double>(item) + 0.1 * static_cast<double>(i));
    }
}

class RowsOfRanks : public ::testing::TestWithParam<std::int64_t> {};

TEST_P(RowsOfRanks, AreThoseOfOneProcess) {
    Communicator const comm;
    auto const share = rows_of_ranks(comm);

    EXPECT_EQ(share(GetParam(), row_length, make_row), rows_alone(GetParam(), row_length, make_row));
}

TEST_P(RowsOfRanks, EachIsMadeOnce) {
    Communicator const comm;
    std::string made;
    (void)rows_of_ranks(comm)(GetParam(), row_length, [&](std::int64_t item, std::span<double> row) {
        made += static_cast<char>(item);
        make_row(item, row);
    });
    auto const of_ranks = comm.gather(made);

    std::string all;
    for (auto const& one : of_ranks) {
        EXPECT_LE(one.size(), static_cast<std::size_t>(GetParam()) / comm.size() + 1);
        all += one;
    }
    std::ranges::sort(all);
    std::string each;
    for (std::int64_t item = 0; comm.is_root() && item < GetParam(); ++item) {
        each += static_cast<char>(item);
    }
    EXPECT_EQ(all, each);
}

// None at all, fewer than ranks, a multiple of their number and not.
INSTANTIATE_TEST_SUITE_P(Items, RowsOfRanks, ::testing::Values(0, 1, 2, 12, 100),
                         [](auto const& one) { return "of_" + std::to_string(one.param); });

}  // namespace
}  // namespace overturn::parallel
