#include "core/withheld.hpp"

#include <fmt/format.h>

namespace overturn {
namespace {

constexpr std::string_view mark = "overturn-withheld sha256 ";
constexpr std::string_view recording_mark = "recording ";

}  // namespace

std::string withheld_text(std::string_view sha256, std::size_t bytes, std::string_view recording) {
    auto const text = fmt::format("{}{} of {} bytes\n", mark, sha256, bytes);
    return recording.empty() ? text : text + fmt::format("{}{}\n", recording_mark, recording);
}

std::string recording_of_withheld(std::string_view text) {
    auto const at = text.find(recording_mark);
    if (at == std::string_view::npos) {
        return {};
    }
    auto const value = text.substr(at + recording_mark.size());
    return std::string(value.substr(0, value.find('\n')));
}

bool is_withheld(std::string_view content) { return content.starts_with(mark); }

}  // namespace overturn
