#include "motion/component_name.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/digit.hpp"
#include "core/units.hpp"
#include "motion/detail/component_words.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

using Text = std::string_view;

using component_words::fillings;
using component_words::horizontal;
using component_words::up;
using component_words::words;

std::string plainly(Text name) {
    auto plain = lowered(trimmed(name));
    std::erase_if(plain, [](char c) { return Text(" \t_-./\"',").find(c) != Text::npos; });
    return plain;
}

/// An azimuth, "090", "360 deg", or a bearing, "n10e"; its digits. Nothing if it is neither.
std::string azimuth_in(Text name) {
    constexpr double full_circle = 360;
    auto text = lowered(trimmed(name));
    bool const bearing =
        text.size() > 2 && (text.front() == 'n' || text.front() == 's') && (text.back() == 'e' || text.back() == 'w');
    auto digits = Text(text);
    if (bearing) {
        digits = trimmed(digits.substr(1, digits.size() - 2));
    } else if (digits.ends_with("deg")) {
        digits = trimmed(digits.substr(0, digits.size() - 3));
    } else if (digits.ends_with("\xC2\xB0")) {
        digits = trimmed(digits.substr(0, digits.size() - 2));
    }
    double azimuth = 0;
    if (!parse_number(digits, azimuth) || !(azimuth >= 0 && azimuth <= full_circle)) {
        return {};
    }
    return bearing ? text : std::string(digits);
}

/// HNZ, BLE, HN1: band, instrument, orientation, of SEED (Appendix A of its manual). Its third number and its letters
/// A, B, C, U, V, W point anywhere.
ComponentName seed_channel(Text lower) {
    constexpr std::size_t letters = 3;
    if (lower.size() != letters || lower.starts_with("ch") || Text("hbeslmcfdv").find(lower[0]) == Text::npos
        || Text("nlhg").find(lower[1]) == Text::npos) {
        return {};
    }
    switch (lower[2]) {
        case 'z':
            return {up, {}};
        case 'n':
        case 'e':
        case '1':
        case '2':
        case 'r':
        case 't':
            return {horizontal, std::string(1, lower[2])};
        default:
            return {};
    }
}

ComponentName looked_up(Text plain) {
    constexpr std::size_t kiknet = 3;  // NS1 in the borehole, NS2 at the surface
    if (plain.size() == kiknet && (plain.back() == '1' || plain.back() == '2')
        && (plain.starts_with("ns") || plain.starts_with("ew") || plain.starts_with("ud"))) {
        plain.remove_suffix(1);
    }
    auto const* const found = std::ranges::find(words, plain, &ComponentWord::text);
    return found == words.end() ? seed_channel(plain) : ComponentName{found->direction, std::string(found->axis)};
}

/// May what is left of a word behind `filling` be a direction? "accX" may, "accele" and "accelerations" may not.
bool may_be_left(Text rest, Text filling) {
    bool const letter = rest.size() == 1;
    return !letter
           || Text(filling == "accel" ? "xyz"
                   : filling == "a"   ? "xyznehvu"
                                      : "xyznhvu")
                      .find(rest)
                  != Text::npos;
}

/// Without what says no direction: "accX", "NS\xE6\x88\x90\xE5\x88\x86", "a_vertical".
ComponentName without_filling(std::string plain) {
    for (bool again = true; again && !plain.empty();) {
        if (auto found = looked_up(plain); found.direction != Direction::unknown) {
            return found;
        }
        again = false;
        for (Text const filling : fillings) {
            if (plain.size() > filling.size() && plain.starts_with(filling)) {
                plain.erase(0, filling.size());
                again = may_be_left(plain, filling);
                break;
            }
            if (plain.size() > filling.size() && filling.size() > 1 && plain.ends_with(filling)) {
                plain.erase(plain.size() - filling.size());
                again = true;
                break;
            }
        }
    }
    return {};
}

bool is_filling(Text token) { return std::ranges::find(fillings, token) != fillings.end(); }

/// What parts of it say together; unknown if one says up and another sideways.
class Agreement {
  public:
    void take(ComponentName const& one) {
        if (one.direction == Direction::unknown) {
            return;
        }
        contradicted_ = contradicted_ || (found_.direction != Direction::unknown && found_.direction != one.direction);
        bool const closer = found_.direction == one.direction && found_.axis == "h";  // "H-270" is along 270
        found_ = found_.direction == Direction::unknown || closer ? one : found_;
    }
    [[nodiscard]] ComponentName found() const { return contradicted_ ? ComponentName{} : found_; }
    [[nodiscard]] bool contradicted() const { return contradicted_; }

  private:
    ComponentName found_;
    bool contradicted_ = false;
};

std::vector<std::string> tokens_of(Text name) {
    std::vector<std::string> tokens;
    for (std::size_t at = 0; at < name.size();) {
        constexpr Text separators = " \t_-./:,;|\"'";
        at = std::min(name.find_first_not_of(separators, at), name.size());
        auto end = std::min(name.find_first_of(separators, at), name.size());
        for (std::size_t i = at + 1; i < end; ++i) {  // "accEW"
            bool const rises = name[i - 1] >= 'a' && name[i - 1] <= 'z' && name[i] >= 'A' && name[i] <= 'Z';
            end = rises ? i : end;
        }
        if (end > at) {
            tokens.push_back(lowered(name.substr(at, end - at)));
        }
        at = end;
    }
    return tokens;
}

/// "N 21 E" is one word.
std::vector<std::string> with_bearings_whole(std::vector<std::string> const& tokens) {
    constexpr std::size_t parts = 3;
    std::vector<std::string> joined;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        std::string bearing;
        for (std::size_t n = 0; n < parts && i + n < tokens.size() && azimuth_in(bearing).empty(); ++n) {
            bearing += tokens[i + n];
            if (!is_digit(bearing.front()) && !azimuth_in(bearing).empty()) {
                i += n;
                break;
            }
        }
        bool const whole = !is_digit(bearing.front()) && !azimuth_in(bearing).empty();
        joined.push_back(whole ? bearing : tokens[i]);
    }
    return joined;
}

/// Words of their own, anywhere; letters at either end; an azimuth of three digits among nothing but fillings.
ComponentName in_tokens(Text name) {
    auto const tokens = with_bearings_whole(tokens_of(name));
    Agreement agreed;
    auto const others = std::ranges::count_if(
        tokens, [](auto const& token) { return !is_filling(token) && looked_up(token).axis != "h"; });
    constexpr std::size_t azimuth_digits = 3;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        auto const& token = tokens[i];
        bool const at_an_end = i == 0 || i + 1 == tokens.size();
        bool const counted = token.size() > 1 ? !is_filling(token) : at_an_end && token != "a" && token != "s";
        agreed.take(counted ? without_filling(token) : ComponentName{});
        bool const three = token.size() == azimuth_digits && std::ranges::all_of(token, is_digit);
        if ((three && others == 1) || (token.size() >= azimuth_digits && !is_digit(token[0]))) {
            if (auto const azimuth = azimuth_in(token); !azimuth.empty()) {
                agreed.take({horizontal, azimuth});
            }
        }
    }
    return agreed.found();
}

/// Of the line, either way [deg]: of "n", "e", "090", "n10e".
std::optional<double> azimuth_along(ComponentName const& component) {
    constexpr double east = 90;
    Text axis = component.axis;
    if (component.direction != horizontal || axis.empty()) {
        return std::nullopt;
    }
    if (axis == "n" || axis == "e") {
        return axis == "n" ? 0 : east;
    }
    bool const bearing = axis.front() == 'n' || axis.front() == 's';
    double degrees = 0;
    bool const number = axis == "1" || axis == "2";  // of h1 and h2
    bool const read = bearing ? parse_number(trimmed(axis.substr(1, axis.size() - 2)), degrees)
                              : !number && parse_number(axis, degrees);
    bool const turned = bearing && (axis.front() == 's') != (axis.back() == 'w');
    return read ? std::optional(turned ? -degrees : degrees) : std::nullopt;
}

}  // namespace

ComponentName component_named(std::string_view name) {
    if (auto const azimuth = azimuth_in(name); !azimuth.empty()) {
        return {horizontal, azimuth};
    }
    return looked_up(plainly(name));
}

ComponentName component_in(std::string_view name) {
    std::string outside;
    Agreement agreed;
    while (!name.empty()) {
        auto const open = name.find_first_of("([{");
        outside += name.substr(0, open);
        outside += ' ';
        if (open == Text::npos) {
            break;
        }
        auto const close = std::min(name.find_first_of(")]}", open), name.size());
        auto const inside = name.substr(open + 1, close - open - 1);
        bool const azimuth = lowered(inside).find("deg") != std::string::npos || inside.ends_with("\xC2\xB0");
        agreed.take(inside == "s" ? ComponentName{}
                    : azimuth     ? component_named(inside)
                                  : without_filling(plainly(inside)));
        name = name.substr(std::min(close + 1, name.size()));
    }
    if (auto const whole = without_filling(plainly(outside)); whole.direction != Direction::unknown) {
        agreed.take(whole);
    } else {
        agreed.take(in_tokens(outside));
    }
    return agreed.found();
}

std::optional<double> degrees_between(ComponentName const& one, ComponentName const& other) {
    auto const first = azimuth_along(one);
    auto const second = azimuth_along(other);
    if (!first || !second) {
        return std::nullopt;
    }
    constexpr double half_circle = 180;
    double const apart = std::fmod(std::abs(*first - *second), half_circle);
    return std::min(apart, half_circle - apart);
}

bool may_be_one(ComponentName const& one, ComponentName const& other) {
    constexpr double apart_deg = 45;
    bool const both_known = one.direction != Direction::unknown && other.direction != Direction::unknown;
    return !both_known
           || (is_vertical(one.direction) == is_vertical(other.direction)
               && degrees_between(one, other).value_or(0) < apart_deg);
}

Direction direction_of(std::string_view name) { return component_named(name).direction; }

}  // namespace overturn
