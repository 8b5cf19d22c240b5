#include "output/json.hpp"

#include <cmath>

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

Json json_of(Table const& table) {
    auto list = Json::array();
    std::vector<std::string> keys;
    for (auto const& column : table.columns) {
        keys.push_back(column.key());
    }
    for (auto const& row : table.rows) {
        auto object = Json::object();
        for (auto const& [name, value] : table.constants) {
            object[name] = json_of(value);
        }
        for (std::size_t c = 0; c < keys.size(); ++c) {
            object[keys[c]] = json_of(row[c]);
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
