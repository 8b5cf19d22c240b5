#include "spectra/detail/design_json.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/units.hpp"
#include "motion/column_unit.hpp"
#include "motion/text_lines.hpp"
#include "spectra/detail/design_part.hpp"

namespace overturn {
namespace {

using Json = nlohmann::ordered_json;

struct Spectrum {
    std::string name;
    std::vector<std::pair<double, double>> points;
};

bool is_number_list(Json const& value) {
    return value.is_array() && !value.empty() && std::ranges::all_of(value, &Json::is_number);
}

bool is_pair_list(Json const& value) {
    constexpr std::size_t two = 2;
    return value.is_array() && value.size() >= two
           && std::ranges::all_of(value, [](Json const& each) { return is_number_list(each) && each.size() == two; });
}

/// All below `value`, in its order. \param depth of what the caller stands at: nothing real nests deeper than a few
void collect(Json const& value, std::string const& name, int depth, std::vector<Spectrum>& found) {
    constexpr int deepest = 16;
    if (depth > deepest || !value.is_object()) {
        return;
    }
    auto const periods = value.find("periods");
    auto const ordinates = value.find("ordinates");
    if (periods != value.end() && ordinates != value.end() && is_number_list(*periods) && is_number_list(*ordinates)
        && periods->size() == ordinates->size()) {
        Spectrum spectrum{name, {}};
        for (std::size_t i = 0; i < periods->size(); ++i) {
            spectrum.points.emplace_back((*periods)[i].get<double>(), (*ordinates)[i].get<double>());
        }
        found.push_back(std::move(spectrum));
    }
    for (auto const& [key, each] : value.items()) {
        if (is_pair_list(each) && lowered(key).find("spectrum") != std::string::npos) {
            Spectrum spectrum{key, {}};
            for (auto const& pair : each) {
                spectrum.points.emplace_back(pair[0].get<double>(), pair[1].get<double>());
            }
            found.push_back(std::move(spectrum));
        } else {
            collect(each, key, depth + 1, found);
        }
    }
}

bool is_unit(std::string const& text) {
    return std::ranges::any_of(std::array{Dimension::acceleration, Dimension::velocity, Dimension::length},
                               [&](Dimension dimension) { return unit_spelled(text, dimension).has_value(); });
}

/// "# units: cm/s2" and "# damping 0.02" for each place below `value` that states one, as a table's text has them.
void collect_text(Json const& value, int depth, std::string& text) {
    constexpr int deepest = 16;
    if (depth > deepest || !value.is_structured()) {
        return;
    }
    for (auto const& [key, each] : value.items()) {
        auto const lower = lowered(key);
        if (each.is_string() && lower.find("unit") != std::string::npos && is_unit(each.get<std::string>())) {
            text += fmt::format("# units: {}\n", each.get<std::string>());
        } else if (lower.find("damping") != std::string::npos && each.is_primitive() && !each.is_boolean()) {
            auto const said = each.is_string() ? each.get<std::string>() : each.dump();
            text += fmt::format("# damping {}\n", said.substr(0, said.find('\n')));
        } else if (!is_number_list(each)) {
            collect_text(each, depth + 1, text);
        }
    }
}

Spectrum const& chosen(std::vector<Spectrum> const& found, std::string const& part, std::string const& file) {
    if (found.empty()) {
        throw InputError({file},
                         "JSON without a spectrum (arrays periods and ordinates, or pairs under a name that "
                         "holds 'spectrum'). Write columns T (s),Sa (g)");
    }
    std::vector<std::string> names;
    std::ranges::transform(found, std::back_inserter(names), &Spectrum::name);
    return found[part_among(names, part, "spectra", {file})];
}

}  // namespace

bool is_json(std::string_view content) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    content.remove_prefix(content.starts_with(byte_order_mark) ? byte_order_mark.size() : 0);
    return trimmed(content).starts_with('{');
}

std::string table_of_design_json(std::string_view content, std::string const& name, std::string const& part) {
    auto const json = Json::parse(content, nullptr, false);
    if (json.is_discarded()) {
        throw InputError({name}, "no JSON that can be read, though it begins like one (cut short?). Fetch it anew");
    }
    std::vector<Spectrum> found;
    collect(json, "spectrum", 0, found);
    auto const& spectrum = chosen(found, part, name);
    auto const lower = lowered(content);
    bool const of_usgs = lower.find("referencedocument") != std::string::npos
                         || lower.find("earthquake.usgs.gov/ws/designmaps") != std::string::npos;
    std::string text;
    collect_text(json, 0, text);
    text += of_usgs ? "T (s),Sa (g)\n" : "T (s),Sa\n";
    for (auto const& [period, ordinate] : spectrum.points) {
        text += fmt::format("{},{}\n", period, ordinate);
    }
    return text;
}

}  // namespace overturn
