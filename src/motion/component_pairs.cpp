#include "motion/component_pairs.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "core/digit.hpp"
#include "motion/component_name.hpp"

namespace overturn {
namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

// A name around one of its words: "kobe_" and ".csv" of "NS".
using Around = std::pair<std::string, std::string>;

// A part of a name: where it begins, and its length.
using Part = std::pair<std::size_t, std::size_t>;

// The last word before `end`, not before `from`.
Part word_before(std::string_view name, std::size_t from, std::size_t end) {
    while (end > from && !is_word(name[end - 1])) {
        --end;
    }
    auto begin = end;
    while (begin > from && is_word(name[begin - 1])) {
        --begin;
    }
    return {begin, end - begin};
}

// A word and its end, behind a number or small letters: "TCU068N", "kobeNS", "KJM000", "1x", "sx".
void add_word(std::vector<Part>& places, std::string_view name, Part const& word) {
    auto const [begin, size] = word;
    places.push_back(word);
    for (std::size_t length = 1; length <= 3 && length < size; ++length) {
        auto const at = begin + size - length;
        bool const azimuth = length == 3 && is_digit(name[at]) && is_digit(name[at + 1]) && is_digit(name[at + 2])
                             && !is_digit(name[at - 1]);
        bool const letters = length < 3 && std::isupper(static_cast<unsigned char>(name[at])) != 0
                             && std::isupper(static_cast<unsigned char>(name[at - 1])) == 0;
        bool const axis = length == 1 && (name[at] == 'x' || name[at] == 'y') && (size == 2 || is_digit(name[at - 1]));
        if (azimuth || letters || axis) {
            places.emplace_back(at, length);
        }
    }
}

// Where a direction may stand: the last word before the extension, that before a number, the extension, a folder. In
// between, a word says what the motion is of.
std::vector<Part> places_of(std::string_view name) {
    std::vector<Part> places;
    auto const file = name.rfind('/') == std::string_view::npos ? 0 : name.rfind('/') + 1;
    for (std::size_t folder = 0; folder < file;) {
        auto const end = name.find('/', folder);
        places.emplace_back(folder, end - folder);
        folder = end + 1;
    }
    auto const dot =
        name.rfind('.') == std::string_view::npos || name.rfind('.') <= file ? name.size() : name.rfind('.');
    if (dot + 1 < name.size()) {
        places.emplace_back(dot + 1, name.size() - dot - 1);
    }
    auto const last = word_before(name, file, dot);
    add_word(places, name, last);
    if (std::ranges::all_of(name.substr(last.first, last.second), is_digit)) {  // "hx_1"
        add_word(places, name, word_before(name, file, last.first));
    }
    return places;
}

std::optional<ComponentName> horizontal(std::string_view word) {
    auto const named = component_named(word);
    bool const single_number = word.size() < 3 && !word.empty() && is_digit(word[0]);
    return named.direction == Direction::horizontal && !single_number ? std::optional(named) : std::nullopt;
}

// North and east, 000 and 090, X and Y, H1 and H2; not east and west.
bool are_square(std::string_view one, std::string_view other) {
    auto const a = horizontal(one);
    auto const b = horizontal(other);
    if (!a || !b || a->axis == b->axis) {
        return false;
    }
    constexpr double square = 90;
    constexpr double nearly = 1;
    auto const between = degrees_between(*a, *b);
    return !between || std::abs(*between - square) < nearly;
}

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> component_pairs(std::span<std::string const> names) {
    std::map<Around, std::map<std::string, std::size_t>> words;
    for (std::size_t i = 0; i < names.size(); ++i) {
        for (auto const& [at, length] : places_of(names[i])) {
            Around around{names[i].substr(0, at), names[i].substr(at + length)};
            words[std::move(around)].emplace(names[i].substr(at, length), i);
        }
    }
    std::set<std::pair<std::size_t, std::size_t>> pairs;
    for (auto const& [around, of] : words) {
        if (of.size() != 2) {
            continue;
        }
        auto const& [one, first] = *of.begin();
        auto const& [other, second] = *of.rbegin();
        // "x.csv" and "y.csv", "H1.csv" and "H2.csv" may be any two motions; "x_1.csv" and "y_1.csv" are not.
        bool const no_more = around.second.empty() || around.second.front() == '.';
        bool const alone = around.first.empty() && no_more && (one.size() < 2 || is_digit(one.back()));
        if (!alone && are_square(one, other)) {
            pairs.emplace(std::min(first, second), std::max(first, second));
        }
    }
    return {pairs.begin(), pairs.end()};
}

}  // namespace overturn
