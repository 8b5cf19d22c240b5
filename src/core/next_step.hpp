/// What a user does after trouble outside the program (a full disk, a failing one) is mended. It depends on the verb;
/// the message is made deep inside, where the verb is not known.
#pragma once

#include <string>

namespace overturn {

/// While one lives, next_step() gives its text. Not for several threads.
class NextStep {
  public:
    /// \param text "go on with --resume", as the end of a sentence that it closes without a full stop
    explicit NextStep(std::string text);
    ~NextStep();
    NextStep(NextStep const&) = delete;
    NextStep& operator=(NextStep const&) = delete;
    NextStep(NextStep&&) = delete;
    NextStep& operator=(NextStep&&) = delete;

  private:
    std::string before_;
};

/// "repeat the command", unless a verb states another.
[[nodiscard]] std::string const& next_step();

}  // namespace overturn
