#include "motion/detail/vertical_token.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/digit.hpp"
#include "core/units.hpp"
#include "motion/component_name.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

std::vector<Text> tokens_of_line(Text lower) {
    std::vector<Text> tokens;
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= lower.size(); ++i) {
        auto const c = i < lower.size() ? static_cast<unsigned char>(lower[i]) : static_cast<unsigned char>(' ');
        bool const within = (c >= 'a' && c <= 'z') || is_digit(c) || c >= 0x80;
        if (!within) {
            if (i > begin) {
                tokens.push_back(lower.substr(begin, i - begin));
            }
            begin = i + 1;
        }
    }
    return tokens;
}

/// HNZ, and what ends in it: "abchnz".
bool ends_in_vertical_channel(Text token) {
    constexpr std::size_t letters = 3;
    return token.size() >= letters && token.ends_with('z') && Text("lngh").find(token[token.size() - 2]) != Text::npos
           && Text("hbeslmcd").find(token[token.size() - letters]) != Text::npos;
}

bool is_vertical_token(Text token) {
    constexpr auto known = std::to_array<Text>({"z", "v", "ud", "du", "up", "updown", "down", "upward", "upwards",
                                                "downward", "downwards", "vert", "vertical", "vertically", "dwn"});
    return std::ranges::find(known, token) != known.end() || token.starts_with("vertic")
           || (token.size() > 1 && is_vertical(direction_of(token))) || ends_in_vertical_channel(token);
}

/// A letter says a horizontal one only beside a letter of the vertical.
bool is_horizontal_token(Text token, bool letters) {
    return !is_digit(token.front()) && (letters || token.size() > 1) && direction_of(token) == Direction::horizontal;
}

bool is_height(Text token) {
    constexpr auto heights =
        std::to_array<Text>({"altitude", "elevation", "depth", "height", "elev", "alt", "intensity"});
    return std::ranges::find(heights, token) != heights.end();
}

/// "dip -90": upright, as SEED has it, but of a fault none; empty otherwise.
std::string dip_in(Text lower) {
    for (Text const of_fault : {"fault", "strike", "rake", "rupture"}) {
        if (lower.find(of_fault) != Text::npos) {
            return {};
        }
    }
    auto const words = parted_at(lower, " \t,;:=()[]#%!*");
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        double degrees = 0;
        constexpr double steep = 60;
        if (words[i] == "dip" && parse_number(words[i + 1], degrees) && std::abs(degrees) >= steep) {
            return std::string(words[i]) + " " + std::string(words[i + 1]);
        }
    }
    return {};
}

}  // namespace

std::vector<std::string> compass_words_in(std::string_view line) {
    constexpr auto words = std::to_array<Text>({"NS", "EW", "UD", "N-S", "E-W", "U-D", "SN", "WE", "DU"});
    constexpr std::size_t channel = 3;
    std::vector<std::string> found;
    for (auto const word : parted_at(line, " \t,;:=()[]{}#%!*/_.\"'<>|+")) {
        bool const seed = word.size() == channel && Text("HEB").find(word[0]) != Text::npos
                          && Text("NLG").find(word[1]) != Text::npos && Text("ZNE").find(word[2]) != Text::npos;
        if (seed || std::ranges::find(words, word) != words.end()) {
            found.emplace_back(word);
        }
    }
    return found;
}

std::string vertical_token_in(std::string_view lower) {
    auto const tokens = tokens_of_line(lower);
    if (auto dip = dip_in(lower); !dip.empty()) {
        return dip;
    }
    Text found;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        bool const height = tokens[i].size() == 1 && i > 0 && is_height(tokens[i - 1]);
        if (is_vertical_token(tokens[i]) && !height && found.size() < tokens[i].size()) {
            found = tokens[i];
        }
    }
    bool const beside =
        std::ranges::any_of(tokens, [&](Text token) { return is_horizontal_token(token, found.size() == 1); });
    return beside ? std::string() : std::string(found);
}

}  // namespace overturn
