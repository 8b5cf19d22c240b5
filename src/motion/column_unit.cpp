#include "motion/column_unit.hpp"

#include <array>
#include <string>

#include "core/units.hpp"

namespace overturn {
namespace {

struct Spelling {
    std::string_view text;
    double si;
};
constexpr std::array<Spelling, 17> spellings{{{"m/s2", 1},
                                              {"m/s^2", 1},
                                              {"m/s/s", 1},
                                              {"m/s**2", 1},
                                              {"m/sec2", 1},
                                              {"m/sec^2", 1},
                                              {"mps2", 1},
                                              {"cm/s2", 1e-2},
                                              {"cm/s^2", 1e-2},
                                              {"cm/s/s", 1e-2},
                                              {"cm/s**2", 1e-2},
                                              {"cm/sec2", 1e-2},
                                              {"cm/sec^2", 1e-2},
                                              {"cmps2", 1e-2},
                                              {"gal", 1e-2},
                                              {"mm/s2", 1e-3},
                                              {"mm/s^2", 1e-3}}};

std::optional<double> unit_called(std::string_view text) {
    for (auto const& [spelling, si] : spellings) {
        if (text == spelling) {
            return si;
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<double> unit_in_name(std::string_view name) {
    std::string lower;
    for (char const c : name) {
        lower += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    std::string_view const text = lower;
    if (auto const open = text.find_first_of("(["); open != std::string_view::npos) {
        auto const close = text.find_first_of(")]", open);
        auto const inside = trimmed(text.substr(open + 1, close == std::string_view::npos ? close : close - open - 1));
        return inside == "g" ? std::optional(g0) : unit_called(inside);
    }
    auto const last = text.find_last_of("_ ");
    return last == std::string_view::npos ? std::nullopt : unit_called(text.substr(last + 1));
}

}  // namespace overturn
