#include "store/detail/dataset_rows.hpp"

namespace overturn::store {

PropertyList dataset_properties() {
    PropertyList properties(checked(H5Pcreate(H5P_DATASET_CREATE), "make dataset properties"));
    checked(H5Pset_obj_track_times(properties.id(), false), "leave times out");
    return properties;
}

void write_rows(Dataset const& dataset, hid_t memory_type, void const* values, std::int64_t first, std::int64_t count,
                std::string const& name) {
    auto const start = static_cast<hsize_t>(first);
    auto const size = static_cast<hsize_t>(count);
    Dataspace const memory(checked(H5Screate_simple(1, &size, nullptr), "make a dataspace"));
    Dataspace const file(checked(H5Dget_space(dataset.id()), "read a dataspace"));
    checked(H5Sselect_hyperslab(file.id(), H5S_SELECT_SET, &start, nullptr, &size, nullptr), "select rows");
    checked(H5Dwrite(dataset.id(), memory_type, memory.id(), file.id(), H5P_DEFAULT, values), "write " + name);
}

}  // namespace overturn::store
