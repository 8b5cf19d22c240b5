#include "core/texts_of.hpp"

#include <algorithm>
#include <span>

#include <fmt/format.h>

namespace overturn {

std::string count_text(std::int64_t count, std::string_view one, std::string_view more) {
    return fmt::format("{} {}{}", count, count == 1 || more.empty() ? one : more,
                       count != 1 && more.empty() ? "s" : "");
}

std::string names_text(std::vector<std::string> const& names, std::size_t most) {
    auto const shown = std::min(most, names.size());
    auto const text = fmt::format("{}", fmt::join(std::span(names).first(shown), ", "));
    return shown == names.size() ? text : fmt::format("{} and {} more", text, names.size() - shown);
}

void TextsOf::add(std::string_view text, std::string_view name) {
    if (text.empty()) {
        return;
    }
    auto found = std::ranges::find(entries_, text, &Entry::text);
    if (found == entries_.end()) {
        found = entries_.insert(found, {std::string(text), {}});
    }
    found->names.emplace_back(name);
}

}  // namespace overturn
