#include <algorithm>
#include <cstring>

#include "store/detail/dataset_rows.hpp"
#include "store/results_file.hpp"

namespace overturn::store {

void ResultsWriter::write_categories(Dataset const& dataset, Field const& spec, std::span<std::int64_t const> values,
                                     std::int64_t first, std::string const& name) {
    auto const bytes = category_bytes(spec);
    std::vector<std::byte> categories(values.size() * bytes);
    for (std::size_t i = 0; i < values.size(); ++i) {  // little-endian, here and there
        std::memcpy(categories.data() + i * bytes, &values[i], bytes);
    }
    write_rows(dataset, types_.of(file_, spec), categories.data(), first, static_cast<std::int64_t>(values.size()),
               name);
}

void ResultsWriter::array(std::string const& where, Field const& spec, std::vector<double> const& values,
                          std::string const& scale) {
    write_array(where, spec, H5T_NATIVE_DOUBLE, values.data(), values.size(), scale);
}

void ResultsWriter::array(std::string const& where, Field const& spec, std::vector<std::int64_t> const& values,
                          std::string const& scale) {
    if (spec.type == FieldType::category) {
        auto const dataset = create(where, spec, static_cast<std::int64_t>(values.size()));
        write_categories(dataset, spec, values, 0, spec.name);
        checked(H5Dflush(dataset.id()), "write " + spec.name);
        lay_along(where, dataset, spec.name, scale);
        return;
    }
    auto integer = spec;
    integer.type = FieldType::integer;
    write_array(where, integer, H5T_NATIVE_INT64, values.data(), values.size(), scale);
}

void ResultsWriter::write_array(std::string const& where, Field const& spec, hid_t memory_type, void const* values,
                                std::size_t count, std::string const& scale) {
    auto const size = static_cast<std::int64_t>(count);
    auto const dataset = create(where, spec, size);
    write_rows(dataset, memory_type, values, 0, size, spec.name);
    checked(H5Dflush(dataset.id()), "write " + spec.name);
    lay_along(where, dataset, spec.name, scale);
}

void ResultsWriter::bytes(std::string const& where, std::string const& name, std::string const& description,
                          std::string const& content) {
    auto const size = static_cast<hsize_t>(content.size());
    Dataspace const space(checked(H5Screate_simple(1, &size, nullptr), "make a dataspace"));
    auto const properties = dataset_properties();
    if (size > 0) {
        constexpr hsize_t largest_chunk = 1 << 20;
        hsize_t const chunk = std::min(size, largest_chunk);
        constexpr unsigned level = 6;
        checked(H5Pset_chunk(properties.id(), 1, &chunk), "set chunks");
        checked(H5Pset_deflate(properties.id(), level), "set compression");
    }
    Dataset const dataset(checked(H5Dcreate2(group(where).id(), name.c_str(), H5T_STD_U8LE, space.id(), H5P_DEFAULT,
                                             properties.id(), H5P_DEFAULT),
                                  "create " + where + "/" + name));
    describe(dataset, {name, "1", description});
    make_axis(dataset, name);
    if (size > 0) {
        checked(H5Dwrite(dataset.id(), H5T_NATIVE_UINT8, H5S_ALL, H5S_ALL, H5P_DEFAULT, content.data()),
                "write " + name);
        checked(H5Dflush(dataset.id()), "write " + name);
    }
}

}  // namespace overturn::store
