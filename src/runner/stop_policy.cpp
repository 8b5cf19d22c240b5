#include "runner/stop_policy.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <ctime>

#include "core/elapsed.hpp"

namespace overturn {
namespace {

constexpr long ms_per_s = 1000;
constexpr long ns_per_ms = 1'000'000;
constexpr long grace_ms = 500;

long now_ms() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec * ms_per_s + now.tv_nsec / ns_per_ms;
}

// A signal handler can reach nothing else: the only globals of the program.
volatile std::sig_atomic_t requested = 0;
volatile std::sig_atomic_t urgent = 0;
long volatile requested_ms = 0;
long volatile urgent_ms = 0;

constexpr std::array heeded{SIGUSR1, SIGUSR2, SIGTERM, SIGINT};
std::array<void (*)(int), heeded.size()> before{SIG_DFL, SIG_DFL, SIG_DFL, SIG_DFL};

void request(int signal) {
    auto const now = now_ms();
    if (requested != 0 && now - requested_ms >= grace_ms) {
        std::signal(signal, SIG_DFL);  // leaves at once; blocks on disk stay good
        std::raise(signal);
        return;
    }
    if (requested == 0) {
        requested_ms = now;
        requested = signal;
    }
    if (signal != SIGUSR1 && urgent == 0) {
        urgent_ms = now;
        urgent = 1;
    }
}

}  // namespace

void stop_on_signals() {
    for (std::size_t i = 0; i < heeded.size(); ++i) {
        auto* const earlier = std::signal(heeded[i], &request);
        before[i] = earlier == &request ? before[i] : earlier;
    }
}

void restore_signals() {
    for (std::size_t i = 0; i < heeded.size(); ++i) {
        std::signal(heeded[i], before[i] == SIG_ERR ? SIG_DFL : before[i]);
    }
    if (requested != 0) {
        std::raise(requested);
    }
}

StopPolicy::StopPolicy(double after_s) : begin_(Clock::now()), after_s_(after_s) {}

double StopPolicy::elapsed_s() const { return seconds_since(begin_); }

bool StopPolicy::may_begin() const { return requested == 0 && elapsed_s() + longest_s_ <= after_s_; }

bool StopPolicy::may_go_on() const {
    if (urgent != 0 && now_ms() - urgent_ms >= grace_ms) {
        return false;
    }
    return elapsed_s() <= after_s_;
}

bool StopPolicy::may_merge() const {
    constexpr long merge_grace_ms = 60 * ms_per_s;  // of the minutes that batch systems are asked to warn before
    return may_go_on() && (requested == 0 || now_ms() - requested_ms < merge_grace_ms);
}

// A batch system's job ends a tenth of the run after its limit, or 30 s: all are to have left before that.
double StopPolicy::overdue_in_s() const {
    constexpr double least_s = 10, most_s = 20, share = 1. / 15;
    return after_s_ + std::clamp(share * after_s_, least_s, most_s) - elapsed_s();
}

void StopPolicy::block_took(double seconds) { longest_s_ = std::max(longest_s_, seconds); }

}  // namespace overturn
