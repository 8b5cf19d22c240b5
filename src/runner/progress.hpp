/// Progress of long work on stderr: one line that rewrites itself on a terminal, plain lines elsewhere.
#pragma once

#include <cstdint>
#include <string>

#include "core/elapsed.hpp"

namespace overturn {

/// From here on stderr gets one JSON object a line: {"event": "progress", "done": 3, "of": 8, ...}, and {"event":
/// "note", "text": "..."} of all else.
void tell_as_json(std::string output);
/// Then, the last of them: {"event":"end","output":...,"exit_code":...}. Once for a process, however it ends: the rank
/// that speaks for all calls it.
void tell_end(int exit_code);

class Progress {
  public:
    /// \param total blocks in all; \param done blocks that an earlier run left behind; \param trials per block, on
    /// average
    /// \param counted what is counted, where it is not blocks
    Progress(std::int64_t total, std::int64_t done, double trials_per_block, std::string counted = "blocks");

    /// Is it time to show something again?
    [[nodiscard]] bool is_due() const;
    /// \param fresh blocks that this run has done so far
    void show(std::int64_t fresh);
    /// Ends the rewriting line.
    void finish() const;
    [[nodiscard]] double elapsed_s() const;

  private:
    void show_json(std::int64_t done, double per_second, double left_s);

    bool terminal_;
    std::int64_t total_, before_;
    double trials_per_block_;
    std::string counted_;
    Clock::time_point begin_;
    double shown_s_ = -1;
};

/// "12 s", "3 min 20 s", "2 h 05 min".
[[nodiscard]] std::string duration_text(double seconds);

}  // namespace overturn
