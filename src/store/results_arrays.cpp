#include <algorithm>

#include "store/detail/dataset_rows.hpp"
#include "store/detail/growing_file.hpp"

namespace overturn::store {

void ResultsWriter::array(std::string const& where, Field const& spec, std::vector<double> const& values,
                          std::string const& scale) {
    growing_->write_array(where, spec, H5T_NATIVE_DOUBLE, values.data(), values.size(), scale);
}

void ResultsWriter::array(std::string const& where, Field const& spec, std::vector<std::int64_t> const& values,
                          std::string const& scale) {
    if (spec.type == FieldType::category) {
        auto const dataset = growing_->create(where, spec, values.size());
        growing_->write_categories(dataset, spec, values, 0, spec.name);
        growing_->lay_along(where, dataset, spec.name, scale);
        return;
    }
    auto integer = spec;
    integer.type = FieldType::integer;
    growing_->write_array(where, integer, H5T_NATIVE_INT64, values.data(), values.size(), scale);
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
    Dataset const dataset(checked(H5Dcreate2(growing_->group(where).id(), name.c_str(), H5T_STD_U8LE, space.id(),
                                             H5P_DEFAULT, properties.id(), H5P_DEFAULT),
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
