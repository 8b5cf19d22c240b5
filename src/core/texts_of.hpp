/// Numbers of things in words, and the same text about several things, once.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace overturn {

/// "1 wave", "40 waves". \param more of other numbers than one, where it is not `one` with an s
[[nodiscard]] std::string count_text(std::int64_t count, std::string_view one, std::string_view more = {});

/// "a, b, c and 4 more".
[[nodiscard]] std::string names_text(std::vector<std::string> const& names, std::size_t most = 3);

/// Texts in the order in which they came, each with the names of what it is about.
class TextsOf {
  public:
    struct Entry {
        std::string text;
        std::vector<std::string> names;
    };

    /// An empty text is none.
    void add(std::string_view text, std::string_view name);
    [[nodiscard]] std::vector<Entry> const& entries() const { return entries_; }

  private:
    std::vector<Entry> entries_;
};

}  // namespace overturn
