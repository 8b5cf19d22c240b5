/// The dictionary of component_name.hpp.
#pragma once

#include <array>
#include <string_view>

#include "motion/component_name.hpp"

namespace overturn {

struct ComponentWord {
    std::string_view text;  ///< in lower case, without blanks, hyphens and underscores
    Direction direction;
    std::string_view axis = {};
};

namespace component_words {
inline constexpr auto up = Direction::up;
inline constexpr auto down = Direction::down;
inline constexpr auto horizontal = Direction::horizontal;

// A letter "d" is a displacement as often as "down", and is in neither list.
inline constexpr auto words = std::to_array<ComponentWord>({
    {"u", up},
    {"up", up},
    {"ud", up},
    {"updown", up},
    {"upward", up},
    {"upwards", up},
    {"z", up},
    {"v", up},
    {"ver", up},
    {"vert", up},
    {"vrt", up},
    {"vertical", up},
    {"vertikal", up},
    {"verticale", up},
    {"d\xC3\xBC\xC5\x9F"
     "ey",
     up},
    {"dusey", up},
    {"\xE4\xB8\x8A\xE4\xB8\x8B", up},  // UD
    {"\xE9\x89\x9B\xE7\x9B\xB4", up},  // plumb
    {"\xE5\x9E\x82\xE7\x9B\xB4", up},
    {"\xE7\xAB\x96\xE5\x90\x91", up},
    {"\xE7\xAB\x96\xE7\x9B\xB4", up},
    {"\xE5\x9E\x82\xE5\x90\x91", up},
    {"\xE9\x93\x85\xE5\x9E\x82", up},
    {"\xE9\x93\x85\xE7\x9B\xB4", up},
    {"\xEC\x83\x81\xED\x95\x98", up},
    {"\xEC\x88\x98\xEC\xA7\x81", up},  // of Korea
    {"d", down},
    {"dn", down},
    {"dwn", down},
    {"down", down},
    {"downward", down},
    {"downwards", down},
    {"n", horizontal, "n"},
    {"s", horizontal, "n"},
    {"ns", horizontal, "n"},
    {"sn", horizontal, "n"},
    {"north", horizontal, "n"},
    {"south", horizontal, "n"},
    {"northsouth", horizontal, "n"},
    {"southnorth", horizontal, "n"},
    {"nord", horizontal, "n"},
    {"nordsud", horizontal, "n"},
    {"nords\xC3\xBC"
     "d",
     horizontal, "n"},
    {"norte", horizontal, "n"},
    {"nortesur", horizontal, "n"},
    {"kuzey", horizontal, "n"},
    {"kg", horizontal, "n"},  // kuzey-guney
    {"gk", horizontal, "n"},
    {"guney", horizontal, "n"},
    {"g\xC3\xBCney", horizontal, "n"},
    {"sud", horizontal, "n"},
    {"s\xC3\xBC"
     "d",
     horizontal, "n"},
    {"sur", horizontal, "n"},
    {"kuzeyguney", horizontal, "n"},
    {"kuzeyg\xC3\xBCney", horizontal, "n"},
    {"\xE5\x8D\x97\xE5\x8C\x97", horizontal, "n"},
    {"\xE5\x8C\x97\xE5\x8D\x97", horizontal, "n"},
    {"\xEB\x82\xA8\xEB\xB6\x81", horizontal, "n"},
    {"\xEB\xB6\x81\xEB\x82\xA8", horizontal, "n"},
    {"e", horizontal, "e"},
    {"w", horizontal, "e"},
    {"ew", horizontal, "e"},
    {"we", horizontal, "e"},
    {"east", horizontal, "e"},
    {"west", horizontal, "e"},
    {"eastwest", horizontal, "e"},
    {"westeast", horizontal, "e"},
    {"ost", horizontal, "e"},
    {"ostwest", horizontal, "e"},
    {"estouest", horizontal, "e"},
    {"estovest", horizontal, "e"},
    {"est", horizontal, "e"},
    {"ouest", horizontal, "e"},
    {"ovest", horizontal, "e"},
    {"oeste", horizontal, "e"},
    {"eo", horizontal, "e"},  // este-oeste, est-ovest
    {"oe", horizontal, "e"},
    {"db", horizontal, "e"},  // dogu-bati
    {"bd", horizontal, "e"},
    {"bati", horizontal, "e"},
    {"bat\xC4\xB1", horizontal, "e"},
    {"este", horizontal, "e"},
    {"esteoeste", horizontal, "e"},
    {"dogu", horizontal, "e"},
    {"dogubati", horizontal, "e"},
    {"do\xC4\x9Fu", horizontal, "e"},
    {"do\xC4\x9Fu"
     "bat\xC4\xB1",
     horizontal, "e"},
    {"\xE6\x9D\xB1\xE8\xA5\xBF", horizontal, "e"},
    {"\xE4\xB8\x9C\xE8\xA5\xBF", horizontal, "e"},
    {"\xE8\xA5\xBF\xE6\x9D\xB1", horizontal, "e"},
    {"\xEB\x8F\x99\xEC\x84\x9C", horizontal, "e"},
    {"\xEC\x84\x9C\xEB\x8F\x99", horizontal, "e"},
    {"x", horizontal, "x"},
    {"y", horizontal, "y"},
    {"h", horizontal, "h"},
    {"hor", horizontal, "h"},
    {"horiz", horizontal, "h"},
    {"horizontal", horizontal, "h"},
    {"\xE6\xB0\xB4\xE5\xB9\xB3", horizontal, "h"},
    {"\xE6\xB0\xB4\xE5\xB9\xB3"
     "1",
     horizontal, "1"},
    {"\xE6\xB0\xB4\xE5\xB9\xB3"
     "2",
     horizontal, "2"},
    {"h1", horizontal, "1"},
    {"h2", horizontal, "2"},
    {"hor1", horizontal, "1"},
    {"hor2", horizontal, "2"},
    {"horiz1", horizontal, "1"},
    {"horiz2", horizontal, "2"},
    {"horizontal1", horizontal, "1"},
    {"horizontal2", horizontal, "2"},
    {"comp1", horizontal, "1"},
    {"comp2", horizontal, "2"},
    {"component1", horizontal, "1"},
    {"component2", horizontal, "2"},
    {"l", horizontal, "l"},
    {"ln", horizontal, "l"},
    {"long", horizontal, "l"},
    {"longitudinal", horizontal, "l"},
    {"t", horizontal, "t"},
    {"tr", horizontal, "t"},
    {"tran", horizontal, "t"},
    {"trans", horizontal, "t"},
    {"transverse", horizontal, "t"},
    {"transversal", horizontal, "t"},
    {"lateral", horizontal, "t"},
    {"r", horizontal, "r"},
    {"radial", horizontal, "r"},
    {"tangential", horizontal, "tangential"},
    {"fn", horizontal, "fn"},
    {"faultnormal", horizontal, "fn"},
    {"fp", horizontal, "fp"},
    {"faultparallel", horizontal, "fp"},
});

// What stands before or behind a direction without saying one.
inline constexpr auto fillings = std::to_array<std::string_view>({"aceleracion",
                                                                  "aceleraci\xC3\xB3n",
                                                                  "accelerazione",
                                                                  "acc\xC3\xA9l\xC3\xA9ration",
                                                                  "beschleunigung",
                                                                  "ivme",
                                                                  "componente",
                                                                  "composante",
                                                                  "komponente",
                                                                  "direccion",
                                                                  "direzione",
                                                                  "richtung",
                                                                  "acceleration",
                                                                  "accelerogram",
                                                                  "accel",
                                                                  "acc",
                                                                  "a",
                                                                  "component",
                                                                  "comp",
                                                                  "motion",
                                                                  "ground",
                                                                  "channel",
                                                                  "dir",
                                                                  "direction",
                                                                  "recorded",
                                                                  "corrected",
                                                                  "\xE6\x88\x90\xE5\x88\x86",
                                                                  "\xE6\x96\xB9\xE5\x90\x91",
                                                                  "\xE5\x90\x91",
                                                                  "\xE5\x8B\x95",
                                                                  "\xE5\x8A\xA0\xE9\x80\x9F\xE5\xBA\xA6"});
}  // namespace component_words

}  // namespace overturn
