#include <algorithm>
#include <bit>
#include <cstring>
#include <sstream>

#include <fmt/format.h>

#include "core/error.hpp"
#include "store/detail/category_names.hpp"
#include "store/detail/dataset_rows.hpp"
#include "store/detail/objects.hpp"
#include "store/detail/opened_file.hpp"

namespace overturn::store {
namespace {

bool exists(File const& file, std::string const& path) {
    for (std::size_t slash = path.find('/', 1); slash != std::string::npos; slash = path.find('/', slash + 1)) {
        if (H5Lexists(file.id(), path.substr(0, slash).c_str(), H5P_DEFAULT) <= 0) {
            return false;
        }
    }
    return H5Lexists(file.id(), path.c_str(), H5P_DEFAULT) > 0;
}

void require_dataset(File const& file, std::string const& name) {
    validate(exists(file, name), "results file: has no {} {}", name, advice);
}

Dataset open_dataset(File const& file, std::string const& name) {
    require_dataset(file, name);
    return Dataset(checked(H5Dopen2(file.id(), name.c_str(), H5P_DEFAULT), "open " + name));
}

// A column of numbers, or of names for numbers. \throws InputError if it is none
Dataset open_numbers(File const& file, std::string const& name) {
    auto dataset = open_dataset(file, name);
    Datatype const type(checked(H5Dget_type(dataset.id()), "read a type"));
    auto const kind = H5Tget_class(type.id());
    validate(kind == H5T_FLOAT || kind == H5T_INTEGER || kind == H5T_ENUM,
             "results file: {} holds no numbers (it was edited). Restore it or run the campaign again", name);
    return dataset;
}

// A damaged file may promise more than any memory holds.
void require_plausible(File const& file, std::string const& name, hssize_t size) {
    hsize_t held = 0;
    checked(H5Fget_filesize(file.id(), &held), "ask for the file's size");
    constexpr hsize_t densest = 1100;  // what compression can make of zeros
    if (size > 0 && static_cast<hsize_t>(size) / densest > held) {
        throw SystemError(
            fmt::format("HDF5: cannot read {} ({} values in a file of {} bytes: it is damaged)", name, size, held));
    }
}

template <class Value> std::vector<Value> read_all(File const& file, std::string const& name, hid_t memory_type) {
    auto const dataset = open_numbers(file, name);
    Dataspace const space(checked(H5Dget_space(dataset.id()), "read a dataspace"));
    auto const size = H5Sget_simple_extent_npoints(space.id());
    require_plausible(file, name, size);
    std::vector<Value> values(std::max<hssize_t>(0, size));
    if (!values.empty()) {
        checked(H5Dread(dataset.id(), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "read " + name);
    }
    return values;
}

template <class Value>
Value read_one(Dataset const& dataset, std::string const& name, hid_t memory_type, std::int64_t row) {
    Value value{};
    read_some(dataset, name, memory_type, row, 1, &value);
    return value;
}

std::int64_t length_of(Dataset const& dataset) {
    Dataspace const space(checked(H5Dget_space(dataset.id()), "read a dataspace"));
    return H5Sget_simple_extent_ndims(space.id()) == 1 ? H5Sget_simple_extent_npoints(space.id()) : -1;
}

// Type and length.
void measure(Dataset const& dataset, ColumnMeaning& column) {
    Datatype const type(checked(H5Dget_type(dataset.id()), "read a type"));
    auto const kind = H5Tget_class(type.id());
    bool const number = kind == H5T_FLOAT || kind == H5T_INTEGER || kind == H5T_ENUM;
    column.type = kind == H5T_ENUM ? FieldType::category : kind == H5T_INTEGER ? FieldType::integer : FieldType::real;
    column.rows = number ? length_of(dataset) : -1;
}

// A column that the file does not have.
void fill_absent(Field const& column, std::size_t row_bytes, std::span<std::byte> rows) {
    for (std::size_t place = column.offset; place < rows.size(); place += row_bytes) {
        auto const bits = column.type == FieldType::real ? std::bit_cast<std::int64_t>(never) : column.absent;
        std::memcpy(rows.data() + place, &bits, sizeof(bits));
    }
}

}  // namespace

std::string ResultsReader::text(std::string const& name) const { return read_text_attribute(opened_->file.id(), name); }
std::int64_t ResultsReader::integer(std::string const& name) const {
    return read_integer_attribute(opened_->file.id(), name);
}

bool ResultsReader::has(std::string const& dataset) const { return exists(opened_->file, dataset); }
void ResultsReader::require(std::string const& dataset) const { require_dataset(opened_->file, dataset); }

std::int64_t ResultsReader::length(std::string const& dataset) const {
    auto const rows = length_of(open_numbers(opened_->file, dataset));
    require_plausible(opened_->file, dataset, rows);
    return std::max<std::int64_t>(0, rows);
}

std::optional<Layout> ResultsReader::layout() const {
    auto const dataset = open_numbers(opened_->file, std::string(layout_column));
    PropertyList const made(checked(H5Dget_create_plist(dataset.id()), fmt::format("look at {}", layout_column)));
    return H5Pget_layout(made.id()) == H5D_CHUNKED ? std::optional(Layout::packed)
           : length_of(dataset) > rows_of_a_chunk  ? std::optional(Layout::plain)
                                                   : std::nullopt;
}

std::vector<std::string> ResultsReader::members(std::string const& group) const {
    std::vector<std::string> names;
    if (!has(group)) {
        return names;
    }
    auto const add = [](hid_t, char const* name, H5L_info_t const*, void* list) -> herr_t {
        static_cast<std::vector<std::string>*>(list)->emplace_back(name);
        return 0;
    };
    Group const handle(checked(H5Gopen2(opened_->file.id(), group.c_str(), H5P_DEFAULT), "open group " + group));
    checked(H5Literate(handle.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names), "list " + group);
    return names;
}

std::vector<ColumnMeaning> ResultsReader::columns() const {
    std::vector<ColumnMeaning> found;
    each_object(opened_->file, [&](std::string const& path, Object const& object) {
        if (H5Iget_type(object.id()) != H5I_DATASET) {
            return;
        }
        auto const text = [&](char const* name) {
            return H5Aexists(object.id(), name) > 0 ? read_text_attribute(object.id(), name) : std::string();
        };
        found.push_back({path.substr(1), text("units"), text("description")});
        measure(open_dataset(opened_->file, path), found.back());
    });
    std::ranges::sort(found, {}, &ColumnMeaning::path);
    return found;
}

std::vector<double> ResultsReader::reals(std::string const& dataset) const {
    return read_all<double>(opened_->file, dataset, H5T_NATIVE_DOUBLE);
}

std::vector<std::int64_t> ResultsReader::integers(std::string const& dataset) const {
    auto const handle = open_numbers(opened_->file, dataset);
    if (is_category(handle)) {
        auto const length = length_of(handle);
        require_plausible(opened_->file, dataset, length);
        return read_categories(handle, dataset, 0, std::max<std::int64_t>(0, length));
    }
    return read_all<std::int64_t>(opened_->file, dataset, H5T_NATIVE_INT64);
}

std::vector<std::string> ResultsReader::texts(std::string const& dataset) const {
    std::vector<std::string> values;
    if (!has(dataset)) {
        auto const slash = dataset.rfind('/');
        std::istringstream lines(attribute_or(dataset.substr(0, slash), dataset.substr(slash + 1), ""));
        for (std::string line; std::getline(lines, line);) {
            values.push_back(line);
        }
        return values;
    }
    auto const names = categories(dataset);
    for (auto const number : integers(dataset)) {
        auto const name = std::ranges::find(names, number, &Category::value);
        validate(name != names.end(), "results file: {} holds no texts {}", dataset, advice);
        values.push_back(name->name == no_text ? "" : name->name);
    }
    return values;
}

std::vector<Category> ResultsReader::categories(std::string const& dataset) const {
    if (!has(dataset)) {
        return {};
    }
    auto const handle = open_numbers(opened_->file, dataset);
    return is_category(handle) ? stored_names(handle) : flagged_names(handle);
}

std::vector<std::int64_t> ResultsReader::named(std::string const& dataset, std::span<Category const> names) const {
    auto values = integers(dataset);
    auto const stored = categories(dataset);
    validate(!stored.empty() || values.empty(), "results file: {} holds no names {}", dataset, advice);
    rename_values(values, stored, names, dataset, false);
    return values;
}

double ResultsReader::real_at(std::string const& dataset, std::int64_t row) const {
    return read_one<double>(open_numbers(opened_->file, dataset), dataset, H5T_NATIVE_DOUBLE, row);
}

std::int64_t ResultsReader::integer_at(std::string const& dataset, std::int64_t row) const {
    auto const handle = open_numbers(opened_->file, dataset);
    if (is_category(handle)) {
        return read_categories(handle, dataset, row, 1).front();
    }
    return read_one<std::int64_t>(handle, dataset, H5T_NATIVE_INT64, row);
}

void ResultsReader::rows(TableSpec const& spec, std::int64_t length, std::int64_t first,
                         std::span<std::byte> rows) const {
    auto const count = rows.size() / spec.row_bytes;
    OVERTURN_EXPECT(rows.size() % spec.row_bytes == 0);
    std::vector<std::int64_t> values(count);
    for (auto const& column : spec.columns) {
        auto const name = spec.group + "/" + column.name;
        if (!has(name)) {
            if (column.essential) {
                require(name);
            }
            fill_absent(column, spec.row_bytes, rows);
            continue;
        }
        auto const dataset = open_numbers(opened_->file, name);
        auto const stored = length_of(dataset);
        validate(stored == length, "results file: {} has {} rows, the campaign {} {}", name, stored, length, advice);
        if (column.type == FieldType::category) {
            validate(is_category(dataset), "results file: {} holds no names {}", name, advice);
            values = read_categories(dataset, name, first, count);
            rename_values(values, stored_names(dataset), column.categories, name, column.essential);
        } else {
            read_some(dataset, name, column.type == FieldType::real ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT64, first,
                      count, values.data());
        }
        for (std::size_t i = 0; i < count; ++i) {
            std::memcpy(rows.data() + i * spec.row_bytes + column.offset, &values[i], sizeof(std::int64_t));
        }
    }
}

std::string ResultsReader::content(std::string const& dataset) const {
    auto const bytes = read_all<std::uint8_t>(opened_->file, dataset, H5T_NATIVE_UINT8);
    return {bytes.begin(), bytes.end()};
}

std::string ResultsReader::text_attribute(std::string const& object, std::string const& name) const {
    Handle<H5Oclose> const handle(checked(H5Oopen(opened_->file.id(), object.c_str(), H5P_DEFAULT), "open " + object));
    return read_text_attribute(handle.id(), name);
}

std::string ResultsReader::attribute_or(std::string const& object, std::string const& name,
                                        std::string const& other) const {
    if (!has(object) || H5Aexists_by_name(opened_->file.id(), object.c_str(), name.c_str(), H5P_DEFAULT) <= 0) {
        return other;
    }
    return text_attribute(object, name);
}

std::string hdf5_version() {
    Quiet const first;  // asking wakes the library, and its ending can be set only before that
    unsigned major = 0;
    unsigned minor = 0;
    unsigned release = 0;
    checked(H5get_libversion(&major, &minor, &release), "read its version");
    return fmt::format("{}.{}.{}", major, minor, release);
}

}  // namespace overturn::store
