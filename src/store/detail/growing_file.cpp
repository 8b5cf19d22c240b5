#include "store/detail/growing_file.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

#include <fmt/format.h>
#include <unistd.h>

#include "store/detail/dataset_rows.hpp"

namespace overturn::store {

ResultsWriter::Growing::Growing(std::string const& path, Layout how) : layout(how) {
    require_memory_for_hdf5();
    // Ours alone by the run's lock: HDF5's own lock would fail where a file system has none.
    PropertyList const access(checked(H5Pcreate(H5P_FILE_ACCESS), "make file properties"));
    checked(H5Pset_file_locking(access.id(), false, true), "leave locks out");
    // Nothing is held back for later, when a dataset is closed and no error is heard: to flush each costs more.
    checked(H5Pset_sieve_buf_size(access.id(), 0), "write at once");
    auto const id = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id());
    if (id < 0) {
        ::unlink(path.c_str());  // a full disk still takes an empty file
    }
    file = File(checked(id, "create " + path));
}

void ResultsWriter::Growing::abandon() {
    for (auto& table : tables) {
        for (auto& dataset : table.datasets) {
            dataset.release();
        }
        if (table.numbers) {
            table.numbers->release();
        }
    }
    for (auto& [path, group] : groups) {
        group.release();
    }
    types.release();
    file.release();
}

Group& ResultsWriter::Growing::group(std::string const& path) {
    auto const found = groups.find(path);
    if (found != groups.end()) {
        return found->second;
    }
    hid_t parent = file.id();
    auto const slash = path.rfind('/');
    if (slash != std::string::npos) {
        parent = group(path.substr(0, slash)).id();
    }
    auto const name = slash == std::string::npos ? path : path.substr(slash + 1);
    return groups
        .emplace(path, Group(checked(H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                                     "create group " + path)))
        .first->second;
}

Dataset ResultsWriter::Growing::create(std::string const& where, Field const& spec, std::int64_t rows, Room room) {
    auto const type = types.of(file, spec);
    auto const size = static_cast<hsize_t>(rows);
    Dataspace const space(checked(H5Screate_simple(1, &size, nullptr), "make a dataspace"));
    auto const properties = dataset_properties();
    PropertyList const access(checked(H5Pcreate(H5P_DATASET_ACCESS), "make dataset properties"));
    if (layout == Layout::packed) {
        bool const shows_it = fmt::format("{}/{}", where, spec.name) == layout_column;
        pack(properties, access, size, shows_it ? 0 : rows_of_a_chunk);
    } else if (room == Room::now) {
        checked(H5Pset_alloc_time(properties.id(), H5D_ALLOC_TIME_EARLY), "ask for room at once");
        checked(H5Pset_fill_time(properties.id(), H5D_FILL_TIME_NEVER), "leave it as it is");
    }
    Dataset dataset(checked(
        H5Dcreate2(group(where).id(), spec.name.c_str(), type, space.id(), H5P_DEFAULT, properties.id(), access.id()),
        "create " + where + "/" + spec.name));
    describe(dataset, spec);
    return dataset;
}

Dataset ResultsWriter::Growing::open(std::string const& path) const {
    return Dataset(checked(H5Dopen2(file.id(), path.c_str(), H5P_DEFAULT), "open " + path));
}

void ResultsWriter::Growing::lay_along(std::string const& where, Dataset const& dataset, std::string const& name,
                                       std::string const& axis) const {
    if (axis.empty() || axis == name) {
        make_axis(dataset, name);
        return;
    }
    auto const slash = axis.rfind('/');
    bool const path = slash != std::string::npos;
    attach_axis(dataset, open(path ? axis : where + "/" + axis), path ? axis.substr(slash + 1) : axis);
}

void ResultsWriter::Growing::write_categories(Dataset const& dataset, Field const& spec,
                                              std::span<std::int64_t const> values, std::int64_t first,
                                              std::string const& name) {
    static_assert(std::endian::native == std::endian::little, "the first bytes of a number are its low ones");
    auto const bytes = category_bytes(spec);
    std::vector<std::byte> categories(values.size() * bytes);
    for (std::size_t i = 0; i < values.size(); ++i) {  // little-endian, here and in the file
        std::memcpy(categories.data() + i * bytes, &values[i], bytes);
    }
    write_rows(dataset, types.of(file, spec), categories.data(), first, values.size(), name);
}

void ResultsWriter::Growing::write_array(std::string const& where, Field const& spec, hid_t memory_type,
                                         void const* values, std::size_t count, std::string const& scale) {
    std::int64_t const size = count;
    auto const dataset = create(where, spec, size);
    write_rows(dataset, memory_type, values, 0, size, spec.name);
    lay_along(where, dataset, spec.name, scale);
}

}  // namespace overturn::store
