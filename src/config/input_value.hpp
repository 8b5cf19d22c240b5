/// The values a campaign was read with, and where each comes from by its own word.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/units.hpp"

namespace overturn::config {

/// Origin of a value. by_default: no file states it, the program does.
enum class Basis { published, measured, assumed, not_stated, by_default };

/// "published", "measured", "assumed", "not stated", "default"
[[nodiscard]] std::string_view name_of(Basis basis);

/// A stretch of a file's text, lines and columns from 1, columns counted in characters; the end is behind the last.
struct TextSpan {
    int line = 0, column = 0, end_line = 0, end_column = 0;

    [[nodiscard]] bool is_known() const { return line > 0; }
};

/// One value that was read, or a default that stood in for it.
struct InputValue {
    std::string key;   ///< "bodies[0].mass"; of a file that a table names, below that table
    std::string text;  ///< as written: "12.6 t"; lists on one line
    Basis basis = Basis::not_stated;
    std::string source;                     ///< empty: none stated
    std::vector<std::string> range = {};    ///< lowest and highest plausible value as written; empty: none stated
    std::optional<double> number = {};      ///< [SI] of a value that was read as a number
    Dimension dimension = Dimension::none;  ///< of that number
    std::string file = {};                  ///< that states it; of a default, the campaign
    TextSpan span = {};                     ///< its place there; unknown for --set and defaults
    int depth = 0;                          ///< 0: the document itself, 1: a file that it names
};

}  // namespace overturn::config
