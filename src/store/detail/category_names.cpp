#include "store/detail/category_names.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <map>
#include <memory>
#include <sstream>
#include <vector>

#include "core/error.hpp"

namespace overturn::store {

bool is_category(Dataset const& dataset) {
    Datatype const type(checked(H5Dget_type(dataset.id()), "read a type"));
    return H5Tget_class(type.id()) == H5T_ENUM;
}

void read_some(Dataset const& dataset, std::string const& name, hid_t memory_type, std::int64_t first,
               std::int64_t count, void* values) {
    Dataspace const file(checked(H5Dget_space(dataset.id()), "read a dataspace"));
    auto const start = static_cast<hsize_t>(first);
    auto const size = static_cast<hsize_t>(count);
    Dataspace const memory(checked(H5Screate_simple(1, &size, nullptr), "make a dataspace"));
    checked(H5Sselect_hyperslab(file.id(), H5S_SELECT_SET, &start, nullptr, &size, nullptr), "select rows");
    checked(H5Dread(dataset.id(), memory_type, memory.id(), file.id(), H5P_DEFAULT, values), "read " + name);
}

std::vector<std::int64_t> read_categories(Dataset const& dataset, std::string const& name, std::int64_t first,
                                          std::int64_t count) {
    Datatype const type(checked(H5Dget_type(dataset.id()), "read a type"));
    auto const bytes = H5Tget_size(type.id());
    validate(bytes >= 1 && bytes <= sizeof(std::int64_t),
             "results file: {} holds names of {} bytes (it is not of this program). Run the "
             "campaign again",
             name, bytes);
    std::vector<std::byte> raw(count * bytes);
    if (count > 0) {
        read_some(dataset, name, type.id(), first, count, raw.data());
    }
    std::vector<std::int64_t> values(count);
    for (std::size_t i = 0; i < values.size(); ++i) {
        std::memcpy(&values[i], raw.data() + i * bytes, bytes);
    }
    return values;
}

std::vector<Category> stored_names(Dataset const& dataset) {
    Datatype const type(checked(H5Dget_type(dataset.id()), "read a type"));
    std::vector<Category> names;
    auto const count = H5Tget_nmembers(type.id());
    for (unsigned member = 0; count > 0 && member < static_cast<unsigned>(count); ++member) {
        std::unique_ptr<char, herr_t (*)(void*)> const name(H5Tget_member_name(type.id(), member), &H5free_memory);
        std::vector<std::byte> value(H5Tget_size(type.id()));
        checked(H5Tget_member_value(type.id(), member, value.data()), "read a name's number");
        std::int64_t number = 0;  // little-endian, here and in the file
        std::memcpy(&number, value.data(), std::min(value.size(), sizeof(number)));
        names.push_back({number, name ? name.get() : ""});
    }
    return names;
}

std::vector<Category> flagged_names(Dataset const& dataset) {
    if (H5Aexists(dataset.id(), "flag_values") <= 0 || H5Aexists(dataset.id(), "flag_meanings") <= 0) {
        return {};
    }
    std::istringstream words(read_text_attribute(dataset.id(), "flag_meanings"));
    std::vector<std::string> const meanings{std::istream_iterator<std::string>(words), {}};
    Attribute const flags(checked(H5Aopen(dataset.id(), "flag_values", H5P_DEFAULT), "open flag_values"));
    Dataspace const space(checked(H5Aget_space(flags.id()), "read a dataspace"));
    auto const count = H5Sget_simple_extent_npoints(space.id());
    if (count != static_cast<hssize_t>(meanings.size())) {
        return {};
    }
    std::vector<std::int64_t> values(meanings.size());
    checked(H5Aread(flags.id(), H5T_NATIVE_INT64, values.data()), "read flag_values");
    std::vector<Category> names;
    for (std::size_t i = 0; i < values.size(); ++i) {
        names.push_back({values[i], meanings[i]});
    }
    return names;
}

void rename_values(std::vector<std::int64_t>& values, std::span<Category const> stored,
                   std::span<Category const> wanted, std::string const& column, bool essential) {
    std::map<std::int64_t, std::int64_t> renamed;
    for (auto& value : values) {
        auto found = renamed.find(value);
        if (found == renamed.end()) {
            auto const name = std::ranges::find(stored, value, &Category::value);
            validate(name != stored.end(), "results file: {} holds {}, which has no name {}", column, value, advice);
            auto const ours = std::ranges::find(wanted, name->name, &Category::name);
            validate(ours != wanted.end() || !essential,
                     "results file: {} holds '{}', which this program does not know. Use the program that wrote it",
                     column, name->name);
            found = renamed.emplace(value, ours != wanted.end() ? ours->value : unknown_category).first;
        }
        value = found->second;
    }
}

}  // namespace overturn::store
