#include "core/withheld.hpp"

#include <fmt/format.h>

namespace overturn {
namespace {

constexpr std::string_view mark = "overturn-withheld sha256 ";

}  // namespace

std::string withheld_text(std::string_view sha256, std::size_t bytes) {
    return fmt::format("{}{} of {} bytes\n", mark, sha256, bytes);
}

bool is_withheld(std::string_view content) { return content.starts_with(mark); }

}  // namespace overturn
