#include "motion/detail/prose_words.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "core/digit.hpp"
#include "core/units.hpp"
#include "motion/column_unit.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

// What may stand between a column and its direction.
constexpr auto fillings = std::to_array<Text>({"is",
                                               "are",
                                               "as",
                                               "the",
                                               "axis",
                                               "axes",
                                               "direction",
                                               "directions",
                                               "dir",
                                               "component",
                                               "comp",
                                               "components",
                                               "column",
                                               "columns",
                                               "points",
                                               "pointing",
                                               "positive",
                                               "to",
                                               "stands",
                                               "for",
                                               "means",
                                               "denotes",
                                               "corresponds",
                                               "corresponding",
                                               "represents",
                                               "motion",
                                               "accel",
                                               "acceleration",
                                               "accelerations",
                                               "acc",
                                               "ground",
                                               "of",
                                               "along",
                                               "in",
                                               "and",
                                               "with",
                                               "where",
                                               "sensor",
                                               "recorded",
                                               "channel",
                                               "channels",
                                               "here",
                                               "azimuth",
                                               "orientation",
                                               "oriented",
                                               "time",
                                               "t",
                                               "a",
                                               "es",
                                               "eje",
                                               "componente",
                                               "canal",
                                               "ist",
                                               "richtung",
                                               "komponente",
                                               "asse",
                                               "e",
                                               "positif",
                                               "positivo",
                                               "deg",
                                               "degrees",
                                               "data",
                                               "names",
                                               "order"});
constexpr auto denials = std::to_array<Text>({"not", "no", "never", "except", "without", "station", "coordinates"});
constexpr auto channels = std::to_array<Text>({"ch", "chn", "chan", "channel", "canal", "kanal"});
constexpr auto places = std::to_array<Text>({"col", "column", "columna", "colonne", "spalte", "colonna"});

template <class Words> bool is_among(Text word, Words const& words) {
    return std::ranges::find(words, word) != words.end();
}

bool is_number(Text word) { return !word.empty() && std::ranges::all_of(word, is_digit); }

std::string numbered(Text word, Text number) {
    while (!word.empty() && Text("_-.").find(word.back()) != Text::npos) {
        word.remove_suffix(1);
    }
    number = number.substr(std::min(number.find_first_not_of('0'), number.size()));
    if (!is_number(number)) {
        return {};
    }
    return is_among(word, channels) ? "ch" + std::string(number)
           : is_among(word, places) ? "col" + std::string(number)
                                    : std::string();
}

std::string numbered(Text word) {
    auto const begin = std::min(word.find_first_of("0123456789"), word.size());
    return numbered(word.substr(0, begin), word.substr(begin));
}

/// The words of each clause, in lower case, with what joins them.
std::vector<std::vector<ProseWord>> clauses_of(Text line) {
    auto lower = lowered(line);
    for (Text const arrow : {"\xE2\x86\x92", "->", "=>"}) {
        for (auto at = lower.find(arrow); at != std::string::npos; at = lower.find(arrow, at)) {
            lower.replace(at, arrow.size(), " = ");
        }
    }
    std::vector<std::vector<ProseWord>> clauses(1);
    std::string word;
    bool joined = false;
    int depth = 0;
    for (std::size_t i = 0; i <= lower.size(); ++i) {
        char const c = i < lower.size() ? lower[i] : ' ';
        bool const point = c == '.' && (i + 1 >= lower.size() || lower[i + 1] == ' ');
        if (Text(" \t=:,;|()[]{}#!%*\"'<>").find(c) == Text::npos && !point) {
            word += c;
            continue;
        }
        while (!word.empty() && Text("-_").find(word.back()) != Text::npos) {
            word.pop_back();
        }
        if (word.find_first_not_of("-_/+") != std::string::npos) {
            clauses.back().push_back({word, joined, depth > 0});
            joined = false;
        }
        word.clear();
        joined = joined || Text("=:([").find(c) != Text::npos;
        depth = std::max(depth + (c == '(' || c == '[' ? 1 : c == ')' || c == ']' ? -1 : 0), 0);
        if (Text(",;|").find(c) != Text::npos) {
            clauses.emplace_back();
            joined = false;
        }
    }
    return clauses;
}

/// "channel" and "2" are "ch2".
void join_numbers(std::vector<ProseWord>& words) {
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        if (auto whole = numbered(words[i].text, words[i + 1].text); !whole.empty()) {
            words[i].text = std::move(whole);
            words.erase(words.begin() + static_cast<std::ptrdiff_t>(i) + 1);
        }
    }
    for (auto& word : words) {
        auto whole = numbered(word.text);
        word.text = whole.empty() ? word.text : std::move(whole);
    }
}

bool is_ascii(Text word) {
    return std::ranges::all_of(word, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

}  // namespace

std::vector<std::vector<ProseWord>> prose_words(std::string_view line) {
    auto clauses = clauses_of(line);
    std::ranges::for_each(clauses, join_numbers);
    return clauses;
}

std::string numbered_name(std::string_view word) { return numbered(word); }

ComponentName direction_in(ProseWord const& word) {
    constexpr std::size_t azimuth = 3;
    bool const figures = is_digit(word.text.front());
    bool const letter = word.text.size() == 1;
    bool const any =
        figures ? is_number(word.text) && word.text.size() == azimuth : !letter || word.joined || word.bracket;
    return !any ? ComponentName{} : is_ascii(word.text) ? component_named(word.text) : component_in(word.text);
}

bool is_filling_word(std::string_view word) {
    return is_among(word, fillings) || unit_spelled(word, Dimension::acceleration).has_value()
           || unit_spelled(word, Dimension::time).has_value();
}

bool denies(std::vector<ProseWord> const& words) {
    return std::ranges::any_of(words, [](ProseWord const& word) { return is_among(word.text, denials); });
}

}  // namespace overturn
