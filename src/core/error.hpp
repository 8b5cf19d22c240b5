/// Two voices for errors: the user's input (InputError, always checked) and the developers' promises (ContractError).
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace overturn {

/// Place in a text file; line and column count from 1, 0 means "not known".
struct Location {
    std::string file;
    int line = 0;
    int column = 0;

    /// "file:line:col: ", as much of it as is known; empty if nothing is.
    [[nodiscard]] std::string prefix() const;
};

/// Something the user can mend. what() is one line: `file:line:col: problem (why) what to do`.
class InputError : public std::runtime_error {
  public:
    explicit InputError(std::string const& message) : std::runtime_error(message) {}
    InputError(Location const& where, std::string_view message);
};

/// A promise between parts of this program was broken: our mistake, never the user's.
class ContractError : public std::logic_error {
  public:
    using std::logic_error::logic_error;
};

/// Something outside the program failed: a full disk, an unwritable folder, a broken library call.
class SystemError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Throws InputError with the formatted message unless `ok`.
template <class... Args> void validate(bool ok, fmt::format_string<Args...> message, Args&&... args) {
    if (!ok) {
        throw InputError(fmt::format(message, std::forward<Args>(args)...));
    }
}

[[noreturn]] void contract_failed(char const* kind, char const* condition, char const* file, int line);

}  // namespace overturn

#if OVERTURN_CHECKED
#define OVERTURN_EXPECT(condition) \
    ((condition) ? void() : ::overturn::contract_failed("expected", #condition, __FILE__, __LINE__))
#define OVERTURN_ENSURE(condition) \
    ((condition) ? void() : ::overturn::contract_failed("did not ensure", #condition, __FILE__, __LINE__))
#else
#define OVERTURN_EXPECT(condition) void()
#define OVERTURN_ENSURE(condition) void()
#endif
