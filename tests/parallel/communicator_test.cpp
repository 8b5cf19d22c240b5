// Requirement R-1001: texts reach every rank whole and in order, and no piece of work is given out twice or lost.
#include "parallel/communicator.hpp"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <thread>

#include <gtest/gtest.h>

namespace overturn::parallel {
namespace {

std::string long_text(std::size_t length, int salt) {
    std::string text(length, '\0');
    for (std::size_t i = 0; i < length; ++i) {
        text[i] = static_cast<char>((i * 31 + static_cast<std::size_t>(salt)) % 251);  // zeros among them
    }
    return text;
}

std::string packed(std::vector<std::int64_t> const& values) {
    return {reinterpret_cast<char const*>(values.data()), values.size() * sizeof(std::int64_t)};
}

std::vector<std::int64_t> unpacked(std::string const& text) {
    std::vector<std::int64_t> values(text.size() / sizeof(std::int64_t));
    if (!text.empty()) {  // a rank may have got nothing
        std::memcpy(values.data(), text.data(), text.size());
    }
    return values;
}

TEST(Communicator, KnowsWhoItIs) {
    Communicator const comm;

    EXPECT_GE(comm.rank(), 0);
    EXPECT_LT(comm.rank(), comm.size());
    EXPECT_EQ(comm.is_root(), comm.rank() == 0);
    EXPECT_FALSE(comm.host().empty());
}

TEST(Communicator, BroadcastsAnything) {
    Communicator const comm;
    for (std::size_t const length : {0UL, 1UL, 3UL << 20U}) {
        std::string text = comm.is_root() ? long_text(length, 7) : "something older and longer";
        comm.broadcast(text);

        EXPECT_EQ(text, long_text(length, 7));
    }
}

TEST(Communicator, GathersInRankOrder) {
    Communicator const comm;
    auto const length_on = [](int rank) { return rank == 1 ? 0 : static_cast<std::size_t>(200000 * rank + 5); };
    auto const texts = comm.gather(long_text(length_on(comm.rank()), comm.rank()));

    ASSERT_EQ(texts.size(), static_cast<std::size_t>(comm.is_root() ? comm.size() : 0));
    for (std::size_t rank = 0; rank < texts.size(); ++rank) {
        EXPECT_EQ(texts[rank], long_text(length_on(static_cast<int>(rank)), static_cast<int>(rank)));
    }
}

TEST(Communicator, AgreesOnTheLargest) {
    Communicator const comm;

    EXPECT_EQ(comm.largest(-comm.rank()), 0);
    EXPECT_EQ(comm.largest(comm.rank()), comm.size() - 1);
}

class Counting : public ::testing::TestWithParam<std::int64_t> {};

TEST_P(Counting, EveryValueIsGivenOnce) {
    constexpr std::int64_t work = 3000;
    auto const step = GetParam();
    Communicator const comm;
    std::vector<std::int64_t> mine;
    {
        SharedCounter counter(comm);
        for (auto value = counter.take(step); value < work; value = counter.take(step)) {
            mine.push_back(value);
        }
    }
    EXPECT_TRUE(std::is_sorted(mine.begin(), mine.end()));
    std::vector<std::int64_t> all;
    for (auto const& text : comm.gather(packed(mine))) {
        auto const part = unpacked(text);
        all.insert(all.end(), part.begin(), part.end());
    }
    std::sort(all.begin(), all.end());

    if (comm.is_root()) {
        ASSERT_EQ(all.size(), static_cast<std::size_t>(work / step));
        for (std::size_t i = 0; i < all.size(); ++i) {
            EXPECT_EQ(all[i], static_cast<std::int64_t>(i) * step);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Steps, Counting, ::testing::Values(1, 8), ::testing::PrintToStringParamName());

TEST(SharedCounter, StartsAtZeroEveryTime) {
    Communicator const comm;
    for (int round = 0; round < 3; ++round) {
        SharedCounter counter(comm);
        EXPECT_LT(counter.take(), comm.size());
    }
}

/// A big step ends the work for all: how a rank asked to stop keeps the others from starting anew.
TEST(SharedCounter, ABigStepLeavesNothingForAnybody) {
    constexpr std::int64_t work = 100;
    Communicator const comm;
    SharedCounter counter(comm);
    (void)counter.take(work);

    EXPECT_GE(counter.take(), work);
}

TEST(SharedCounter, LookingTakesNothing) {
    Communicator const comm;
    SharedCounter counter(comm);
    (void)counter.take(2);
    comm.wait_for_all([] {});

    EXPECT_EQ(counter.look(), 2 * comm.size());
    EXPECT_EQ(counter.look(), 2 * comm.size());
    comm.wait_for_all([] {});
}

/// Nobody passes before the last has come, and those who wait may go on serving.
TEST(Communicator, WaitsForTheLast) {
    Communicator const comm;
    SharedCounter arrived(comm);
    if (comm.rank() == comm.size() - 1) {
        std::this_thread::sleep_for(std::chrono::milliseconds(30));
    }
    (void)arrived.take();
    int turns = 0;
    comm.wait_for_all([&] {
        comm.serve();
        ++turns;
    });

    EXPECT_EQ(arrived.look(), comm.size());
    EXPECT_TRUE(comm.size() == 1 || comm.rank() == comm.size() - 1 || turns > 0);
    comm.wait_for_all([] {});
}

}  // namespace
}  // namespace overturn::parallel
