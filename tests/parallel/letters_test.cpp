// Requirement R-1101: letters between ranks come whole and in order, and need no other rank.
#include "parallel/letters.hpp"

#include <gtest/gtest.h>

namespace overturn::parallel {
namespace {

std::string long_text(int salt) {
    std::string text(3'000'000, '\0');
    for (std::size_t i = 0; i < text.size(); ++i) {
        text[i] = static_cast<char>((i * 31 + static_cast<std::size_t>(salt)) % 251);  // zeros among them
    }
    return text;
}

TEST(Letters, NothingComesWhereNothingWasSent) {
    Communicator const comm;
    Letters letters;

    EXPECT_FALSE(letters.take().has_value());
    comm.wait_for_all({});  // before the next test sends any
}

/// Long ones first: the short ones behind them are there sooner.
TEST(Letters, ComeWholeAndInOrder) {
    Communicator const comm;
    Letters letters;
    std::vector<std::string> const texts{long_text(1), "", "short", long_text(2)};
    if (!comm.is_root()) {
        for (auto const& text : texts) {
            letters.send(0, text + std::to_string(comm.rank()));
        }
        EXPECT_EQ(letters.wait().text, "all there");
    }
    std::vector<std::size_t> come(static_cast<std::size_t>(comm.size()));
    for (std::size_t left = comm.is_root() ? texts.size() * (come.size() - 1) : 0; left > 0; --left) {
        auto const [from, text] = letters.wait();
        auto& next = come[static_cast<std::size_t>(from)];
        ASSERT_LT(next, texts.size());
        EXPECT_TRUE(text == texts[next] + std::to_string(from)) << "letter " << next << " of rank " << from;
        ++next;
    }
    for (int rank = 1; comm.is_root() && rank < comm.size(); ++rank) {
        letters.send(rank, "all there");
    }
    comm.wait_for_all({});
}

/// The last rank takes its letters only after the others have had theirs answered.
TEST(Letters, PassARankThatIsBusy) {
    Communicator const comm;
    if (comm.size() < 3) {
        GTEST_SKIP() << "needs three ranks";
    }
    Letters letters;
    int const busy = comm.size() - 1;
    if (comm.is_root()) {
        for (int rank = busy; rank > 0; --rank) {
            letters.send(rank, long_text(rank));
        }
        for (int answers = 1; answers < busy; ++answers) {
            EXPECT_EQ(letters.wait().text, "there");
        }
        EXPECT_FALSE(letters.take().has_value());
        letters.send(busy, "others have answered");
        EXPECT_EQ(letters.wait().from, busy);
    } else if (comm.rank() != busy) {
        EXPECT_TRUE(letters.wait().text == long_text(comm.rank()));
        letters.send(0, "there");
    }
    if (comm.rank() == busy) {
        EXPECT_TRUE(letters.wait().text == long_text(busy));
        EXPECT_EQ(letters.wait().text, "others have answered");
        letters.send(0, "there");
    }
    comm.wait_for_all({});
}

}  // namespace
}  // namespace overturn::parallel
