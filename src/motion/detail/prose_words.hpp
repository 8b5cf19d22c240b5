/// The words of a line of prose that says which column is which, each with what joins it to the one before.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "motion/component_name.hpp"

namespace overturn {

struct ProseWord {
    std::string text;      ///< in lower case; a channel or a column with its number is one word, "ch2", "col3"
    bool joined = false;   ///< by an equals sign, a colon or a bracket to the word before
    bool bracket = false;  ///< within one
};

/// Words of each clause, between commas, semicolons and bars.
[[nodiscard]] std::vector<std::vector<ProseWord>> prose_words(std::string_view line);

/// "ch2" of "ch2", "CH-2", "channel_2", "CHN(2)"; "col2" of columns; empty otherwise.
[[nodiscard]] std::string numbered_name(std::string_view word);

/// The direction that a word says: a letter alone only behind a sign or in brackets; of figures, three are an azimuth.
[[nodiscard]] ComponentName direction_in(ProseWord const& word);

/// May it stand between a column and its direction: "is", "axis", a unit?
[[nodiscard]] bool is_filling_word(std::string_view word);

/// "not", "station": of no column at all, or not so.
[[nodiscard]] bool denies(std::vector<ProseWord> const& words);

}  // namespace overturn
