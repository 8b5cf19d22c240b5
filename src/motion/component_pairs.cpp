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

// Where a direction may stand: the last word before the extension (or its end, behind a number or small letters), the
// extension, a folder. In between, a word says what the motion is of.
std::vector<std::pair<std::size_t, std::size_t>> places_of(std::string_view name) {
    std::vector<std::pair<std::size_t, std::size_t>> places;
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
    auto end = dot;
    while (end > file && !is_word(name[end - 1])) {
        --end;
    }
    auto begin = end;
    while (begin > file && is_word(name[begin - 1])) {
        --begin;
    }
    places.emplace_back(begin, end - begin);
    for (std::size_t const length : {1U, 2U, 3U}) {  // "TCU068N", "kobeNS", "KJM000"
        auto const at = end - length;
        bool const fits = end - begin > length;
        bool const azimuth = length == 3 && fits && is_digit(name[at]) && is_digit(name[at + 1])
                             && is_digit(name[at + 2]) && !is_digit(name[at - 1]);
        bool const letters = length < 3 && fits && std::isupper(static_cast<unsigned char>(name[at])) != 0
                             && std::isupper(static_cast<unsigned char>(name[at - 1])) == 0;
        if (azimuth || letters) {
            places.emplace_back(at, length);
        }
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
        // "x.csv" and "y.csv", "H1.csv" and "H2.csv" may be any two motions.
        bool const alone = around.first.empty() && (one.size() < 2 || is_digit(one.back()));
        if (!alone && are_square(one, other)) {
            pairs.emplace(std::min(first, second), std::max(first, second));
        }
    }
    return {pairs.begin(), pairs.end()};
}

}  // namespace overturn
