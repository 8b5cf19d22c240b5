/// Waiting for other ranks without burning a core.
#pragma once

#include <algorithm>
#include <chrono>
#include <thread>

namespace overturn::parallel {

/// For one who looks again and again for what comes from another rank: at first at once, then it sleeps, up to a fifth
/// of a millisecond. MPI's own waits never sleep, and a rank that still works may need the core.
class Pause {
  public:
    void operator()() {
        using std::chrono::microseconds;
        constexpr int looks = 200;
        constexpr microseconds longest(200);
        if (look_ >= looks) {
            std::this_thread::sleep_for(std::min(longest, microseconds(look_ - looks + 1)));
        } else {
            std::this_thread::yield();
        }
        ++look_;
    }

  private:
    int look_ = 0;
};

}  // namespace overturn::parallel
