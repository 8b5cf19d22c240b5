#include "results/stored_names.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <string_view>
#include <utility>

#include "core/error.hpp"
#include "response/registry.hpp"
#include "results/schema.hpp"
#include "store/known_columns.hpp"

namespace overturn {
namespace {

constexpr char const* verdict_column = "trials/verdict";

// Is the name one of the column's attribute, "rocked, overturned"?
bool is_listed(store::ResultsReader const& file, char const* attribute, std::string_view name) {
    auto const list = ", " + file.attribute_or(verdict_column, attribute, "") + ", ";
    return list.find(fmt::format(", {}, ", name)) != std::string::npos;
}

Verdict meaning_of(store::ResultsReader const& file, std::string_view name) {
    if (is_listed(file, "fell", name)) {
        return Verdict::overturned;
    }
    if (!is_listed(file, "decided", name)) {
        return Verdict::contact_lost;
    }
    return is_listed(file, "moved", name) ? Verdict::rocked : Verdict::at_rest;
}

constexpr std::string_view of_model = "trials/";  // groups of columns of one model alone

bool is_of_model(std::string_view model, std::string_view column) {
    return std::ranges::any_of(models(), [&](auto const& known) {
        auto const& traits = known.traits();
        return traits.name == model
               && (column == "trial" || std::ranges::find(traits.fields, column, &Field::name) != traits.fields.end());
    });
}

// Of trials and waves, whose columns follow from the campaign.
bool is_of_rows(std::string_view group) {
    return group == "trials" || group.starts_with(of_model) || group == "waves" || group.starts_with("waves/");
}

struct ColumnPath {
    std::string group, name;
};

ColumnPath placed(std::string const& path) {
    auto const slash = path.rfind('/');
    return slash == std::string::npos ? ColumnPath{{}, path}
                                      : ColumnPath{path.substr(0, slash), path.substr(slash + 1)};
}

bool is_known(ColumnPath const& path, std::span<store::TableSpec const> tables) {
    auto const table = std::ranges::find(tables, path.group, &store::TableSpec::group);
    if (table == tables.end()) {
        return path.group.starts_with(of_model) && is_of_model(path.group.substr(of_model.size()), path.name);
    }
    return path.name == table->axis || path.group + "/" + path.name == table->axis
           || std::ranges::find(table->columns, path.name, &Field::name) != table->columns.end();
}

std::vector<store::TableSpec> tables_of_rows(CampaignSpec const& spec) {
    std::vector<store::TableSpec> tables{trial_table(spec), wave_table(spec)};
    std::ranges::move(measure_tables(spec), std::back_inserter(tables));
    return tables;
}

}  // namespace

std::vector<Category> verdicts_in(store::ResultsReader const& file) {
    auto categories = verdict_categories();
    for (auto const& stored : file.categories(verdict_column)) {
        if (std::ranges::find(categories, stored.name, &Category::name) == categories.end()) {
            categories.push_back({static_cast<std::int64_t>(meaning_of(file, stored.name)), stored.name});
        }
    }
    return categories;
}

std::vector<Category> unknown_verdicts(store::ResultsReader const& file) {
    // verdicts_in puts them behind those that are known.
    auto const all = verdicts_in(file);
    return {all.begin() + std::ssize(verdict_categories()), all.end()};
}

std::vector<UnknownModel> unknown_models(store::ResultsReader const& file) {
    constexpr char const* column = "trials/rung";
    std::vector<UnknownModel> unknown;
    for (auto const& stored : file.categories(column)) {
        if (std::ranges::find(model_categories(), stored.name, &Category::name) != model_categories().end()) {
            continue;
        }
        auto const numbers = file.integers(column);
        if (auto const trials = std::ranges::count(numbers, stored.value); trials > 0) {
            unknown.push_back({stored.name, trials});
        }
    }
    return unknown;
}

std::vector<std::string> unknown_columns_of_results(store::ResultsReader const& file) {
    auto const bodies = file.members("bodies");
    std::vector<std::string> unknown;
    for (auto const& column : file.columns()) {
        auto const path = placed(column.path);
        auto const group = store::page_name_of(path.group, bodies);
        if (!is_of_rows(group) && group != "inputs" && !store::is_known_column(group, path.name)) {
            unknown.push_back(column.path);
        }
    }
    return unknown;
}

std::vector<std::string> unknown_columns(store::ResultsReader const& file, CampaignSpec const& spec) {
    auto const known = tables_of_rows(spec);
    auto unknown = unknown_columns_of_results(file);
    for (auto const& column : file.columns()) {
        auto const path = placed(column.path);
        if (is_of_rows(path.group) && !is_known(path, known)) {
            unknown.push_back(column.path);
        }
    }
    std::ranges::sort(unknown);
    return unknown;
}

std::vector<std::string> absent_columns(store::ResultsReader const& file, CampaignSpec const& spec) {
    auto tables = tables_of_rows(spec);
    std::ranges::move(extra_tables(ModelSelector(spec.effects, spec.accuracy)), std::back_inserter(tables));
    std::vector<std::string> absent;
    for (auto const& table : tables) {
        for (auto const& column : table.columns) {
            if (auto path = table.group + "/" + column.name; !file.has(path)) {
                absent.push_back(std::move(path));
            }
        }
    }
    return absent;
}

std::vector<double> reals_or_unknown(store::ResultsReader const& file, std::string const& column, std::size_t rows) {
    return file.has(column) ? file.reals(column) : std::vector<double>(rows, never);
}

std::vector<Verdict> stored_verdicts(store::ResultsReader const& file) {
    auto const numbers = file.named(verdict_column, verdicts_in(file));
    std::vector<Verdict> verdicts;
    verdicts.reserve(numbers.size());
    std::ranges::transform(numbers, std::back_inserter(verdicts),
                           [](std::int64_t number) { return static_cast<Verdict>(number); });
    return verdicts;
}

store::TableSpec stored_trial_table(store::ResultsReader const& file, CampaignSpec const& spec) {
    auto table = trial_table(spec);
    auto const verdict = std::ranges::find(table.columns, "verdict", &Field::name);
    OVERTURN_EXPECT(verdict != table.columns.end());
    verdict->categories = verdicts_in(file);
    return table;
}

store::TableSpec held_in(store::ResultsReader const& file, store::TableSpec table) {
    std::erase_if(table.columns, [&](Field const& column) { return !file.has(table.group + "/" + column.name); });
    return table;
}

}  // namespace overturn
