#include "output/csv.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <memory>

#include <fmt/format.h>

#include "core/error.hpp"
#include "store/durable.hpp"

namespace overturn::output {
namespace {

[[noreturn]] void fail(std::filesystem::path const& path) {
    throw SystemError(fmt::format("cannot write {} ({}). Free space, or choose another folder with -o", path.string(),
                                  std::strerror(errno)));
}

// Text that a cell's edge, a quote or a line's end would break is quoted.
void append_text(fmt::memory_buffer& out, std::string_view text) {
    if (text.find_first_of(",\"\n\r") == std::string_view::npos) {
        out.append(text);
        return;
    }
    out.push_back('"');
    for (char const c : text) {
        if (c == '"') {
            out.push_back('"');
        }
        out.push_back(c);
    }
    out.push_back('"');
}

void append_cell(fmt::memory_buffer& out, SheetCell const& cell) {
    if (auto const* const number = std::get_if<double>(&cell)) {
        fmt::format_to(std::back_inserter(out), "{}", *number);
    } else if (auto const* const count = std::get_if<std::int64_t>(&cell)) {
        fmt::format_to(std::back_inserter(out), "{}", *count);
    } else if (auto const* const text = std::get_if<std::string_view>(&cell)) {
        append_text(out, *text);
    }
}

// Lines gathered until they are worth a write.
class Lines {
  public:
    explicit Lines(std::filesystem::path const& path)
        : path_(path), file_(std::fopen(path.c_str(), "wb"), &std::fclose) {
        if (!file_) {
            fail(path_);
        }
    }
    template <class Append> void add(std::size_t cells, Append append) {
        for (std::size_t c = 0; c < cells; ++c) {
            if (c > 0) {
                out_.push_back(',');
            }
            append(out_, c);
        }
        out_.push_back('\n');
        constexpr std::size_t worth_it = 1 << 20U;
        if (out_.size() >= worth_it) {
            flush();
        }
    }
    void close() {
        flush();
        if (std::fclose(file_.release()) != 0) {
            fail(path_);
        }
    }

  private:
    void flush() {
        if (std::fwrite(out_.data(), 1, out_.size(), file_.get()) != out_.size()) {
            fail(path_);
        }
        out_.clear();
    }
    std::filesystem::path path_;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
    fmt::memory_buffer out_;
};

}  // namespace

void write_csv(std::filesystem::path const& path, Sheet const& sheet) {
    store::FileInWork file(path);
    Lines lines(file.beside());
    lines.add(sheet.columns.size(),
              [&](fmt::memory_buffer& out, std::size_t c) { append_text(out, sheet.columns[c].title()); });
    sheet.each_row([&](std::span<SheetCell const> row) {
        lines.add(row.size(), [&](fmt::memory_buffer& out, std::size_t c) { append_cell(out, row[c]); });
    });
    lines.close();
    file.keep();
}

}  // namespace overturn::output
