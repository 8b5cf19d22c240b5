/// Runs the real program, alone or under mpirun, without a shell: what it printed and how it ended.
#pragma once

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace overturn::testing {

inline std::string read_text(std::filesystem::path const& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// A folder of its own, gone with the object.
class Folder {
  public:
    Folder() {
        auto name = (std::filesystem::temp_directory_path() / "overturn-test-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) {
            throw std::runtime_error("cannot make a temporary folder");
        }
        path_ = name;
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    Folder(Folder const&) = delete;
    Folder& operator=(Folder const&) = delete;
    Folder(Folder&&) = delete;
    Folder& operator=(Folder&&) = delete;

    [[nodiscard]] std::filesystem::path const& path() const { return path_; }
    [[nodiscard]] std::filesystem::path operator/(std::string const& name) const { return path_ / name; }
    void write(std::string const& name, std::string const& text) const {
        std::ofstream(path_ / name, std::ios::binary) << text;
    }
    [[nodiscard]] std::string read(std::string const& name) const { return read_text(path_ / name); }
    [[nodiscard]] bool has(std::string const& name) const { return std::filesystem::exists(path_ / name); }

  private:
    std::filesystem::path path_;
};

/// What ctest cannot pass on, a list of variables: lets mpirun start more ranks than there are cores, as any user.
inline void use_mpi_environment() {
    std::istringstream variables(OVERTURN_MPI_ENVIRONMENT);
    for (std::string variable; variables >> variable;) {
        auto const equals = variable.find('=');
        ::setenv(variable.substr(0, equals).c_str(), variable.substr(equals + 1).c_str(), 1);
    }
}

/// Wrapped lines are one again: what begins with four spaces goes on with the line before.
inline std::string unwrapped(std::string text) {
    for (std::size_t at = 0; (at = text.find("\n    ", at)) != std::string::npos;) {
        auto const word = std::min(text.find_first_not_of(' ', at + 1), text.size());
        text.replace(at, word - at, " ");
    }
    return text;
}

struct Ended {
    int code = -1;  ///< exit code, or 128 + signal
    std::string out;
    std::string err;             ///< notes and errors; of wrapped notes each is one line again
    std::string err_lines = {};  ///< the same as it was printed
};

/// A process as /proc/PID/stat has it: its state ('Z': ended, and nobody took note) and the process that started it.
struct ProcessState {
    char state = 'X';
    pid_t parent = 0;
};

inline ProcessState state_of(std::filesystem::path const& process) {
    auto const stat = read_text(process / "stat");
    auto const name_end = stat.rfind(')');
    return name_end == std::string::npos ? ProcessState{}
                                         : ProcessState{stat[name_end + 2], std::atoi(stat.c_str() + name_end + 4)};
}

/// The processes that `parent` started: the ranks of a local mpirun.
inline std::vector<pid_t> children_of(pid_t parent) {
    std::vector<pid_t> children;
    std::error_code error;
    for (auto const& entry : std::filesystem::directory_iterator("/proc", error)) {
        if (!std::isdigit(entry.path().filename().string()[0])) {
            continue;
        }
        if (state_of(entry.path()).parent == parent) {
            children.push_back(std::atoi(entry.path().filename().c_str()));
        }
    }
    return children;
}

/// A program under way in a folder.
class Running {
  public:
    Running(Folder const& folder, std::vector<std::string> arguments) {
        static int number = 0;
        launches_ = arguments[0] == OVERTURN_MPIRUN;
        auto const name = ".output-" + std::to_string(++number);
        out_ = folder / (name + ".out");
        err_ = folder / (name + ".err");
        use_mpi_environment();
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addchdir_np(&actions, folder.path().c_str());
        posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&actions, 1, out_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        posix_spawn_file_actions_addopen(&actions, 2, err_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        std::vector<char*> argv;
        for (auto& argument : arguments) {
            argv.push_back(argument.data());
        }
        argv.push_back(nullptr);
        if (posix_spawnp(&pid_, argv[0], &actions, nullptr, argv.data(), environ) != 0) {
            throw std::runtime_error("cannot start " + arguments[0]);
        }
        posix_spawn_file_actions_destroy(&actions);
    }
    ~Running() {
        if (pid_ > 0) {
            ::kill(pid_, SIGKILL);
            (void)wait();
        }
    }
    Running(Running const&) = delete;
    Running& operator=(Running const&) = delete;
    Running(Running&&) = delete;
    Running& operator=(Running&&) = delete;

    void signal(int number) const { ::kill(pid_, number); }
    [[nodiscard]] pid_t pid() const { return pid_; }

    /// mpirun of Open MPI 4.1.4 may wait for ever for a lock of its own after one of its ranks was killed (1 of 150
    /// runs, in PMIx_server_finalize): so it is killed half a minute after the last of them has ended.
    Ended wait() {
        using Clock = std::chrono::steady_clock;
        int status = 0;
        auto looked = Clock::now(), last_seen = looked;
        while (launches_ && ::waitpid(pid_, &status, WNOHANG) == 0) {
            auto const now = Clock::now();
            if (now - looked > std::chrono::seconds(1)) {
                looked = now;
                last_seen = has_working_ranks() ? now : last_seen;
            }
            if (now - last_seen > std::chrono::seconds(30)) {
                ::kill(pid_, SIGKILL);
                launches_ = false;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        if (!launches_) {
            ::waitpid(pid_, &status, 0);
        }
        pid_ = -1;
        auto const err = read_text(err_);
        return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read_text(out_), unwrapped(err), err};
    }

  private:
    [[nodiscard]] bool has_working_ranks() const {
        return std::ranges::any_of(children_of(pid_), [](pid_t rank) {
            auto const state = state_of("/proc/" + std::to_string(rank)).state;
            return state != 'Z' && state != 'X';
        });
    }

    std::filesystem::path out_, err_;
    pid_t pid_ = -1;
    bool launches_ = false;  ///< ranks
};

inline Ended execute(Folder const& folder, std::vector<std::string> arguments) {
    return Running(folder, std::move(arguments)).wait();
}

inline std::vector<std::string> joined(std::vector<std::string> first, std::vector<std::string> const& more) {
    first.insert(first.end(), more.begin(), more.end());
    return first;
}

/// `overturn ...`
inline Ended overturn(Folder const& folder, std::vector<std::string> const& arguments) {
    return execute(folder, joined({OVERTURN_PROGRAM}, arguments));
}

/// `overturn plan ...`, its wrapped lines as one each.
inline Ended planned(Folder const& folder, std::vector<std::string> const& arguments) {
    auto ended = overturn(folder, joined({"plan"}, arguments));
    ended.out = unwrapped(ended.out);
    return ended;
}

/// The command line of `mpirun -n ranks overturn ...`; --quiet keeps mpirun from commenting on exit codes.
inline std::vector<std::string> mpirun(int ranks, std::vector<std::string> const& arguments) {
    return joined({OVERTURN_MPIRUN, "--quiet", "-n", std::to_string(ranks), OVERTURN_PROGRAM}, arguments);
}

/// Waits until `condition` holds; false after half a minute without.
template <class Condition> bool comes_true(Condition&& condition) {
    constexpr int most = 6000;
    for (int i = 0; i < most; ++i) {
        if (condition()) {
            return true;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
}

/// How many finished blocks lie beside the output.
inline int blocks_done(Folder const& folder, std::string const& output) {
    int count = 0;
    std::error_code error;
    // Folders of blocks and those of rare events too; what comes and goes meanwhile is no matter.
    std::filesystem::recursive_directory_iterator at(folder / (output + ".parts"), error);
    for (; !error && at != std::filesystem::recursive_directory_iterator(); at.increment(error)) {
        count += at->path().filename().string().ends_with(".block") ? 1 : 0;
    }
    return count;
}

/// Exactly one line, of the form `overturn: problem (why) what to do`.
inline ::testing::AssertionResult is_one_error_line(std::string const& text) {
    auto const end = text.find('\n');
    if (!text.starts_with("overturn: ") || end != text.size() - 1) {
        return ::testing::AssertionFailure() << "not one line of ours: <" << text << ">";
    }
    auto const open = text.find(" (");
    auto const close = text.find(')', open);
    if (open == std::string::npos || close == std::string::npos || end - close < 5) {
        return ::testing::AssertionFailure() << "not 'problem (why) what to do': " << text;
    }
    return ::testing::AssertionSuccess();
}

/// Lines that were wrapped, as one.
inline std::string in_one_line(std::string text) {
    std::ranges::replace(text, '\n', ' ');
    return text;
}

}  // namespace overturn::testing
