#include "runner/progress.hpp"

#include <cmath>
#include <cstdio>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "core/elapsed.hpp"
#include "core/note_form.hpp"
#include "core/print_note.hpp"

namespace overturn {

namespace {

bool as_json = false;  // of the process, as stderr is
std::string output_told;
bool end_told = false;

std::string note_as_json(std::string const& line) {
    return nlohmann::ordered_json{{"event", "note"}, {"text", line}}.dump(
        -1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace

void tell_as_json(std::string output) {
    as_json = true;
    output_told = std::move(output);
    form_notes(&note_as_json);
}

void tell_end(int exit_code) {
    if (as_json && !std::exchange(end_told, true)) {
        print_note("{}\n",
                   nlohmann::ordered_json{{"event", "end"}, {"output", output_told}, {"exit_code", exit_code}}.dump(
                       -1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    }
}

std::string duration_text(double seconds) {
    std::int64_t const whole = std::llround(seconds);
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

Progress::Progress(std::int64_t total, std::int64_t done, double trials_per_block, std::string counted)
    : terminal_(isatty(STDERR_FILENO) != 0 && !as_json),
      total_(total),
      before_(done),
      trials_per_block_(trials_per_block),
      counted_(std::move(counted)),
      begin_(Clock::now()) {}

double Progress::elapsed_s() const { return seconds_since(begin_); }

bool Progress::is_due() const {
    constexpr double terminal_every_s = 0.2;
    constexpr double json_every_s = 1;
    constexpr double plain_every_s = 10;
    return elapsed_s() - shown_s_ >= (as_json ? json_every_s : terminal_ ? terminal_every_s : plain_every_s);
}

void Progress::show(std::int64_t fresh) {
    double const seconds = elapsed_s();
    if (fresh == 0) {
        return;
    }
    shown_s_ = seconds;
    auto const done = before_ + fresh;
    double const per_second = static_cast<double>(fresh) * trials_per_block_ / seconds;
    double const left_s = seconds / static_cast<double>(fresh) * static_cast<double>(total_ - done);
    if (as_json) {
        show_json(done, per_second, left_s);
        return;
    }
    auto const line = fmt::format("{} of {} {}, {}{}", done, total_, counted_,
                                  trials_per_block_ > 0 ? fmt::format("{:.0f} trials/s, ", per_second) : "",
                                  done == total_ ? "took " + duration_text(seconds) : duration_text(left_s) + " left");
    print_note("{}{:<70}{}", terminal_ ? "\r" : "", line, terminal_ ? "" : "\n");
}

void Progress::show_json(std::int64_t done, double per_second, double left_s) {
    nlohmann::ordered_json event{{"event", "progress"}, {"counted", counted_},      {"done", done},
                                 {"of", total_},        {"elapsed_s", elapsed_s()}, {"left_s", left_s}};
    if (trials_per_block_ > 0) {
        event["trials_per_s"] = per_second;
    }
    print_note("{}\n", event.dump());
}

void Progress::finish() const {
    if (terminal_ && shown_s_ >= 0) {
        print_note("\n");
    }
}

}  // namespace overturn
