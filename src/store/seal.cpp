#include "store/seal.hpp"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "store/durable.hpp"
#include "store/sha256.hpp"

namespace overturn::store {
namespace {

constexpr std::string_view mark = "\noverturn-seal sha256 ";
constexpr std::string_view mark_of_stretches = "\noverturn-seal sha256 of the sha256 of every 64 MiB ";
static_assert(file_stretch == std::uint64_t{64} << 20U, "the mark names it");

std::string line_of(std::string_view begin, std::string const& digits, std::uint64_t bytes) {
    return fmt::format("{}{} of {:020} bytes\n", begin, digits, bytes);
}

std::uint64_t line_length(std::string_view begin) { return line_of(begin, std::string(64, '0'), 0).size(); }

[[noreturn]] void fail(std::filesystem::path const& path) {
    throw SystemError(fmt::format("cannot read {} (a failing disk?). Check the disk and retry", path.string()));
}

// Up to one stretch: of the bytes themselves.
std::string sealed_line(std::filesystem::path const& path, std::uint64_t bytes, HashStretches const& hash,
                        StretchDigests known = {}) {
    auto const stretches = stretches_of(0, bytes, file_stretch);
    auto unknown = stretches;
    std::erase_if(unknown, [&](Stretch const& stretch) { return known.contains(stretch); });
    known.merge(hash(path, unknown));
    std::string digests;
    for (auto const& stretch : stretches) {
        digests += known.at(stretch);
    }
    return stretches.size() == 1 ? line_of(mark, digests, bytes) : line_of(mark_of_stretches, sha256(digests), bytes);
}

// The last bytes of a file: as many as the longer line has, or all.
std::string end_of(std::filesystem::path const& path, std::uint64_t size) {
    std::string end(std::min(size, line_length(mark_of_stretches)), '\0');
    std::ifstream file(path, std::ios::binary);
    file.seekg(static_cast<std::streamoff>(size - end.size()));
    if (!file.read(end.data(), static_cast<std::streamsize>(end.size()))) {
        fail(path);
    }
    return end;
}

}  // namespace

void seal(std::filesystem::path const& path, HashStretches const& hash, StretchDigests known) {
    auto const line = sealed_line(path, std::filesystem::file_size(path), hash, std::move(known));
    append(path, std::as_bytes(std::span(line)));
}

Seal seal_of(std::filesystem::path const& path) {
    std::error_code error;
    auto const size = std::filesystem::file_size(path, error);
    if (error) {
        fail(path);
    }
    if (size < line_length(mark)) {
        return Seal::missing;
    }
    auto const end = end_of(path, size);
    if (end.starts_with(mark_of_stretches)) {
        return end == sealed_line(path, size - end.size(), hash_stretches) ? Seal::intact : Seal::broken;
    }
    // Of one digest, as long files had before they were hashed in stretches.
    auto const line = std::string_view(end).substr(end.size() - line_length(mark));
    Stretch const whole{0, size - line.size()};
    if (line.starts_with(mark) && line == line_of(mark, hash_stretches(path, {whole}).at(whole), whole.bytes)) {
        return Seal::intact;
    }
    // One damaged letter of the line is damage, not another program's work.
    auto const holds = [&](char const* word) { return line.find(word) != std::string_view::npos; };
    return holds("seal") || holds("sha256") || line.ends_with(" bytes\n") ? Seal::broken : Seal::missing;
}

std::string sealed_digest(std::filesystem::path const& path) {
    auto const size = std::filesystem::file_size(path);
    if (size < line_length(mark)) {
        return {};
    }
    auto const end = end_of(path, size);
    constexpr std::size_t digits = 64;
    for (auto const begin : {mark_of_stretches, mark}) {
        auto const length = line_length(begin);
        auto const line = std::string_view(end).substr(end.size() - std::min<std::uint64_t>(length, end.size()));
        if (line.starts_with(begin)) {
            return std::string(line.substr(begin.size(), digits));
        }
    }
    return {};
}

}  // namespace overturn::store
