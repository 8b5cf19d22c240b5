#include "campaign/progress.hpp"

#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

namespace overturn {

std::string duration_text(double seconds) {
    auto const whole = static_cast<std::int64_t>(std::llround(seconds));
    constexpr std::int64_t minute = 60;
    constexpr std::int64_t hour = 3600;
    if (seconds < 10) {
        return fmt::format("{:.1f} s", seconds);
    }
    if (whole < minute) {
        return fmt::format("{} s", whole);
    }
    if (whole < hour) {
        return fmt::format("{} min {:02} s", whole / minute, whole % minute);
    }
    return fmt::format("{} h {:02} min", whole / hour, whole % hour / minute);
}

Progress::Progress(std::int64_t total, std::int64_t done, double trials_per_block)
    : terminal_(isatty(STDERR_FILENO) != 0),
      total_(total),
      before_(done),
      done_(done),
      trials_per_block_(trials_per_block),
      begin_(std::chrono::steady_clock::now()) {}

double Progress::elapsed_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

void Progress::block_done() {
    ++done_;
    constexpr double terminal_every_s = 0.2;
    constexpr double plain_every_s = 10;
    double const now = elapsed_s();
    if (now - shown_s_ >= (terminal_ ? terminal_every_s : plain_every_s) || done_ == total_) {
        shown_s_ = now;
        show(done_ == total_);
    }
}

void Progress::show(bool last) const {
    double const seconds = elapsed_s();
    auto const fresh = static_cast<double>(done_ - before_);
    double const per_second = fresh * trials_per_block_ / seconds;
    double const left_s = seconds / fresh * static_cast<double>(total_ - done_);
    auto const line = fmt::format("{} of {} blocks, {:.0f} trials/s, {}", done_, total_, per_second,
                                  last ? "took " + duration_text(seconds) : duration_text(left_s) + " left");
    fmt::print(stderr, "{}{:<70}{}", terminal_ ? "\r" : "", line, terminal_ ? "" : "\n");
    std::fflush(stderr);
}

void Progress::finish() const {
    if (terminal_ && shown_s_ >= 0) {
        fmt::print(stderr, "\n");
    }
}

}  // namespace overturn
