#include "motion/detail/mapping_words.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/digit.hpp"
#include "core/units.hpp"
#include "motion/detail/prose_words.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

bool is_number(Text word) { return !word.empty() && std::ranges::all_of(word, is_digit); }

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
    if (!stem.empty() && stem != "a" && !is_filling_word(stem)) {
        aliases.push_back(stem);
    }
    auto const rest = behind_prefix(stem);
    if (is_axis(rest) && rest != stem) {
        aliases.emplace_back(rest);
    }
    auto whole = lowered(name);
    std::erase_if(whole, [](char c) { return Text(" _-.()[]").find(c) != Text::npos; });
    if (auto channel = numbered_name(whole); !channel.empty()) {
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

std::optional<std::size_t> column_of(ProseWord const& word, Aliases const& aliases) {
    auto const own = std::ranges::find_if(
        aliases, [&](auto const& names) { return std::ranges::find(names, word.text) != names.end(); });
    return own == aliases.end() ? std::nullopt : std::optional(static_cast<std::size_t>(own - aliases.begin()));
}

/// "x: NS", "y = positive up": a column and what a sign or a bracket joins to it, each in turn.
std::vector<MappingToken> joined_pairs(std::vector<ProseWord> const& words, Aliases const& aliases) {
    std::vector<MappingToken> pairs;
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        auto const column = column_of(words[i], aliases);
        auto at = i + 1;
        if (!column || !words[at].joined) {
            continue;
        }
        auto const says_none = [&](ProseWord const& word) {
            return is_filling_word(word.text) && direction_in(word).direction == Direction::unknown;
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

MappingClause clause_of(std::vector<ProseWord> const& words, Aliases const& aliases) {
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
            clause.wordy = clause.wordy || !is_filling_word(word.text);
        }
    }
    return clause;
}

}  // namespace

std::vector<MappingClause> mapping_clauses(std::string_view line,
                                           std::vector<std::vector<std::string>> const& aliases) {
    std::vector<MappingClause> clauses;
    for (auto const& words : prose_words(line)) {
        if (!denies(words)) {
            clauses.push_back(clause_of(words, aliases));
        }
    }
    return clauses;
}

std::vector<std::string> listed_directions(std::string_view line) {
    std::vector<std::string> all;
    std::vector<std::string> words;
    bool known = true;
    for (auto const& clause : prose_words(line)) {
        for (auto const& word : clause) {
            bool const letter = word.text.size() == 1;
            bool const direction = !is_digit(word.text.front())
                                   && component_in(word.text).direction != Direction::unknown
                                   && (letter || component_named(word.text).direction != Direction::unknown);
            if (direction) {
                all.push_back(word.text);
            } else {
                known = known && is_filling_word(word.text);
            }
            if (direction && !letter) {
                words.push_back(word.text);
            }
        }
    }
    return known ? all : words;
}

}  // namespace overturn
