/// Texts from one rank to another. Unlike the collective calls of a communicator they need no rank but these two, so
/// that one which has stopped holds up nobody.
#pragma once

#include <list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "parallel/communicator.hpp"

namespace overturn::parallel {

struct Letter {
    int from = 0;
    std::string text;
};

/// \pre one at a time on each rank, and every letter is taken before the next one is made
class Letters {
  public:
    Letters();
    ~Letters();
    Letters(Letters const&) = delete;
    Letters& operator=(Letters const&) = delete;
    Letters(Letters&&) = delete;
    Letters& operator=(Letters&&) = delete;

    /// Returns at once; the text is kept until it is there.
    void send(int to, std::string text);
    /// A letter that has come whole, of each rank in the order in which it sent them; nothing if none has.
    [[nodiscard]] std::optional<Letter> take();
    /// Waits for one without burning its core.
    [[nodiscard]] Letter wait();

  private:
    struct OnTheWay;
    std::list<OnTheWay> sent_, coming_;
};

}  // namespace overturn::parallel
