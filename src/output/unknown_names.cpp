#include "output/unknown_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/texts_of.hpp"
#include "response/registry.hpp"
#include "results/stored_names.hpp"

namespace overturn::output {
namespace {

constexpr std::size_t most_named = 12;  // columns

}  // namespace

std::vector<std::string> unknown_names_text(store::ResultsReader const& file) {
    std::vector<std::string> verdicts;
    for (auto const& [value, name] : unknown_verdicts(file)) {
        verdicts.push_back(fmt::format("verdict '{}' is not known to this program: its trials count as {}", name,
                                       entry_of(static_cast<Verdict>(value)).name));
    }
    std::vector<std::string> models;
    for (auto const& [name, trials] : unknown_models(file)) {
        models.push_back(fmt::format("model '{}' is not known to this program: its {} count under no model", name,
                                     count_text(trials, "trial")));
    }
    std::vector<std::string> lines;
    for (auto const& group : {verdicts, models}) {
        if (!group.empty()) {
            lines.push_back(fmt::format("{}", fmt::join(group, "; ")));
        }
    }
    return lines;
}

std::string unknown_columns_text(store::ResultsReader const& file, CampaignSpec const& spec) {
    auto const unknown = unknown_columns(file, spec);
    return unknown.empty() ? std::string()
                           : "columns that this program does not know: " + names_text(unknown, most_named);
}

std::string absent_columns_text(store::ResultsReader const& file, CampaignSpec const& spec) {
    auto const absent = absent_columns(file, spec);
    return absent.empty() ? std::string()
                          : fmt::format("it has no {}: results that need {} are not known",
                                        names_text(absent, most_named), absent.size() == 1 ? "it" : "them");
}

}  // namespace overturn::output
