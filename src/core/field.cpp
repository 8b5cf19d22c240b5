#include "core/field.hpp"

#include <algorithm>
#include <cstring>
#include <map>

#include "core/error.hpp"

namespace overturn {
namespace {

template <class Value> Value value_at(std::span<std::byte const> row, Field const& field) {
    Value value{};
    OVERTURN_EXPECT(field.offset + sizeof(value) <= row.size());
    std::memcpy(&value, row.data() + field.offset, sizeof(value));
    return value;
}

}  // namespace

std::vector<Category> numbered(std::vector<std::string> names) {
    std::vector<Category> categories;
    categories.reserve(names.size());
    for (auto& name : names) {
        categories.push_back({std::ssize(categories), std::move(name)});
    }
    return categories;
}

std::string Field::key() const {
    static std::map<std::string, std::string> const suffixes{
        {"1", ""},         {"s", "_s"},         {"m", "_m"},        {"rad", "_rad"},     {"m/s", "_mps"},
        {"m/s2", "_mps2"}, {"J/kg", "_jpkg"},   {"kg", "_kg"},      {"Hz", "_hz"},       {"N", "_n"},
        {"Pa", "_pa"},     {"rad/s", "_radps"}, {"kg m2", "_kgm2"}, {"1/a", "_per_year"}};
    auto const suffix = suffixes.find(units);
    OVERTURN_EXPECT(suffix != suffixes.end());
    return name + (suffix == suffixes.end() ? "" : suffix->second);
}

Field Field::always() const {
    auto field = *this;
    field.essential = true;
    return field;
}

Field Field::if_absent(std::int64_t value) const {
    auto field = *this;
    field.absent = value;
    return field;
}

double real_at(std::span<std::byte const> row, Field const& field) { return value_at<double>(row, field); }

std::int64_t integer_at(std::span<std::byte const> row, Field const& field) {
    return value_at<std::int64_t>(row, field);
}

void set_real(std::span<std::byte> row, Field const& field, double value) {
    OVERTURN_EXPECT(field.offset + sizeof(value) <= row.size());
    std::memcpy(row.data() + field.offset, &value, sizeof(value));
}

std::string category_at(std::span<std::byte const> row, Field const& field) {
    auto const value = integer_at(row, field);
    auto const found = std::ranges::find(field.categories, value, &Category::value);
    return found != field.categories.end() ? found->name : fmt::format("{}", value);
}

std::vector<std::string> differing(Fields const& fields, std::span<std::byte const> a, std::span<std::byte const> b) {
    std::vector<std::string> names;
    for (auto const& field : fields) {
        if (integer_at(a, field) != integer_at(b, field)) {
            names.push_back(field.name);
        }
    }
    return names;
}

Field const& field_named(Fields const& fields, std::string_view name) {
    auto const found = std::ranges::find(fields, name, &Field::name);
    OVERTURN_EXPECT(found != fields.end());
    return *found;
}

}  // namespace overturn
