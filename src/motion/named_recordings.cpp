#include "motion/named_recordings.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <map>
#include <string_view>
#include <tuple>

#include "core/digit.hpp"
#include "motion/component_name.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

// What stands behind a direction, up to the extension: at most a number, what was done to the motion, or any word.
enum class Behind : std::uint8_t { nothing, processing, any_word };

// A name around one of its words: "kobe_" and ".csv" of "NS".
using Around = std::tuple<std::string, std::string, Behind>;

// A part of a name.
struct Part {
    std::size_t begin, size;
    Behind behind = Behind::nothing;

    [[nodiscard]] Text of(Text name) const { return name.substr(begin, size); }
};

template <std::size_t N> bool is_among(std::array<Text, N> const& words, Text word) {
    return std::ranges::find(words, Text(lowered(word))) != words.end();
}

constexpr auto processing = std::to_array<Text>({"acc", "accel", "acceleration", "filt", "filtered", "corr",
                                                 "corrected", "cor", "bp", "hp", "lp", "h", "raw", "processed"});
// A number behind one of these is that of a component.
constexpr auto components =
    std::to_array<Text>({"comp", "component", "hor", "horiz", "horizontal", "dir", "direction", "ch", "channel"});

// The last word before `end`, not before `from`.
Part word_before(Text name, std::size_t from, std::size_t end) {
    while (end > from && !is_word(name[end - 1])) {
        --end;
    }
    auto begin = end;
    while (begin > from && is_word(name[begin - 1])) {
        --begin;
    }
    return {begin, end - begin};
}

bool is_upper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }

// An end of a word that is a direction behind a number or small letters: "TCU068N", "kobeNS", "q1ns", "KJM000", "1x".
bool is_direction(Text word, std::size_t length) {
    auto const end = word.substr(word.size() - length);
    char const before = word[word.size() - length - 1];
    bool const azimuth = length == 3 && std::ranges::all_of(end, is_digit) && !is_digit(before);
    bool const letters = length < 3 && is_upper(end[0]) && !is_upper(before);
    bool const axis = length == 1 && Text("xyz").find(end[0]) != Text::npos && (word.size() == 2 || is_digit(before));
    return azimuth || letters || axis || end == "ns" || end == "ew" || end == "ud";
}

// A word, its end, and what stands before its last digit: "NS1" of KiK-net.
void add_word(std::vector<Part>& places, Text name, Part const& word) {
    places.push_back(word);
    for (std::size_t length = 1; length <= 3 && length < word.size; ++length) {
        if (is_direction(word.of(name), length)) {
            places.push_back({word.begin + word.size - length, length, word.behind});
        }
    }
    constexpr std::size_t letters = 2;
    if (word.size > letters && is_digit(name[word.begin + word.size - 1]) && word.behind == Behind::nothing) {
        Part const direction{word.begin + word.size - 1 - letters, letters};
        if (is_among(std::to_array<Text>({"ns", "ew", "ud"}), direction.of(name))) {
            places.push_back(direction);
        }
    }
}

// Where a direction may stand: the last word before the extension, that before a number or one more word, the
// extension, a folder.
std::vector<Part> places_of(Text name) {
    std::vector<Part> places;
    auto const file = name.rfind('/') == Text::npos ? 0 : name.rfind('/') + 1;
    for (std::size_t folder = 0; folder < file;) {
        auto const end = name.find('/', folder);
        places.push_back({folder, end - folder});
        folder = end + 1;
    }
    auto const dot = name.rfind('.') == Text::npos || name.rfind('.') <= file ? name.size() : name.rfind('.');
    if (dot + 1 < name.size()) {
        places.push_back({dot + 1, name.size() - dot - 1});
    }
    auto const last = word_before(name, file, dot);
    add_word(places, name, last);
    auto before = word_before(name, file, last.begin);
    if (std::ranges::all_of(last.of(name), is_digit)) {  // "hx_1"
        add_word(places, name, before);
        if (is_among(components, before.of(name))) {
            places.push_back({before.begin, last.begin + last.size - before.begin});
        }
    } else if (std::ranges::all_of(last.of(name), is_letter) && before.size > 0) {  // "q1_NS_acc"
        before.behind = is_among(processing, last.of(name)) ? Behind::processing : Behind::any_word;
        add_word(places, name, before);
    }
    return places;
}

bool is_azimuth(Text word) { return word.size() == 3 && std::ranges::all_of(word, is_digit); }

// "ch1", "Dir 2", "Channel_3": of these the third is upright.
ComponentName numbered(Text word) {
    auto const is_named = [&](Text name) {
        auto const rest = word.substr(std::min(name.size(), word.size()));
        return lowered(word.substr(0, name.size())) == name && !rest.empty() && rest.size() <= 2
               && (rest.size() == 1 || !is_word(rest[0]));
    };
    char const number = word.empty() ? ' ' : word.back();
    if (number < '1' || number > '3' || std::ranges::none_of(components, is_named)) {
        return {};
    }
    return number == '3' ? ComponentName{Direction::up, {}} : ComponentName{Direction::horizontal, {number}};
}

ComponentName direction_named(Text word) {
    if (auto one = numbered(word); one.direction != Direction::unknown) {
        return one;
    }
    bool const single_number = word.size() < 3 && !word.empty() && is_digit(word[0]);
    auto const lower = lowered(word);
    return single_number    ? ComponentName{}
           : lower == "rad" ? ComponentName{Direction::horizontal, "r"}
           : lower == "trn" ? ComponentName{Direction::horizontal, "t"}
                            : component_named(word);
}

constexpr double square = 90;
constexpr double nearly = 1;

// North and east, 000 and 090, X and Y, H1 and H2; not east and west.
bool are_square(ComponentName const& one, ComponentName const& other) {
    if (one.direction != Direction::horizontal || other.direction != Direction::horizontal || one.axis == other.axis) {
        return false;
    }
    auto const between = degrees_between(one, other);
    return !between || std::abs(*between - square) < nearly;
}

// Of three a letter more says little: "event_L", "event_N" and "event_Z" are names.
bool are_of_one_kind(ComponentName const& one, ComponentName const& other) {
    if (degrees_between(one, other)) {
        return true;
    }
    constexpr auto kinds = std::to_array<Text>({"xy", "lt", "rt", "12", "fnfp"});
    auto const pair = std::min(one.axis, other.axis) + std::max(one.axis, other.axis);
    return is_among(kinds, pair);
}

// A word of its own, or a letter that is used for the vertical axis. "d" is a displacement too.
bool is_upright(Text word) { return is_vertical(direction_named(word).direction) && lowered(word) != "d"; }

bool is_halfway(ComponentName const& one, ComponentName const& other, ComponentName const& third) {
    auto const is_45 = [&](ComponentName const& of) {
        return std::abs(degrees_between(of, third).value_or(0) - square / 2) < nearly;
    };
    return is_45(one) && is_45(other);
}

using Words = std::map<std::string, std::size_t>;  // place of the name by its word

bool are_two_directions(Text one, Text other) {
    if (are_square(direction_named(one), direction_named(other))) {
        return true;
    }
    auto const beside = [](Text level, Text upright) {
        bool const letters = level.size() == 1 && upright.size() == 1;
        return direction_named(level).direction == Direction::horizontal && is_upright(upright)
               && (letters ? Text("xXyY").find(level[0]) != Text::npos && lowered(upright) == "z"
                           : level.size() > 1 && upright.size() > 1);
    };
    return beside(one, other) || beside(other, one);
}

bool are_three_directions(Text one, Text other, Text third) {
    auto const a = direction_named(one);
    auto const b = direction_named(other);
    return are_square(a, b) && are_of_one_kind(a, b)
           && (is_upright(third)
               || (is_azimuth(one) && is_azimuth(other) && is_azimuth(third)
                   && is_halfway(a, b, direction_named(third))));
}

// The six files of a station of KiK-net, in the borehole and at the surface: "NS1", "EW1", "UD1", "NS2", ...
bool are_of_kiknet(Words const& words, Around const& around) {
    constexpr auto all = std::to_array<Text>({"ns1", "ew1", "ud1", "ns2", "ew2", "ud2"});
    auto const is_one = [&](auto const& word) { return is_among(all, word.first); };
    auto const has = [&](Text part) {
        return std::ranges::any_of(words, [&](auto const& word) { return lowered(word.first).starts_with(part); });
    };
    return std::get<1>(around).empty() && std::ranges::all_of(words, is_one) && has("ns") && has("ew");
}

// Before any word but one of processing only what is nothing but a direction: "q1_NS_rock"; no "North", no "H1".
bool is_plain(Text word) { return is_among(std::to_array<Text>({"ns", "ew", "ud"}), word) || is_azimuth(word); }

bool are_of_one_recording(Words const& words, Around const& around) {
    auto const& [before, after, behind] = around;
    // "x.csv" and "y.csv", "H1.csv" and "H2.csv" may be any two motions; "x_1.csv" and "y_1.csv" are not.
    bool const no_more = before.empty() && (after.empty() || after.front() == '.');
    for (auto const& [word, place] : words) {
        bool const is_short = word.size() < 2 || is_digit(word.back());
        if ((no_more && is_short) || (behind == Behind::any_word && !is_plain(word))) {
            return false;
        }
    }
    std::vector<Text> in;
    for (auto const& [word, place] : words) {
        in.emplace_back(word);
    }
    switch (in.size()) {
        case 2:
            return are_two_directions(in[0], in[1]);
        case 3:
            return are_three_directions(in[0], in[1], in[2]) || are_three_directions(in[0], in[2], in[1])
                   || are_three_directions(in[1], in[2], in[0]) || are_of_kiknet(words, around);
        default:
            return in.size() > 3 && are_of_kiknet(words, around);
    }
}

}  // namespace

std::vector<std::size_t> named_recordings(std::span<std::string const> names) {
    std::map<Around, Words> words;
    std::vector<std::size_t> first(names.size());
    std::map<Text, std::size_t> known;
    for (std::size_t i = 0; i < names.size(); ++i) {
        first[i] = known.emplace(names[i], i).first->second;
        for (auto const& part : places_of(names[i])) {
            Around around{names[i].substr(0, part.begin), names[i].substr(part.begin + part.size), part.behind};
            words[std::move(around)].emplace(part.of(names[i]), i);
        }
    }
    for (auto const& [around, of] : words) {
        if (!are_of_one_recording(of, around)) {
            continue;
        }
        for (auto const& [word, place] : of) {
            auto const one = std::minmax(first[of.begin()->second], first[place]);
            std::ranges::replace(first, std::size_t(one.second), std::size_t(one.first));
        }
    }
    return first;
}

}  // namespace overturn
