#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <numeric>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "core/error.hpp"
#include "store/detail/dataset_rows.hpp"
#include "store/detail/objects.hpp"
#include "store/durable.hpp"
#include "store/results_file.hpp"
#include "store/seal.hpp"
#include "store/sha256.hpp"

namespace overturn::store {

struct ResultsWriter::Table {
    TableSpec spec;
    std::vector<Dataset> datasets;
    std::int64_t rows = 0;
    std::int64_t written = 0;
};

namespace {

static_assert(std::endian::native == std::endian::little);

}  // namespace

ResultsWriter::ResultsWriter(std::filesystem::path path) : path_(std::move(path)), growing_(path_) {
    growing_ += ".merging";
    // Ours alone by the run's claim: HDF5's own lock would fail where a file system has none.
    PropertyList const access(checked(H5Pcreate(H5P_FILE_ACCESS), "make file properties"));
    checked(H5Pset_file_locking(access.id(), false, true), "leave locks out");
    auto const id = H5Fcreate(growing_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id());
    if (id < 0) {
        ::unlink(growing_.c_str());  // a full disk still takes an empty file
    }
    file_ = File(checked(id, "create " + growing_.string()));
}

ResultsWriter::~ResultsWriter() {
    if (!finished_) {
        abandon();
        std::error_code ignored;
        std::filesystem::remove(growing_, ignored);
    }
}

// HDF5 cannot close a file that it could not write (it crashes), so everything open in it is let go instead.
void ResultsWriter::abandon() {
    for (auto& table : tables_) {
        for (auto& dataset : table.datasets) {
            dataset.release();
        }
    }
    for (auto& [path, group] : groups_) {
        group.release();
    }
    types_.release();
    file_.release();
}

Group& ResultsWriter::group(std::string const& path) {
    auto const found = groups_.find(path);
    if (found != groups_.end()) {
        return found->second;
    }
    hid_t parent = file_.id();
    auto const slash = path.rfind('/');
    if (slash != std::string::npos) {
        parent = group(path.substr(0, slash)).id();
    }
    auto const name = slash == std::string::npos ? path : path.substr(slash + 1);
    return groups_
        .emplace(path, Group(checked(H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                                     "create group " + path)))
        .first->second;
}

bool TableSpec::numbers_rows() const {
    return !axis.empty() && axis.find('/') == std::string::npos
           && std::ranges::none_of(columns, [this](Field const& column) { return column.name == axis; });
}

void ResultsWriter::attribute(std::string const& name, std::string const& text) {
    write_attribute(file_.id(), name, text);
}
void ResultsWriter::attribute(std::string const& name, std::int64_t value) { write_attribute(file_.id(), name, value); }
void ResultsWriter::attribute(std::string const& where, std::string const& name, std::string const& text) {
    write_attribute(group(where).id(), name, text);
}
void ResultsWriter::attribute(std::string const& where, std::string const& name, std::int64_t value) {
    write_attribute(group(where).id(), name, value);
}
void ResultsWriter::attribute(std::string const& where, std::string const& name, double value) {
    write_attribute(group(where).id(), name, value);
}

std::vector<std::string> ResultsWriter::groups() const {
    std::vector<std::string> names;
    for (auto const& [path, handle] : groups_) {
        names.push_back(path);
    }
    return names;
}

Dataset ResultsWriter::create(std::string const& where, Field const& spec, std::int64_t rows) {
    auto const type = types_.of(file_, spec);
    auto const size = static_cast<hsize_t>(rows);
    Dataspace const space(checked(H5Screate_simple(1, &size, nullptr), "make a dataspace"));
    auto const properties = dataset_properties();
    Dataset dataset(checked(
        H5Dcreate2(group(where).id(), spec.name.c_str(), type, space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT),
        "create " + where + "/" + spec.name));
    describe(dataset, spec);
    return dataset;
}

Dataset ResultsWriter::open(std::string const& path) const {
    return Dataset(checked(H5Dopen2(file_.id(), path.c_str(), H5P_DEFAULT), "open " + path));
}

// `axis`: of the group `where`, or a path; empty or the dataset's own name: itself.
void ResultsWriter::lay_along(std::string const& where, Dataset const& dataset, std::string const& name,
                              std::string const& axis) {
    if (axis.empty() || axis == name) {
        make_axis(dataset, name);
        return;
    }
    auto const slash = axis.rfind('/');
    bool const path = slash != std::string::npos;
    attach_axis(dataset, open(path ? axis : where + "/" + axis), path ? axis.substr(slash + 1) : axis);
}

void ResultsWriter::number_rows(TableSpec const& spec, std::int64_t rows) {
    constexpr std::int64_t most = 1 << 16;
    auto const axis = create(spec.group, {spec.axis, "1", spec.axis_description, FieldType::integer}, rows);
    for (std::int64_t first = 0; first < rows; first += most) {
        std::vector<std::int64_t> numbers(static_cast<std::size_t>(std::min(most, rows - first)));
        std::iota(numbers.begin(), numbers.end(), first);
        write_rows(axis, H5T_NATIVE_INT64, numbers.data(), first, static_cast<std::int64_t>(numbers.size()), spec.axis);
    }
}

std::size_t ResultsWriter::table(TableSpec spec, std::int64_t rows) {
    Table table;
    if (spec.numbers_rows()) {
        number_rows(spec, rows);
    }
    for (auto const& column : spec.columns) {
        table.datasets.push_back(create(spec.group, column, rows));
    }
    for (std::size_t c = 0; c < spec.columns.size(); ++c) {
        lay_along(spec.group, table.datasets[c], spec.columns[c].name, spec.axis);
    }
    table.spec = std::move(spec);
    table.rows = rows;
    tables_.push_back(std::move(table));
    return tables_.size() - 1;
}

void ResultsWriter::append(std::size_t number, std::span<std::byte const> rows) {
    auto& table = tables_.at(number);
    auto const count = rows.size() / table.spec.row_bytes;
    OVERTURN_EXPECT(rows.size() % table.spec.row_bytes == 0);
    OVERTURN_EXPECT(table.written + static_cast<std::int64_t>(count) <= table.rows);
    std::vector<std::int64_t> gathered(count);
    for (std::size_t c = 0; c < table.spec.columns.size(); ++c) {
        auto const& column = table.spec.columns[c];
        for (std::size_t i = 0; i < count; ++i) {
            std::memcpy(&gathered[i], rows.data() + i * table.spec.row_bytes + column.offset, sizeof(std::int64_t));
        }
        auto const name = table.spec.group + "/" + column.name;
        auto const size = static_cast<std::int64_t>(count);
        if (column.type == FieldType::category) {
            write_categories(table.datasets[c], column, gathered, table.written, name);
        } else {
            write_rows(table.datasets[c], column.type == FieldType::real ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT64,
                       gathered.data(), table.written, size, name);
        }
    }
    table.written += static_cast<std::int64_t>(count);
}

void ResultsWriter::add_digests() {
    auto const text = text_of(digests_of(file_));
    attribute(digest_of_all, sha256(text));
    bytes(digest_group, digest_list,
          "SHA-256 of every object's type, shape, attributes and content: lines of digest and path", text);
}

void ResultsWriter::finish() {
    for (auto const& table : tables_) {
        if (table.written != table.rows) {
            throw ContractError(fmt::format("table {} got {} of {} rows", table.spec.group, table.written, table.rows));
        }
    }
    add_digests();
    // First everything goes to disk, where a failure is heard of; then closing has nothing left to write.
    checked(H5Fflush(file_.id(), H5F_SCOPE_GLOBAL), "write " + growing_.string());
    tables_.clear();
    groups_.clear();
    types_.close();
    checked(H5Fclose(file_.release()), "close " + growing_.string());
    seal(growing_);
    make_durable(growing_);
    rename_durably(growing_, path_);
    finished_ = true;
}

}  // namespace overturn::store
