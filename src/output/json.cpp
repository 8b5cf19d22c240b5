#include "output/json.hpp"

#include <cmath>
#include <utility>
#include <variant>

#include "core/field.hpp"

namespace overturn::output {

Json json_of(Cell const& cell) {
    return std::visit(
        [](auto const& value) -> Json {
            using Value = std::remove_cvref_t<decltype(value)>;
            if constexpr (std::is_same_v<Value, std::monostate>) {
                return nullptr;
            } else if constexpr (std::is_same_v<Value, double>) {
                return std::isfinite(value) ? Json(value) : Json(nullptr);
            } else {
                return value;
            }
        },
        cell);
}

Json stated_json(double si, IntensityUnit const& unit) {
    return {{"value", std::isfinite(si) ? Json(unit.of(si)) : Json(nullptr)}, {"unit", unit.symbol}};
}

Json json_of(Table const& table) {
    auto list = Json::array();
    std::vector<std::string> keys;
    for (auto const& column : table.columns) {
        keys.push_back(column.key());
    }
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
        auto const& row = table.rows[r];
        auto object = Json::object();
        for (auto const& [name, value] : table.constants) {
            object[name] = json_of(value);
        }
        Json stated;
        for (std::size_t c = 0; c < keys.size(); ++c) {
            object[keys[c]] = json_of(row[c]);
            auto const& of_column = table.columns[c].unit;
            if (auto const& unit =
                    of_column.by_row && r < table.typed_of_rows.size() ? table.typed_of_rows[r] : of_column.typed) {
                auto const* const si = std::get_if<double>(&row[c]);
                stated[table.columns[c].name] = stated_json(si != nullptr ? *si : never, *unit);
            }
        }
        if (!stated.is_null()) {
            object["stated"] = std::move(stated);
        }
        list.push_back(std::move(object));
    }
    return list;
}

Json json_of(std::span<Table const> tables) {
    auto json = Json::object();
    for (auto const& table : tables) {
        auto& list = json.emplace(table.name, Json::array()).first.value();
        for (auto& row : json_of(table)) {
            list.push_back(std::move(row));
        }
    }
    return json;
}

}  // namespace overturn::output
