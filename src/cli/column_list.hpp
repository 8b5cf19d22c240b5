/// `overturn list columns FILE.h5`: what the columns of a results file mean, as the file itself says.
#pragma once

#include <string>
#include <vector>

#include "output/table.hpp"
#include "store/results_file.hpp"

namespace overturn::cli {

/// Columns of one group. Groups of different bodies, limit states, quantities and runs that hold the same columns are
/// one: their names are "<body>", "<limit>", "<quantity>" and "<n>" here.
struct ListedGroup {
    std::string name;                           ///< "limits/<limit>/stripes/<body>"
    std::vector<store::ColumnMeaning> columns;  ///< path: the column's own name
    std::vector<std::string> unknown;           ///< names of columns that this program does not know
};

/// Adds those of a file to what is listed, in the order of names.
/// \param unknown paths of columns that this program does not know
void add_groups(store::ResultsReader const& file, std::vector<std::string> const& unknown,
                std::vector<ListedGroup>& groups);

/// Adds the columns of tables that only JSON has, in the order of names.
void add_groups(std::vector<output::Table> const& tables, std::vector<ListedGroup>& groups);

/// Columns of a file, and those of tables that only `fit --json` has.
struct ListedColumns {
    std::vector<ListedGroup> file, json;
};
/// For people at a terminal.
[[nodiscard]] std::string columns_text(ListedColumns const& of);
/// The text of src/store/COLUMNS.md.
[[nodiscard]] std::string columns_markdown(ListedColumns const& of);

}  // namespace overturn::cli
