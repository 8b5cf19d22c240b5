#include "cli/assumptions_text.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign/model_assumptions.hpp"
#include "core/texts_of.hpp"
#include "core/wrapped.hpp"

namespace overturn::cli {
namespace {

using config::Basis;
using config::InputValue;

std::string_view name_of(Bears bears) {
    static constexpr std::array names{"none", "all", "where-not-called-for"};
    return names.at(static_cast<std::size_t>(bears));
}

// Assumed ones first, then by how little is known of them.
std::vector<InputValue> in_order_of_doubt(CampaignSpec const& spec) {
    auto inputs = physical_inputs(spec);
    static constexpr std::array order{Basis::assumed, Basis::not_stated, Basis::by_default, Basis::measured,
                                      Basis::published};
    std::ranges::stable_sort(inputs, {}, [](InputValue const& input) { return std::ranges::find(order, input.basis); });
    return inputs;
}

Json model_json(ModelAssumption const& assumption) {
    return {{"name", assumption.name},
            {"assumed", assumption.assumed},
            {"direction", overturn::name_of(assumption.direction)},
            {"key", assumption.key},
            {"effect", assumption.effect},
            {"evidence", assumption.evidence}};
}

Json input_json(InputValue const& input) {
    bool const of_file = input.span.is_known();
    return {{"key", input.key},
            {"value", input.text},
            {"basis", config::name_of(input.basis)},
            {"source", or_null(!input.source.empty(), input.source)},
            {"range", or_null(!input.range.empty(), input.range)},
            {"si", output::json_of(input.number ? output::Cell(*input.number) : output::Cell())},
            {"units", or_null(input.number.has_value(), si_symbol(input.dimension))},
            {"file", or_null(of_file, input.file)},
            {"line", or_null(of_file, input.span.line)},
            {"column", or_null(of_file, input.span.column)}};
}

}  // namespace

std::string model_assumptions_text() {
    constexpr std::size_t name_width = 25;  // of the longest name, with two blanks before it and one behind
    std::string text =
        "assumptions of the model\n"
        "  unsafe: if the assumption is false, more bodies overturn than computed\n"
        "  key: replaces the assumption; effect: as measured by a study of this project\n";
    for (auto const& one : model_assumptions()) {
        text += labelled(fmt::format("  {}", one.name), one.assumed, name_width);
        text += labelled("", fmt::format("{}; key: {}", overturn::name_of(one.direction), one.key), name_width);
        text += labelled("", fmt::format("effect: {} ({})", one.effect, one.evidence), name_width);
    }
    return text;
}

Json model_assumptions_json() {
    auto list = Json::array();
    for (auto const& one : model_assumptions()) {
        list.push_back(model_json(one));
    }
    return list;
}

Json assumptions_json(CampaignSpec const& spec) {
    auto const inputs = in_order_of_doubt(spec);
    auto const tally = tally_of(inputs);
    Json json{{"counts",
               {{"inputs", tally.all()},
                {"assumed", tally.assumed},
                {"published", tally.published},
                {"measured", tally.measured},
                {"not_stated", tally.not_stated},
                {"default", tally.by_default}}},
              {"inputs", Json::array()},
              {"model", Json::array()}};
    for (auto const& input : inputs) {
        json["inputs"].push_back(input_json(input));
    }
    for (auto const& one : model_assumptions()) {
        json["model"].push_back(model_json(one));
        json["model"].back()["bears"] = name_of(one.bears(spec));
    }
    return json;
}

std::string assumptions_lines(CampaignSpec const& spec, bool full) {
    constexpr std::size_t most_keys = 2;
    auto const inputs = in_order_of_doubt(spec);
    auto const tally = tally_of(inputs);
    auto text = labelled("inputs", full ? text_of(tally)
                                        : fmt::format("{}: {} assumed, {} published, {} measured, {} without a "
                                                      "source, {} defaults (list: --full)",
                                                      tally.all(), tally.assumed, tally.published, tally.measured,
                                                      tally.not_stated, tally.by_default));
    std::vector<std::string> unstated, assumed;
    for (auto const& input : inputs) {
        if (input.basis == Basis::not_stated) {
            unstated.push_back(input.key);
        } else if (input.basis == Basis::assumed) {
            assumed.push_back(input.key);
            text += !full ? ""
                          : labelled("assumed", fmt::format("{} = {}{}", input.key, input.text,
                                                            input.source.empty() ? "" : " (" + input.source + ")"));
        }
    }
    if (!full && !assumed.empty()) {
        text += labelled("assumed", names_text(assumed, most_keys) + " (values and reasons: --full)");
    }
    if (full && !unstated.empty()) {
        text += labelled("no source", fmt::format(R"({}: state basis = "published", "measured" or "assumed")",
                                                  fmt::join(unstated, ", ")));
    }
    std::vector<std::string> unsafe;
    std::size_t bearing = 0;
    for (auto const& one : model_assumptions()) {
        if (one.bears(spec) == Bears::no) {
            continue;
        }
        ++bearing;
        if (one.direction == Misjudged::unsafe) {
            unsafe.emplace_back(one.name);
        }
    }
    return text
           + labelled(
               "model",
               fmt::format("{} assumptions, {} unsafe (if false, more bodies overturn){}: overturn list "
                           "assumptions",
                           bearing, unsafe.size(), full ? fmt::format(" {}", fmt::join(unsafe, ", ")) : std::string()));
}

}  // namespace overturn::cli
