/// The fields of a struct, each stated once: its name, unit and meaning serve the results file's writer and reader,
/// comparisons of every bit, and JSON.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace overturn {

/// A quantity that never came: no fall, no uplift, no friction. JSON writes it as null.
inline constexpr double never = std::numeric_limits<double>::quiet_NaN();

enum class FieldType { real, integer, category };

/// A name for one value of a field. Values are stored: never renumber.
struct Category {
    std::int64_t value = 0;
    std::string name;
};

/// The value of a category whose name this program does not know: of a file that another program wrote.
inline constexpr std::int64_t unknown_category = -1;

/// The names of 0, 1, 2, ...
[[nodiscard]] std::vector<Category> numbered(std::vector<std::string> names);

/// One field of a struct whose fields all take 8 bytes: double for real, a 64-bit integer or enumeration for the
/// others.
struct Field {
    std::string name;   ///< without the unit: "peak_slip"
    std::string units;  ///< "m"; "1" for a pure number
    std::string description;
    FieldType type = FieldType::real;
    std::size_t offset = 0;                 ///< in the struct [bytes]
    std::vector<Category> categories = {};  ///< where type is category
    std::int64_t absent = 0;                ///< value for files without this column; of a real one always NaN
    bool essential = false;                 ///< no file is without it, and no value of it without meaning
    std::vector<std::pair<std::string, std::string>> notes = {};  ///< further attributes of its column: name and text

    /// The same, as a column that every file has.
    [[nodiscard]] Field always() const;
    /// The same, with what a file without this column has instead.
    [[nodiscard]] Field if_absent(std::int64_t value) const;
    /// The name with its unit, as scripts know it from JSON: "peak_slip_m".
    [[nodiscard]] std::string key() const;
};

using Fields = std::vector<Field>;

/// The table of a struct: specialised beside it.
template <class Row> [[nodiscard]] Fields const& fields_of();

namespace field_detail {
template <class Row, class Value> Row row_of(Value Row::*);
template <class Row, class Value> Value value_of(Value Row::*);
}  // namespace field_detail

/// Offset of a member in its struct [bytes]. `Row`: the struct, where the member is of one that it derives from.
template <auto Member, class Row = decltype(field_detail::row_of(Member))> [[nodiscard]] std::size_t offset_of() {
    Row const row{};
    return static_cast<std::size_t>(reinterpret_cast<std::byte const*>(&(row.*Member))
                                    - reinterpret_cast<std::byte const*>(&row));
}

/// The line of a struct's table: field<&Outcome::peak_slip_m>("peak_slip", "m", "max |slip| of the base").
template <auto Member> [[nodiscard]] Field field(std::string name, std::string units, std::string description) {
    using Value = decltype(field_detail::value_of(Member));
    static_assert(sizeof(Value) == sizeof(double));
    using Row = decltype(field_detail::row_of(Member));
    auto const type = std::is_same_v<Value, double> ? FieldType::real : FieldType::integer;
    std::int64_t absent = 0;
    if constexpr (!std::is_same_v<Value, double>) {
        absent = static_cast<std::int64_t>(Row{}.*Member);
    }
    return {std::move(name), std::move(units), std::move(description), type, offset_of<Member>(), {}, absent};
}
/// The line of a member whose values have names.
template <auto Member>
[[nodiscard]] Field category(std::string name, std::string description, std::vector<Category> const& categories) {
    auto line = field<Member>(std::move(name), "1", std::move(description));
    line.type = FieldType::category;
    line.categories = categories;
    return line;
}

/// The fields of a base class as those of `Row`, which derives from it.
template <class Row, class Base> [[nodiscard]] Fields fields_of_base() {
    static_assert(std::is_base_of_v<Base, Row>);
    Row const row{};
    auto const shift = static_cast<std::size_t>(reinterpret_cast<std::byte const*>(static_cast<Base const*>(&row))
                                                - reinterpret_cast<std::byte const*>(&row));
    auto fields = fields_of<Base>();
    for (auto& field : fields) {
        field.offset += shift;
    }
    return fields;
}

/// The bytes of one row.
template <class Row> [[nodiscard]] std::span<std::byte const> bytes_of(Row const& row) {
    static_assert(std::is_trivially_copyable_v<Row>);
    return std::as_bytes(std::span(&row, 1));
}

[[nodiscard]] double real_at(std::span<std::byte const> row, Field const& field);
[[nodiscard]] std::int64_t integer_at(std::span<std::byte const> row, Field const& field);
void set_real(std::span<std::byte> row, Field const& field, double value);

/// The name of the category that the row's field holds; its number where it holds none.
[[nodiscard]] std::string category_at(std::span<std::byte const> row, Field const& field);

/// The fields in which two rows differ in any bit, by name.
[[nodiscard]] std::vector<std::string> differing(Fields const& fields, std::span<std::byte const> a,
                                                 std::span<std::byte const> b);
template <class Row> [[nodiscard]] std::vector<std::string> differing(Row const& a, Row const& b) {
    return differing(fields_of<Row>(), bytes_of(a), bytes_of(b));
}
template <class Row> [[nodiscard]] bool same_bits(Row const& a, Row const& b) { return differing(a, b).empty(); }

/// The field of that name. \pre there is one
[[nodiscard]] Field const& field_named(Fields const& fields, std::string_view name);

}  // namespace overturn
