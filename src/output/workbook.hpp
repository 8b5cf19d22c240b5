/// Sheets as a workbook of Excel (.xlsx), by libxlsxwriter. A build without that library has none.
#pragma once

#include <filesystem>
#include <span>

#include "output/sheets.hpp"

namespace overturn::output {

/// To be called before any work. \throws InputError if this program was built without the library, or a sheet has more
/// rows or columns than Excel holds (1 048 576 and 16 384)
void require_workbook(std::span<Sheet const> sheets);

/// One sheet each, a header line first. Numbers have 16 significant digits, as the library writes them (csv: all);
/// absent cells are empty, infinite numbers the text "inf". The rows are not held in memory: they lie in the folder of
/// `path` meanwhile. Equal sheets give equal bytes. \throws SystemError if it cannot be written
void write_workbook(std::filesystem::path const& path, std::span<Sheet const> sheets);

}  // namespace overturn::output
