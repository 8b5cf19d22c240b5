/// The words of quantity_words.hpp.
#pragma once

#include <array>
#include <string_view>

#include "motion/column_role.hpp"

namespace overturn::quantity_tables {

struct QuantityWord {
    std::string_view text;  ///< in lower case
    Quantity quantity;
};
// Parts of words, the more telling ones first: "acceleration" is also written "accel. time history".
inline constexpr auto parts = std::to_array<QuantityWord>({
    {"spectr", Quantity::spectrum},
    {"spektr", Quantity::spectrum},
    {"spettr", Quantity::spectrum},
    {"fourier", Quantity::spectrum},
    {"\xE3\x82\xB9\xE3\x83\x9A\xE3\x82\xAF\xE3\x83\x88\xE3\x83\xAB", Quantity::spectrum},
    {"angular", Quantity::other},
    {"rad/s", Quantity::other},
    {"jerk", Quantity::other},
    {"integrated accel", Quantity::velocity},
    {"integral of accel", Quantity::velocity},
    {"integral of the accel", Quantity::velocity},
    {"integrated once", Quantity::velocity},
    {"integrated twice", Quantity::displacement},
    {"\xE8\xA7\x92\xE9\x80\x9F", Quantity::other},  // angular velocity
    {"accel", Quantity::acceleration},
    {"acc\xC3\xA9l", Quantity::acceleration},
    {"aceler", Quantity::acceleration},
    {"beschleunig", Quantity::acceleration},
    {"ivme", Quantity::acceleration},
    {"\xC4\xB0vme", Quantity::acceleration},
    {"\xD1\x83\xD1\x81\xD0\xBA\xD0\xBE\xD1\x80", Quantity::acceleration},
    {"\xEA\xB0\x80\xEC\x86\x8D\xEB\x8F\x84", Quantity::acceleration},
    {"\xE5\x8A\xA0\xE9\x80\x9F\xE5\xBA\xA6", Quantity::acceleration},
    {"veloc", Quantity::velocity},
    {"vitesse", Quantity::velocity},
    {"geschwind", Quantity::velocity},
    {"h\xC4\xB1z", Quantity::velocity},
    {"\xD0\xBA\xD0\xBE\xD1\x80\xD0\xBE\xD1\x81\xD1\x82", Quantity::velocity},
    {"speed", Quantity::velocity},
    {"\xEC\x86\x8D\xEB\x8F\x84", Quantity::velocity},
    {"\xE9\x80\x9F\xE5\xBA\xA6", Quantity::velocity},
    {"displ", Quantity::displacement},
    {"desplaz", Quantity::displacement},
    {"d\xC3\xA9plac", Quantity::displacement},
    {"deplac", Quantity::displacement},
    {"deplasman", Quantity::displacement},
    {"verschieb", Quantity::displacement},
    {"spostam", Quantity::displacement},
    {"\xEB\xB3\x80\xEC\x9C\x84", Quantity::displacement},
    {"\xE5\xA4\x89\xE4\xBD\x8D", Quantity::displacement},
    {"\xE4\xBD\x8D\xE7\xA7\xBB", Quantity::displacement},
    {"voltage", Quantity::other},
    {"volts", Quantity::other},
});
// Parts of names alone: in prose they are of other things.
inline constexpr auto parts_of_names = std::to_array<QuantityWord>({
    {"freq", Quantity::frequency},
    {"perio", Quantity::frequency},
    {"p\xC3\xA9rio", Quantity::frequency},
    {"periyo", Quantity::frequency},
    {"\xE5\x91\xA8\xE6\x9C\x9F", Quantity::frequency},
    {"time", Quantity::time},
    {"tiempo", Quantity::time},
    {"temps", Quantity::time},
    {"zeit", Quantity::time},
    {"zaman", Quantity::time},
    {"tempo", Quantity::time},
    {"tijd", Quantity::time},
    {"czas", Quantity::time},
    {"elapsed", Quantity::time},
    {"\xD0\xB2\xD1\x80\xD0\xB5\xD0\xBC\xD1\x8F", Quantity::time},
    {"\xE6\x99\x82\xE9\x96\x93", Quantity::time},
    {"\xE6\x97\xB6\xE9\x97\xB4", Quantity::time},
    {"\xE6\x99\x82\xE5\x88\xBB", Quantity::time},
    {"\xE6\x97\xB6\xE5\x88\xBB", Quantity::time},
    {"\xEC\x8B\x9C\xEA\xB0\x84", Quantity::time},
    {"arias", Quantity::other},
    {"husid", Quantity::other},
});
// Before all others: "probability of exceeding the acceleration".
inline constexpr auto parts_of_hazards = std::to_array<QuantityWord>({{"exceed", Quantity::hazard},
                                                                      {"annual", Quantity::hazard},
                                                                      {"hazard", Quantity::hazard},
                                                                      {"probab", Quantity::hazard}});
// Words of their own, among others.
inline constexpr auto tokens = std::to_array<QuantityWord>({
    {"acc", Quantity::acceleration},
    {"vel", Quantity::velocity},
    {"dis", Quantity::displacement},
    {"disp", Quantity::displacement},
    {"counts", Quantity::counts},
    {"psa", Quantity::spectrum},
    {"psv", Quantity::spectrum},
    {"fas", Quantity::spectrum},
});
inline constexpr auto tokens_of_names = std::to_array<QuantityWord>({
    {"sa", Quantity::spectrum},    {"sv", Quantity::spectrum},  {"sd", Quantity::spectrum},
    {"poe", Quantity::hazard},     {"afe", Quantity::hazard},   {"cnt", Quantity::counts},
    {"cts", Quantity::counts},     {"hiz", Quantity::velocity}, {"pgv", Quantity::other},
    {"pgd", Quantity::other},      {"cav", Quantity::other},    {"theta", Quantity::other},
    {"omega", Quantity::other},    {"flag", Quantity::other},   {"date", Quantity::other},
    {"year", Quantity::other},     {"depth", Quantity::other},  {"magnitude", Quantity::other},
    {"distance", Quantity::other}, {"snr", Quantity::other},    {"power", Quantity::other},
    {"seconds", Quantity::time},   {"utc", Quantity::time},     {"clock", Quantity::time},
});
// The whole name, without its unit.
inline constexpr auto wholes = std::to_array<QuantityWord>({{"", Quantity::index},
                                                            {"index", Quantity::index},
                                                            {"idx", Quantity::index},
                                                            {"no", Quantity::index},
                                                            {"no.", Quantity::index},
                                                            {"nr", Quantity::index},
                                                            {"nr.", Quantity::index},
                                                            {"num", Quantity::index},
                                                            {"number", Quantity::index},
                                                            {"n\xC2\xB0", Quantity::index},
                                                            {"id", Quantity::index},
                                                            {"i", Quantity::index},
                                                            {"row", Quantity::index},
                                                            {"point", Quantity::index},
                                                            {"sample", Quantity::index},
                                                            {"samples", Quantity::index},
                                                            {"step", Quantity::index},
                                                            {"count", Quantity::index},
                                                            {"unnamed: 0", Quantity::index},
                                                            {"\xE7\x95\xAA\xE5\x8F\xB7", Quantity::index},
                                                            {"\xE5\xBA\x8F\xE5\x8F\xB7", Quantity::index},
                                                            {"t", Quantity::time},
                                                            {"sec", Quantity::time},
                                                            {"secs", Quantity::time},
                                                            {"second", Quantity::time},
                                                            {"seconds", Quantity::time},
                                                            {"s", Quantity::time},
                                                            {"ms", Quantity::time},
                                                            {"\xE7\xA7\x92", Quantity::time},
                                                            {"a", Quantity::acceleration},
                                                            {"ag", Quantity::acceleration},
                                                            {"d", Quantity::displacement},
                                                            {"f", Quantity::frequency},
                                                            {"period", Quantity::frequency}});

}  // namespace overturn::quantity_tables
