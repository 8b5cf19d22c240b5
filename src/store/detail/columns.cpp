#include "store/detail/columns.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <hdf5_hl.h>

#include "core/error.hpp"

namespace overturn::store {
namespace {

Datatype enumeration(Field const& column) {
    bool const small = category_bytes(column) == 1;
    Datatype type(checked(H5Tenum_create(small ? H5T_STD_U8LE : H5T_STD_U16LE), "make an enumeration"));
    for (auto const& category : column.categories) {
        auto const value = static_cast<std::uint16_t>(category.value);  // its first byte is the small one
        checked(H5Tenum_insert(type.id(), category.name.c_str(), &value), "name " + category.name);
    }
    return type;
}

bool same_names(Field const& a, Field const& b) {
    return std::ranges::equal(a.categories, b.categories,
                              [](auto const& x, auto const& y) { return x.value == y.value && x.name == y.name; });
}

// CF: a blank parts two meanings.
void write_flags(Dataset const& dataset, Field const& column) {
    std::vector<std::int64_t> values;
    std::string meanings;
    for (auto const& category : column.categories) {
        values.push_back(category.value);
        auto word = category.name;
        std::ranges::replace(word, ' ', '_');
        meanings += (meanings.empty() ? "" : " ") + word;
    }
    // CF: of the type that the values have.
    auto const stored = column.type != FieldType::category ? H5T_STD_I64LE
                        : category_bytes(column) == 1      ? H5T_STD_U8LE
                                                           : H5T_STD_U16LE;
    auto const count = static_cast<hsize_t>(values.size());
    Dataspace const space(checked(H5Screate_simple(1, &count, nullptr), "make a dataspace"));
    Attribute const flags(checked(H5Acreate2(dataset.id(), "flag_values", stored, space.id(), H5P_DEFAULT, H5P_DEFAULT),
                                  "make flag_values"));
    checked(H5Awrite(flags.id(), H5T_NATIVE_INT64, values.data()), "write flag_values");
    write_attribute(dataset.id(), "flag_meanings", meanings);
}

}  // namespace

std::size_t category_bytes(Field const& column) {
    std::int64_t largest = 0;
    for (auto const& category : column.categories) {
        largest = std::max(largest, category.value);
    }
    OVERTURN_EXPECT(largest <= std::numeric_limits<std::uint16_t>::max());
    return largest <= std::numeric_limits<std::uint8_t>::max() ? 1 : 2;
}

hid_t ColumnTypes::of(File const& file, Field const& column) {
    if (column.type != FieldType::category) {
        return column.type == FieldType::real ? H5T_IEEE_F64LE : H5T_STD_I64LE;
    }
    auto name = column.name + "_type";
    for (int next = 2; committed_.contains(name); ++next) {
        if (auto const& there = committed_.at(name); same_names(there.column, column)) {
            return there.type.id();
        }
        name = fmt::format("{}_type_{}", column.name, next);
    }
    auto type = enumeration(column);
    PropertyList const properties(checked(H5Pcreate(H5P_DATATYPE_CREATE), "make type properties"));
    checked(H5Pset_obj_track_times(properties.id(), false), "leave times out");
    checked(H5Tcommit2(file.id(), name.c_str(), type.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT),
            "commit " + name);
    return committed_.emplace(name, Committed{column, std::move(type)}).first->second.type.id();
}

void ColumnTypes::release() {
    for (auto& [name, committed] : committed_) {
        committed.type.release();
    }
}

void describe(Dataset const& dataset, Field const& column) {
    if (!column.units.empty()) {
        write_attribute(dataset.id(), "units", column.units);
    }
    write_attribute(dataset.id(), "description", column.description);
    write_attribute(dataset.id(), "long_name", column.description);
    if (!column.categories.empty()) {
        write_flags(dataset, column);
    }
    for (auto const& [name, text] : column.notes) {
        write_attribute(dataset.id(), name, text);
    }
}

void make_axis(Dataset const& dataset, std::string const& name) {
    if (H5DSis_scale(dataset.id()) <= 0) {
        checked(H5DSset_scale(dataset.id(), name.c_str()), "make an axis of " + name);
    }
}

void attach_axis(Dataset const& dataset, Dataset const& axis, std::string const& name) {
    make_axis(axis, name);
    checked(H5DSattach_scale(dataset.id(), axis.id(), 0), "attach axis " + name);
}

}  // namespace overturn::store
