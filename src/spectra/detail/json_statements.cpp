#include "spectra/detail/json_statements.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/digit.hpp"
#include "core/units.hpp"
#include "motion/column_role.hpp"
#include "motion/column_unit.hpp"
#include "motion/component_name.hpp"
#include "motion/telling_words.hpp"
#include "motion/text_lines.hpp"
#include "motion/text_statements.hpp"
#include "spectra/detail/target_names.hpp"

namespace overturn {
namespace {

using Text = std::string_view;
using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

Words split(Text words) {
    Words found;
    while (!words.empty()) {
        auto const end = std::min(words.find(' '), words.size());
        found.emplace_back(words.substr(0, end));
        words = words.substr(std::min(end + 1, words.size()));
    }
    return found;
}

template <std::size_t N> bool is_one_of(std::string const& word, std::array<Text, N> const& list) {
    return std::ranges::find(list, Text(word)) != list.end();
}

template <std::size_t N> bool has_one_of(Words const& words, std::array<Text, N> const& list) {
    return std::ranges::any_of(words, [&](auto const& word) { return is_one_of(word, list); });
}

// Beside the telling words of a key; they change nothing of what it says.
constexpr auto fillings = std::to_array<Text>(
    {"spectrum", "spectral", "spectra", "response", "ordinate", "ordinates", "value", "values",   "of",     "the",
     "data",     "output",   "applied", "target",   "design",   "y",         "axis",  "by",       "motion", "ground",
     "seismic",  "system",   "name",    "in",       "metadata", "meta",      "info",  "amplitude"});
constexpr auto of_dampings =
    std::to_array<Text>({"zeta", "xi", "\xCE\xB6", "\xCE\xBE", "ratio", "factor", "coefficient", "level", "percent",
                         "pct", "critical", "oscillator", "fraction", "sdof", "viscous"});
constexpr auto of_soils =
    std::to_array<Text>({"soil", "site", "foundation", "radiation", "material", "layer", "rock", "pile", "kappa"});
constexpr auto of_units = std::to_array<Text>({"unit", "units", "uom", "einheit", "einheiten", "unidad", "unidades"});
constexpr auto of_components =
    std::to_array<Text>({"component", "components", "comp", "direction", "dir", "orientation", "channel"});
constexpr auto of_factors =
    std::to_array<Text>({"scale", "scaling", "factor", "multiplier", "gain", "sf", "time", "period", "amplification"});
constexpr auto of_statistics =
    std::to_array<Text>({"percentile", "fractile", "quantile", "sigma", "epsilon", "statistic", "stat", "level"});
constexpr auto scales = std::to_array<Text>({"log", "log10", "ln", "logarithm", "logarithms", "logarithmic", "scaled"});
constexpr auto of_papers =
    std::to_array<Text>({"url", "href", "link", "date", "version", "status", "reference", "document", "license"});
constexpr auto of_quantities =
    std::to_array<Text>({"type", "quantity", "kind", "measure", "imt", "ordinate", "ordinates", "label", "ylabel",
                         "title", "name", "description", "comment", "comments", "note", "notes", "id", "spectrum"});

/// Are all of these such words, or fillings, and at least one of them such a word?
template <std::size_t N> bool are_all(Words const& words, std::array<Text, N> const& list) {
    return has_one_of(words, list) && std::ranges::all_of(words, [&](auto const& word) {
               return is_one_of(word, list) || is_one_of(word, fillings);
           });
}

bool is_of_damping(std::string const& word) {
    return word.find("damp") != std::string::npos
           || is_one_of(word, std::to_array<Text>({"zeta", "xi", "\xCE\xB6", "\xCE\xBE"}));
}

/// Without quotes, on one line; of a list of one value that value.
std::string text_of(Json const& value) {
    if (value.is_array() && value.size() == 1 && value[0].is_primitive()) {
        return text_of(value[0]);
    }
    auto text =
        value.is_string() ? value.get<std::string>() : value.dump(-1, ' ', false, Json::error_handler_t::replace);
    std::ranges::replace(text, '\n', ' ');
    std::ranges::replace(text, '\r', ' ');
    return std::string(trimmed(text));
}

/// What the words beside "units" name: an acceleration, a time, ...; unknown if nothing but fillings, other if another.
Quantity quantity_beside_unit(Words const& words) {
    auto found = Quantity::unknown;
    for (auto const& word : words) {
        if (is_one_of(word, of_units) || is_one_of(word, fillings)) {
            continue;
        }
        bool const time = word.starts_with("period") || word == "time" || word == "t" || word == "x";
        auto const one = time ? Quantity::time
                         : word.starts_with("accel") || word == "acc" || word == "sa" || word == "psa"
                             ? Quantity::acceleration
                         : word.starts_with("vel") || word == "sv" || word == "psv" ? Quantity::velocity
                         : word.starts_with("disp") || word == "sd"                 ? Quantity::displacement
                                                                                    : Quantity::other;
        found = found == Quantity::unknown || one == Quantity::other ? one : found;
    }
    return found;
}

Quantity quantity_of(TargetKind kind) {
    auto const dimension = dimension_of(kind);
    return dimension == Dimension::acceleration ? Quantity::acceleration
           : dimension == Dimension::velocity   ? Quantity::velocity
                                                : Quantity::displacement;
}

/// "units": "g", "units": {"acceleration": "g"}, "periodUnits": "ms", "units": ["s", "g"].
JsonStatement of_unit(Words const& words, std::string const& key, Json const& value, TargetKind kind) {
    JsonStatement statement;
    auto const quantity = quantity_beside_unit(words);
    auto const take = [&](Json const& one) {
        auto const text = text_of(one);
        bool const time = unit_spelled(text, Dimension::time).has_value();
        bool const own = unit_spelled(text, dimension_of(kind)).has_value();
        if (time && (quantity == Quantity::time || (quantity == Quantity::unknown && value.is_array()))) {
            statement.period_unit = text;
        } else if (quantity == Quantity::unknown || quantity == quantity_of(kind)) {
            statement.text += fmt::format("{}units: {}", statement.text.empty() ? "" : "; ", text);
        } else if (quantity == Quantity::time || (quantity == Quantity::other && own)) {
            statement.text = fmt::format("{}: {}", key, text);
        }
    };
    if (value.is_array()) {
        std::ranges::for_each(value, take);
    } else {
        take(value);
    }
    return statement;
}

std::string of_damping(Words const& words, std::string const& key, Json const& value) {
    bool const percent = has_one_of(words, std::to_array<Text>({"percent", "pct"}));
    bool const unit = has_one_of(words, of_units);
    bool const known = std::ranges::all_of(words, [](auto const& word) {
        return is_of_damping(word) || is_one_of(word, of_dampings) || is_one_of(word, fillings);
    });
    auto const text = text_of(value);
    if (has_one_of(words, of_soils)
        || (unit && is_one_of(text, std::to_array<Text>({"", "-", "1", "fraction", "ratio", "decimal"})))) {
        return {};
    }
    return known ? fmt::format("damping {}{}", text, percent ? " %" : "")
                 : fmt::format("{} (damping): '{}'", key, text);
}

/// Does a value change a spectrum, whatever its key is called: "84th percentile", "floor 3", "frequency", "ln"?
bool tells_anywhere(Text text) {
    auto const words = words_of_key(text);
    return tells_vertical(words) || tells_statistic(words) || (tells_other_spectrum(words) && !tells_no_response(words))
           || tells_factor(lowered(text)) || words.find("freq") != std::string::npos
           || has_one_of(split(words), scales);
}

/// Does a value say what the ordinates are, or which of several they are?
bool tells(Text text, TargetKind kind) {
    TextStatements statements(dimension_of(kind));
    statements.take(text, 1);
    auto const lower = lowered(text);
    return !statements.other().empty() || !statements.telling().empty() || statements.unit() || tells_of_spectrum(lower)
           || tells_factor(lower) || lower.find("damp") != std::string::npos
           || kind_named(lower).value_or(kind) != kind;
}

}  // namespace

std::string words_of_key(std::string_view key) {
    std::string words;
    auto const lower = [](char c) { return (c >= 'a' && c <= 'z') || is_digit(c); };
    for (std::size_t i = 0; i < key.size(); ++i) {
        bool const capital = key[i] >= 'A' && key[i] <= 'Z';
        bool const part = capital || lower(key[i]) || static_cast<unsigned char>(key[i]) >= 0x80;
        bool const begins = capital && i > 0 && lower(key[i - 1]);
        if ((begins || !part) && !words.empty() && words.back() != ' ') {
            words += ' ';
        }
        words += part ? std::string(1, key[i]) : std::string();
    }
    return lowered(trimmed(words));
}

bool tells_of_spectrum(std::string_view words) {
    constexpr auto parts = std::to_array<Text>({"displ", "veloc", "energy", "normali"});
    return tells_vertical(words) || tells_statistic(words) || tells_other_spectrum(words)
           || std::ranges::any_of(parts, [&](Text part) { return words.find(part) != Text::npos; });
}

JsonStatement json_statement(std::span<std::string const> keys, nlohmann::ordered_json const& value, TargetKind kind) {
    Words all;
    for (auto const& key : keys) {
        std::ranges::move(split(words_of_key(key)), std::back_inserter(all));
    }
    auto const& key = keys.back();
    auto const own = split(words_of_key(key));
    auto const text = fmt::format("{}: {}", key, text_of(value));
    if (value.is_boolean()) {
        bool const change =
            has_one_of(own, scales) || tells_factor(words_of_key(key)) || tells_of_spectrum(words_of_key(key));
        return {value.get<bool>() && change ? text : std::string(), {}};
    }
    if (value.is_null()) {
        return {};
    }
    if (std::ranges::any_of(all, is_of_damping)) {
        return {of_damping(all, key, value), {}};
    }
    if (has_one_of(all, of_units)) {
        return value.is_number() ? JsonStatement{text, {}} : of_unit(all, key, value, kind);
    }
    if (are_all(own, of_components)) {
        auto const component = text_of(value);
        bool const horizontal = direction_of(component) == Direction::horizontal;
        return {horizontal ? std::string() : fmt::format("{}: {}", words_of_key(key), component), {}};
    }
    if (are_all(own, of_factors) || are_all(own, of_statistics)) {
        bool const plain = (value.is_number() && value.get<double>() == 1 && !has_one_of(own, of_statistics))
                           || text_of(value) == "linear" || text_of(value) == "mean";
        return {plain ? std::string() : text, {}};
    }
    bool const of_quantity = are_all(own, of_quantities);
    bool const listed = value.is_array() && !value.empty() && std::ranges::all_of(value, &Json::is_string);
    auto const one = [&](Json const& each) {
        return of_quantity ? tells(text_of(each), kind) : tells_anywhere(text_of(each));
    };
    bool const telling = listed ? std::ranges::any_of(value, one) : value.is_string() && one(value);
    return {telling && !has_one_of(own, of_papers) ? text : std::string(), {}};
}

}  // namespace overturn
