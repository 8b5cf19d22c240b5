#include "store/row_places.hpp"

#include <bit>
#include <cerrno>
#include <cstring>
#include <sstream>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "core/error.hpp"
#include "store/durable.hpp"

namespace overturn::store {
namespace {

constexpr std::size_t most_waiting = 8 << 20;  // bytes of rows: a column of them is some ten kB

[[noreturn]] void fail(std::filesystem::path const& path, int reason) {
    throw SystemError(
        fmt::format("cannot write {} ({}). {}", path.string(), std::strerror(reason), advice_on_disk(reason)));
}

}  // namespace

// The file's name comes last, as it may hold anything.
std::string RowPlaces::serialise() const {
    std::string text = fmt::format("{}\n", tables.size());
    for (auto const& table : tables) {
        text += fmt::format("{} {} {}\n", table.row_bytes, table.rows, table.columns.size());
        for (auto const& column : table.columns) {
            text += fmt::format("{} {} {} {}\n", column.at, column.bytes, column.offset, column.path);
        }
    }
    return text + file.string();
}

RowPlaces RowPlaces::deserialise(std::string const& text) {
    std::istringstream in(text);
    RowPlaces places;
    std::size_t count = 0;
    in >> count;
    places.tables.resize(count);
    for (auto& table : places.tables) {
        in >> table.row_bytes >> table.rows >> count;
        table.columns.resize(count);
        for (auto& column : table.columns) {
            in >> column.at >> column.bytes >> column.offset;
            in.get();
            std::getline(in, column.path);
        }
    }
    if (places.tables.empty() || places.tables.back().columns.empty()) {
        in.get();  // the end of the last line
    }
    OVERTURN_ENSURE(!in.fail());
    places.file = text.substr(in.tellg());
    return places;
}

PlacedRows::PlacedRows(RowPlaces places) : places_(std::move(places)), waiting_(places_.tables.size()) {
    file_ = ::open(places_.file.c_str(), O_WRONLY | O_CLOEXEC);
    if (file_ < 0) {
        fail(places_.file, errno);
    }
}

PlacedRows::~PlacedRows() { ::close(file_); }

void PlacedRows::write(std::size_t table, std::int64_t first, std::span<std::byte const> rows) {
    auto& waiting = waiting_.at(table);
    auto const row_bytes = places_.tables[table].row_bytes;
    OVERTURN_EXPECT(rows.size() % row_bytes == 0);
    if (first != waiting.first + static_cast<std::int64_t>(waiting.rows.size() / row_bytes)) {
        put(table);
        waiting.first = first;
    }
    waiting.rows.insert(waiting.rows.end(), rows.begin(), rows.end());
    if (waiting.rows.size() >= most_waiting) {
        put(table);
    }
}

void PlacedRows::put(std::size_t table) {
    static_assert(std::endian::native == std::endian::little, "the first bytes of a number are its low ones");
    auto const& place = places_.tables[table];
    auto& waiting = waiting_[table];
    auto const count = waiting.rows.size() / place.row_bytes;
    OVERTURN_EXPECT(waiting.first >= 0 && waiting.first + static_cast<std::int64_t>(count) <= place.rows);
    std::vector<std::byte> values;
    for (auto const& column : place.columns) {
        values.resize(count * column.bytes);
        for (std::size_t i = 0; i < count; ++i) {
            auto const row = waiting.first + static_cast<std::int64_t>(i);
            void const* const value = column.offset == ColumnPlace::of_number
                                          ? static_cast<void const*>(&row)
                                          : waiting.rows.data() + i * place.row_bytes + column.offset;
            std::memcpy(values.data() + i * column.bytes, value, column.bytes);
        }
        auto at = column.at + static_cast<std::uint64_t>(waiting.first) * column.bytes;
        for (std::span<std::byte const> left(values); !left.empty();) {
            auto const written = ::pwrite(file_, left.data(), left.size(), static_cast<off_t>(at));
            if (written < 0 && errno != EINTR) {
                fail(places_.file, errno);
            }
            at += written > 0 ? written : 0;
            left = left.subspan(written > 0 ? written : 0);
        }
    }
    waiting.first += static_cast<std::int64_t>(count);
    waiting.rows.clear();
}

void PlacedRows::finish() {
    for (std::size_t table = 0; table < waiting_.size(); ++table) {
        put(table);
    }
    if (::fsync(file_) != 0) {
        fail(places_.file, errno);
    }
}

}  // namespace overturn::store
