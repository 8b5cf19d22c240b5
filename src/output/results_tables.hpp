/// Tables in a results file: written, and compared with those of a file.
#pragma once

#include <span>
#include <string>

#include "output/table.hpp"
#include "store/results_file.hpp"

namespace overturn::output {

/// Writes a table as a group of columns. Nothing where it has no rows or lies in no file.
void write_table(store::ResultsWriter& file, Table const& table);
void write_tables(store::ResultsWriter& file, std::span<Table const> tables);

/// Largest difference between stored numbers and the same computed again.
struct Difference {
    double relative = 0;  ///< the largest; infinite where a number, a count or a name is another one
    std::string column;   ///< where: "fragility/type-a/median"
};
/// Difference over rows that both have, matched by `key`, a column of names; columns and rows that only one of them has
/// are left out. \pre the table has the column `key`
[[nodiscard]] Difference difference(store::ResultsReader const& file, Table const& table, std::string const& key);

}  // namespace overturn::output
