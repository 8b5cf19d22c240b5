#include "motion/detail/mapping_words.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

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
                                               "upwards:",
                                               "deg",
                                               "degrees",
                                               "data",
                                               "names"});
constexpr auto denials = std::to_array<Text>({"not", "no", "never", "except", "without", "station", "coordinates"});
constexpr auto channels = std::to_array<Text>({"ch", "chn", "chan", "channel", "canal", "kanal"});
constexpr auto places = std::to_array<Text>({"col", "column", "columna", "colonne", "spalte", "colonna"});

template <class Words> bool is_among(Text word, Words const& words) {
    return std::ranges::find(words, word) != words.end();
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_number(Text word) { return !word.empty() && std::ranges::all_of(word, is_digit); }

/// "ch2" of "ch2", "CH-2", "channel_2", "CHN(2)"; "col2" of columns; empty otherwise.
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

struct Word {
    std::string text;
    bool joined = false;   ///< by an equals sign, a colon or a bracket to the word before
    bool bracket = false;  ///< within one
};

/// The words of each clause, in lower case, with what joins them.
std::vector<std::vector<Word>> words_of(Text line) {
    auto lower = lowered(line);
    for (Text const arrow : {"\xE2\x86\x92", "->", "=>"}) {
        for (auto at = lower.find(arrow); at != std::string::npos; at = lower.find(arrow, at)) {
            lower.replace(at, arrow.size(), " = ");
        }
    }
    std::vector<std::vector<Word>> clauses(1);
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
void join_numbers(std::vector<Word>& words) {
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

/// A letter alone says a direction only behind a sign or in brackets; of figures, three are an azimuth.
ComponentName direction_in(Word const& word) {
    constexpr std::size_t azimuth = 3;
    bool const figures = is_digit(word.text.front());
    bool const letter = word.text.size() == 1;
    bool const any =
        figures ? is_number(word.text) && word.text.size() == azimuth : !letter || word.joined || word.bracket;
    return !any ? ComponentName{} : is_ascii(word.text) ? component_named(word.text) : component_in(word.text);
}

bool is_known(Text word) {
    return is_among(word, fillings) || unit_spelled(word, Dimension::acceleration).has_value()
           || unit_spelled(word, Dimension::time).has_value();
}

std::string stem_of(Text name) {
    auto stem = lowered(trimmed(name.substr(0, name.find_first_of("([{"))));
    std::erase(stem, ' ');
    return stem;
}

/// Behind "a", "acc", "accel" and an underscore: what says which it is.
Text behind_prefix(Text stem) {
    for (Text const prefix : {"acceleration", "accel", "acc", "a"}) {
        if (stem.starts_with(prefix) && stem.size() > prefix.size()) {
            auto const rest = stem.substr(prefix.size());
            return rest.substr(std::min(rest.find_first_not_of("_-."), rest.size()));
        }
    }
    return stem;
}

bool is_axis(Text word) { return word.size() == 1 && Text("xyzuvw").find(word[0]) != Text::npos; }

}  // namespace

std::vector<std::string> aliases_of(std::string_view name, std::size_t place) {
    auto const stem = stem_of(name);
    std::vector<std::string> aliases{fmt::format("col{}", place + 1)};
    if (!stem.empty() && stem != "a" && !is_known(stem)) {
        aliases.push_back(stem);
    }
    auto const rest = behind_prefix(stem);
    if (is_axis(rest) && rest != stem) {
        aliases.emplace_back(rest);
    }
    auto whole = lowered(name);
    std::erase_if(whole, [](char c) { return Text(" _-.()[]").find(c) != Text::npos; });
    if (auto channel = numbered(whole); !channel.empty()) {
        aliases.push_back(std::move(channel));
    }
    return aliases;
}

bool is_axis_name(std::string_view name) {
    auto const stem = stem_of(name);
    auto const rest = behind_prefix(stem);
    return is_axis(rest) || is_number(rest) || component_in(name).direction == Direction::unknown;
}

namespace {

using Aliases = std::vector<std::vector<std::string>>;

std::optional<std::size_t> column_of(Word const& word, Aliases const& aliases) {
    auto const own = std::ranges::find_if(
        aliases, [&](auto const& names) { return std::ranges::find(names, word.text) != names.end(); });
    return own == aliases.end() ? std::nullopt : std::optional(static_cast<std::size_t>(own - aliases.begin()));
}

/// "x: NS", "y = positive up": a column and what a sign or a bracket joins to it, each in turn.
std::vector<MappingToken> joined_pairs(std::vector<Word> const& words, Aliases const& aliases) {
    std::vector<MappingToken> pairs;
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        auto const column = column_of(words[i], aliases);
        auto at = i + 1;
        if (!column || !words[at].joined) {
            continue;
        }
        auto const says_none = [&](Word const& word) {
            return is_known(word.text) && direction_in(word).direction == Direction::unknown;
        };
        while (at < words.size() && says_none(words[at]) && !column_of(words[at], aliases)) {
            ++at;
        }
        auto const direction = at < words.size() ? direction_in(words[at]) : ComponentName{};
        if (direction.direction != Direction::unknown) {
            pairs.push_back({MappingToken::Kind::column, *column, {}, false});
            pairs.push_back({MappingToken::Kind::direction, 0, direction, true});
            i = at;
        }
    }
    return pairs;
}

MappingClause clause_of(std::vector<Word> const& words, Aliases const& aliases) {
    if (auto pairs = joined_pairs(words, aliases); !pairs.empty()) {
        return {std::move(pairs), false};
    }
    MappingClause clause;
    for (auto const& word : words) {
        auto const direction = direction_in(word);
        if (auto const column = column_of(word, aliases)) {
            clause.tokens.push_back({MappingToken::Kind::column, *column, direction, word.joined});
        } else if (direction.direction != Direction::unknown) {
            clause.tokens.push_back({MappingToken::Kind::direction, 0, direction, word.joined});
        } else {
            clause.wordy = clause.wordy || !is_known(word.text);
        }
    }
    return clause;
}

}  // namespace

std::vector<MappingClause> mapping_clauses(std::string_view line,
                                           std::vector<std::vector<std::string>> const& aliases) {
    std::vector<MappingClause> clauses;
    for (auto& words : words_of(line)) {
        join_numbers(words);
        if (std::ranges::none_of(words, [](Word const& word) { return is_among(word.text, denials); })) {
            clauses.push_back(clause_of(words, aliases));
        }
    }
    return clauses;
}

}  // namespace overturn
