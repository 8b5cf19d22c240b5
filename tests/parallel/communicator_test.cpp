// Requirement: bytes reach every rank whole and in order, and no piece of work is given out twice or lost.
#include "parallel/communicator.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <span>

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

std::vector<std::byte> bytes_of(std::string const& text) {
    auto const bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

std::string packed(std::vector<std::int64_t> const& values) {
    return {reinterpret_cast<char const*>(values.data()), values.size() * sizeof(std::int64_t)};
}

std::vector<std::int64_t> unpacked(std::string const& text) {
    std::vector<std::int64_t> values(text.size() / sizeof(std::int64_t));
    std::memcpy(values.data(), text.data(), text.size());
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

TEST(Communicator, PollFindsNothingWhereNothingWasSent) {
    Communicator const comm;

    EXPECT_FALSE(comm.poll());
    (void)comm.largest(0);  // nobody goes on to send before all have looked
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

constexpr int messages = 40;

/// Small enough to go at once and large enough to wait for their receiver, more than may be under way.
std::vector<std::byte> message_of(int rank, int number) {
    auto const length = static_cast<std::size_t>(number % 4 == 3 ? 300000 : number * 11);
    return bytes_of(long_text(length, rank + number));
}

void post_all(Communicator const& comm) {
    Outbox outbox;
    for (int number = 0; number < messages; ++number) {
        outbox.post(message_of(comm.rank(), number));
    }
}

void receive_all(Communicator const& comm) {
    std::vector<int> next(static_cast<std::size_t>(comm.size()), 0);
    for (int left = messages * (comm.size() - 1); left > 0; --left) {
        auto const message = comm.receive();
        ASSERT_GT(message.from, 0);
        ASSERT_LT(message.from, comm.size());
        int const number = next[static_cast<std::size_t>(message.from)]++;
        EXPECT_EQ(message.bytes, message_of(message.from, number))
            << "message " << number << " of rank " << message.from;
    }
}

TEST(Outbox, DeliversEverythingInOrder) {
    Communicator const comm;
    if (comm.is_root()) {
        receive_all(comm);
    } else {
        post_all(comm);
    }
    (void)comm.largest(0);  // nobody goes on to the next test's messages before all of these are there
    EXPECT_FALSE(comm.poll());
    (void)comm.largest(0);
}

TEST(Outbox, PollBringsWhatHasArrived) {
    Communicator const comm;
    {
        Outbox outbox;
        outbox.post(bytes_of("from " + std::to_string(comm.rank())));
        if (comm.is_root()) {
            std::vector<int> heard(static_cast<std::size_t>(comm.size()), 0);
            for (int left = comm.size(); left > 0;) {
                if (auto const message = comm.poll()) {
                    EXPECT_EQ(message->bytes, bytes_of("from " + std::to_string(message->from)));
                    ++heard.at(static_cast<std::size_t>(message->from));
                    --left;
                }
            }
            EXPECT_EQ(std::count(heard.begin(), heard.end(), 1), comm.size());
        }
    }
    (void)comm.largest(0);
}

}  // namespace
}  // namespace overturn::parallel
