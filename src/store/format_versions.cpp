#include "store/format_versions.hpp"

#include <array>

#include <fmt/format.h>

namespace overturn::store {
namespace {

/// An error whose last files are of a version: whoever mends one that touched results adds a line, and gives the format
/// its next number if the version does not tell the files apart.
struct KnownError {
    std::int64_t last_version;
    char const* text;
};

constexpr std::array known_errors{
    KnownError{
        1, "impacts of early files lie up to 8 % of a step away where the forcing changes fast (mended in bb5d42d)"},
    KnownError{1, "contact of early files may be lost up to 2 ms late in samples of 0.05 s (mended in a8b8acc)"},
    KnownError{
        3,
        "hclpf of files without a drawn beta_u is the 5 % point of one curve; that of drawn bodies has intervals "
        "that leave the split out; curves leave undecided trials out"},
    KnownError{1, "intervals of the earliest files leave undecided trials out (mended in 0f4925a)"},
};

}  // namespace

std::string known_errors_of(std::int64_t version) {
    std::string text;
    for (auto const& error : known_errors) {
        if (version <= error.last_version) {
            text += fmt::format("{}{}", text.empty() ? " Known of its version: " : "; ", error.text);
        }
    }
    return text;
}

}  // namespace overturn::store
