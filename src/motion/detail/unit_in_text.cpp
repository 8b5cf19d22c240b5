#include "motion/detail/unit_in_text.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "core/digit.hpp"
#include "core/units.hpp"
#include "motion/column_unit.hpp"
#include "motion/component_name.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

constexpr Text edges = " \t:=.#!;,\"'";

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

Text without_edges(Text text) {
    text = text.substr(std::min(text.find_first_not_of(edges), text.size()));
    auto const end = text.find_last_not_of(" \t:=;,.\"'");
    return end == Text::npos ? Text{} : text.substr(0, end + 1);
}

/// What stands in the outermost brackets.
std::vector<Text> in_brackets(Text line) {
    std::vector<Text> found;
    int depth = 0;
    std::size_t open = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        bool const opens = line[i] == '(' || line[i] == '[';
        bool const closes = line[i] == ')' || line[i] == ']';
        open = opens && depth == 0 ? i : open;
        depth += opens ? 1 : closes ? -1 : 0;
        if (closes && depth == 0) {
            found.push_back(line.substr(open + 1, i - open - 1));
        }
        depth = std::max(depth, 0);
    }
    return found;
}

/// Behind "unit", "units of", "unit =".
Text behind_key(Text line) {
    Text key = "unit";
    for (Text const other : {"einheit", "unidad", "unit\xC3\xA9"}) {
        key = line.find(other) != Text::npos ? other : key;
    }
    auto const at = line.find(key);
    if (at == Text::npos || (at > 0 && is_letter(line[at - 1]))) {
        return {};
    }
    auto rest = line.substr(at + key.size());
    rest = rest.substr(rest.starts_with('s') ? 1 : 0);
    bool const marked = !rest.empty() && Text(" :=").find(rest.front()) != Text::npos;
    rest = without_edges(rest);
    for (Text const word : {"are ", "is ", "of ", "in "}) {
        rest = rest.substr(rest.starts_with(word) ? word.size() : 0);
    }
    return marked ? without_edges(rest) : Text{};
}

Text behind_in(Text line) {
    auto const at = line.find(" in ");
    return at == Text::npos ? Text{} : without_edges(line.substr(at + Text(" in ").size()));
}

std::vector<Text> between_commas(Text line) {
    std::vector<Text> parts;
    while (!line.empty()) {
        auto const end = std::min(line.find_first_of(",;"), line.size());
        parts.push_back(without_edges(line.substr(0, end)));
        line = line.substr(std::min(end + 1, line.size()));
    }
    return parts;
}

/// The beginning of the word that names what is measured.
Text stem_of(Dimension dimension) {
    return dimension == Dimension::velocity ? "vel" : dimension == Dimension::length ? "displ" : "acc";
}

bool is_compound(Text text) { return text.find_first_of("/^%*0123456789") != Text::npos; }

}  // namespace

bool looks_like_unit(std::string_view text) {
    constexpr auto letters = std::to_array<Text>(
        {"m",  "cm", "mm",  "um",  "nm",     "in",      "ft",    "g",      "gal",   "mgal",   "gals",  "s",       "sec",
         "gn", "mg", "e",   "x",   "second", "seconds", "meter", "meters", "metre", "metres", "per",   "squared", "sq",
         "v",  "mv", "rad", "deg", "pa",     "kpa",     "n",     "kn",     "hz",    "count",  "counts"});
    bool any = false;
    for (std::size_t at = 0; at < text.size();) {
        auto const begin = at;
        while (at < text.size() && is_letter(text[at])) {
            ++at;
        }
        if (at > begin) {
            any = true;
            if (std::ranges::find(letters, text.substr(begin, at - begin)) == letters.end()) {
                return false;
            }
        } else if (static_cast<unsigned char>(text[at++]) >= 0x80) {
            return false;
        }
    }
    return any && component_named(text).direction == Direction::unknown;
}

UnitInText unit_in_text(std::string_view lower, Dimension dimension) {
    UnitInText in_text;
    auto const take = [&](Text text, bool is_unit) {
        text = without_edges(text);
        auto const si = text.empty() ? std::nullopt : unit_spelled(text, dimension);
        in_text.si = in_text.si ? in_text.si : si;
        if (!si && is_unit && looks_like_unit(text) && !unit_spelled(text, Dimension::time)
            && !unit_spelled(text, Dimension::frequency)) {
            in_text.unknown = text;
        }
    };
    bool const named = lower.find(stem_of(dimension)) != Text::npos;
    take(behind_key(lower), true);
    take(behind_in(lower), named);
    for (auto const text : in_brackets(lower)) {
        take(text, named);
    }
    for (auto const text : between_commas(lower)) {
        if (text.starts_with("% ") || text.find(':') != Text::npos) {
            continue;  // a comment's mark, or per cent? A key and its value, "x: 000"
        }
        take(text, is_compound(text) && text.find_first_of("abcdefghijklmnopqrstuvwxyz") != Text::npos
                       && text.size() == without_edges(lower).size());
    }
    // "acceleration g/10"; "acceleration 9.81 m/s2" is a quantity, or a factor
    auto const last = lower.find_last_of(" \t");
    if (named && last != Text::npos) {
        auto const word = lower.substr(last + 1);
        auto const before = trimmed(lower.substr(0, last));
        bool const share = before.ends_with(" of");  // "tenths of g"
        bool const factor = share || (!before.empty() && is_digit(before.back()));
        take(!factor && word.find_first_of("()[]") == Text::npos && (is_compound(word) || word == "g" || word == "gn")
                 ? word
                 : Text{},
             true);
    }
    return in_text;
}

}  // namespace overturn
