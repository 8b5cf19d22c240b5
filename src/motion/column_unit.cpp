#include "motion/column_unit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "motion/text_lines.hpp"

namespace overturn {
namespace {

struct Spelling {
    std::string_view text;
    double si;
    Dimension dimension = Dimension::acceleration;
};

// Beside those of unit_factor, as `plainly` writes them.
constexpr std::array spellings{Spelling{"mps2", 1},
                               Spelling{"cmps2", 1e-2},
                               Spelling{"gals", 1e-2},
                               Spelling{"mgal", 1e-5},
                               Spelling{"mm/s2", 1e-3},
                               Spelling{"um/s2", 1e-6},
                               Spelling{"nm/s2", 1e-9},
                               Spelling{"in/s2", 0.0254},
                               Spelling{"ft/s2", 0.3048},
                               Spelling{"g's", g0},
                               Spelling{"mg", 1e-3 * g0},
                               Spelling{"m-g", 1e-3 * g0},
                               Spelling{"%g", 1e-2 * g0},
                               Spelling{"mps", 1, Dimension::velocity},
                               Spelling{"cmps", 1e-2, Dimension::velocity},
                               Spelling{"um/s", 1e-6, Dimension::velocity},
                               Spelling{"nm/s", 1e-9, Dimension::velocity},
                               Spelling{"in/s", 0.0254, Dimension::velocity},
                               Spelling{"ft/s", 0.3048, Dimension::velocity},
                               Spelling{"kines", 1e-2, Dimension::velocity},
                               Spelling{"in", 0.0254, Dimension::length},
                               Spelling{"ft", 0.3048, Dimension::length},
                               Spelling{"um", 1e-6, Dimension::length},
                               Spelling{"nm", 1e-9, Dimension::length},
                               Spelling{"us", 1e-6, Dimension::time},
                               Spelling{"sn", 1, Dimension::time},  // saniye
                               Spelling{"seg", 1, Dimension::time},
                               Spelling{"minute", 60, Dimension::time},
                               Spelling{"minutes", 60, Dimension::time},
                               Spelling{"hour", 3600, Dimension::time},
                               Spelling{"hours", 3600, Dimension::time},
                               Spelling{"sek", 1, Dimension::time},
                               Spelling{"\xE7\xA7\x92", 1, Dimension::time},
                               Spelling{"\xEC\xB4\x88", 1, Dimension::time},
                               Spelling{"khz", 1e3, Dimension::frequency},
                               Spelling{"cps", 1, Dimension::frequency},
                               Spelling{"1/s", 1, Dimension::frequency}};

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
}

/// "cm/sec/sec", "cm/s**2", "cm.s^-2" and "cm/s\xC2\xB2" are all "cm/s2".
std::string plainly(std::string_view text) {
    auto plain = lowered(trimmed(text));
    for (std::string_view const dropped : {"^", "**", "\xC2\xB7", " ", ".", "$", "{", "}", "(", ")"}) {
        replace_all(plain, dropped, "");
    }
    constexpr std::array<std::pair<std::string_view, std::string_view>, 11> words{{{"per", "/"},
                                                                                   {"squared", "2"},
                                                                                   {"centi", "c"},
                                                                                   {"milli", "m"},
                                                                                   {"micro", "u"},
                                                                                   {"\xC2\xB5", "u"},
                                                                                   {"nano", "n"},
                                                                                   {"meters", "m"},
                                                                                   {"metres", "m"},
                                                                                   {"meter", "m"},
                                                                                   {"metre", "m"}}};
    for (auto const& [word, sign] : words) {
        replace_all(plain, word, sign);
    }
    replace_all(plain, "\xC2\xB2", "2");
    replace_all(plain, "\xE2\x88\x92", "-");
    for (std::string_view const seconds : {"seconds", "second", "secs", "sec"}) {
        replace_all(plain, seconds, "s");
    }
    replace_all(plain, "s/s", "s2");
    if (plain.find('/') == std::string::npos) {
        for (std::string_view const power : {"-2", "-1"}) {
            if (plain.size() > power.size() + 1 && plain.ends_with(std::string("s").append(power))) {
                plain = plain.substr(0, plain.size() - power.size() - 1).append(power == "-2" ? "/s2" : "/s");
            }
        }
    }
    return plain;
}

}  // namespace

std::optional<double> unit_spelled(std::string_view text, Dimension dimension) {
    auto const plain = plainly(text);
    for (auto const& spelling : spellings) {
        if (spelling.dimension == dimension && spelling.text == plain) {
            return spelling.si;
        }
    }
    try {
        return unit_factor(plain, dimension);
    } catch (InputError const&) {
        return std::nullopt;
    }
}

namespace {

bool is_unit(std::string_view text) {
    constexpr std::array dimensions{Dimension::acceleration, Dimension::velocity, Dimension::length, Dimension::time,
                                    Dimension::frequency};
    return std::ranges::any_of(dimensions,
                               [&](Dimension dimension) { return unit_spelled(text, dimension).has_value(); });
}

}  // namespace

std::optional<IntensitySpelled> intensity_unit_spelled(std::string_view text) {
    for (auto const dimension : {Dimension::acceleration, Dimension::velocity, Dimension::length}) {
        if (auto const si = text.empty() ? std::nullopt : unit_spelled(text, dimension)) {
            return IntensitySpelled{dimension, *si};
        }
    }
    return std::nullopt;
}

UnitText unit_text_in_name(std::string_view name) {
    UnitText first;
    for (auto open = name.find_first_of("(["); open != std::string_view::npos;
         open = name.find_first_of("([", open + 1)) {
        auto const close = name.find_first_of(")]", open);
        auto const text = trimmed(name.substr(open + 1, close == std::string_view::npos ? close : close - open - 1));
        if (is_unit(text)) {
            return {text, true};
        }
        first = first.bracketed ? first : UnitText{text, true};
    }
    if (first.bracketed) {
        return first;
    }
    auto const last = trimmed(name).find_last_of("_ ");
    return {last == std::string_view::npos ? std::string_view{} : trimmed(name).substr(last + 1), false};
}

std::optional<double> unit_in_name(std::string_view name, Dimension dimension) {
    auto const [text, bracketed] = unit_text_in_name(name);
    constexpr std::size_t telling = 2;  // a letter alone needs its brackets
    return bracketed || text.size() >= telling ? unit_spelled(text, dimension) : std::nullopt;
}

std::optional<double> unit_of_values(std::string_view name, Dimension dimension) {
    bool const in_g = dimension == Dimension::acceleration && unit_text_in_name(name).text == "g";
    return in_g ? std::optional(g0) : unit_in_name(name, dimension);
}

std::string name_of_unit(double si, Dimension dimension) {
    constexpr double same = 1e-9;
    static constexpr std::array names{"m/s2", "gal", "g", "mm/s2", "m/s", "cm/s", "m", "cm", "mm"};
    for (auto const* name : names) {
        if (auto const named = unit_spelled(name, dimension); named && std::abs(si - *named) <= same * *named) {
            return name;
        }
    }
    return fmt::format("{:.7g} {}", si, si_symbol(dimension));
}

bool is_in_si(std::string_view name, Dimension dimension) {
    auto const [text, bracketed] = unit_text_in_name(name);
    auto const si = unit_spelled(text, dimension);
    return si ? *si == 1 : !bracketed;
}

}  // namespace overturn
