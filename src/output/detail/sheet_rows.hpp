/// Rows of a sheet from the columns of a results file.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "output/sheets.hpp"

namespace overturn::output {

/// A column of a part of a sheet.
struct SheetSource {
    SheetColumn column;
    std::string path = {};  ///< of the column in the file; empty: `text` in every row
    std::string text = {};
    FieldType type = FieldType::real;
    std::vector<Category> names = {};           ///< of values
    std::vector<std::string> flags = {};        ///< of the bits from 0 of a mask
    double per_unit = 0;                        ///< SI value of the unit in which it is shown; 0: as it is stored
    std::string only_where = {}, only_is = {};  ///< absent where this column of names says another
};

/// Rows that come from columns of one length.
struct SheetPart {
    std::int64_t rows = 0;
    std::vector<SheetSource> sources;
};

/// The parts below each other: of columns that only some have, the others' cells are absent.
[[nodiscard]] Sheet sheet_of(std::string name, store::ResultsReader const& file, std::vector<SheetPart> parts);

/// Rows of texts.
[[nodiscard]] Sheet text_sheet(std::string name, std::vector<SheetColumn> columns,
                               std::vector<std::vector<std::string>> rows);

}  // namespace overturn::output
