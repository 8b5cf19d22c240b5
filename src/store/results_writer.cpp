#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <numeric>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#include "core/error.hpp"
#include "store/detail/dataset_rows.hpp"
#include "store/detail/growing_file.hpp"
#include "store/detail/objects.hpp"
#include "store/durable.hpp"
#include "store/results_file.hpp"
#include "store/seal.hpp"
#include "store/sha256.hpp"

namespace overturn::store {

ResultsWriter::ResultsWriter(std::filesystem::path path, Layout layout) : path_(std::move(path)), growing_path_(path_) {
    growing_path_ += ".merging";
    growing_ = std::make_unique<Growing>(growing_path_.string(), layout);
}

ResultsWriter::~ResultsWriter() {
    if (!finished_) {
        growing_->abandon();
        std::error_code ignored;
        std::filesystem::remove(growing_path_, ignored);
    }
}

bool TableSpec::numbers_rows() const {
    return !axis.empty() && axis.find('/') == std::string::npos
           && std::ranges::none_of(columns, [this](Field const& column) { return column.name == axis; });
}

void ResultsWriter::attribute(std::string const& name, std::string const& text) {
    write_attribute(growing_->file.id(), name, text);
}
void ResultsWriter::attribute(std::string const& name, std::int64_t value) {
    write_attribute(growing_->file.id(), name, value);
}
void ResultsWriter::attribute(std::string const& where, std::string const& name, std::string const& text) {
    write_attribute(growing_->group(where).id(), name, text);
}
void ResultsWriter::attribute(std::string const& where, std::string const& name, std::int64_t value) {
    write_attribute(growing_->group(where).id(), name, value);
}
void ResultsWriter::attribute(std::string const& where, std::string const& name, double value) {
    write_attribute(growing_->group(where).id(), name, value);
}

std::vector<std::string> ResultsWriter::groups() const {
    std::vector<std::string> names;
    for (auto const& [path, handle] : growing_->groups) {
        names.push_back(path);
    }
    return names;
}

std::size_t ResultsWriter::table(TableSpec spec, std::int64_t rows) {
    Growing::Table table;
    if (spec.numbers_rows()) {
        table.numbers = growing_->create(spec.group, {spec.axis, "1", spec.axis_description, FieldType::integer}, rows,
                                         Growing::Room::now);
    }
    for (auto const& column : spec.columns) {
        table.datasets.push_back(growing_->create(spec.group, column, rows, Growing::Room::now));
    }
    for (std::size_t c = 0; c < spec.columns.size(); ++c) {
        growing_->lay_along(spec.group, table.datasets[c], spec.columns[c].name, spec.axis);
    }
    table.spec = std::move(spec);
    table.rows = rows;
    growing_->tables.push_back(std::move(table));
    return growing_->tables.size() - 1;
}

// Puts the tables so far to disk before the first row, whoever writes it: HDF5 then gives what comes later the same
// place.
void ResultsWriter::settle() {
    if (!settled_) {
        settled_ = true;
        checked(H5Fflush(growing_->file.id(), H5F_SCOPE_GLOBAL), "write " + growing_path_.string());
    }
}

void ResultsWriter::append(std::size_t number, std::span<std::byte const> rows) {
    settle();
    auto& table = growing_->tables.at(number);
    OVERTURN_EXPECT(rows.size() % table.spec.row_bytes == 0);
    table.waiting.insert(table.waiting.end(), rows.begin(), rows.end());
    OVERTURN_EXPECT(table.taken() <= table.rows);
    constexpr std::size_t most_waiting = 1 << 20;
    if (table.waiting.size() >= most_waiting) {
        growing_->write(table);
    }
}

void ResultsWriter::Growing::write(Table& table) {
    auto const count = table.waiting.size() / table.spec.row_bytes;
    std::vector<std::int64_t> gathered(count);
    for (std::size_t c = 0; c < table.spec.columns.size() && count > 0; ++c) {
        auto const& column = table.spec.columns[c];
        for (std::size_t i = 0; i < count; ++i) {
            std::memcpy(&gathered[i], table.waiting.data() + i * table.spec.row_bytes + column.offset,
                        sizeof(std::int64_t));
        }
        auto const name = table.spec.group + "/" + column.name;
        if (column.type == FieldType::category) {
            write_categories(table.datasets[c], column, gathered, table.written, name);
        } else {
            write_rows(table.datasets[c], column.type == FieldType::real ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT64,
                       gathered.data(), table.written, static_cast<std::int64_t>(count), name);
        }
    }
    if (table.numbers && count > 0) {
        std::iota(gathered.begin(), gathered.end(), table.written);
        write_rows(*table.numbers, H5T_NATIVE_INT64, gathered.data(), table.written, static_cast<std::int64_t>(count),
                   table.spec.axis);
    }
    table.written += static_cast<std::int64_t>(count);
    table.waiting.clear();
}

RowPlaces ResultsWriter::places() const {
    OVERTURN_EXPECT(growing_->layout == Layout::plain);
    RowPlaces places{growing_path_, {}};
    for (auto const& table : growing_->tables) {
        TablePlace place{table.spec.row_bytes, table.rows, {}};
        auto const add = [&](Dataset const& dataset, std::string const& name, std::uint64_t bytes,
                             std::uint64_t offset) {
            auto const at = H5Dget_offset(dataset.id());
            OVERTURN_ENSURE(at != HADDR_UNDEF);
            place.columns.push_back({fmt::format("/{}/{}", table.spec.group, name), at, bytes, offset});
        };
        for (std::size_t c = 0; c < table.datasets.size() && table.rows > 0; ++c) {
            auto const& column = table.spec.columns[c];
            add(table.datasets[c], column.name,
                column.type == FieldType::category ? category_bytes(column) : sizeof(double), column.offset);
        }
        if (table.numbers && table.rows > 0) {
            add(*table.numbers, table.spec.axis, sizeof(std::int64_t), ColumnPlace::of_number);
        }
        places.tables.push_back(std::move(place));
    }
    return places;
}

RowPlaces ResultsWriter::give_places() {
    for (auto& table : growing_->tables) {
        OVERTURN_EXPECT(table.taken() == 0);
        table.written = table.rows;
    }
    settle();
    // NFS lets two nodes write to one page only where it lies within the file: beyond its end each fills it with zeros.
    hsize_t size = 0;
    checked(H5Fget_filesize(growing_->file.id(), &size), "ask for the file's size");
    if (::truncate(growing_path_.c_str(), static_cast<off_t>(size)) != 0) {
        throw SystemError(fmt::format("cannot extend {} ({}). {}", growing_path_.string(), std::strerror(errno),
                                      advice_on_disk(errno)));
    }
    return places();
}

// Reads long columns back, and with the same bytes the stretches of the file that they lie in. What HDF5 changes of
// such a stretch after that lies between columns: these got their room in one piece when they were made, and HDF5
// neither moves nor writes them once their rows are there; of rows it holds nothing back. Packed columns have no such
// place.
ResultsWriter::ReadBack ResultsWriter::read_back(HashStretches const& hash) const {
    ReadBack read;
    if (growing_->layout == Layout::packed) {
        return read;
    }
    Stretches columns, wanted;
    for (auto const& table : places().tables) {
        for (auto const& column : table.columns) {
            Stretch const whole{column.at, static_cast<std::uint64_t>(table.rows) * column.bytes};
            columns.insert(whole);
            if (auto const length = column_stretch / column.bytes * column.bytes; whole.bytes > length) {
                auto some = stretches_of(whole.at, whole.bytes, length);
                wanted.insert(some.begin(), some.end());
                read.long_columns.emplace(column.path, std::move(some));
            }
        }
    }
    // Not the first one, with the head of the file; nor the last one, with its end.
    for (auto const& whole : stretches_of(0, columns.empty() ? 0 : columns.rbegin()->end(), file_stretch)) {
        if (whole.at > 0 && whole.bytes == file_stretch) {
            wanted.insert(whole);
            read.between.merge(outside(whole, columns));
        }
    }
    wanted.insert(read.between.begin(), read.between.end());
    // Opened anew, it has its present length on this node too, also through what is open already.
    std::ifstream const seen(growing_path_);
    read.digests = wanted.empty() ? StretchDigests() : hash(growing_path_, wanted);
    return read;
}

void ResultsWriter::add_digests(ReadBack const& read) {
    HashedColumns hashed;
    for (auto const& [path, stretches] : read.long_columns) {
        for (auto const& stretch : stretches) {
            hashed[path].push_back(read.digests.at(stretch));
        }
    }
    auto const text = text_of(digests_of(growing_->file, ContentHash::stretches, hashed));
    attribute(digest_of_all, sha256(text));
    bytes(digest_group, digest_list,
          "SHA-256 of every object's type, shape, attributes and content: lines of digest and path", text);
    write_attribute(growing_->open(fmt::format("{}/{}", digest_group, digest_list)).id(), digest_stretch,
                    static_cast<std::int64_t>(column_stretch));
}

void ResultsWriter::finish(HashStretches const& hash) {
    for (auto& table : growing_->tables) {
        growing_->write(table);
        if (table.written != table.rows) {
            throw ContractError(fmt::format("table {} got {} of {} rows", table.spec.group, table.written, table.rows));
        }
    }
    auto read = read_back(hash);
    add_digests(read);
    // First everything goes to disk, where a failure is heard of; then closing has nothing left to write.
    checked(H5Fflush(growing_->file.id(), H5F_SCOPE_GLOBAL), "write " + growing_path_.string());
    growing_->tables.clear();
    growing_->groups.clear();
    growing_->types.close();
    checked(H5Fclose(growing_->file.release()), "close " + growing_path_.string());
    for (auto const& [part, digest] : hash_stretches(growing_path_, read.between)) {
        if (digest != read.digests.at(part)) {
            read.digests.erase({part.at / file_stretch * file_stretch, file_stretch});
        }
    }
    seal(growing_path_, hash, std::move(read.digests));
    make_durable(growing_path_);
    rename_durably(growing_path_, path_);
    finished_ = true;
}

}  // namespace overturn::store
