#include "report/figure.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.hpp"
#include "report/detail/figure_folder.hpp"
#include "report/detail/package.hpp"

namespace overturn::report {
namespace {

namespace fs = std::filesystem;

constexpr char const* packages = "apt-get install python3 python3-matplotlib python3-h5py";

std::string interpreter() {
    if (char const* stated = std::getenv("OVERTURN_PYTHON"); stated != nullptr && *stated != '\0') {
        return stated;
    }
    constexpr char const* system_python = "/usr/bin/python3";
    return ::access(system_python, X_OK) == 0 ? system_python : "python3";
}

/// While it lives, signals that end a process are noted instead, so that its folder is removed before it ends.
class Stopped {
  public:
    Stopped() {
        seen_ = 0;
        struct sigaction action {};
        action.sa_handler = [](int signal) { seen_ = signal; };
        for (std::size_t i = 0; i < signals.size(); ++i) {
            ::sigaction(signals.at(i), &action, &before_.at(i));
        }
    }
    ~Stopped() {
        for (std::size_t i = 0; i < signals.size(); ++i) {
            ::sigaction(signals.at(i), &before_.at(i), nullptr);
        }
    }
    Stopped(Stopped const&) = delete;
    Stopped& operator=(Stopped const&) = delete;
    Stopped(Stopped&&) = delete;
    Stopped& operator=(Stopped&&) = delete;

    /// The signal, 0 if there was none.
    [[nodiscard]] static int by() { return seen_; }
    /// \throws SystemError if there was one
    static void check() {
        if (by() != 0) {
            throw SystemError(fmt::format("stopped by signal {} (no figure). Run the same command again", by()));
        }
    }

  private:
    static constexpr std::array signals{SIGTERM, SIGINT, SIGHUP};
    static inline volatile std::sig_atomic_t seen_ = 0;  // a handler reaches nothing else
    std::array<struct sigaction, signals.size()> before_{};
};

/// The exit code; standard error goes to `errors`.
int run(std::vector<std::string> arguments, std::string const& errors) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    constexpr int output_mode = 0600;
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 2, errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, output_mode);
    std::vector<char*> argv;
    argv.reserve(arguments.size() + 1);
    for (auto& argument : arguments) {
        argv.push_back(argument.data());
    }
    argv.push_back(nullptr);
    pid_t child = 0;
    int const failed = posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    constexpr int not_found = 127;
    if (failed != 0) {
        return not_found;
    }
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
        if (Stopped::by() != 0) {
            ::kill(child, SIGTERM);
        }
    }
    Stopped::check();
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string last_line_of(std::string const& path) {
    std::ifstream file(path);
    std::string last;
    for (std::string line; std::getline(file, line);) {
        last = line.empty() ? last : line;
    }
    return last;
}

void run_script(std::vector<std::string> const& arguments, std::string const& errors) {
    constexpr int not_found = 127;
    int const code = run(arguments, errors);
    if (code == not_found) {
        throw SystemError(
            fmt::format("{} missing (figures are drawn by Python). Install it: {}", arguments[0], packages));
    }
    if (code != 0) {
        auto const why = last_line_of(errors);
        throw SystemError(why.find("Install it: ") != std::string::npos
                              ? why
                              : fmt::format("no figure (Python: {}). If a package is broken: {}", why, packages));
    }
}

std::string extension_of(fs::path const& output) {
    auto extension = output.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return extension;
}

}  // namespace

void check_figure_name(fs::path const& output) {
    static constexpr std::array<std::string_view, 3> known{".svg", ".png", ".pdf"};
    validate(std::find(known.begin(), known.end(), extension_of(output)) != known.end(),
             "{}: not the name of a figure (its ending says the kind). End it in .svg, .png or .pdf", output.string());
}

namespace {

// Runs a script within `folder`; the figure's place.
fs::path drawn_in(FigureFolder const& folder, std::string_view script, nlohmann::ordered_json const& data,
                  std::string const& extension) {
    auto const input =
        folder.write("data.json", data.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    auto drawn = folder / ("figure" + extension);
    Stopped::check();
    // Isolated (-I): PYTHONPATH, PYTHONHOME and the folders of a user or of a cluster's modules are not looked at.
    run_script({interpreter(), "-IB", draw_script().string(), std::string(script), input, drawn.string()},
               (folder / "errors").string());
    return drawn;
}

}  // namespace

void draw_figure(std::string_view script, nlohmann::ordered_json const& data, fs::path const& output) {
    check_figure_name(output);
    Stopped const stopped;
    FigureFolder const folder;
    auto const drawn = drawn_in(folder, script, data, extension_of(output));
    std::error_code error;
    fs::copy_file(drawn, output, fs::copy_options::overwrite_existing, error);
    Stopped::check();
    validate(!error, "{}: cannot be written ({}). Choose another place", output.string(), error.message());
}

std::string figure_text(std::string_view script, nlohmann::ordered_json const& data, std::string const& kind) {
    Stopped const stopped;
    FigureFolder const folder;
    std::ifstream file(drawn_in(folder, script, data, kind), std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(file), {}};
    Stopped::check();
    return text;
}

}  // namespace overturn::report
