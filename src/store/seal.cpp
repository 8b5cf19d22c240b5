#include "store/seal.hpp"

#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "store/durable.hpp"
#include "store/sha256.hpp"

namespace overturn::store {
namespace {

constexpr std::string_view mark = "\noverturn-seal sha256 ";

std::string line_of(std::string const& digits, std::uint64_t bytes) {
    return fmt::format("{}{} of {:020} bytes\n", mark, digits, bytes);
}

std::uint64_t line_length() {
    static auto const length = line_of(std::string(64, '0'), 0).size();
    return length;
}

[[noreturn]] void fail(std::filesystem::path const& path) {
    throw SystemError(fmt::format("cannot read {} (a failing disk?). Check the disk and retry", path.string()));
}

std::string digits_of(std::ifstream& file, std::uint64_t bytes, std::filesystem::path const& path) {
    constexpr std::uint64_t at_once = 1 << 20;
    Sha256 hash;
    std::vector<char> part(at_once);
    for (auto left = bytes; left > 0;) {
        auto const size = std::min(left, at_once);
        if (!file.read(part.data(), size)) {
            fail(path);
        }
        hash.add(std::as_bytes(std::span(part).first(size)));
        left -= size;
    }
    return hash.digits();
}

}  // namespace

void seal(std::filesystem::path const& path) {
    auto const bytes = std::filesystem::file_size(path);
    std::ifstream file(path, std::ios::binary);
    auto const line = line_of(digits_of(file, bytes, path), bytes);
    append(path, std::as_bytes(std::span(line)));
}

Seal seal_of(std::filesystem::path const& path) {
    std::error_code error;
    auto const size = std::filesystem::file_size(path, error);
    if (error) {
        fail(path);
    }
    if (size < line_length()) {
        return Seal::missing;
    }
    auto const bytes = size - line_length();
    std::ifstream file(path, std::ios::binary);
    auto const digits = digits_of(file, bytes, path);
    std::string line(line_length(), '\0');
    if (!file.read(line.data(), line.size())) {
        fail(path);
    }
    if (line == line_of(digits, bytes)) {
        return Seal::intact;
    }
    // One damaged letter of the mark is damage, not another program's work.
    return line.find("seal") != std::string::npos || line.find("sha256") != std::string::npos ? Seal::broken
                                                                                              : Seal::missing;
}

std::string sealed_digest(std::filesystem::path const& path) {
    auto const size = std::filesystem::file_size(path);
    if (size < line_length()) {
        return {};
    }
    std::ifstream file(path, std::ios::binary);
    file.seekg(size - line_length());
    std::string line(line_length(), '\0');
    if (!file.read(line.data(), line.size())) {
        fail(path);
    }
    constexpr std::size_t digits = 64;
    return line.starts_with(mark) ? line.substr(mark.size(), digits) : std::string();
}

}  // namespace overturn::store
