#include "parallel/rows_of_ranks.hpp"

#include <cstring>
#include <string>

#include "core/error.hpp"

namespace overturn::parallel {
namespace {

std::string bytes_of(std::span<double const> values) {
    return {reinterpret_cast<char const*>(values.data()), values.size_bytes()};
}

}  // namespace

ShareRows rows_of_ranks(Communicator const& comm) {
    if (comm.size() == 1) {
        return rows_alone;
    }
    return [&comm](std::int64_t items, std::size_t row_length, RowWork const& work) {
        std::string own;
        std::vector<double> row(row_length);
        for (std::int64_t item = comm.rank(); item < items; item += comm.size()) {
            work(item, row);
            own += bytes_of(row);
        }
        auto const of_ranks = comm.gather(own);
        std::string whole;
        auto const row_bytes = row_length * sizeof(double);
        for (std::int64_t item = 0; comm.is_root() && item < items; ++item) {
            whole += of_ranks[item % comm.size()].substr(item / comm.size() * row_bytes, row_bytes);
        }
        comm.broadcast(whole);
        OVERTURN_ENSURE(whole.size() == items * row_bytes);
        std::vector<double> rows(items * row_length);
        std::memcpy(rows.data(), whole.data(), whole.size());
        return rows;
    };
}

}  // namespace overturn::parallel
