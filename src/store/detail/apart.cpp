#include "store/detail/apart.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <exception>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace overturn::store {
namespace {

// Ends the child without touching what it shares with its parent: no buffers are written out, no handlers called.
[[noreturn]] void answer(int to, std::function<std::string()> const& look) {
    constexpr unsigned longest_s = 60;
    rlimit const no_core{0, 0};
    ::setrlimit(RLIMIT_CORE, &no_core);
    for (int const signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGALRM}) {
        std::signal(signal, SIG_DFL);
    }
    ::alarm(longest_s);
    // What the C library says of a heap that damage has upset is nobody's line.
    if (int const nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC); nowhere >= 0) {
        ::dup2(nowhere, STDERR_FILENO);
    }
    std::string text;
    try {
        text = look();
    } catch (std::exception const&) {
        ::_exit(1);
    }
    for (std::size_t at = 0; at < text.size();) {
        auto const written = ::write(to, text.data() + at, text.size() - at);
        if (written <= 0) {
            ::_exit(1);
        }
        at += written;
    }
    ::_exit(0);
}

}  // namespace

std::optional<std::string> looked_at_apart(std::function<std::string()> const& look) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) {
        return std::nullopt;
    }
    auto const child = ::fork();
    if (child == 0) {
        ::close(ends[0]);
        answer(ends[1], look);
    }
    ::close(ends[1]);
    std::string text;
    std::array<char, 4096> part{};
    while (child > 0) {
        auto const got = ::read(ends[0], part.data(), part.size());
        if (got > 0) {
            text.append(part.data(), got);
        } else if (got == 0 || errno != EINTR) {
            break;
        }
    }
    ::close(ends[0]);
    int status = 0;
    while (child > 0 && ::waitpid(child, &status, 0) < 0 && errno == EINTR) {}
    bool const fine = child > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
    return fine ? std::optional(text) : std::nullopt;
}

}  // namespace overturn::store
